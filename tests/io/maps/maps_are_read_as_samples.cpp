// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON and WKT.
#include <fmt/core.h>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/document/curve_source.h"
#include "core/io/format.h"
#include "core/io/systems/map_conversion.h"
#include "tests/io/checked_reading.h"

using namespace mes;
using mes::test::good;
using mes::test::read_map;

namespace {

using Indices = std::vector<std::uint32_t>;
using Contours = std::vector<SampleData::Contour>;

/// Longitude and latitude of a position of a map.
Vec2 degrees_of(const LoadedFile& file, Vec2 position) {
  const auto conversion = MapConversion::of(file.data.map.value(), MapTarget::wgs84);
  REQUIRE(conversion);
  return conversion->from_plane(position);
}

}  // namespace

TEST_CASE("every geometry of WKT gives its positions in order") {
  const LoadedFile file = read_map(
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
  const LoadedFile file = read_map(
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
    const LoadedFile file = read_map(text);
    CHECK(file.data.positions == std::vector<Vec2>{{1, 2}, {4, 5}});
    REQUIRE(file.warnings.size() == 1);
    CHECK_THAT(file.warnings[0], Catch::StartsWith("map:1:") && Catch::Contains("heights and measures"));
  }
}

TEST_CASE("a line that ends where it begins is a ring") {
  CHECK(read_map("LINESTRING (0 0, 1 0, 1 1, 0 0)").data.contours == Contours{{true, {0, 1, 2}}});
  CHECK(read_map("LINESTRING (0 0, 1 0, 0 0)").data.contours == Contours{{false, {0, 1}}});
}

TEST_CASE("a remark counts holes that lie outside their polygon") {
  const auto told = [](const std::string& text) {
    const LoadedFile file = read_map(text);
    return file.warnings.empty() ? std::string() : file.warnings.back();
  };
  const std::string square = "POLYGON ((0 0, 8 0, 8 8, 4 8, 4 4, 0 4, 0 0)";  // an L
  CHECK(told(square + ", (5 5, 7 5, 7 7, 5 5))").empty());
  // In the box, but not in the L; one vertex lies on the outline.
  CHECK_THAT(told(square + ", (1 4, 3 5, 3 7, 1 4))"), Catch::Contains("1 hole lies outside its polygon"));
  CHECK_THAT(told(square + ", (5 5, 7 5, 7 7, 5 5), (9 0, 10 0, 10 1, 9 0), (1 5, 2 5, 2 6, 1 5))"),
             Catch::Contains("2 holes lie outside their polygons"));
  // A hole that touches the outline from inside, that crosses it, or that repeats it, does not lie outside.
  CHECK(told(square + ", (0 0, 2 1, 1 2, 0 0))").empty());
  CHECK(told(square + ", (1 3, 3 3, 3 6, 1 3))").empty());
  CHECK(told(square + ", (0 0, 8 0, 8 8, 4 8, 4 4, 0 4, 0 0))").empty());
  CHECK(told("MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1)), "
             "((10 0, 14 0, 14 4, 10 4, 10 0), (11 1, 12 1, 12 2, 11 1)))")
            .empty());
  CHECK_THAT(
      told(R"({"type":"Polygon","coordinates":[[[8,50],[9,50],[9,51],[8,50]],[[9,51],[9.5,51],[9.5,51.5],[9,51]]]})"),
      Catch::Contains("1 hole lies outside its polygon"));
}

TEST_CASE("a remark counts polygons that lie inside others") {
  const auto told = [](const std::string& polygons) {
    const LoadedFile file = good(read_sample_bytes("MULTIPOLYGON (" + polygons + ")", "a.wkt", {}));
    std::string out;
    for (const std::string& warning : file.warnings) out += warning + '\n';
    return out;
  };
  const std::string park = "((0 0, 9 0, 9 9, 0 9, 0 0))";
  const std::string park_with_lake = "((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 2 7, 7 7, 7 2, 2 2))";
  CHECK_THAT(told(park + ", ((2 2, 4 2, 4 4, 2 2))"),
             Catch::Contains("a.wkt: 1 polygon lies inside another one, and cuts a hole into it"));
  CHECK_THAT(told("((2 2, 4 2, 4 4, 2 2)), ((5 5, 6 5, 6 6, 5 5)), " + park),
             Catch::Contains("2 polygons lie inside others"));
  // It may touch the other from inside, and lie beside a hole there.
  CHECK_THAT(told(park + ", ((0 0, 4 0, 4 4, 0 0))"), Catch::Contains("1 polygon lies inside"));
  CHECK_THAT(told(park_with_lake + ", ((0 0, 2 0, 1 2, 0 0))"), Catch::Contains("1 polygon lies inside"));
  // An island in a lake, a lake that is a polygon of its own, neighbours, and polygons that cross.
  CHECK_THAT(told(park_with_lake + ", ((3 3, 4 3, 4 4, 3 3))"), !Catch::Contains("inside"));
  CHECK_THAT(told(park_with_lake + ", ((2 2, 7 2, 7 7, 2 7, 2 2))"), !Catch::Contains("inside"));
  CHECK_THAT(told(park + ", ((9 0, 12 0, 12 9, 9 9, 9 0))"), !Catch::Contains("inside"));
  CHECK_THAT(told(park + ", ((5 5, 12 5, 12 6, 5 5))"), !Catch::Contains("inside"));
}

TEST_CASE("WKT is in the plane unless it names degrees") {
  CHECK(read_map("POINT (30 60)").data.positions == std::vector<Vec2>{{30, 60}});
  CHECK(read_map("SRID=3857;POINT (30 60)").data.positions == std::vector<Vec2>{{30, 60}});
  CHECK(read_map("SRID=0;POINT (30 60)").warnings.empty());
  const LoadedFile file = read_map("SRID=4326;LINESTRING (29 60, 31 60)");
  REQUIRE(file.warnings.size() == 1);
  CHECK_THAT(file.warnings[0], Catch::Contains("metres about 30 E, 60 N"));
  // The length of a degree of longitude at 60 degrees by the program geod: 55799.47039 m.
  CHECK(length(file.data.positions[1]) == Approx(55799.47039).epsilon(1e-9));
  CHECK(file.data.positions[0].x == Approx(-file.data.positions[1].x).epsilon(1e-12));
}

TEST_CASE("every geometry of GeoJSON gives its positions in order") {
  const LoadedFile file = read_map(R"({"features": [
    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [1000, 2]}, "properties": null},
    {"type": "Feature", "geometry": null, "properties": {}},
    {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
      {"type": "MultiPoint", "coordinates": [[3, 4], [5, 6]]},
      {"type": "LineString", "coordinates": [[7, 8], [9, 10], [11, 8]]},
      {"type": "MultiLineString", "coordinates": [[[-1, 1], [-1, 2]], [[-1, 3], [-1, 4]]]}]}},
    {"type": "Feature", "geometry": {"type": "Polygon",
      "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 1]]]}},
    {"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [[[[20, 0], [21, 0], [21, 1], [20, 0]]], []]}}
    ], "type": "FeatureCollection"})");
  CHECK(file.format == "geojson");
  // 1000 is not a longitude, so nothing is projected.
  CHECK(file.warnings ==
        std::vector<std::string>{
            "map: 1000, 2 is not a longitude and latitude, so the coordinates are those of a plane"});
  CHECK(file.data.positions == std::vector<Vec2>{{7, 8},  {9, 10}, {11, 8}, {-1, 1},   {-1, 2}, {-1, 3}, {-1, 4},
                                                 {0, 0},  {9, 0},  {9, 9},  {0, 9},    {1, 1},  {2, 1},  {2, 2},
                                                 {20, 0}, {21, 0}, {21, 1}, {1000, 2}, {3, 4},  {5, 6}});
  CHECK(file.data.contours == Contours{{false, {0, 1, 2}},
                                       {false, {3, 4}},
                                       {false, {5, 6}},
                                       {true, {7, 8, 9, 10}},
                                       {true, {11, 12, 13}},
                                       {true, {14, 15, 16}}});
}

