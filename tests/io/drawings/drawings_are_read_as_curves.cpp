// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: what is drawn, and where. The drawings are 100 wide and high where nothing else is said, and their y points down,
// so a point (x, y) of them is expected at (x, 100 - y). Lines have a stroke, without which nothing is seen of them.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/io/format.h"
#include "core/io/svg/svg_drawing.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::kPi;

namespace {

std::string drawing(const std::string& content, const std::string& attributes = "") {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" overflow="visible" )" + attributes +
         ">" + content + "</svg>";
}

Expected<SvgDrawing> read_drawing(const std::string& text) {
  ReadJob job;
  return read_svg_drawing(text, "a.svg", job);
}

SvgDrawing good_drawing(const std::string& text) {
  auto read = read_drawing(text);
  INFO((read ? std::string() : read.error().message()));
  REQUIRE(read.has_value());
  return *std::move(read);
}

std::vector<PlaneCurve> curves_of(const std::string& content, const std::string& attributes = "") {
  SvgDrawing read = good_drawing(drawing(content, attributes));
  for (const std::string& warning : read.warnings) UNSCOPED_INFO(warning);
  CHECK(read.warnings.empty());
  return std::move(read.curves.curves);
}

/// The start and the end of each piece, y down again.
std::vector<Vec2> ends_of(const PlaneCurve& curve) {
  std::vector<Vec2> out{{curve.start().x, 100.0 - curve.start().y}};
  curve.for_each_piece([&](const Piece& piece) { out.push_back({piece.to().x, 100.0 - piece.to().y}); });
  return out;
}

void require_ends(const std::string& content, const std::vector<Vec2>& wanted, const std::string& attributes = "") {
  INFO(content);
  const std::vector<PlaneCurve> curves = curves_of(content, attributes);
  REQUIRE(curves.size() == 1);
  const std::vector<Vec2> found = ends_of(curves[0]);
  REQUIRE(found.size() == wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO(i << ": " << found[i].x << ", " << found[i].y);
    CHECK(distance(found[i], wanted[i]) < 1e-10);
  }
}

std::string path(const std::string& data) {
  return "<path fill='none' stroke='red' d='" + data + "'/>";
}

Vec2 point_on(const std::string& content, double t, std::size_t wanted = 0) {
  Vec2 out;
  std::size_t i = 0;
  curves_of(content).at(0).for_each_piece([&](const Piece& piece) {
    if (i++ == wanted) out = piece.at(t);
  });
  return {out.x, 100.0 - out.y};
}

}  // namespace

TEST_CASE("every command of a path goes where it says, absolute and relative") {
  require_ends(path("M 10 10 L 20 10 H 30 V 25 h-5 v 5 l 1 1"),
               {{10, 10}, {20, 10}, {30, 10}, {30, 25}, {25, 25}, {25, 30}, {26, 31}});
  require_ends(path("m10 10 5 0 0 5z"), {{10, 10}, {15, 10}, {15, 15}, {10, 10}});
}

TEST_CASE("numbers of a path need nothing between them where they cannot be mistaken") {
  require_ends(path("M10-10.5L.5.5-1e1-2E-1,+3 4"), {{10, -10.5}, {0.5, 0.5}, {-10, -0.2}, {3, 4}});
}

TEST_CASE("smooth commands mirror the control point before them, and only one of their own kind") {
  // The middle of a cubic is (p0 + 3 p1 + 3 p2 + p3) / 8, of a quadratic (p0 + 2 p1 + p2) / 4.
  CHECK(distance(point_on(path("M0 0 C 0 8 8 8 8 0 S 16 -8 16 0"), 0.5, 1), {12, -6}) < 1e-12);
  CHECK(distance(point_on(path("M0 0 c 0 8 8 8 8 0 s 8 -8 8 0"), 0.5, 1), {12, -6}) < 1e-12);
  CHECK(distance(point_on(path("M0 0 L 8 0 S 16 -8 16 0"), 0.5, 1), {(8 + 24 + 48 + 16) / 8.0, -3}) < 1e-12);
  CHECK(distance(point_on(path("M0 0 Q 4 8 8 0 T 16 0"), 0.5, 1), {12, -4}) < 1e-12);
  CHECK(distance(point_on(path("M0 0 q 4 8 8 0 t 8 0 t 8 0"), 0.5, 2), {20, 4}) < 1e-12);
  CHECK(distance(point_on(path("M0 0 C 0 8 8 8 8 0 T 16 0"), 0.5, 1), {10, 0}) < 1e-12);
}

