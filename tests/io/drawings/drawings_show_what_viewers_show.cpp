// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: what is hidden, cut or not painted is not read, and what is left out is said. Drawings are 100 wide and high, and
// their y points down.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/curves/clip_region.h"
#include "core/curves/curve_bounds.h"
#include "core/io/svg/svg_drawing.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::kPi;

namespace {

SvgDrawing drawing_shown(const std::string& content, const std::string& attributes = "") {
  ReadJob job;
  auto read = read_svg_drawing(
      "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100' " + attributes + ">" + content + "</svg>",
      "a.svg", job);
  INFO((read ? std::string() : read.error().message()));
  REQUIRE(read.has_value());
  return *std::move(read);
}

/// The ids of the curves that are read.
std::string seen(const std::string& content) {
  std::string out;
  for (const PlaneCurve& curve : drawing_shown(content).curves.curves) out += curve.name;
  return out;
}

/// A square with an id, one unit large.
std::string square(const std::string& id, const std::string& attributes = "") {
  return "<rect id='" + id + "' width='1' height='1' " + attributes + "/>";
}

std::vector<std::string> warnings_of(const std::string& content) {
  return drawing_shown(content).warnings;
}

/// Of curves that are closed, holes counted as they turn.
double area_of(const std::vector<PlaneCurve>& curves) {
  double twice = 0.0;
  for (const PlaneCurve& curve : curves)
    curve.for_each_piece([&](const Piece& piece) {
      constexpr int kSteps = 2000;
      const int steps = piece.kind == PieceKind::line ? 1 : kSteps;
      for (int i = 0; i < steps; ++i)
        twice += cross(piece.at(static_cast<double>(i) / steps), piece.at(static_cast<double>(i + 1) / steps));
    });
  return std::abs(0.5 * twice);
}

std::vector<PlaneCurve> curves_shown(const std::string& content) {
  return drawing_shown(content).curves.curves;
}

Box2 box_shown(const std::string& content) {
  const Box2 box = bounds_of(curves_shown(content));
  return {{box.low.x, 100.0 - box.high.y}, {box.high.x, 100.0 - box.low.y}};
}

void require_box(const std::string& content, Vec2 low, Vec2 high) {
  INFO(content);
  const Box2 box = box_shown(content);
  CHECK(distance(box.low, low) < 1e-9);
  CHECK(distance(box.high, high) < 1e-9);
}

const std::string kDisk = "<clipPath id='c'><circle cx='50' cy='50' r='10'/></clipPath>";

}  // namespace

TEST_CASE("style sheets hide what their selectors choose") {
  const auto is_hidden = [](const std::string& selector) {
    INFO(selector);
    return seen("<style>" + selector + "{display:none}</style><g id='g' class='layer top'>" +
                square("a", "class='off x-1' data-name='under side' lang='en-GB'") + "</g>")
        .empty();
  };
  // Of a rectangle within a group.
  for (const char* selector : {"rect",
                               "*",
                               ".off",
                               "#a",
                               "rect.off",
                               "rect#a.off",
                               ".off.x-1",
                               "g rect",
                               "g > rect",
                               "svg g > .off",
                               "* rect",
                               ".layer.top rect",
                               "circle, .off",
                               "[class]",
                               "[data-name]",
                               "[data-name='under side']",
                               "[data-name~=side]",
                               "[data-name^=\"un\"]",
                               "[data-name$='de']",
                               "[data-name*='r s']",
                               "[lang|=en]",
                               "[ID=a]:not(x), [id=a]",
                               "[data-name='UNDER SIDE' i]",
                               "rect:first-child",
                               ":last-child.off",
                               "rect:nth-child(2n+1)",
                               "g:not(.bottom)>*",
                               ":is(circle, rect)",
                               ":where(#a)",
                               "svg|rect",
                               "*|rect",
                               "#\\61",
                               "g",
                               "svg:root rect",
                               "rect:only-child"})
    CHECK(is_hidden(selector));
  for (const char* selector : {"circle", ".of", ".offx", "#b", "rect > rect", "svg > rect", "g + rect", "g ~ rect",
                               "rect g", "[data-name=under]", "[lang|=en-G]", "rect:hover", "rect:nth-child(2)",
                               ":not(rect, g, svg)", "rect::before", "RECT", ".OFF", "rect:not(.off)", ".layer .top"})
    CHECK_FALSE(is_hidden(selector));
  CHECK(seen("<style>#a + rect {display:none} #b ~ #d {display:none}</style>" + square("a") + square("b") +
             square("c") + square("d")) == "ac");
}