TEST_CASE("degrees become metres about the middle of the map") {
  const LoadedFile file = read_map(R"({"type": "LineString", "coordinates": [[10, 59, 8.5], [14, 61, 9]]})");
  REQUIRE(file.warnings.size() == 2);
  CHECK_THAT(file.warnings[0],
             Catch::Contains("metres about 12 E, 60 N: azimuthal equidistant, lengths are right to 0.01 %"));
  CHECK_THAT(file.warnings[1], Catch::StartsWith("map:1:49: ") && Catch::Contains("heights"));
  REQUIRE(file.data.positions.size() == 2);
  // Distance and direction from 12 E, 60 N by the program geod: 156496.16988 m, 43.742219 degrees from north.
  CHECK(length(file.data.positions[1]) == Approx(156496.16988).epsilon(1e-9));
  CHECK(std::atan2(file.data.positions[1].x, file.data.positions[1].y) ==
        Approx(43.742219 * 3.14159265358979323846 / 180).epsilon(1e-7));

  const LoadedFile fiji = read_map(R"({"type": "MultiPoint", "coordinates": [[179, -17], [-179, -17], [177, -17]]})");
  CHECK_THAT(fiji.warnings[0], Catch::Contains("about 179 E, 17 S"));
  // The length is that of geod; the plane is true to scale only from its origin, 179 E.
  CHECK(length(fiji.data.positions[1]) == Approx(212970.73716).epsilon(1e-9));
  CHECK(length(fiji.data.positions[0]) < 1e-6);
}

