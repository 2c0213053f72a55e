// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle's .node and .poly, CGAL's .edg, OBJ, OFF and PLY.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "core/io/format.h"
#include "temporary_folder.h"
#include "tests/io/checked_reading.h"

using namespace mes;
using mes::test::check_refused;
using mes::test::good;
using mes::test::kAtVertices;

namespace {

LoadedFile read_mesh(std::string_view bytes, const std::string& name = "a") {
  return good(read_sample_bytes(bytes, name, {}, kAtVertices));
}

using Contours = std::vector<SampleData::Contour>;
using Positions = std::vector<Vec2>;

const std::string kTwoTriangles =
    "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "3 0 1 2\n3 0 2 3\n";

template <class Value>
void append_bytes(std::string& out, Value value, bool is_big) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  if (is_big == (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
  out.append(bytes.data(), bytes.size());
}

/// A square with a vertex inside, a segment beside it, and what is to be passed over.
std::string binary_ply(bool is_big) {
  std::string out =
      "ply\nformat binary_" + std::string(is_big ? "big" : "little") +
      "_endian 1.0\ncomment by hand\nelement vertex 7\nproperty uchar red\nproperty double x\nproperty "
      "float y\nproperty short z\nelement material 2\nproperty list uchar float shine\nelement face "
      "4\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\nproperty ushort "
      "vertex2\nend_header\n";
  const Positions vertices{{0, 0}, {0.1, 0}, {0.1, 0.5}, {0, 0.5}, {0.05, 0.25}, {3, 3}, {4, 3}};
  for (const Vec2 p : vertices) {
    append_bytes(out, std::uint8_t{255}, is_big);
    append_bytes(out, p.x, is_big);
    append_bytes(out, static_cast<float>(p.y), is_big);
    append_bytes(out, std::int16_t{-7}, is_big);
  }
  for (const std::uint8_t length : {std::uint8_t{0}, std::uint8_t{2}}) {
    append_bytes(out, length, is_big);
    for (int i = 0; i < length; ++i) append_bytes(out, 0.5F, is_big);
  }
  for (std::int32_t i = 0; i < 4; ++i) {
    append_bytes(out, std::uint8_t{3}, is_big);
    for (const std::int32_t corner : {i, (i + 1) % 4, 4}) append_bytes(out, corner, is_big);
  }
  append_bytes(out, std::int32_t{6}, is_big);
  append_bytes(out, std::uint16_t{5}, is_big);
  return out;
}

}  // namespace

TEST_CASE("vertices of Triangle are samples in their order, whatever number is the first") {
  for (const std::string first : {"0", "1"}) {
    const std::string second = first == "0" ? "1" : "2";
    const LoadedFile file = read_mesh(
        "# by hand\n2 2 1 1\n" + first + " 0.5 1e2 7 0 # attribute, marker\n\n" + second + "  -3 4  8 1\r\n",
        "a.txt");
    CHECK(file.format == "triangle");
    CHECK(file.data.positions == Positions{{0.5, 100}, {-3, 4}});
    CHECK(file.data.contours.empty());
    CHECK(file.warnings == std::vector<std::string>{"a.txt:2:5: attributes of vertices are left out"});
  }
}

TEST_CASE("segments of Triangle become curves where they follow each other, and end where they branch") {
  const LoadedFile file = read_mesh(
      "13 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 10 0\n6 11 0\n7 12 1\n8 20 0\n9 21 0\n10 22 0\n11 21 1\n12 30 30\n"
      "13 40 40\n"
      "12 0\n1 1 2\n2 3 2\n3 3 4\n4 4 1\n5 7 6\n6 6 5\n7 8 9\n8 9 10\n9 9 11\n10 13 13\n11 2 1\n12 1 2\n"
      "1\n1 2 2\n",
      "a.poly");
  CHECK(file.format == "triangle");
  CHECK(file.data.positions == Positions{{12, 1},
                                         {11, 0},
                                         {10, 0},
                                         {20, 0},
                                         {21, 0},
                                         {22, 0},
                                         {21, 1},
                                         {0, 0},
                                         {4, 0},
                                         {4, 4},
                                         {0, 4},
                                         {30, 30},
                                         {40, 40}});
  CHECK(file.data.contours ==
        Contours{{false, {0, 1, 2}}, {false, {3, 4}}, {false, {4, 5}}, {false, {4, 6}}, {true, {7, 8, 9, 10}}});
  CHECK(file.warnings ==
        std::vector<std::string>{
            "a.poly: 1 vertex has more than two segments: curves meet there",
            "a.poly:28:1: the place of 1 hole is left out, for the segments around holes say where these are"});
}

TEST_CASE("a .poly without vertices has them in the .node beside it, and says so where that is missing") {
  const test::TemporaryFolder folder;
  const std::string poly = "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
  const auto path = folder.write("a.poly", poly);
  const auto missing = read_sample_file(path);
  REQUIRE_FALSE(missing.has_value());
  CHECK(missing.error().message() ==
        path.string() + ":1:1: there are no vertices, nor is there a.node beside it, which would have them");
  const auto node = folder.write("a.node", "3 2 0 0\n1 0 0\n2 5 0\n3 0 5\n");
  const LoadedFile file = good(read_sample_file(path, {}, nullptr, kAtVertices));
  CHECK(file.data.positions == Positions{{0, 0}, {5, 0}, {0, 5}});
  CHECK(file.data.contours == Contours{{true, {0, 1, 2}}});
  REQUIRE(file.sources.size() == 2);
  CHECK(file.sources[0].path == node);
  check_refused(poly, "1:1: there are no vertices, which would be in a .node file beside it", "a.poly");
  folder.write("a.node", "3 2 0 0\n1 0 0\n2 5 x\n");
  const auto broken = read_sample_file(path);
  REQUIRE_FALSE(broken.has_value());
  CHECK_THAT(broken.error().message(), Catch::StartsWith(node.string() + ":3:5: "));
}

TEST_CASE("files of Triangle that are wrong are refused where they are wrong") {
  check_refused("3 2 0 0\n1 0 0\n2 1 0\n", "3:6: the file ends after 2 of 3 vertices");
  check_refused("3 2 0 0\n1 0 0\n2 1 0\n4 5 5\n", "4:1: expected vertex 3, found 4");
  check_refused("2 2 0 0\n1 0 0\n2 1 nan\n", "3:5: \"nan\" is not a finite number");
  check_refused("4000000000 2 0 0\n1 0 0\n2 1 1\n", "3:6: the file ends after 2 of 4000000000 vertices");
  check_refused("2 3 0 0\n1 0 0 0\n2 1 1 1\n", "1:3: expected the dimension 2, found 3", "a.node");
  check_refused("2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 3\n", "5:5: there is no vertex 3");
  check_refused("2 2 0 0\n1 0 0\n2 1 1\n9 0\n1 1 2\n", "5:6: the file ends after 1 of 9 segments");
  check_refused("99999999999 2 0 0\n1 0 0\n2 1 1\n", "1:1: these are too many vertices");
}

TEST_CASE("segments of CGAL meet where their ends are equal") {
  const std::string bytes = "4\n0 0 1 0\n1 1 1 0\n1 1 -0 0\n5 5 6 6\n";
  const LoadedFile file = read_mesh(bytes, "a.edg");
  CHECK(file.format == "edg");
  CHECK(file.data.positions == Positions{{5, 5}, {6, 6}, {0, 0}, {1, 0}, {1, 1}});
  CHECK(file.data.contours == Contours{{false, {0, 1}}, {true, {2, 3, 4}}});
  CHECK(read_mesh(bytes).format == "edg");
  CHECK(read_mesh(bytes, "a.pts").format == "pairs");
  CHECK(read_mesh("1\n0 0 1 0\n7\n", "a.edg").warnings ==
        std::vector<std::string>{"a.edg:3:1: everything after the 1 announced segments is ignored"});
  check_refused("3\n0 0 1 0\n", "2:8: the file ends after 1 of 3 segments", "a.edg");
  check_refused("2\n0 0 1 0\n0 0 1\n", "3:6: expected a coordinate, found the end of the line", "a.edg");
}

TEST_CASE("points of CGAL are pairs") {
  CHECK(read_mesh("0 1\n2 3\n", "a.pts").data.positions == Positions{{0, 1}, {2, 3}});
}

TEST_CASE("faces give the outline around them, and what is inside it is left out") {
  const LoadedFile square = read_mesh(kTwoTriangles);
  CHECK(square.format == "off");
  CHECK(square.data.positions == Positions{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(square.data.contours.size() == 1);
  CHECK(square.warnings.empty());

  const LoadedFile fan = read_mesh(
      "COFF 6 4 0\n0 0 0 1 1 1 1\n2 0 0\n2 2 0\n0 2 0\n1 1 0\n9 9 0\n3 0 1 4\n3 1 2 4 0.5\n"
      "3 2 3 4\n3 3 0 4\n");
  CHECK(fan.data.positions == Positions{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {9, 9}});
  CHECK(fan.data.contours == Contours{{true, {0, 1, 2, 3}}});
  CHECK(fan.warnings ==
        std::vector<std::string>{"a: 1 vertex inside faces is left out, for the outlines of the faces are read"});
}

TEST_CASE("a surface without an outline gives all its vertices, and heights are mentioned") {
  const LoadedFile file = read_mesh("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  CHECK(file.data.positions == Positions{{0, 0}, {1, 0}, {0, 1}, {0, 0}});
  CHECK(file.data.contours.empty());
  CHECK(file.warnings == std::vector<std::string>{"a:3:5: heights are left out"});
}

TEST_CASE("OFF files that are wrong are refused where they are wrong") {
  check_refused("OFF\n", "1:4: expected the number of vertices, found the end of the line");
  check_refused("OFF BINARY\n", "1:5: only OFF as text can be read");
  check_refused("OFF\n2 1 0\n0 0 0\n", "3:6: the file ends after 1 of 2 vertices");
  check_refused("OFF\n1 1 0\n0 0\n", "3:4: expected a coordinate, found the end of the line");
  check_refused("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "4:7: there is no vertex 1");
  check_refused("OFF\n1 1 0\n0 0 0\n4000000000 0\n", "4:13: expected 4000000000 corners");
  check_refused("OFF\n0 0 0\n", "1:1: there is nothing in it to take samples of");
  check_refused("4OFF\n1 0 0\n0 0 0 0\n", "1:1: expected OFF, found \"4OFF\"", "a.off");
}

TEST_CASE("OBJ has lines, outlines of faces, and vertices counted from either end") {
  const LoadedFile file = read_mesh(
      "# by hand\nmtllib a.mtl\no thing\nv 0 0 5\nv 1 0 5\nv 1 1 5 1.0\nv 0 1 5\nvt 0 0\nvn 0 0 1\n"
      "f 1/1/1 2//1 3/1 -1\nv 5 5 5\nv 6 5 5\nv 7 6 5\nl -3 -2 -1\nv 8 8 5\np 8\ncurv 0 1 1 2\n",
      "a.obj");
  CHECK(file.format == "obj");
  CHECK(file.data.positions == Positions{{5, 5}, {6, 5}, {7, 6}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {8, 8}});
  CHECK(file.data.contours == Contours{{false, {0, 1, 2}}, {true, {3, 4, 5, 6}}});
  CHECK(file.warnings == std::vector<std::string>{"a.obj:17:1: curves and surfaces of free form are left out"});
  check_refused("v 0 0 0\nl 1 2\n", "2:5: there is no vertex \"2\"");
  check_refused("v 0 0 0\nl 1 -2\n", "2:5: there is no vertex \"-2\"");
  check_refused("v 0 0 0\nl 1\n", "2:4: expected 2 vertices at least");
  check_refused("v 0 0 0\nf 1 1 x\n", "2:7: expected the number of a vertex, found \"x\"");
  check_refused("v 0 0 0\nw 1\n", "2:1: expected v, l, f or another word of OBJ, found \"w\"");
  check_refused("v 0 1e999 0\n",
                "1:5: \"1e999\" is too large: coordinates and radii are 0, or from 2^-500 (3.1e-151) to below 2^500 "
                "(3.3e150) in magnitude",
                "a.obj");
}

TEST_CASE("PLY is the same as text and in both orders of bytes") {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 7\nproperty uchar red\nproperty double x\nproperty float y\nproperty "
      "short "
      "z\nelement material 2\nproperty list uchar float shine\nelement face 4\nproperty list uchar int "
      "vertex_indices\nelement edge 1\nproperty int vertex1\nproperty ushort vertex2\nend_header\n"
      "255 0 0 -7\n255 0.1 0 -7\n255 0.1 0.5 -7\n255 0 0.5 -7\n255 0.05 0.25 -7\n255 3 3 -7\n255 4 3 -7\n"
      "0\n2 0.5 0.5\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n6 5\n";
  const LoadedFile file = read_mesh(text);
  CHECK(file.format == "ply");
  CHECK(file.data.positions == Positions{{4, 3}, {3, 3}, {0, 0}, {0.1, 0}, {0.1, 0.5}, {0, 0.5}});
  CHECK(file.data.contours == Contours{{false, {0, 1}}, {true, {2, 3, 4, 5}}});
  CHECK(file.warnings ==
        std::vector<std::string>{"a: 1 vertex inside faces is left out, for the outlines of the faces are read",
                                 "a: 2 elements \"material\" are left out"});
  for (const bool is_big : {false, true}) {
    const LoadedFile binary = read_mesh(binary_ply(is_big));
    CHECK(binary.data.positions == file.data.positions);
    CHECK(binary.data.contours == file.data.contours);
    CHECK(binary.warnings == file.warnings);
  }
}

TEST_CASE("PLY files that are wrong are refused where they are wrong") {
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0\n1 1\n";
  check_refused("ply\nformat of 1937\n",
                "2:8: expected ascii, binary_little_endian or binary_big_endian, found \"of\"");
  check_refused("ply\nformat ascii 1.0\nproperty float x\n", "3:1: a property without an element");
  check_refused("ply\nformat ascii 1.0\nelement vertex many\n",
                "3:16: expected the number of elements, found \"many\"");
  check_refused(head, "5:17: the header has no end");
  check_refused(head + "property quaternion q\n", "6:10: expected a type such as float, found \"quaternion\"");
  check_refused(head + "end_header\n0 0\n1\n", "8:2: the file ends within vertex 1");
  check_refused(head + "end_header\n0 0\n1 nan\n", "8:3: vertex 1: \"nan\" is not a finite number");
  check_refused(head + "end_header\n0 0\n1e400 2\n", "8:1: vertex 1: \"1e400\" is too large");
  check_refused(head + faces + "3 0 1 1e400\n", "11:7: face 0: \"1e400\" is too large");
  // A line that lacks a number takes one from the next, and then there is more than was announced.
  CHECK(read_mesh(head + "end_header\n0 0\n1 1\n7\n").warnings ==
        std::vector<std::string>{"a:9:1: everything after the announced elements is ignored"});
  CHECK(read_mesh(head + "end_header\n0 0\n1 1 7\n").warnings.size() == 1);
  CHECK(read_mesh(head + "end_header\n0 0\n1 1\n\n").warnings.empty());
  check_refused(head + faces + "3 0 1 2\n", "11:7: face 0: there is no vertex 2 before it");
  check_refused(head + faces + "4000000000 0 1 2\n", "11:17: the file ends within face 0");
  check_refused(head + faces + "-3 0 1 2\n", "11:1: face 0: a list has no such length");
  std::string binary = binary_ply(false);
  const std::string cut = binary.substr(0, binary.size() - 1);
  check_refused(cut, " at byte " + std::to_string(cut.size() - 1) + ": the file ends within edge 0");
  const std::size_t body = binary.find("end_header\n") + 11;
  for (std::size_t size = body; size < binary.size(); ++size) {
    const auto read = read_sample_bytes(binary.substr(0, size), "a.ply");
    REQUIRE_FALSE(read);
    CHECK_THAT(read.error().text, Catch::StartsWith("at byte ") && Catch::Contains(": the file ends within "));
  }
  // A value is refused where its element begins, whatever of it is wrong.
  const std::string floats =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
      "property float y\nproperty uchar q\nend_header\n";
  const std::string nan = std::string("\x00\x00\xC0\x7F", 4) + std::string(5, '\0');
  check_refused(floats + std::string(9, '\0') + nan,
                " at byte " + std::to_string(floats.size() + 9) + ": vertex 1: nan is not a finite number");
  // Elements without properties take no time, however many there are.
  CHECK(read_mesh("ply\nformat ascii 1.0\nelement nothing 9999999999999999999\nelement vertex 1\nproperty int x\n"
                  "property int y\nend_header\n1 2\n")
            .data.positions == Positions{{1, 2}});
}

TEST_CASE("a line of OBJ that ends with a backslash goes on in the next") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const LoadedFile file = read_mesh("v 0 0 0" + end + "v 2 \\" + end + "0 0" + end + "v 2 1 0 # all of it \\" +
                                      end + "v 0 1 0" + end + "f 1 2 \\" + end + "\\" + end + "  3 4" + end);
    CHECK(file.format == "obj");
    CHECK(file.data.positions == Positions{{0, 0}, {2, 0}, {2, 1}, {0, 1}});
    CHECK(file.data.contours == Contours{{true, {0, 1, 2, 3}}});
    CHECK(file.warnings.empty());
    check_refused("v 0 0 0" + end + "f 1 \\" + end + " 1 \\" + end + "x" + end,
                  "4:1: expected the number of a vertex, found \"x\"");
    check_refused("v 0 0 0" + end + "f 1 \\" + end + " 1 2 \\" + end + "1 1" + end, "3:4: there is no vertex \"2\"");
  }
  // The last line has none to go on in.
  CHECK(read_mesh("v 0 0 0\nv 1 0 0\nl 1 2 \\", "a.obj").data.contours == Contours{{false, {0, 1}}});
}

TEST_CASE("vertices that all lie in one plane are read in that plane") {
  const std::string face = "f 1 2 3 4\n";
  const LoadedFile upright = read_mesh("v 0 0 0\nv 2 0 0\nv 2 0 1\nv 0 0 1\n" + face);
  CHECK(upright.data.positions == Positions{{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  CHECK(upright.data.contours.size() == 1);
  CHECK(upright.warnings ==
        std::vector<std::string>{"a:1:1: all vertices lie in one plane, of which x and z are read"});
  const LoadedFile sideways = read_mesh("v 5 0 0\nv 5 2 0\nv 5 2 1\nv 5 0 1\n" + face);
  CHECK(sideways.data.positions == Positions{{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  CHECK(sideways.warnings ==
        std::vector<std::string>{"a:1:1: all vertices lie in one plane, of which y and z are read"});

  // Turned about two axes and moved, in as many decimals as programs write: a rectangle of 2 by 1 all the same.
  for (const int decimals : {3, 4, 6, 9, 15})
    for (const double tilt : {0.2, 0.7, 1.1, 1.5707963267948966, 2.5}) {
      INFO(decimals << " decimals, tilt " << tilt);
      std::string obj;
      std::string off = "OFF\n4 1 0\n";
      std::string ply =
          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
      for (const Vec2 p : Positions{{0, 0}, {2, 0}, {2, 1}, {0, 1}}) {
        const double y = p.y * std::cos(tilt);
        char line[1200];
        std::snprintf(line, sizeof line, "%.*f %.*f %.*f\n", decimals, 7 + p.x * std::cos(0.4) - y * std::sin(0.4),
                      decimals, -3 + p.x * std::sin(0.4) + y * std::cos(0.4), decimals, 1 + p.y * std::sin(tilt));
        obj += std::string("v ") + line;
        off += line;
        ply += line;
      }
      for (const std::string& mesh : {obj + face, off + "4 0 1 2 3\n", ply + "4 0 1 2 3\n"}) {
        const LoadedFile file = read_mesh(mesh);
        REQUIRE(file.data.contours.size() == 1);
        REQUIRE(file.data.positions.size() == 4);
        REQUIRE(file.warnings.size() == 1);
        CHECK_THAT(file.warnings[0], Catch::Contains("all vertices lie in one plane"));
        const double rounding = 2.0 * std::pow(10.0, -decimals) + 1e-12;
        for (std::size_t i = 0; i < 4; ++i) {
          const Vec2 side = file.data.positions[(i + 1) % 4] - file.data.positions[i];
          CHECK(std::abs(length(side) - (i % 2 == 0 ? 2.0 : 1.0)) < rounding);
        }
      }
    }
}

TEST_CASE("vertices that lie in no common plane are seen from above, and a few places in a row are no plane") {
  const LoadedFile relief = read_mesh("v 0 0 0\nv 2 0 0\nv 2 2 1\nv 0 2 0\nf 1 2 3\nf 1 3 4\n");
  CHECK(relief.data.positions == Positions{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK(relief.warnings == std::vector<std::string>{"a:1:1: heights are left out"});
  // A line has its length; one that goes straight up, too.
  const LoadedFile slope = read_mesh("v 0 0 0\nv 3 0 4\nl 1 2\n");
  CHECK(distance(slope.data.positions[0], slope.data.positions[1]) == Approx(5.0));
  CHECK(read_mesh("v 1 1 0\nv 1 1 4\nl 1 2\n").data.positions == Positions{{1, 0}, {1, 4}});
  const LoadedFile oblique = read_mesh("v 0 0 0\nv 1 2 2\nv 2 4 4\nl 1 2 3\n");
  CHECK(distance(oblique.data.positions[0], oblique.data.positions[2]) == Approx(6.0));
  // Rounding errors do not count as heights.
  CHECK(read_mesh("v 0 0 1e-9\nv 2 0 0\nv 2 2 0\nv 0 2 -1e-9\nf 1 2 3 4\n").data.positions ==
        Positions{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  // Of single precision, far from the origin.
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec2 p : Positions{{0, 0}, {2, 0}, {2, 1}, {0, 1}})
    for (const double value : {1000.0 + p.x * 0.6, 1000.0 + p.x * 0.8, 50.0 + p.y})
      append_bytes(ply, static_cast<float>(value), false);
  append_bytes(ply, std::uint8_t{4}, false);
  for (std::int32_t i = 0; i < 4; ++i) append_bytes(ply, i, false);
  const LoadedFile single = read_mesh(ply);
  CHECK(distance(single.data.positions[0], single.data.positions[1]) == Approx(2.0).epsilon(1e-4));
  CHECK(distance(single.data.positions[1], single.data.positions[2]) == Approx(1.0).epsilon(1e-4));
}

TEST_CASE("legal forms of meshes that are rare are read") {
  // OFF without its word; PLY with a comment before its format; OBJ with a Fortran exponent and words of renderers.
  CHECK(read_mesh("4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "a.off").data.contours.size() == 1);
  CHECK(read_mesh("ply\ncomment first\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                  "y\nend_header\n1 2\n")
            .data.positions == Positions{{1, 2}});
  CHECK(read_mesh("shadow_obj a.obj\nd_interp on\nv 1.5D+1 2d0 0\nv 1 0 0\nl 1 2\n").data.positions ==
        Positions{{15, 2}, {1, 0}});
}
