// SPDX-License-Identifier: GPL-3.0-or-later
// DXF and Ipe. Lengths and areas of samples are compared with those of the shapes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/base/geometry/box2.h"
#include "core/document/curve_source.h"
#include "core/io/format.h"
#include "tests/io/checked_reading.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::check_refused;
using mes::test::kPi;

namespace {

LoadedFile read_cad(std::string_view bytes) {
  auto read = read_sample_bytes(bytes, "a");
  INFO((read ? std::string() : read.error().message()));
  REQUIRE(read.has_value());
  return *std::move(read);
}

/// "0 LINE 10 1.5" as lines.
std::string entities(const std::string& words) {
  std::string out = "  0\nSECTION\n  2\nENTITIES\n";
  for (const char c : words) out += c == ' ' ? '\n' : c;
  return out + "\n0\nENDSEC\n0\nEOF\n";
}

double length_of(const SampleData& data) {
  double out = 0.0;
  for (const auto& contour : data.contours)
    for (std::size_t i = 0; i + (contour.closed ? 0 : 1) < contour.points.size(); ++i)
      out += distance(data.positions[contour.points[i]],
                      data.positions[contour.points[(i + 1) % contour.points.size()]]);
  return out;
}

Box2 box_of(const SampleData& data) {
  Box2 out;
  for (const Vec2 p : data.positions) out.add(p);
  return out;
}

std::string ipe(const std::string& objects) {
  return "<?xml version=\"1.0\"?>\n<!DOCTYPE ipe SYSTEM \"ipe.dtd\">\n<ipe "
         "version=\"70218\">\n<ipestyle/>\n<page>\n" +
         objects + "\n</page>\n</ipe>\n";
}
std::string ipe_path(const std::string& operators) {
  return "<path stroke=\"black\">\n" + operators + "\n</path>";
}

}  // namespace

TEST_CASE("each entity of DXF is the curve that it says") {
  const LoadedFile circle = read_cad(entities("0 CIRCLE 8 0 10 3 20 4 40 2"));
  CHECK(circle.format == "dxf");
  CHECK(length_of(circle.data) == Approx(4 * kPi).epsilon(1e-3));
  for (const Vec2 p : circle.data.positions) CHECK(distance(p, {3, 4}) == Approx(2.0).epsilon(1e-12));
  REQUIRE(circle.data.contours.size() == 1);
  CHECK(circle.data.contours[0].closed);

  // From 350 to 80 degrees, through the right.
  const LoadedFile arc = read_cad(entities("0 ARC 10 0 20 0 40 1 50 350 51 80"));
  CHECK(length_of(arc.data) == Approx(kPi / 2).epsilon(1e-3));
  CHECK_FALSE(arc.data.contours[0].closed);
  CHECK(box_of(arc.data).low.x == Approx(std::cos(80 * kPi / 180)));
  CHECK(box_of(arc.data).low.y == Approx(-std::sin(10 * kPi / 180)));

  // Whole turns before its start change nothing, and so many that a turn is below their last bit are no end of work.
  const LoadedFile turned = read_cad(entities("0 ARC 10 0 20 0 40 1 50 3950 51 80"));
  CHECK(length_of(turned.data) == Approx(kPi / 2).epsilon(1e-3));
  CHECK(box_of(turned.data).low.x == Approx(std::cos(80 * kPi / 180)));
  const LoadedFile wound = read_cad(entities("0 ARC 10 0 20 0 40 1 50 3518446744073709551615 51 -11"));
  for (const Vec2 p : wound.data.positions) CHECK(distance(p, {0, 0}) == Approx(1.0).epsilon(1e-12));

  const LoadedFile ellipse = read_cad(entities("0 ELLIPSE 10 1 20 1 11 0 21 4 40 0.5 41 0 42 3.14159265358979"));
  const Box2 half = box_of(ellipse.data);
  CHECK(half.low.x == Approx(-1.0).epsilon(1e-4));
  CHECK(half.high.x == Approx(1.0).margin(1e-9));
  CHECK(half.high.y == Approx(5.0));

  const LoadedFile spline = read_cad(entities(
      "0 SPLINE 70 8 71 3 72 8 73 4 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 0 20 4 10 4 20 4 10 4 "
      "20 0"));
  CHECK(box_of(spline.data).high.y == Approx(3.0).epsilon(1e-4));

  const LoadedFile points = read_cad(entities("0 POINT 10 1.5 20 2 30 7 0 POINT 10 3 20 4"));
  CHECK(points.data.positions == std::vector<Vec2>{{1.5, 2}, {3, 4}});
}