TEST_CASE("flags of an arc may run together with what follows") {
  for (const char* data : {"M1 2 a1 1 0 00.5.5", "M1 2a1,1,0,0,0,.5,.5", "M1 2 a 1 1 0 0 0 0.5 0.5"}) {
    const std::vector<PlaneCurve> curves = curves_of(path(data));
    REQUIRE(curves.size() == 1);
    CHECK(ends_of(curves[0]) == std::vector<Vec2>{{1, 2}, {1.5, 2.5}});
  }
  CHECK(curves_of(path("M0 0a1 1 0 01.5.5 1 1 0 102 2")).at(0).piece_count() == 2);
}

TEST_CASE("an arc turns the way its flag says, y down") {
  // From (10, 0) to (0, 10) around the origin: "positive angle" turns from x to y.
  CHECK(distance(point_on(path("M10 0 A 10 10 0 0 1 0 10"), 0.5), {10 / std::sqrt(2), 10 / std::sqrt(2)}) < 1e-12);
  CHECK(distance(point_on(path("M10 0 A 10 10 0 1 1 0 10"), 0.5), {10 + 10 / std::sqrt(2), 10 + 10 / std::sqrt(2)}) <
        1e-12);
  CHECK(distance(point_on(path("M10 0 A 10 10 0 0 0 0 10"), 0.5), {10 - 10 / std::sqrt(2), 10 - 10 / std::sqrt(2)}) <
        1e-12);
  CHECK(distance(point_on(path("M-10 0 A 20 10 90 0 1 10 0"), 0.5), {0, -20}) < 1e-12);
  require_ends(path("M0 0 A 0 5 0 0 1 7 7"), {{0, 0}, {7, 7}});
}

TEST_CASE("a path has a curve for each of its parts, and begins again where it was closed") {
  const std::vector<PlaneCurve> curves = curves_of(path("M0 0H4V4zl-2-2v-2M9 9M20 20h5"));
  REQUIRE(curves.size() == 3);
  CHECK(curves[0].is_closed());
  CHECK(ends_of(curves[1]) == std::vector<Vec2>{{0, 0}, {-2, -2}, {-2, -4}});
  CHECK_FALSE(curves[1].is_closed());
  CHECK(ends_of(curves[2]) == std::vector<Vec2>{{20, 20}, {25, 20}});
}

TEST_CASE("what is filled is closed, and what is stroked is as open as it is drawn") {
  CHECK(curves_of("<path d='M0 0H4V4'/>").at(0).is_closed());
  CHECK_FALSE(curves_of("<g style='fill: none; stroke: red'><path d='M0 0H4V4'/></g>").at(0).is_closed());
  CHECK_FALSE(curves_of("<path stroke='red' d='M0 0H4V4'/>").at(0).is_closed());
  CHECK_FALSE(curves_of("<style>.a{fill:none;stroke:red}</style><path class='a' d='M0 0H4V4'/>").at(0).is_closed());
  CHECK(curves_of("<style>.a{stroke:red}</style><path d='M0 0H4V4'/>").at(0).is_closed());
  // An end that misses the start by the digits that were left out.
  CHECK(curves_of(path("M0 0H40V40H.001V.001")).at(0).is_closed());
}

TEST_CASE("basic shapes are the curves that SVG says") {
  require_ends("<rect x='10' y='20' width='30' height='10'/>", {{10, 20}, {40, 20}, {40, 30}, {10, 30}, {10, 20}});
  require_ends("<rect x='10' y='20' width='30' height='10' rx='4'/>",
               {{14, 20}, {36, 20}, {40, 24}, {40, 26}, {36, 30}, {14, 30}, {10, 26}, {10, 24}, {14, 20}});
  require_ends("<rect width='30' height='10' rx='40' ry='2'/>",
               {{15, 0}, {15, 0}, {30, 2}, {30, 8}, {15, 10}, {15, 10}, {0, 8}, {0, 2}, {15, 0}});
  require_ends("<line stroke='red' x1='1' y1='2' x2='3' y2='4'/>", {{1, 2}, {3, 4}});
  require_ends("<polyline fill='none' stroke='red' points='1,2 3,4, 5 6'/>", {{1, 2}, {3, 4}, {5, 6}});
  require_ends("<polygon points='1,2 3,4 5,6'/>", {{1, 2}, {3, 4}, {5, 6}, {1, 2}});
  CHECK(distance(point_on("<circle cx='50' cy='40' r='10'/>", 0.25), {50, 50}) < 1e-12);
  CHECK(distance(point_on("<ellipse cx='50' cy='40' rx='10' ry='5'/>", 0.75), {50, 35}) < 1e-12);
  CHECK(distance(point_on("<rect x='10' y='20' width='30' height='10' rx='4'/>", 0.5, 1),
                 {36 + 4 * std::sqrt(0.5), 24 - 4 * std::sqrt(0.5)}) < 1e-12);
  CHECK(curves_of("<circle r='0'/><rect width='5'/><ellipse rx='-1' ry='2'/><polyline points='1 1'/>").empty());
}