TEST_CASE("degrees are kept bit for bit where that is asked for") {
  const ReadRequest kept{.degrees = MapDegrees::kept};
  const std::vector<Vec2> positions{{179.1, -17.3}, {-179.7, -17}, {177, -16.9}};
  for (const char* text : {R"({"type": "LineString", "coordinates": [[179.1, -17.3], [-179.7, -17], [177, -16.9]]})",
                           "SRID=4326;LINESTRING (179.1 -17.3, -179.7 -17, 177 -16.9)"}) {
    const LoadedFile file = read_map(text, "map", kept);
    CHECK(file.data.positions == positions);
    CHECK(file.degrees == MapDegrees::kept);
    CHECK(file.warnings == std::vector<std::string>{"map: degrees are kept as coordinates of the plane"});
    const LoadedFile projected = read_map(text);
    CHECK(projected.degrees == MapDegrees::projected);
    CHECK(projected.data.positions != positions);
    CHECK(projected.data.contours == file.data.contours);
  }
}

TEST_CASE("only longitudes and latitudes are kept or projected, and GeoJSON with others gets a remark") {
  const ReadRequest kept{.degrees = MapDegrees::kept};
  const std::string geojson = R"({"type": "Point", "coordinates": [-181, 2]})";
  for (const std::string& text : {geojson, std::string("POINT (-181 2)"), std::string("-181 2\n")}) {
    for (const ReadRequest& request : {kept, ReadRequest{}}) {
      const LoadedFile file = read_map(text, "map", request);
      CHECK(file.data.positions == std::vector<Vec2>{{-181, 2}});
      CHECK(file.degrees == std::nullopt);
      std::vector<std::string> told;
      if (text == geojson)
        told = {"map: -181, 2 is not a longitude and latitude, so the coordinates are those of a plane"};
      CHECK(file.warnings == told);
    }
  }
}

TEST_CASE("KML and GPX have degrees alone, to 360 in the east") {
  const auto gpx = [](const char* position) {
    return fmt::format("<gpx version=\"1.1\"><wpt {}/></gpx>\n", position);
  };
  const auto kml = [](const char* position) {
    return fmt::format("<kml><Placemark><Point><coordinates>{}</coordinates></Point></Placemark></kml>\n", position);
  };
  for (const std::string& text : {gpx(R"(lat="147" lon="-42")"), kml("-42,147")}) {
    const auto refused = read_sample_bytes(text, "map");
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message().contains("-42, 147 is not a longitude and latitude"));
  }
  for (const std::string& text : {gpx(R"(lat="-17" lon="182")"), kml("182,-17")}) {
    const LoadedFile file = read_map(text);
    CHECK(file.degrees == MapDegrees::projected);
    CHECK(file.data.positions.size() == 1);
  }
}