TEST_CASE("bulges of polylines are arcs, to the right where they are positive") {
  for (const std::string polyline :
       {"0 LWPOLYLINE 90 2 70 1 10 -1 20 0 42 1 10 1 20 0 42 1",
        "0 POLYLINE 66 1 70 1 0 VERTEX 10 -1 20 0 42 1 0 VERTEX 10 1 20 0 42 1 0 SEQEND"}) {
    const LoadedFile circle = read_cad(entities(polyline));
    REQUIRE(circle.data.contours.size() == 1);
    CHECK(circle.data.contours[0].closed);
    for (const Vec2 p : circle.data.positions) CHECK(length(p) == Approx(1.0));
  }
  // A quarter: its bulge is the tangent of a quarter of 90 degrees.
  const LoadedFile quarter = read_cad(entities("0 LWPOLYLINE 70 0 10 0 20 0 42 0.41421356237309503 10 1 20 1"));
  for (const Vec2 p : quarter.data.positions) CHECK(distance(p, {0, 1}) == Approx(1.0));
  const LoadedFile left = read_cad(entities("0 LWPOLYLINE 70 0 10 0 20 0 42 -0.41421356237309503 10 1 20 1"));
  for (const Vec2 p : left.data.positions) CHECK(distance(p, {1, 0}) == Approx(1.0));
}

TEST_CASE("lines and arcs that meet end to end are one outline") {
  // A slot, its parts in any order, with the digits that programs write.
  const LoadedFile slot = read_cad(entities(
      "0 LINE 10 0.0 20 -1.0 11 5.0 21 -1.0 0 LINE 10 5.0 20 1.0000002 11 0.0 21 1.0 0 ARC 10 0 20 0 40 1 50 90 51 "
      "270 0 ARC 10 5 20 0 40 1 50 270 51 90"));
  REQUIRE(slot.data.contours.size() == 1);
  CHECK(slot.data.contours[0].closed);
  CHECK(length_of(slot.data) == Approx(10 + 2 * kPi).epsilon(1e-3));
}

TEST_CASE("what is seen from below is mirrored, and what stands upright is left out") {
  const LoadedFile below =
      read_cad(entities("0 ARC 10 -3 20 0 40 1 50 0 51 90 210 0 220 0 230 -1 0 CIRCLE 40 1 210 1 230 0"));
  CHECK(box_of(below.data).low.x == Approx(2.0));
  CHECK(box_of(below.data).high.x == Approx(3.0));
  CHECK(below.warnings == std::vector<std::string>{"a:24:1: 1 entity that is not parallel to the plane is left out"});
}