TEST_CASE("transforms are applied from the inside out") {
  const std::string line = "<line stroke='red' x1='1' y1='0' x2='2' y2='1'/>";
  require_ends("<g transform='translate(10 20) scale(2)'>" + line + "</g>", {{12, 20}, {14, 22}});
  require_ends("<g transform='scale(2, -3),translate(10,20)'>" + line + "</g>", {{22, -60}, {24, -63}});
  require_ends("<g transform='rotate(90)'>" + line + "</g>", {{0, 1}, {-1, 2}});
  require_ends("<g transform='rotate(90 1 0)'>" + line + "</g>", {{1, 0}, {0, 1}});
  require_ends("<g transform='matrix(1 2 3 4 5 6)'>" + line + "</g>", {{6, 8}, {10, 14}});
  require_ends("<g transform='skewX(45)'>" + line + "</g>", {{1, 0}, {3, 1}});
  require_ends("<g transform='skewY(45)'>" + line + "</g>", {{1, 1}, {2, 3}});
  require_ends(
      "<g transform='translate(5)'><line stroke='red' x1='1' y1='0' x2='2' y2='1' transform='scale(3)'/></g>",
      {{8, 0}, {11, 3}});
  // An ellipse that is turned and skewed stays one: (cos w, sin w) goes to (cos w + sin w, sin w).
  CHECK(distance(point_on("<circle r='1' transform='skewX(45)'/>", 0.125), {2 * std::sqrt(0.5), std::sqrt(0.5)}) <
        1e-12);
}

TEST_CASE("a view box is fitted into its viewport") {
  const std::string line = "<line stroke='red' x1='0' y1='0' x2='10' y2='10'/>";
  const auto nested = [&](const std::string& attributes) {
    return "<svg x='10' y='20' width='40' height='20' viewBox='0 0 10 10' " + attributes + ">" + line + "</svg>";
  };
  require_ends(nested(""), {{20, 20}, {40, 40}});
  require_ends(nested("preserveAspectRatio='xMinYMin'"), {{10, 20}, {30, 40}});
  require_ends(nested("preserveAspectRatio='xMaxYMax meet'"), {{30, 20}, {50, 40}});
  require_ends(nested("preserveAspectRatio='xMidYMax slice' overflow='visible'"), {{10, 0}, {50, 40}});
  require_ends(nested("preserveAspectRatio='none'"), {{10, 20}, {50, 40}});
  require_ends("<svg x='10%' y='20%' width='50%' height='50%' viewBox='0 0 10 10'>" + line + "</svg>",
               {{10, 20}, {60, 70}});
  require_ends(line, {{-5, -5}, {95, 95}}, "viewBox='0.5 0.5 10 10'");
}

TEST_CASE("lengths have units, and percentages are of the viewport") {
  require_ends("<line stroke='red' x1='1in' y1='2.54cm' x2='25.4mm' y2='72pt'/>", {{96, 96}, {96, 96}});
  require_ends("<line stroke='red' x1='6pc' y1='7px' x2='50%' y2='10%'/>", {{96, 7}, {50, 10}});
  CHECK(distance(point_on("<circle r='10%'/>", 0.5), {-10, 0}) < 1e-12);
  // A page in millimetres, with a millimetre for a unit.
  const SvgDrawing page =
      good_drawing("<svg width='210mm' height='297mm' viewBox='0 0 210 297'><rect width='210' height='297'/></svg>");
  CHECK(page.curves.curves.at(0).start() == Vec2{0, 297});
}