TEST_CASE("coordinates of the plane stay as they are") {
  const LoadedFile other = read_map(
      R"({"type": "Point", "crs": {"type": "name", "properties": {"name": "EPSG:3857"}}, "coordinates": [1, 2]})");
  CHECK(other.data.positions == std::vector<Vec2>{{1, 2}});
  const LoadedFile ours = read_map(
      R"({"type":"Feature","properties":{"layer":"points","kind":"point"},"geometry":{"type":"Point","coordinates":[1,2]}})");
  CHECK(ours.data.positions == std::vector<Vec2>{{1, 2}});
  CHECK(ours.warnings.empty());
}

TEST_CASE("lists of rings in JSON are read, and a list of points") {
  const LoadedFile rings = read_map("[\n[[0.5, 0], [9, 0], [9, 9]],\n[[1, 1], [2, 1], [2, 2], [1, 1]]\n]", "a.json");
  CHECK(rings.data.positions == std::vector<Vec2>{{0.5, 0}, {9, 0}, {9, 9}, {1, 1}, {2, 1}, {2, 2}});
  CHECK(rings.data.contours == Contours{{true, {0, 1, 2}}, {true, {3, 4, 5}}});
  const LoadedFile points = read_map("[[0, 0], [9, 0], [9, 9]]", "a.json");
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
  CHECK(read_map("POFF 1 0 0 1 2", "a.wkt").format == "poff");
  CHECK(read_map("point,x,y\n1,2,3\n2,4,5\n", "a.csv").format == "csv");
  CHECK(read_map("POINT (1 2)", "a.csv").format == "wkt");
  CHECK(read_map(R"([[1, 2]])", "a.txt").format == "geojson");
}

TEST_CASE("GeoJSON texts may follow each other, on lines or after record separators") {
  const std::string first =
      R"({"type":"Feature","properties":{"a":"}{\\"},"geometry":{"type":"Point","coordinates":[1000,2]}})";
  const std::string second = R"({"type":"LineString","coordinates":[[0,0],[3,4]]})";
  const std::vector<Vec2> positions{{0, 0}, {3, 4}, {1000, 2}};
  for (const std::string& text :
       {first + "\n" + second + "\n", first + "\r\n\r\n" + second, "\x1e" + first + "\n\x1e" + second + "\n",
        first + second, "\xEF\xBB\xBF" + first + "\n" + second}) {
    INFO(text);
    const LoadedFile file = read_map(text);
    CHECK(file.format == "geojson");
    CHECK(file.data.positions == positions);
    CHECK(file.data.contours == Contours{{false, {0, 1}}});
  }
  CHECK(read_map("\x1e" + second).data.positions.size() == 2);
  // Errors have the place in the file.
  const auto refused = [](const std::string& text) {
    const auto read = read_sample_bytes(text, "a.geojson");
    REQUIRE_FALSE(read.has_value());
    return read.error().message();
  };
  CHECK(refused(first + "\n" + R"({"type":"Point","coordinates":[1,}])") == "a.geojson:2:34: this is not JSON");
  CHECK(refused(first + "\n" + R"({"type":"Point","coordinates":[1,"x"]})") == "a.geojson:2:34: expected a number");
  CHECK(refused(first + "\n\n" + R"({"type":"Point","coordinates":[1,2])").starts_with("a.geojson:3:"));
  CHECK(refused(second + "\nand more").starts_with("a.geojson:2:"));
}

