// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON and WKT.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/io/format.h"

using namespace mes;

namespace {

LoadedFile read_good(std::string_view bytes, const std::string& name = "map", const ReadRequest& request = {}) {
  auto read = read_sample_bytes(bytes, name, {}, request);
  INFO((read ? std::string() : read.error().message()));
  REQUIRE(read.has_value());
  return *std::move(read);
}

using Indices = std::vector<std::uint32_t>;
using Contours = std::vector<SampleData::Contour>;

constexpr double kKilometresADegree = 6371.0088 * 3.14159265358979323846 / 180.0;

}  // namespace

TEST_CASE("every geometry of WKT gives its positions in order") {
  const LoadedFile file = read_good(
      "POINT (1 2)\n"
      "LINESTRING(3 4, 5 6)\n"
      "Polygon ((0 0, 10 0, 10 10, 0 10, 0 0), (2 2, 4 2, 4 4, 2 2))\n"
      "MULTIPOINT (20 20, 21 21), MULTIPOINT ((22 22), (23 23));\n"
      "MULTILINESTRING ((30 30, 31 31), (32 32, 33 33))\r"
      "MULTIPOLYGON (((40 40, 41 40, 41 41)), ((50 50, 51 50, 51 51, 50 50)))\r\n"
      "GEOMETRYCOLLECTION (POINT (60 60), GEOMETRYCOLLECTION (LINESTRING (70 70, 71 71)), POLYGON EMPTY)\n"
      "MULTIPOINT EMPTY");
  CHECK(file.format == "wkt");
  CHECK(file.warnings.empty());
  // Lines and rings first, then points.
  CHECK(file.data.positions == std::vector<Vec2>{{3, 4},   {5, 6},   {0, 0},   {10, 0},  {10, 10}, {0, 10},  {2, 2},
                                                 {4, 2},   {4, 4},   {30, 30}, {31, 31}, {32, 32}, {33, 33}, {40, 40},
                                                 {41, 40}, {41, 41}, {50, 50}, {51, 50}, {51, 51}, {70, 70}, {71, 71},
                                                 {1, 2},   {20, 20}, {21, 21}, {22, 22}, {23, 23}, {60, 60}});
  CHECK(file.data.contours == Contours{{false, {0, 1}},
                                       {true, {2, 3, 4, 5}},
                                       {true, {6, 7, 8}},
                                       {false, {9, 10}},
                                       {false, {11, 12}},
                                       {true, {13, 14, 15}},
                                       {true, {16, 17, 18}},
                                       {false, {19, 20}}});
}

TEST_CASE("triangles and surfaces of WKT are read by their rings") {
  const LoadedFile file = read_good(
      "POINT (9 9)\n"
      "TRIANGLE Z ((0 0 1, 4 0 1, 0 3 1, 0 0 1))\n"
      "TIN (((10 0, 14 0, 10 3, 10 0)), ((20 0, 24 0, 20 3, 20 0)))\n"
      "PolyhedralSurface (((30 0, 34 0, 34 3, 30 3, 30 0)))\n");
  CHECK(file.format == "wkt");
  REQUIRE(file.data.contours.size() == 4);
  for (const SampleData::Contour& contour : file.data.contours) CHECK(contour.closed);
  CHECK(file.data.positions.size() == 14);
  CHECK(file.data.contours.back().points.size() == 4);
  CHECK(file.data.positions[file.data.contours.back().points[2]] == Vec2{34, 3});
  CHECK(file.warnings.size() == 1);  // heights
}

TEST_CASE("heights and measures of WKT are left out with a warning") {
  for (const char* text : {"LINESTRING Z (1 2 3, 4 5 6)", "linestring zm(1 2 3 nan, 4 5 6 7)",
                           "LINESTRINGM(1 2 3,4 5 6)", "LINESTRING (1 2 3, 4 5 6)"}) {
    const LoadedFile file = read_good(text);
    CHECK(file.data.positions == std::vector<Vec2>{{1, 2}, {4, 5}});
    REQUIRE(file.warnings.size() == 1);
    CHECK_THAT(file.warnings[0], Catch::StartsWith("map:1:") && Catch::Contains("heights and measures"));
  }
}