TEST_CASE("use draws what it refers to at its place") {
  const std::string link = "xmlns:xlink='http://www.w3.org/1999/xlink'";
  require_ends("<defs><line stroke='red' id='a' x1='1' y1='2' x2='3' y2='4'/></defs><use href='#a' x='10' y='20'/>",
               {{11, 22}, {13, 24}});
  require_ends(
      "<defs><g id='a' transform='scale(2)'><line stroke='red' x2='1' y2='1'/></g></defs>"
      "<use xlink:href='#a' transform='translate(5 6)' x='1'/>",
      {{6, 6}, {8, 8}}, link);
  require_ends(
      "<symbol id='s' viewBox='0 0 1 1'><line stroke='red' x2='1' y2='1'/></symbol>"
      "<use href='#s' x='10' y='10' width='20' height='30'/>",
      {{10, 15}, {30, 35}});
  CHECK(curves_of("<line stroke='red' id='a' x2='1'/><use href='#a' y='5'/><use href='#a' y='6'/>").size() == 3);
}

TEST_CASE("what is hidden or not drawn by itself is left out") {
  const std::string line = "<line stroke='red' x2='1'/>";
  for (const std::string element : {"defs", "clipPath", "mask", "pattern", "marker", "symbol"})
    CHECK(curves_of("<" + element + ">" + line + "</" + element + ">").empty());
  CHECK(curves_of("<switch>" + line + line + "</switch>").size() == 1);
  CHECK(curves_of("<other:line xmlns:other='x' x2='1'/>").empty());
  CHECK(good_drawing("<svg:svg xmlns:svg='s'><svg:line stroke='red' x2='1'/><line stroke='red' x2='1'/></svg:svg>")
            .curves.curves.size() == 1);
}

TEST_CASE("what is left out is said once a kind, with the place of the first") {
  const SvgDrawing read = good_drawing(
      "<svg>\n <text>a</text>\n <text>b</text>\n <image/>\n <line stroke='red' x2='1'/>\n"
      " <use href='#nowhere'/>\n <path d='M0 0\nL1 1 x'/>\n <circle r='many'/>\n <g transform='turn(3)'/></svg>");
  REQUIRE(read.warnings.size() == 6);
  CHECK(read.warnings[0] == "a.svg:2:2: 2 text elements are left out");
  CHECK(read.warnings[1] == "a.svg:4:2: 1 image element is left out");
  CHECK_THAT(read.warnings[2], Catch::StartsWith("a.svg:6:2: 1 use element is left out"));
  CHECK_THAT(read.warnings[3], Catch::StartsWith("a.svg:8:6: 1 list of coordinates is read up to a fault"));
  CHECK_THAT(read.warnings[4], Catch::StartsWith("a.svg:9:13: 1 value of r is not understood, and is ignored"));
  CHECK_THAT(read.warnings[5],
             Catch::StartsWith("a.svg:10:16: 1 value of transform is not understood, and is ignored"));
  CHECK(read.curves.curves.size() == 2);
}

TEST_CASE("a use of what it is part of is left out") {
  const SvgDrawing read = good_drawing(
      "<svg><g id='a'><line stroke='red' x2='1'/><use href='#a'/></g>"
      "<g id='b'><use href='#c'/></g><g id='c'><use href='#b'/></g>"
      "<use id='u' href='#u'/></svg>");
  CHECK(read.curves.curves.size() == 1);
  REQUIRE(read.warnings.size() == 1);
  CHECK_THAT(read.warnings[0], Catch::Contains("4 use elements are left out, which are part of"));
}

TEST_CASE("a drawing that grows without bounds is refused in one line") {
  std::string bomb = "<svg><g id='a0'><line stroke='red' x2='1'/></g>";
  for (int i = 1; i < 40; ++i) {
    const std::string use = "<use href='#a" + std::to_string(i - 1) + "'/>";
    bomb += "<g id='a" + std::to_string(i) + "'>" + use + use + "</g>";
  }
  const auto grown = read_drawing(bomb + "</svg>");
  REQUIRE_FALSE(grown.has_value());
  CHECK(grown.error().code == ErrorCode::bad_input);
  CHECK_THAT(grown.error().text, Catch::Contains("more than 1000000 elements"));

  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  for (int i = 0; i < 100000; ++i) deep += "</g>";
  const auto nested = read_drawing("<svg>" + deep + "</svg>");
  REQUIRE_FALSE(nested.has_value());
  CHECK_THAT(nested.error().text, Catch::Contains("nested too deeply"));

  // Entities are not expanded, however they are defined.
  const SvgDrawing laughs = good_drawing(
      "<!DOCTYPE svg [<!ENTITY a 'M0 0'><!ENTITY b '&a;&a;'>]>\n<svg><path d='&b;L1 1'/><line stroke='red' "
      "x2='1'/></svg>");
  CHECK(laughs.curves.curves.size() == 1);
  CHECK(laughs.warnings.size() == 1);
}