TEST_CASE("reference systems in degrees are known by their names and numbers") {
  const auto with = [](const std::string& name) {
    return R"({"type":"LineString","coordinates":[[9,50],[11,51]],"crs":{"type":"name","properties":{"name":")" +
           name + R"("}}})";
  };
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326", "urn:ogc:def:crs:EPSG::4258", "EPSG:4269"})
    CHECK(read_map(with(name)).degrees == MapDegrees::projected);
  for (const char* name : {"EPSG:3857", "urn:ogc:def:crs:EPSG::25832", "local"})
    CHECK_FALSE(read_map(with(name)).degrees.has_value());
  CHECK_FALSE(read_sample_bytes(with("EPSG:43260"), "map"));
  CHECK(read_map("SRID=4258;POINT (9 50)").degrees == MapDegrees::projected);
  CHECK_FALSE(read_map("SRID=25832;POINT (9 50)").degrees.has_value());
  // What this program exports lies in the plane, unless it says that these are degrees.
  const std::string feature =
      R"({"type":"Feature","properties":{"layer":"points","kind":"point"},"geometry":{"type":"Point","coordinates":[9,50]}})";
  CHECK_FALSE(read_map(R"({"type":"FeatureCollection","features":[)" + feature + "]}").degrees.has_value());
  CHECK(
      read_map(
          R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},"features":[)" +
          feature + "]}")
          .degrees == MapDegrees::projected);
}

TEST_CASE("curves of WKT are arcs of circles") {
  const auto curves_of = [](const std::string& text) {
    const LoadedFile file = read_map(text);
    CHECK(file.format == "wkt");
    REQUIRE(file.data.source);
    return file.data.source->curves->curves;
  };
  const auto lies_on = [](const PlaneCurve& curve, Vec2 center, double radius) {
    curve.for_each_piece([&](const Piece& piece) {
      for (const double t : {0.0, 0.3, 0.5, 1.0}) CHECK(distance(piece.at(t), center) == Approx(radius));
    });
  };
  const auto half = curves_of("CIRCULARSTRING (1 0, 0 1, -1 0)");
  REQUIRE(half.size() == 1);
  CHECK(half[0].arcs().at(0).sweep == Approx(3.14159265358979));
  lies_on(half[0], {0, 0}, 1);
  // Clockwise, and more than half of the circle.
  const auto most = curves_of("circularstring z(0 1 5, 0 -1 5, -1 0 5)");
  CHECK(most[0].arcs().at(0).sweep == Approx(-1.5 * 3.14159265358979));
  const auto two = curves_of("CIRCULARSTRING(0 0, 1 1, 2 0, 3 -1, 4 0)");
  CHECK(two[0].piece_count() == 2);
  const auto circle = curves_of("CIRCULARSTRING (5 0, 1 0, 5 0)");
  CHECK(circle[0].is_closed());
  lies_on(circle[0], {3, 0}, 2);
  CHECK(std::abs(circle[0].arcs().at(0).sweep) == Approx(2 * 3.14159265358979));
  CHECK(curves_of("CIRCULARSTRING (0 0, 1 1, 2 2)")[0].is_polyline());

  // A slot: its parts share their ends.
  const std::string slot =
      "COMPOUNDCURVE ((0 -1, 3 -1), CIRCULARSTRING (3 -1, 4 0, 3 1), LINESTRING (3 1, 0 1), "
      "CIRCULARSTRING (0 1, -1 0, 0 -1))";
  const auto outline = curves_of(slot);
  REQUIRE(outline.size() == 1);
  CHECK(outline[0].is_closed());
  CHECK(outline[0].piece_count() == 4);
  const auto polygon =
      curves_of("CURVEPOLYGON (" + slot + ", (1 0, 2 0, 2 0.5, 1 0), CIRCULARSTRING (0.5 0, 0 0, 0.5 0))");
  REQUIRE(polygon.size() == 3);
  for (const PlaneCurve& ring : polygon) CHECK(ring.is_closed());
  CHECK(polygon[0] == outline[0]);
  const auto several =
      curves_of("MULTICURVE ((0 0, 5 5), CIRCULARSTRING EMPTY, CIRCULARSTRING (1 0, 0 1, -1 0), " + slot + ")");
  REQUIRE(several.size() == 3);
  CHECK(several[1] == half[0]);
  CHECK(curves_of("MULTISURFACE (((10 0, 14 0, 10 3, 10 0)), CURVEPOLYGON (" + slot +
                  "), POLYGON ((20 0, 24 0, 20 3, 20 0)))")
            .size() == 3);
  CHECK(curves_of("GEOMETRYCOLLECTION (MULTICURVE EMPTY, CURVEPOLYGON (" + slot + "), POINT (9 9))").size() == 1);
  // In degrees a circle of the file becomes an ellipse of the plane, or lines where it is too large for one.
  const std::string large = "SRID=4326;CIRCULARSTRING (21 60, 20 61, 19 60)";
  CHECK(read_map(large).data.source->curves->curves.at(0).arcs().size() == 1);
  const LoadedFile degrees = good(read_sample_bytes(large, "map"));
  const PlaneCurve& arc = degrees.data.source->curves->curves.at(0);
  arc.for_each_piece([&](const Piece& line) {
    CHECK(distance(degrees_of(degrees, line.from()), {20.0, 60.0}) == Approx(1.0).epsilon(1e-9));
    // It goes on smoothly into the next one.
    CHECK(line.kind == PieceKind::quadratic);
    CHECK(line.points[1] == 0.5 * line.from() + 0.5 * line.to());
  });
  CHECK(arc.piece_count() > 100);  // so many lines are not far from it
  const LoadedFile small = read_map("SRID=4326;CIRCULARSTRING (20.0001 60, 20 60.0001, 19.9999 60)");
  const PlaneCurve& kept = small.data.source->curves->curves.at(0);
  REQUIRE(kept.arcs().size() == 1);
  const Vec2 top = degrees_of(small, kept.arcs().at(0).center + kept.arcs().at(0).v);
  CHECK(top.x == Approx(20.0).epsilon(1e-11));
  CHECK(top.y == Approx(60.0001).epsilon(1e-11));

  const auto refused = [](const std::string& text) {
    const auto read = read_sample_bytes(text, "a");
    REQUIRE_FALSE(read.has_value());
    return read.error().message();
  };
  CHECK(refused("CIRCULARSTRING (0 0, 1 1)") ==
        "a:1:16: a CIRCULARSTRING has three positions, or two more for each other arc");
  CHECK(refused("CIRCULARSTRING (0 0)") ==
        "a:1:16: a CIRCULARSTRING has three positions, or two more for each other arc");
  CHECK(refused("COMPOUNDCURVE (POINT (0 0))") == "a:1:16: expected a curve such as CIRCULARSTRING, found \"POINT\"");
  CHECK(refused("CURVEPOLYGON (COMPOUNDCURVE (COMPOUNDCURVE ((0 0, 1 1))))").starts_with("a:1:30: "));
}