TEST_CASE("of declarations the weightier one wins, then the later") {
  const auto is_seen = [](const std::string& sheet, const std::string& attributes = "") {
    INFO(sheet << " " << attributes);
    return seen("<style>" + sheet + "</style>" + square("a", "class='k' " + attributes)) == "a";
  };
  const std::string hide = "{display:none}";
  const std::string show = "{display:inline}";
  CHECK(is_seen("rect" + hide + "rect" + show));
  CHECK_FALSE(is_seen("rect" + show + "rect" + hide));
  CHECK(is_seen(".k" + show + "rect" + hide));
  CHECK(is_seen("#a" + show + ".k.k.k" + hide));
  CHECK_FALSE(is_seen("#a" + hide, "display='inline'"));
  CHECK(is_seen("*" + show, "display='none'"));
  CHECK(is_seen("#a" + hide, "style='display:inline'"));
  CHECK_FALSE(is_seen("rect{display:none!important}", "style='display:inline'"));
  CHECK(is_seen("#a{display:none ! IMPORTANT}", "style='display:inline !important'"));
  CHECK_FALSE(is_seen("rect{display:none !important} #a{display:inline}"));
  CHECK(is_seen("rect{display:none; display:inline}"));
  CHECK_FALSE(is_seen("rect{display:none; display:nothing}"));
  CHECK(is_seen("rect{display:none !urgent}"));
  CHECK_FALSE(is_seen("rect{DISPLAY:None}"));
  CHECK_FALSE(is_seen("", "style='color:red;display:none'"));
  CHECK_FALSE(is_seen("", "style='/* ; */ display : /**/ none'"));
  CHECK_FALSE(is_seen("/* rect{} */ rect/**/{ /* display:inline; */ display:none }"));
  CHECK_FALSE(is_seen("rect{a:'}';b:url(x;y});display:none}"));
  CHECK_FALSE(is_seen("<![CDATA[ g > p, rect{display:none} ]]>"));
  CHECK(is_seen("<!-- rect{display:none} -->"));
  CHECK_FALSE(is_seen("rect{display:none"));
}

TEST_CASE("rules under conditions hold where a screen is meant, and are said where they may hold") {
  const std::string hide = "rect{display:none}";
  const auto read = [&](const std::string& sheet) {
    return drawing_shown("<style>" + sheet + "</style>" + square("a"));
  };
  CHECK(read("@media screen{" + hide + "}").curves.is_empty());
  CHECK(read("@media print, all{" + hide + "}").curves.is_empty());
  CHECK(read("@charset 'utf-8'; @font-face{src:url(a)} @namespace svg url(x); " + hide).curves.is_empty());
  CHECK(read("@media print{" + hide + "}").warnings.empty());
  CHECK_FALSE(read("@media print{" + hide + "}").curves.is_empty());
  for (const std::string condition : {"@media (max-width:10px)", "@supports (display:grid)", "@layer a"}) {
    const SvgDrawing drawing = read(condition + "{" + hide + "}");
    CHECK_FALSE(drawing.curves.is_empty());
    REQUIRE(drawing.warnings.size() == 1);
    CHECK_THAT(drawing.warnings[0], Catch::Contains("1 part of a style sheet is left out"));
  }
  // Words of the file that are not text stay printable.
  CHECK_THAT(read("@m\xff"
                  "dia x{" +
                  hide + "}")
                 .warnings.at(0),
             Catch::EndsWith("(@m\\xffdia)"));
  CHECK(read("@media (max-width:10px){rect{color:red}}").warnings.empty());
  CHECK_THAT(read("@import 'a.css';").warnings.at(0), Catch::Contains("of another file is not read"));
  CHECK_THAT(read("rect:nth-of-type(2 of x){display:none}").warnings.at(0),
             Catch::Contains("selector is not understood"));
  CHECK(warnings_of("<style media='print'>rect{display:none}</style>" + square("a")).empty());
  CHECK(seen("<style media='screen' type='text/css'>rect{display:none}</style>" + square("a")).empty());
  CHECK_THAT(warnings_of("<style type='text/less'>rect{display:none}</style>" + square("a")).at(0),
             Catch::Contains("not CSS"));
  ReadJob job;
  const auto outside =
      read_svg_drawing("<?xml-stylesheet href='a.css'?><svg><rect width='1' height='1'/></svg>", "a", job);
  REQUIRE(outside.has_value());
  CHECK_THAT(outside->warnings.at(0), Catch::Contains("of another file is not read"));
}