TEST_CASE("a line that ends where it begins is a ring") {
  CHECK(read_good("LINESTRING (0 0, 1 0, 1 1, 0 0)").data.contours == Contours{{true, {0, 1, 2}}});
  CHECK(read_good("LINESTRING (0 0, 1 0, 0 0)").data.contours == Contours{{false, {0, 1}}});
}

TEST_CASE("WKT is in the plane unless it names degrees") {
  CHECK(read_good("POINT (30 60)").data.positions == std::vector<Vec2>{{30, 60}});
  CHECK(read_good("SRID=3857;POINT (30 60)").warnings.empty());
  const LoadedFile file = read_good("SRID=4326;LINESTRING (29 60, 31 60)");
  REQUIRE(file.warnings.size() == 1);
  CHECK_THAT(file.warnings[0], Catch::Contains("kilometres about 30 E, 60 N"));
  // At 60 degrees a degree of longitude is half as long as one of latitude.
  CHECK(file.data.positions[1].x == Approx(0.5 * kKilometresADegree).epsilon(1e-12));
  CHECK(file.data.positions[0].x == -file.data.positions[1].x);
}

TEST_CASE("every geometry of GeoJSON gives its positions in order") {
  const LoadedFile file = read_good(R"({"features": [
    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [1000, 2]}, "properties": null},
    {"type": "Feature", "geometry": null, "properties": {}},
    {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
      {"type": "MultiPoint", "coordinates": [[3, 4], [5, 6]]},
      {"type": "LineString", "coordinates": [[7, 8], [9, 10], [11, 8]]},
      {"type": "MultiLineString", "coordinates": [[[0, 1], [0, 2]], [[0, 3], [0, 4]]]}]}},
    {"type": "Feature", "geometry": {"type": "Polygon",
      "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 1]]]}},
    {"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [[[[20, 0], [21, 0], [21, 1], [20, 0]]], []]}}
    ], "type": "FeatureCollection"})");
  CHECK(file.format == "geojson");
  // 1000 is not a longitude, so nothing is projected.
  CHECK(file.warnings.empty());
  CHECK(file.data.positions == std::vector<Vec2>{{7, 8},  {9, 10}, {11, 8}, {0, 1},    {0, 2}, {0, 3}, {0, 4},
                                                 {0, 0},  {9, 0},  {9, 9},  {0, 9},    {1, 1}, {2, 1}, {2, 2},
                                                 {20, 0}, {21, 0}, {21, 1}, {1000, 2}, {3, 4}, {5, 6}});
  CHECK(file.data.contours == Contours{{false, {0, 1, 2}},
                                       {false, {3, 4}},
                                       {false, {5, 6}},
                                       {true, {7, 8, 9, 10}},
                                       {true, {11, 12, 13}},
                                       {true, {14, 15, 16}}});
}

TEST_CASE("degrees become kilometres about the middle of the map") {
  const LoadedFile file = read_good(R"({"type": "LineString", "coordinates": [[10, 59, 8.5], [14, 61, 9]]})");
  REQUIRE(file.warnings.size() == 2);
  CHECK_THAT(file.warnings[0], Catch::Contains("kilometres about 12 E, 60 N"));
  CHECK_THAT(file.warnings[1], Catch::StartsWith("map:1:49: ") && Catch::Contains("heights"));
  REQUIRE(file.data.positions.size() == 2);
  CHECK(file.data.positions[1].x == Approx(kKilometresADegree).epsilon(1e-12));
  CHECK(file.data.positions[1].y == Approx(kKilometresADegree).epsilon(1e-12));
  CHECK(file.data.positions[0].x == Approx(-file.data.positions[1].x).epsilon(1e-12));

  const LoadedFile fiji =
      read_good(R"({"type": "MultiPoint", "coordinates": [[179, -17], [-179, -17], [177, -17]]})");
  CHECK_THAT(fiji.warnings[0], Catch::Contains("about 179 E, 17 S"));
  CHECK(fiji.data.positions[1].x - fiji.data.positions[0].x ==
        Approx(2 * kKilometresADegree * std::cos(17 * 3.14159265358979323846 / 180)).epsilon(1e-12));
}