TEST_CASE("blocks stand where they are inserted, scaled, turned, and in rows") {
  const std::string blocks =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n1\n20\n0\n0\nLINE\n10\n1\n20\n0\n11\n2\n21\n0\n0\nENDBLK\n0\nENDSEC"
      "\n";
  const LoadedFile turned =
      read_cad(blocks + entities("0 INSERT 2 B 10 10 20 20 41 3 42 3 50 90 0 INSERT 2 B 10 -10 20 0 70 2 44 50"));
  const Box2 box = box_of(turned.data);
  CHECK(box.high.y == Approx(23.0));
  CHECK(box.low.x == Approx(-10.0));
  CHECK(box.high.x == Approx(41.0));
  CHECK(turned.data.contours.size() == 3);
  // A block within itself is drawn without that, and one that is not there is nothing.
  const std::string inside_itself =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nLINE\n10\n0\n20\n0\n11\n2\n21\n0\n0\nINSERT\n2\nB\n0\nENDBLK\n0\nEND"
      "SEC\n";
  const LoadedFile recursive = read_cad(inside_itself + entities("0 INSERT 2 B 0 INSERT 2 B 20 5"));
  CHECK(recursive.data.contours.size() == 2);
  CHECK(recursive.warnings == std::vector<std::string>{"a:20:1: 2 blocks inside themselves are left out"});
  std::string nested = "0\nSECTION\n2\nBLOCKS\n";
  for (int i = 0; i < 40; ++i)
    nested += "0\nBLOCK\n2\nB" + std::to_string(i) + "\n0\nINSERT\n2\nB" + std::to_string(i + 1) + "\n0\nENDBLK\n";
  check_refused(nested + "0\nENDSEC\n" + entities("0 INSERT 2 B0"), "320:1: blocks are nested too deeply");
  check_refused(entities("0 INSERT 2 B"), "1:1: nothing is drawn in it; 1 block that is not there is left out");
  check_refused(blocks + entities("0 INSERT 2 B 70 10001"),
                "32:1: a block is inserted in more than 10000 rows or columns");
}

TEST_CASE("what is hidden, or is no curve, is counted and left out") {
  const LoadedFile file = read_cad(
      "999\nmade by hand\n0\nSECTION\n2\nTABLES\n0\nLAYER\n2\noff\n62\n-7\n0\nLAYER\n2\nfrozen\n70\n1\n0\nENDSEC\n" +
      entities(
          "0 POINT 10 1 20 1 0 POINT 8 off 0 POINT 8 frozen 0 POINT 60 1 0 POINT 67 1 0 TEXT 1 Words 0 TEXT 1 More "
          "0 HATCH 0 SPLINE 71 3 11 0 21 0"));
  CHECK(file.data.positions == std::vector<Vec2>{{1, 1}});
  CHECK(file.warnings ==
        std::vector<std::string>{"a:32:1: 3 entities that are invisible or on layers that are off are left out",
                                 "a:44:1: 1 entity in paper space is left out",
                                 "a:48:1: 2 entities TEXT are left out", "a:56:1: 1 entity HATCH is left out",
                                 "a:58:1: 1 spline without control points is left out"});
}

TEST_CASE("DXF that is wrong is refused where it is wrong") {
  check_refused("AutoCAD Binary DXF\r\n\x1a", "1:1: only DXF as text can be read", "a.dxf");
  check_refused(entities("0 LINE 10 x"), "8:1: expected a number for group 10, found \"x\"");
  check_refused(entities("0 LINE 10 nan"), "8:1: expected a number for group 10, found \"nan\"");
  check_refused(entities("0 LINE x 1"), "7:1: expected a group code, found \"x\"");
  check_refused("0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n", "7:3: the file ends within a pair");
  check_refused("0\nSECTION\n2\nENTITIES\n0\nPOINT\n10\n1\n", "8:1: the file ends within a section");
}