TEST_CASE("a table whose columns are called longitude and latitude is a map") {
  const std::string rows = "50.1,8.2,a\n50.2,8.3,b\n50.15,8.5,c\n";
  for (const char* header : {"lat,lon,name\n", "Latitude,Longitude,name\n"}) {
    const LoadedFile file = good(read_sample_bytes(header + rows, "a.csv"));
    REQUIRE(file.data.map);
    CHECK(file.degrees == MapDegrees::projected);
    CHECK(distance(degrees_of(file, file.data.positions.at(1)), {8.3, 50.2}) < 1e-9);
    CHECK_THAT(file.warnings.at(0), Catch::Contains("degrees are projected to metres about 8.35 E, 50.15 N"));
  }
  const LoadedFile kept =
      good(read_sample_bytes("lat,lon\n50,8\n51,9\n", "a.csv", {}, {.degrees = MapDegrees::kept}));
  CHECK(kept.data.positions == std::vector<Vec2>{{8, 50}, {9, 51}});
  // Not by other names, or where one is none.
  CHECK_FALSE(good(read_sample_bytes("y,x,name\n" + rows, "a.csv")).data.map);
  CHECK_FALSE(good(read_sample_bytes("lat,lon\n5800000,500000\n50,8\n", "a.csv")).data.map);
  CHECK(good(read_sample_bytes("lat,lon\n5800000,500000\n", "a.csv")).data.positions.at(0).x == 500000);
}