TEST_CASE("degrees are kept bit for bit where that is asked for") {
  const ReadRequest kept{.degrees = MapDegrees::kept};
  const std::vector<Vec2> positions{{179.1, -17.3}, {-179.7, -17}, {177, -16.9}};
  for (const char* text : {R"({"type": "LineString", "coordinates": [[179.1, -17.3], [-179.7, -17], [177, -16.9]]})",
                           "SRID=4326;LINESTRING (179.1 -17.3, -179.7 -17, 177 -16.9)"}) {
    const LoadedFile file = read_good(text, "map", kept);
    CHECK(file.data.positions == positions);
    CHECK(file.degrees == MapDegrees::kept);
    CHECK(file.warnings == std::vector<std::string>{"map: degrees are kept as coordinates of the plane"});
    const LoadedFile projected = read_good(text);
    CHECK(projected.degrees == MapDegrees::projected);
    CHECK(projected.data.positions != positions);
    CHECK(projected.data.contours == file.data.contours);
  }
}

TEST_CASE("what is kept or projected is longitude and latitude alone") {
  const ReadRequest kept{.degrees = MapDegrees::kept};
  for (const char* text : {R"({"type": "Point", "coordinates": [181, 2]})", "POINT (181 2)", "181 2\n"}) {
    for (const ReadRequest& request : {kept, ReadRequest{}}) {
      const LoadedFile file = read_good(text, "map", request);
      CHECK(file.data.positions == std::vector<Vec2>{{181, 2}});
      CHECK(file.degrees == std::nullopt);
      CHECK(file.warnings.empty());
    }
  }
}

TEST_CASE("coordinates of the plane stay as they are") {
  const LoadedFile other = read_good(
      R"({"type": "Point", "crs": {"type": "name", "properties": {"name": "EPSG:3857"}}, "coordinates": [1, 2]})");
  CHECK(other.data.positions == std::vector<Vec2>{{1, 2}});
  const LoadedFile ours = read_good(
      R"({"type":"Feature","properties":{"layer":"points","kind":"point"},"geometry":{"type":"Point","coordinates":[1,2]}})");
  CHECK(ours.data.positions == std::vector<Vec2>{{1, 2}});
  CHECK(ours.warnings.empty());
}

TEST_CASE("lists of rings in JSON are read, and a list of points") {
  const LoadedFile rings = read_good("[\n[[0.5, 0], [9, 0], [9, 9]],\n[[1, 1], [2, 1], [2, 2], [1, 1]]\n]", "a.json");
  CHECK(rings.data.positions == std::vector<Vec2>{{0.5, 0}, {9, 0}, {9, 9}, {1, 1}, {2, 1}, {2, 2}});
  CHECK(rings.data.contours == Contours{{true, {0, 1, 2}}, {true, {3, 4, 5}}});
  const LoadedFile points = read_good("[[0, 0], [9, 0], [9, 9]]", "a.json");
  CHECK(points.data.positions == std::vector<Vec2>{{0, 0}, {9, 0}, {9, 9}});
  CHECK(points.data.contours.empty());
}

TEST_CASE("a number of GeoJSON that no double holds is refused with its place") {
  const auto read =
      read_sample_bytes("{\"type\":\"Polygon\",\n\"coordinates\":[[[0,0],[-1e999,0],[1,1]]]}", "a.geojson");
  REQUIRE_FALSE(read);
  CHECK(read.error().message() == "a.geojson:2:24: a number in this JSON is too large");
}

TEST_CASE("what looks like a map by its name only is read as what it is") {
  CHECK(read_good("POFF 1 0 0 1 2", "a.wkt").format == "poff");
  CHECK(read_good("point,x,y\n1,2,3\n2,4,5\n", "a.csv").format == "csv");
  CHECK(read_good("POINT (1 2)", "a.csv").format == "wkt");
  CHECK(read_good(R"([[1, 2]])", "a.txt").format == "geojson");
}