TEST_CASE("each path operator of Ipe is the curve that its manual says") {
  const LoadedFile triangle = read_cad(ipe(ipe_path("0 0 m\n10 0 l\n10 10 l\nh")));
  CHECK(triangle.format == "ipe");
  CHECK(length_of(triangle.data) == Approx(20 + std::sqrt(200.0)));
  CHECK(triangle.data.contours[0].closed);

  const LoadedFile ellipse = read_cad(ipe(ipe_path("2 0 0 1 5 5 e")));
  CHECK(box_of(ellipse.data).low.x == Approx(3.0));
  CHECK(box_of(ellipse.data).high.y == Approx(6.0).epsilon(1e-4));
  CHECK(ellipse.data.contours[0].closed);

  // Three quarters of a circle, and the last one: the matrix that mirrors turns the other way.
  const LoadedFile arc = read_cad(ipe(ipe_path("1 0 m\n1 0 0 1 0 0 0 -1 a")));
  CHECK(length_of(arc.data) == Approx(1.5 * kPi).epsilon(1e-3));
  CHECK(length_of(read_cad(ipe(ipe_path("1 0 m\n1 0 0 -1 0 0 0 -1 a"))).data) == Approx(0.5 * kPi).epsilon(1e-3));

  // A parabola, a Bezier curve, and a spline that begins and ends at its first and last points.
  CHECK(box_of(read_cad(ipe(ipe_path("0 0 m 2 4 4 0 c"))).data).high.y == Approx(2.0).epsilon(1e-4));
  CHECK(box_of(read_cad(ipe(ipe_path("0 0 m 2 4 4 0 q"))).data).high.y == Approx(2.0).epsilon(1e-4));
  CHECK(box_of(read_cad(ipe(ipe_path("0 0 m 0 4 4 4 4 0 c"))).data).high.y == Approx(3.0).epsilon(1e-4));
  const LoadedFile spline = read_cad(ipe(ipe_path("0 0 m 1 3 3 3 5 -3 7 -3 8 0 c")));
  CHECK(spline.data.positions.front() == Vec2{0, 0});
  CHECK(distance(spline.data.positions.back(), {8, 0}) < 1e-12);
  const LoadedFile closed = read_cad(ipe(ipe_path("0 0 10 0 10 10 0 10 u")));
  CHECK(closed.data.contours[0].closed);
  // Midway between two knots a uniform cubic spline is 1, 23, 23 and 1 48ths of four control points.
  CHECK(box_of(closed.data).low.x == Approx(20.0 / 48.0).epsilon(1e-3));
}

TEST_CASE("groups and matrices of Ipe move what is in them, and marks are points") {
  const LoadedFile file = read_cad(ipe("<group matrix=\"2 0 0 2 100 0\"><group>" +
                                       std::string("<path matrix=\"0 1 -1 0 0 0\">0 0 m 5 0 l</path></group>") +
                                       "<use name=\"mark/disk(sx)\" pos=\"1 2\"/></group>"
                                       "<use name=\"mark/cross(sx)\" matrix=\"1 0 0 1 7 0\" pos=\"0 0\"/>"));
  CHECK(file.data.positions.front() == Vec2{100, 0});
  CHECK(box_of(file.data).high == Vec2{102, 10});
  CHECK(file.data.positions.back() == Vec2{7, 0});
  CHECK(file.data.contours.size() == 1);
}

TEST_CASE("text, pictures, symbols and undocumented splines of Ipe are counted and left out") {
  const LoadedFile file = read_cad(ipe("<text pos=\"0 0\">$x$</text>\n<image/><text/><use name=\"logo\"/>\n" +
                                       ipe_path("0 0 m 1 1 2 0 3 1 0.5 C 5 5 l")));
  CHECK(file.data.positions.front() == Vec2{3, 1});
  CHECK(file.warnings ==
        std::vector<std::string>{"a:6:1: 2 text objects are left out", "a:7:1: 1 image object is left out",
                                 "a:7:16: 1 symbol object is left out",
                                 "a:9:23: 1 spline of a kind that is not read is left out, with what it belongs to"});
}

TEST_CASE("Ipe files that are wrong are refused where they are wrong") {
  check_refused(ipe(""), "1:1: nothing is drawn in it");
  check_refused(ipe("<text/>"), "1:1: nothing is drawn in it; 1 text object is left out");
  check_refused(ipe(ipe_path("0 0 l")), "7:5: \"l\" has no point to start from");
  check_refused(ipe(ipe_path("0 m")), "7:3: \"m\" has 2 numbers before it, not 1");
  check_refused(ipe(ipe_path("0 0 m 1 1 x")), "7:11: there is no path operator \"x\"");
  check_refused(ipe(ipe_path("0 0 m 1 1e999 l")), "7:9: \"1e999\" is too large");
  check_refused(ipe(ipe_path("0 0 m 1 1")), "7:9: the path ends with numbers and without what they are for");
  check_refused(ipe("<path matrix=\"1 0 0 1\">0 0 m</path>"), "6:15: \"1 0 0 1\" is not a matrix");
  check_refused(ipe("<use name=\"mark/disk\" pos=\"1\"/>"), "6:28: \"1\" is not a position");
  check_refused("<ipe><page><path>0 0 m</page></ipe>",
                "1:25: this is not XML: an element ends that is not open, or the "
                "end is missing");
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<group>";
  for (int i = 0; i < 300; ++i) deep += "</group>";
  const auto read = read_sample_bytes(ipe(deep), "a");
  REQUIRE_FALSE(read.has_value());
  CHECK_THAT(read.error().text, Catch::Contains("nested too deeply"));
}