TEST_CASE("a drawing may have as many pieces as its file spells out") {
  constexpr std::size_t kSteps = 2'100'000;
  std::string path = "M0 0";
  for (std::size_t i = 0; i < kSteps; ++i) path += "h1v1";
  const SvgDrawing read = good_drawing("<svg><path fill='none' stroke='red' d='" + path + "'/></svg>");
  REQUIRE(read.curves.curves.size() == 1);
  CHECK(read.curves.curves[0].piece_count() >= 2 * kSteps);
}

TEST_CASE("a drawing is found by its content, and gives samples with their curves") {
  const std::string text =
      "\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- a > b -->\n"
      "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'svg11.dtd'>\n" +
      drawing("<circle cx='50' cy='60' r='30'/><path fill='none' stroke='red' d='M0 0L100 0'/>");
  const auto read = read_sample_bytes(text, "a.txt");
  REQUIRE(read.has_value());
  CHECK(read->format == "svg");
  REQUIRE(read->data.contours.size() == 2);
  CHECK(read->data.contours[0].closed);
  CHECK_FALSE(read->data.contours[1].closed);
  CHECK(read->data.positions.size() <= 410);
  CHECK(read->data.positions.size() >= 395);
  for (const std::uint32_t i : read->data.contours[0].points)
    CHECK(distance(read->data.positions[i], {50, 40}) == Approx(30).epsilon(1e-12));
  for (const std::uint32_t i : read->data.contours[1].points) CHECK(read->data.positions[i].y == 100);
  const double each = 2 * kPi * 30 / static_cast<double>(read->data.contours[0].points.size());
  CHECK(each == Approx((2 * kPi * 30 + 100) / 400).epsilon(0.02));
}

TEST_CASE("a drawing has the unit of its page, and a number of the file is a number of the plane") {
  const auto read = [](const std::string& attributes, const std::string& content) {
    return good_drawing(R"(<svg xmlns="http://www.w3.org/2000/svg" )" + attributes + ">" + content + "</svg>");
  };
  const std::string square = "<path fill='none' stroke='red' d='M10.1 20 H30.3 V70'/>";
  const auto corners_of = [](const SvgDrawing& drawing) {
    REQUIRE(drawing.curves.curves.size() == 1);
    std::vector<Vec2> out{drawing.curves.curves[0].start()};
    drawing.curves.curves[0].for_each_piece([&](const Piece& piece) { out.push_back(piece.to()); });
    return out;
  };
  const std::vector<Vec2> as_written{{10.1, 80.0}, {30.3, 80.0}, {30.3, 30.0}};
  for (const char* unit : {"mm", "cm", "in", "pt"}) {
    INFO(unit);
    const std::string page = std::string("width='200") + unit + "' height='100" + unit + "'";
    const SvgDrawing same = read(page + " viewBox='0 0 200 100'", square);
    CHECK(same.unit == unit);
    CHECK(corners_of(same) == as_written);
    // Half as many units in the view box.
    const SvgDrawing larger = read(page + " viewBox='0 0 100 50'", "<path stroke='red' d='M1 1 L2 1'/>");
    CHECK(corners_of(larger) == std::vector<Vec2>{{2.0, 98.0}, {4.0, 98.0}});
  }
  // Without a view box a number is a pixel, and a length with its unit is a length.
  const SvgDrawing plain =
      read("width='200mm' height='100mm'", "<line stroke='red' x1='10mm' y1='0' x2='96' y2='0'/>");
  CHECK(plain.unit == "mm");
  const std::vector<Vec2> ends = corners_of(plain);
  CHECK(distance(ends[0], {10.0, 100.0}) < 1e-12);
  CHECK(distance(ends[1], {25.4, 100.0}) < 1e-12);
  for (const char* page : {"width='200' height='100'", "width='200px' height='100px'", "width='200mm'",
                           "width='200mm' height='10cm'", "width='100%' height='100%'", "viewBox='0 0 200 100'",
                           "width='200mm' height='100mm' style='width:200px;height:100px'"}) {
    INFO(page);
    CHECK(read(page, square).unit == "px");
  }
  const auto file = read_sample_bytes(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="8cm" height="8cm" viewBox="0 0 8 8"><circle r="3"/></svg>)",
      "a");
  REQUIRE(file);
  CHECK(file->data.map == MapPlane{.unit = "cm", .page = {8.0, 8.0}});
}