TEST_CASE("what is hidden is left out, with all that a viewer hides with it, and is said") {
  for (const std::string hidden :
       {"display='none'", "style='display:none'", "opacity='0'", "style='opacity:0%'", "visibility='hidden'",
        "style='visibility:collapse'", "style='color: red; display : none'"}) {
    INFO(hidden);
    CHECK(seen("<g " + hidden + "><g>" + square("a") + "</g></g>").empty());
    CHECK(seen(square("a", hidden) + square("b")) == "b");
    CHECK(warnings_of(square("b") + square("a", hidden)) ==
          std::vector<std::string>{"a.svg:1:" + std::to_string(square("b").size() + 67) +
                                   ": 1 hidden element is left out"});
  }
  // What is hidden by visibility may be turned visible again, and nothing else.
  CHECK(seen("<g visibility='hidden'>" + square("a") + square("b", "visibility='visible'") + "</g>") == "b");
  CHECK(seen("<g display='none'>" + square("a", "display='inline'") + "</g>").empty());
  CHECK(seen("<g opacity='0'>" + square("a", "opacity='1'") + "</g>").empty());
  CHECK(seen("<g visibility='hidden'><g visibility='inherit'>" + square("a") + "</g></g>").empty());
  CHECK(seen("<g visibility='hidden'><g style='visibility:initial'>" + square("a") + "</g></g>") == "a");
  CHECK(seen(square("a", "opacity='0.01'") + square("b", "display='bock'") + square("c", "visibility='shown'")) ==
        "abc");
  CHECK_THAT(
      warnings_of("<g display='none'>" + square("a") + "</g>" + square("b", "opacity='0'") + square("c")).at(0),
      Catch::Contains("2 hidden elements are left out"));
  // What `use` draws inherits from it, and has the rules of where it stands.
  CHECK(seen("<defs>" + square("a") + "</defs><use href='#a' visibility='hidden'/>").empty());
  CHECK(seen("<style>g rect{display:none}</style><defs>" + square("a") + "</defs><g><use href='#a'/></g>") == "a");
}

TEST_CASE("what is neither filled nor stroked is left out") {
  const auto is_seen = [](const std::string& attributes, const std::string& around = "") {
    INFO(attributes << " in " << around);
    return seen("<linearGradient id='shade'/><g " + around + ">" + square("a", attributes) + "</g>") == "a";
  };
  for (const std::string none :
       {"fill='none'", "style='fill:none'", "fill='transparent'", "fill-opacity='0'", "fill='#1230'",
        "fill='#11223300'", "fill='rgba(1,2,3,0)'", "fill='rgb(1 2 3 / 0%)'", "fill='url(#nowhere)'",
        "fill='none' stroke='red' stroke-width='0'", "fill='none' stroke='red' stroke-opacity='0'",
        "fill='none' stroke='none'", "fill='NONE'"})
    CHECK_FALSE(is_seen(none));
  for (const std::string some :
       {"fill='red'", "fill='none' stroke='red'", "fill='url(#shade)'", "fill='url(#nowhere) red'", "fill='#1234'",
        "fill='rgba(0,0,0,.1)'", "fill-opacity='0' stroke='red'", "fill='none' stroke='currentColor'"})
    CHECK(is_seen(some));
  CHECK_FALSE(is_seen("", "fill='none'"));
  CHECK(is_seen("", "fill='none' stroke='red'"));
  CHECK(is_seen("fill='initial'", "fill='none'"));
  CHECK_FALSE(is_seen("fill='inherit'", "fill='none'"));
  CHECK(seen("<line id='a' x2='9'/><line id='b' x2='9' stroke='red'/>") == "b");
  CHECK_THAT(warnings_of(square("a", "fill='none'") + square("b")).at(0),
             Catch::Contains("1 shape is left out, which is neither filled nor stroked"));
}