TEST_CASE("a spline of DXF may have inner knots of full multiplicity, or fit points alone") {
  const LoadedFile full = read_cad(
      entities("0 SPLINE 70 8 71 3 72 12 73 8 74 0 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 40 2 40 2 40 2 40 2 "
               "10 0 20 0 10 0 20 3 10 3 20 6 10 6 20 6 10 6 20 6 10 9 20 6 10 9 20 0 10 0 20 0"));
  CHECK(full.warnings.empty());
  REQUIRE(full.data.contours.size() == 1);
  CHECK(full.data.contours[0].closed);
  CHECK(full.data.source->curves->curves[0].piece_count() == 2);

  // Twelve points of a circle, closed: no more than 2e-4 off.
  std::string words = "0 SPLINE 70 11 71 3 72 0 73 0 74 12";
  for (int i = 0; i < 12; ++i)
    words += " 11 " + std::to_string(5 * std::cos(i * kPi / 6)) + " 21 " + std::to_string(5 * std::sin(i * kPi / 6));
  const LoadedFile circle = read_cad(entities(words));
  REQUIRE(circle.data.contours.size() == 1);
  CHECK(circle.data.contours[0].closed);
  for (const Vec2 p : circle.data.positions) CHECK(length(p) == Approx(5.0).epsilon(3e-4));

  // Open, and with the directions of its ends.
  const LoadedFile arch =
      read_cad(entities("0 SPLINE 70 8 71 3 74 3 12 0 22 1 13 0 23 -1 11 0 21 0 11 2 21 1 11 4 21 0"));
  CHECK_FALSE(arch.data.contours[0].closed);
  const std::vector<Vec2>& controls = arch.data.source->curves->curves[0].points();
  CHECK(controls[1].x == Approx(0.0).margin(1e-12));
  CHECK(controls[1].y > 0.5);
  CHECK(controls[5].x == Approx(4.0));
  CHECK(
      read_cad(entities("0 SPLINE 70 8 71 3 74 2 11 0 21 0 11 3 21 4")).data.source->curves->curves[0].is_polyline());
}

TEST_CASE("an ellipse that ends at a turn in few decimals is closed, and one that does not is not") {
  for (const char* turn : {"6.28", "6.283", "6.2832", "6.28319", "6.283185", "6.2831853", "6.28318531", "6.283185307",
                           "6.28318530718", "6.283185307179586", "6.28318530717959D0"}) {
    INFO(turn);
    const LoadedFile file =
        read_cad(entities(std::string("0 ELLIPSE 10 0 20 0 11 10 21 0 40 0.5 41 0.0 42 ") + turn));
    REQUIRE(file.data.contours.size() == 1);
    CHECK(file.data.contours[0].closed);
    const Box2 box = box_of(file.data);
    CHECK(box.width() == Approx(20.0).epsilon(1e-3));
    CHECK(box.height() == Approx(10.0).epsilon(1e-3));
  }
  for (const char* ends : {"41 1.5708 42 7.8540", "41 -3.14159 42 3.14159", "41 3.1416 42 9.4248"}) {
    INFO(ends);
    const LoadedFile file = read_cad(entities(std::string("0 ELLIPSE 10 0 20 0 11 10 21 0 40 0.5 ") + ends));
    CHECK(file.data.contours[0].closed);
    CHECK(box_of(file.data).width() == Approx(20.0).epsilon(1e-3));
  }
  for (const char* ends : {"41 0.0 42 6.27", "41 0.0 42 6.2", "41 0 42 6", "41 0.02 42 6.28"}) {
    INFO(ends);
    const LoadedFile file = read_cad(entities(std::string("0 ELLIPSE 10 0 20 0 11 10 21 0 40 0.5 ") + ends));
    CHECK_FALSE(file.data.contours[0].closed);
  }
  // A sliver that is meant.
  CHECK(length_of(read_cad(entities("0 ARC 10 0 20 0 40 1 50 10.25 51 10.26")).data) ==
        Approx(0.01 * kPi / 180).epsilon(1e-3));
}