TEST_CASE("a shape that overlaps itself is what its fill rule fills, and this is said") {
  const std::string two = "d='M10 10H60V60H10Z M40 40H90V90H40Z'";
  CHECK(area_of(curves_shown("<path id='a' " + two + "/>")) == Approx(4600));
  CHECK(seen("<path id='a' " + two + "/>") == "a");
  CHECK(warnings_of("<path " + two + "/>") ==
        std::vector<std::string>{"a.svg:1:67: 1 shape overlaps itself, and is read as the boundary of its area"});
  CHECK(seen("<path id='a' fill-rule='evenodd' " + two + "/>") == "aa");
  CHECK(warnings_of("<g style='fill-rule: evenodd'><path " + two + "/></g>").empty());
  CHECK(seen("<path id='a' fill='none' stroke='red' " + two + "/>") == "aa");
  // A square within another one is a hole only if it goes around the other way.
  CHECK(seen("<path id='a' d='M10 10H90V90H10Z M30 30H60V60H30Z'/>") == "a");
  CHECK(seen("<path id='a' d='M10 10H90V90H10Z M30 30V60H60V30Z'/>") == "aa");
  // Even where a clip path cuts it.
  CHECK(area_of(curves_shown("<clipPath id='c'><rect width='100' height='50'/></clipPath>"
                             "<path clip-path='url(#c)' " +
                             two + "/>")) == Approx(2300));
}

TEST_CASE("a switch shows the first alternative that a viewer takes") {
  CHECK(seen("<switch>" + square("a", "requiredExtensions='x'") + square("b") + square("c") + "</switch>") == "b");
  CHECK(seen("<switch><desc/>" + square("a", "systemLanguage='de, fr'") + square("b", "systemLanguage='de, en-US'") +
             square("c") + "</switch>") == "b");
  CHECK(seen(square("a", "requiredExtensions='x'") + square("b", "systemLanguage='de'") + square("c")) == "c");
}

TEST_CASE("a clip path cuts areas to what it encloses, and keeps the pieces of both curves") {
  const std::vector<PlaneCurve> disk =
      curves_shown(kDisk + "<g clip-path='url(#c)'><rect x='30' y='30' width='40' height='40'/></g>");
  REQUIRE(disk.size() == 1);
  CHECK(disk[0].is_closed());
  for (const PieceKind kind : disk[0].kinds()) CHECK(kind == PieceKind::arc);
  disk[0].for_each_piece([&](const Piece& piece) {
    for (const double t : {0.0, 0.3, 0.7}) CHECK(distance(piece.at(t), {50, 50}) == Approx(10).epsilon(1e-12));
  });
  CHECK(area_of(disk) == Approx(100 * kPi).epsilon(1e-5));
  // A quarter: an arc and two lines, which meet where they should.
  const std::vector<PlaneCurve> quarter =
      curves_shown(kDisk + "<rect x='50' y='50' width='40' height='40' clip-path='url(#c)'/>");
  REQUIRE(quarter.size() == 1);
  CHECK(quarter[0].piece_count() == 3);
  CHECK(quarter[0].arcs().size() == 1);
  for (const Vec2 corner : {Vec2{50, 50}, Vec2{60, 50}, Vec2{50, 40}})
    CHECK(std::ranges::any_of(quarter[0].points(), [&](Vec2 p) { return distance(p, corner) < 1e-12; }));
  CHECK(area_of(quarter) == Approx(25 * kPi).epsilon(1e-5));
}

TEST_CASE("a clip path of thousands of disks, whose polygons are coarser, still cuts along its arcs") {
  constexpr int kRow = 50;
  std::string clip = "<clipPath id='c'>";
  for (int i = 0; i < kRow * kRow; ++i)
    clip += "<circle r='.7' cx='" + std::to_string(2 * (i % kRow) + 1) + "' cy='" +
            std::to_string(2 * (i / kRow) + 1) + "'/>";
  const std::vector<PlaneCurve> disks =
      curves_shown(clip + "</clipPath><rect clip-path='url(#c)' width='99' height='100'/>");
  REQUIRE(disks.size() == kRow * kRow);
  int cut = 0;
  for (const PlaneCurve& disk : disks) {
    CHECK(disk.is_closed());
    const Vec2 at = disk.start();
    const Vec2 center{2.0 * std::floor(0.5 * at.x) + 1.0, 2.0 * std::floor(0.5 * at.y) + 1.0};
    disk.for_each_piece([&](const Piece& piece) {
      cut += piece.kind == PieceKind::line ? 1 : 0;
      for (const double t : {0.0, 0.3, 0.7})
        CHECK((piece.kind == PieceKind::line ? piece.at(t).x : distance(piece.at(t), center)) ==
              Approx(piece.kind == PieceKind::line ? 99.0 : 0.7).epsilon(1e-9));
    });
  }
  CHECK(cut == kRow);  // the last column is cut in half
}

TEST_CASE("what no clip path cuts is what it was, to the last bit") {
  const std::string inside =
      "<path id='a' d='M47 47C48 40 55 52 52 55S46 54 47 47zM49 50a1 1 0 002 0 1 1 0 00-2 0z'/>"
      "<ellipse id='b' cx='51' cy='49' rx='3' ry='2'/><path fill='none' stroke='red' d='M45 45Q50 55 55 46'/>";
  CHECK(curves_shown(kDisk + "<g clip-path='url(#c)'>" + inside + "</g>") == curves_shown(inside));
  CHECK(warnings_of(kDisk + "<g clip-path='url(#c)'>" + inside + "</g>").empty());
  // One part of a path is cut, the other is not.
  const std::vector<PlaneCurve> both = curves_shown(
      kDisk + "<path clip-path='url(#c)' d='M45 45h2v2h-2zM50 50a2 2 0 004 0 2 2 0 00-4 0zM55 40h20v20h-20z'/>");
  REQUIRE(both.size() == 3);
  CHECK(std::ranges::count_if(both, [](const PlaneCurve& curve) {
          return curve.arcs().size() == 2 && std::abs(curve.arcs()[0].sweep) == kPi;
        }) == 1);
  // The same curve as clip path and as shape.
  const std::string egg = "d='M40 50C40 30 60 30 60 50S40 70 40 50z'";
  CHECK(curves_shown("<clipPath id='e'><path " + egg + "/></clipPath><path clip-path='url(#e)' " + egg + "/>") ==
        curves_shown("<path " + egg + "/>"));
}

TEST_CASE("lines are cut where they leave their clip path, and go on over their start") {
  const std::string stroke = "fill='none' stroke='red' clip-path='url(#c)'";
  const std::vector<PlaneCurve> line = curves_shown(kDisk + "<path " + stroke + " d='M0 50H100M0 44H100M0 5H9'/>");
  REQUIRE(line.size() == 2);
  CHECK(distance(line[0].start(), {40, 50}) < 1e-12);
  CHECK(distance(line[0].end(), {60, 50}) < 1e-12);
  CHECK(distance(line[1].start(), {42, 56}) < 1e-12);
  const std::vector<PlaneCurve> round =
      curves_shown(kDisk + "<rect " + stroke + " x='50' y='50' width='40' height='40'/>");
  REQUIRE(round.size() == 1);
  CHECK_FALSE(round[0].is_closed());
  CHECK(round[0].piece_count() == 2);
  CHECK(std::ranges::any_of(round[0].points(), [](Vec2 p) { return p == Vec2{50, 50}; }));
  // Along its boundary a line is seen.
  const std::string box = "x='40' y='40' width='20' height='10'";
  const std::string frame = "<rect " + box + " fill='none' stroke='red'";
  CHECK(curves_shown("<clipPath id='r'><rect " + box + "/></clipPath>" + frame + " clip-path='url(#r)'/>") ==
        curves_shown(frame + "/>"));
}