TEST_CASE("ends meet within the decimals that a drawing is written with") {
  // A slot of length 3 and radius 1, turned by 30 degrees, in so many decimals.
  for (const int decimals : {3, 4, 6, 8}) {
    INFO(decimals);
    const auto number = [&](double x) {
      char text[400];
      std::snprintf(text, sizeof text, "%.*f", decimals, x);
      return std::string(text);
    };
    const double c = std::cos(kPi / 6);
    const double s = std::sin(kPi / 6);
    const auto at = [&](int code, double x, double y) {
      return " " + std::to_string(code) + " " + number(7.0 + c * x - s * y) + " " + std::to_string(code + 10) + " " +
             number(3.0 + s * x + c * y);
    };
    const LoadedFile slot = read_cad(entities("0 LINE" + at(10, 0, -1) + at(11, 3, -1) + " 0 ARC" + at(10, 3, 0) +
                                              " 40 " + number(1) + " 50 " + number(300) + " 51 " + number(120) +
                                              " 0 LINE" + at(10, 3, 1) + at(11, 0, 1) + " 0 ARC" + at(10, 0, 0) +
                                              " 40 " + number(1) + " 50 " + number(120) + " 51 " + number(300)));
    REQUIRE(slot.data.contours.size() == 1);
    CHECK(slot.data.contours[0].closed);
    CHECK(length_of(slot.data) == Approx(6 + 2 * kPi).epsilon(2e-3));
  }
  // What lies apart by more stays apart.
  CHECK(read_cad(entities("0 LINE 10 0.0000 20 0 11 5.0000 21 0 0 LINE 10 5.0030 20 0 11 9.1234 21 2"))
            .data.contours.size() == 2);
}

TEST_CASE("a bulge of rounding is a straight side") {
  const LoadedFile square = read_cad(
      entities("0 LWPOLYLINE 70 1 10 0 20 0 42 1e-16 10 4 20 0 42 -1e-12 10 4 20 4 42 0.0 10 0 20 4 42 2e-9"));
  CHECK(square.data.source->curves->curves[0].is_polyline());
  CHECK(length_of(square.data) == Approx(16.0));
}

TEST_CASE("drawings of CAD have the unit of their header, and Ipe has points") {
  const auto unit_of = [](const std::string& header) {
    const LoadedFile file =
        read_cad("0\nSECTION\n2\nHEADER\n" + header + "0\nENDSEC\n" + entities("0 LINE 10 0 20 0 11 3 21 4"));
    return file.data.map ? file.data.map->unit : std::string();
  };
  CHECK(unit_of("9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n     4\n9\n$LUNITS\n70\n2\n") == "mm");
  CHECK(unit_of("9\n$INSUNITS\n70\n1\n") == "in");
  CHECK(unit_of("9\n$INSUNITS\n70\n6\n") == "m");
  for (const char* header :
       {"", "9\n$INSUNITS\n70\n0\n", "9\n$INSUNITS\n70\n99\n", "9\n$INSUNITS\n", "9\n$LUNITS\n70\n4\n"})
    CHECK(unit_of(header).empty());
  CHECK(read_cad(ipe(ipe_path("0 0 m\n3 4 l"))).data.map == MapPlane{.unit = "pt"});
}