TEST_CASE("clip paths have rules, transforms, boxes and clip paths of their own") {
  const std::string page = "<rect id='a' x='10' y='10' width='80' height='80' clip-path='url(#c)'/>";
  const auto area = [&](const std::string& clip, const std::string& shape) {
    return area_of(curves_shown(clip + shape));
  };
  require_box(
      "<clipPath id='c' transform='translate(20 30)'><rect width='5' height='6' transform='scale(2)'/></clipPath>" +
          page,
      {20, 30}, {30, 42});
  require_box(
      "<clipPath id='c'><rect width='5' height='6'/></clipPath><g transform='translate(40 40)'>"
      "<rect x='-9' y='-9' width='20' height='20' transform='scale(2)' clip-path='url(#c)'/></g>",
      {40, 40}, {50, 52});
  require_box(
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect x='.25' width='.5' height='.5'/></clipPath>" + page,
      {30, 10}, {70, 50});
  require_box(
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.75' height='1'/></clipPath>"
      "<g clip-path='url(#c)' transform='translate(5 0)'><rect x='10' y='20' width='10' height='10'/>"
      "<rect x='40' y='20' width='30' height='40' display='inline'/><rect display='none' width='90' height='9'/></g>",
      {15, 20}, {60, 60});
  // Two squares in each other, the same way round.
  const std::string ring = "d='M20 20h40v40h-40zM30 30h20v20h-20z'";
  CHECK(area("<clipPath id='c'><path " + ring + " clip-rule='evenodd'/></clipPath>", page) == Approx(1200));
  CHECK(area("<clipPath id='c'><path " + ring + "/></clipPath>", page) == Approx(1600));
  CHECK(area("<g clip-rule='evenodd'><clipPath id='c'><path " + ring + "/></clipPath></g>", page) == Approx(1200));
  CHECK(area("<clipPath id='c'><rect width='40' height='90'/></clipPath>",
             "<path " + ring + " fill-rule='evenodd' clip-path='url(#c)'/>") == Approx(600));
  // Several shapes, which need not turn the same way, are one.
  CHECK(area("<clipPath id='c'><path d='M20 20h20v20h-20z'/><path d='M30 20v20h20v-20z'/></clipPath>", page) ==
        Approx(600));
  // Clip paths of a clip path, of its children, and of several groups.
  const std::string left = "<clipPath id='l'><rect width='50' height='100'/></clipPath>";
  CHECK(area(left + "<clipPath id='c' clip-path='url(#l)'><rect x='40' y='40' width='20' height='20'/></clipPath>",
             page) == Approx(200));
  CHECK(area(left + "<clipPath id='c'><rect x='40' y='40' width='20' height='20' clip-path='url(#l)'/>"
                    "<rect x='70' y='70' width='5' height='5'/></clipPath>",
             page) == Approx(225));
  CHECK(area(left + kDisk,
             "<g clip-path='url(#l)'><g><g clip-path='url(#c)'><rect width='100' height='100'/></g></g></g>") ==
        Approx(50 * kPi).epsilon(1e-5));
  CHECK(area("<defs><rect id='r' width='10' height='10'/></defs><clipPath id='c'><use href='#r' x='20' y='20'/>"
             "<use href='#r' transform='translate(50 50)'/></clipPath>",
             page) == Approx(200));
  CHECK(area("<style>.c{clip-path:url(\"#c\")}</style>" + left +
                 "<clipPath id='c'><rect width='50' height='100'/></clipPath>",
             "<rect class='c' width='60' height='10'/>") == Approx(500));
}

TEST_CASE("what is not seen within a clip path clips nothing in") {
  const auto is_seen = [](const std::string& content) {
    return seen("<clipPath id='c'>" + content + "</clipPath>" + square("a", "clip-path='url(#c)'")) == "a";
  };
  const std::string all = "<rect width='100' height='100' ";
  CHECK(is_seen(all + "/>"));
  CHECK(is_seen(all + "fill='none' opacity='0'/>"));
  CHECK_FALSE(is_seen(""));
  CHECK_FALSE(is_seen(all + "display='none'/>"));
  CHECK_FALSE(is_seen(all + "visibility='hidden'/>"));
  CHECK_FALSE(is_seen("<g>" + all + "/></g>"));
  CHECK_FALSE(is_seen("<line x2='100' y2='100' stroke='red'/>"));
  CHECK_FALSE(is_seen("<rect x='50' width='9' height='9'/>"));
  CHECK_THAT(warnings_of("<clipPath id='c'/>" + square("a", "clip-path='url(#c)'") + square("b")).at(0),
             Catch::Contains("1 shape is left out, which its clip path hides"));
}

TEST_CASE("clip paths that cross themselves by the million are not computed") {
  const auto clip_path = [](int lines) {
    std::string path = "<clipPath id='c'><path d='M0 0";
    // As chords of a star, each of which crosses nearly all others.
    for (int i = 1; i < lines; ++i)
      path += " L" + std::to_string(50.0 + 50.0 * std::cos(2.0 * i)) + " " +
              std::to_string(50.0 + 50.0 * std::sin(2.0 * i));
    return path + "Z'/></clipPath>";
  };
  CHECK(seen(clip_path(60) + square("a", "transform='scale(100)' clip-path='url(#c)'")) != "");
  CHECK_THAT(drawing_shown(clip_path(20000) + square("a", "clip-path='url(#c)'") + square("b")).warnings,
             Catch::Matchers::VectorContains(std::string(
                 "a.svg:1:84: 1 shape in a clip path is left out, which is too large or crosses itself too often")));
  std::string many = clip_path(1000);
  for (int i = 0; i < 1000; ++i) many += "<rect x='1' y='1' width='98' height='98' clip-path='url(#c)'/>";
  ReadJob job;
  const auto read = read_svg_drawing(
      "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>" + many + "</svg>", "a.svg", job);
  REQUIRE_FALSE(read.has_value());
  CHECK_THAT(read.error().message(), Catch::Contains("clip paths cross themselves and the shapes too often"));
}

TEST_CASE("clip paths and masks that are not applied are said") {
  const auto warning = [](const std::string& content, const std::string& attributes) {
    const SvgDrawing read = drawing_shown(content + square("a", attributes));
    CHECK(read.curves.curves.size() == 1);
    REQUIRE(read.warnings.size() == 1);
    return read.warnings[0];
  };
  CHECK_THAT(warning("", "clip-path='url(#no)'"),
             Catch::Contains("1 clip path is not applied, which is not in this file"));
  CHECK_THAT(warning("", "clip-path='url(other.svg#c)'"), Catch::Contains("not in this file"));
  CHECK_THAT(warning("", "style='clip-path: circle(40%)'"), Catch::Contains("which is not that of an element"));
  CHECK_THAT(
      warning("<clipPath id='c' clip-path='url(#c)'><rect width='9' height='9'/></clipPath>", "clip-path='url(#c)'"),
      Catch::Contains("which refers to itself"));
  const auto chain = [](int count) {
    std::string out;
    for (int i = 0; i < count; ++i)
      out += "<clipPath id='c" + std::to_string(i) + "' clip-path='" +
             (i == 0 ? "none" : "url(#c" + std::to_string(i - 1) + ")") +
             "'><rect width='99' height='99'/></clipPath>";
    return out;
  };
  CHECK_THAT(warning(chain(3000), "clip-path='url(#c2999)'"),
             Catch::Contains("1 clip path is not applied, which is at the end of a chain of more than 32"));
  CHECK(warnings_of(chain(32) + square("a", "clip-path='url(#c31)'")).empty());
  CHECK_THAT(warning("<clipPath id='c'><rect width='9' height='9'/><text>a</text></clipPath>", "clip-path='url(#c)'"),
             Catch::Contains("1 text element in a clip path is left out"));
  CHECK_THAT(warning("<mask id='m'><rect width='9' height='9'/></mask>", "mask='url(#m)'"),
             Catch::Contains("1 mask is not applied; what it hides is read"));
  CHECK_THAT(warning("<mask id='m'/><style>rect{mask:url(#m)}</style>", ""),
             Catch::Contains("1 mask is not applied"));
  CHECK_THAT(warning("<pattern id='p'><rect width='9' height='9'/></pattern>", "fill='url(#p)'"),
             Catch::Contains("1 pattern that fills a shape is left out"));
  CHECK(warnings_of(square("a", "clip-path='none' mask='none'")).empty());
  CHECK_THAT(warnings_of("<marker id='m'><rect width='9' height='9'/></marker>"
                         "<path stroke='red' d='M0 0L9 9' marker-end='url(#m)'/>")
                 .at(0),
             Catch::Contains("1 shape has markers, which are left out"));
}

TEST_CASE("viewports within a drawing cut what goes beyond them, unless they are open") {
  const std::string large = "<rect x='-50' y='-50' width='100' height='100'/>";
  require_box("<svg x='10' y='20' width='30' height='40'>" + large + "</svg>", {10, 20}, {40, 60});
  require_box("<svg x='10' y='20' width='30' height='40' overflow='visible'>" + large + "</svg>", {-40, -30},
              {60, 70});
  require_box("<svg x='10' y='20' width='30' height='40' style='overflow:visible'>" + large + "</svg>", {-40, -30},
              {60, 70});
  require_box(
      "<symbol id='s' viewBox='0 0 10 10'>" + large + "</symbol><use href='#s' x='5' y='5' width='20' height='20'/>",
      {5, 5}, {25, 25});
  require_box("<svg width='30' height='40' viewBox='0 0 3 4'><rect width='1' height='1'/></svg>", {0, 0}, {10, 10});
  // The page itself cuts nothing: what lies outside it is said.
  const SvgDrawing off = drawing_shown("<rect x='-9' y='3' width='5' height='5'/><circle r='9'/>");
  CHECK(off.curves.curves.size() == 2);
  CHECK_THAT(off.warnings.at(0), Catch::Contains("1 shape lies outside the page, and is read"));
}

TEST_CASE("transforms of style sheets are those of attributes, with units and an origin") {
  require_box("<style>rect{transform:translate(10px,20px) scale(2)}</style><rect width='5' height='5'/>", {10, 20},
              {20, 30});
  require_box("<rect width='5' height='5' style='transform:rotate(.25turn);transform-origin:10px 10px'/>", {15, 0},
              {20, 5});
  require_box("<style>circle{r:5px;cx:20}</style><circle cy='30' r='1'/>", {15, 25}, {25, 35});
}

TEST_CASE("style sheets and clip paths that ask for too much are refused in one line") {
  const auto refusal = [](const std::string& content) {
    ReadJob job;
    const auto read = read_svg_drawing("<svg>" + content + "</svg>", "a.svg", job);
    REQUIRE_FALSE(read.has_value());
    CHECK(read.error().code == ErrorCode::bad_input);
    return read.error().text;
  };
  std::string selector;
  for (int i = 0; i < 30; ++i) selector += "* ";
  std::string deep;
  for (int i = 0; i < 150; ++i) deep += "<g>";
  std::string ends;
  for (int i = 0; i < 150; ++i) ends += "</g>";
  CHECK_THAT(refusal("<style>x " + selector + "rect{display:none}</style>" + deep + square("a") + ends),
             Catch::Contains("too involved"));
  std::string clip = "<clipPath id='c'>";
  for (int i = 0; i < 200; ++i) clip += "<rect width='1' height='1'/>";
  std::string shapes;
  for (int i = 0; i < 1000; ++i)
    shapes += "<rect width='1' height='1' transform='translate(" + std::to_string(i) + ")' clip-path='url(#c)'/>";
  CHECK_THAT(refusal(clip + "</clipPath>" + shapes), Catch::Contains("more than 100000 elements"));
}
