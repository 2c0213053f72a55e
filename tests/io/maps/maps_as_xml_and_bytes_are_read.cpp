// SPDX-License-Identifier: GPL-3.0-or-later
// KML, GPX and WKB: they give what the same geometries give as GeoJSON and WKT.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/document/curve_source.h"
#include "core/io/format.h"
#include "tests/io/checked_reading.h"

using namespace mes;
using mes::test::read_map;

namespace {

std::string refusal(std::string_view bytes, const std::string& name = "a") {
  const auto read = read_sample_bytes(bytes, name);
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().code == ErrorCode::bad_input);
  return read.error().message();
}

void check_same(const LoadedFile& a, const LoadedFile& b) {
  CHECK(a.data.positions == b.data.positions);
  CHECK(a.data.contours == b.data.contours);
  CHECK(a.data.map == b.data.map);
}

const std::string kKml =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
    "xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><Document><name>a</name>\n";

/// WKB put together by hand.
class Bytes {
 public:
  explicit Bytes(bool is_big = false) : is_big_(is_big) {}
  Bytes& type(std::uint32_t code) {
    out_ += is_big_ ? '\0' : '\1';
    return count(code);
  }
  Bytes& count(std::uint32_t value) { return append(value); }
  Bytes& at(std::initializer_list<double> numbers) {
    for (const double number : numbers) append(number);
    return *this;
  }
  const std::string& text() const { return out_; }
  std::string hex() const {
    std::string out;
    for (const char c : out_)
      for (const unsigned shift : {4U, 0U}) out += "0123456789abcdef"[static_cast<unsigned char>(c) >> shift & 15U];
    return out;
  }

 private:
  template <class Value>
  Bytes& append(Value value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
    if (is_big_ == (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
    out_.append(bytes.data(), bytes.size());
    return *this;
  }
  bool is_big_;
  std::string out_;
};

constexpr std::uint32_t kEwkbZ = 0x80000000;
constexpr std::uint32_t kEwkbSystem = 0x20000000;

}  // namespace

TEST_CASE("every geometry of KML is read as GeoJSON has it") {
  const LoadedFile kml = read_map(
      kKml +
      "<Placemark><Point><coordinates> 23.9,35.5,0 </coordinates></Point></Placemark>\n"
      "<Folder><Placemark><MultiGeometry><LineString><tessellate>1</tessellate><coordinates>\n24,35 24.5,35.25\n25,35"
      "</coordinates></LineString>\n<Polygon><outerBoundaryIs><LinearRing><coordinates>26,35,0 27,35,0 27,36,0 "
      "26,35,0"
      "</coordinates></LinearRing></outerBoundaryIs><innerBoundaryIs><LinearRing><coordinates>26.5,35.1 26.8,35.1 "
      "26.8, 35.3 "
      "26.5,35.1</coordinates></LinearRing></innerBoundaryIs></Polygon></MultiGeometry></Placemark></Folder>\n"
      "<gx:Track><when>2020-01-01</when><gx:coord>28 35 0</gx:coord><gx:coord>28.5 35.5 0</gx:coord></gx:Track>"
      "</Document></kml>");
  CHECK(kml.format == "kml");
  CHECK(kml.degrees == MapDegrees::projected);
  CHECK(kml.warnings.size() == 1);
  check_same(kml, read_map(R"({"type":"GeometryCollection","geometries":[
    {"type":"Point","coordinates":[23.9,35.5]},
    {"type":"LineString","coordinates":[[24,35],[24.5,35.25],[25,35]]},
    {"type":"Polygon","coordinates":[[[26,35],[27,35],[27,36],[26,35]],[[26.5,35.1],[26.8,35.1],[26.8,35.3],[26.5,35.1]]]},
    {"type":"LineString","coordinates":[[28,35],[28.5,35.5]]}]})"));
}

TEST_CASE("prefixes, heights and what KML has no geometry for are dealt with") {
  const LoadedFile file = read_map(
      "<kml:kml xmlns:kml=\"http://www.opengis.net/kml/2.2\"><kml:Placemark><kml:LineString><kml:coordinates>1,2,30 "
      "3,4,0</kml:coordinates></kml:LineString></kml:Placemark>\n<GroundOverlay/><NetworkLink/><GroundOverlay/></"
      "kml:kml>");
  CHECK(file.data.positions.size() == 2);
  REQUIRE(file.warnings.size() == 4);
  CHECK(file.warnings[1] == "map:1:105: heights are left out");
  CHECK(file.warnings[2] == "map:2:1: 2 GroundOverlays are left out");
  CHECK(file.warnings[3] == "map:2:17: 1 NetworkLink is left out");
  CHECK(refusal("<kml></kml>") == "a:1:1: there is nothing in it to take samples of");
  const auto with = [](const std::string& text) {
    return "<kml><Point><coordinates>" + text + "</coordinates></Point></kml>";
  };
  CHECK(refusal(with("1,x")) == "a:1:28: expected a number, found \"x\"");
  CHECK(refusal(with("1")) == "a:1:26: expected longitude and latitude");
  CHECK(refusal(with(",")) == "a:1:26: expected longitude and latitude");
  CHECK(refusal(with("1,2,3,4")) == "a:1:32: expected longitude, latitude and height, found more");
  CHECK(refusal("<kml><Point>").starts_with("a:1:"));
}

TEST_CASE("tracks and routes of GPX are lines, and waypoints are points") {
  const LoadedFile gpx = read_map(
      "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\" xmlns=\"http://www.topografix.com/GPX/1/1\"><metadata/>\n"
      "<wpt lat=\"35.5\" lon=\"23.9\"><name>start</name></wpt>\n"
      "<rte><name>r</name><rtept lat=\"35\" lon=\"24\"/><rtept lat=\"35.25\" lon=\"24.5\"/></rte>\n"
      "<trk><trkseg><trkpt lat=\"35\" lon=\"26\"><ele>12.5</ele><time>2020-01-01T00:00:00Z</time></trkpt><trkpt "
      "lon=\"27\" lat=\"35\"/><trkpt lat=\"36\" lon=\"27\"/><trkpt lat=\"35\" lon=\"26\"/></trkseg>\n"
      "<trkseg><trkpt lat=\"35\" lon=\"28\"/><trkpt lat=\"35.5\" lon=\"28.5\"/></trkseg></trk></gpx>\n");
  CHECK(gpx.format == "gpx");
  REQUIRE(gpx.warnings.size() == 2);
  CHECK(gpx.warnings[1] == "map:5:39: heights are left out");
  check_same(gpx, read_map(R"({"type":"GeometryCollection","geometries":[
    {"type":"Point","coordinates":[23.9,35.5]},
    {"type":"LineString","coordinates":[[24,35],[24.5,35.25]]},
    {"type":"LineString","coordinates":[[26,35],[27,35],[27,36],[26,35]]},
    {"type":"LineString","coordinates":[[28,35],[28.5,35.5]]}]})"));
  CHECK(refusal("<gpx><wpt lat=\"1\"/></gpx>") == "a:1:6: wpt has no lon");
  CHECK(refusal("<gpx><wpt lat=\"1\" lon=\"east\"/></gpx>") == "a:1:24: expected a number, found \"east\"");
  CHECK(refusal("<gpx/>") == "a:1:1: there is nothing in it to take samples of");
}

TEST_CASE("every geometry of WKB is read as WKT has it, in both orders of bytes and in digits") {
  for (const bool is_big : {false, true}) {
    Bytes wkb(is_big);
    wkb.type(7).count(9);
    wkb.type(1).at({9, 8});
    wkb.type(2).count(2).at({3, 4, 5, 6});
    wkb.type(3).count(2).count(4).at({0, 0, 10, 0, 10, 10, 0, 0}).count(4).at({5, 1, 6, 1, 6, 2, 5, 1});
    wkb.type(4).count(2).type(1).at({20, 20}).type(1).at({21, 21});
    wkb.type(6).count(1).type(3).count(1).count(4).at({30, 0, 34, 0, 30, 3, 30, 0});
    wkb.type(8).count(3).at({41, 0, 40, 1, 39, 0});
    wkb.type(9).count(2).type(2).count(2).at({50, 0, 51, 0}).type(8).count(3).at({51, 0, 52, 1, 53, 0});
    wkb.type(10).count(1).type(8).count(3).at({60, 0, 62, 0, 60, 0});
    wkb.type(17).count(1).count(4).at({70, 0, 74, 0, 70, 3, 70, 0});
    const LoadedFile wkt = read_map(
        "GEOMETRYCOLLECTION (POINT (9 8), LINESTRING (3 4, 5 6), POLYGON ((0 0, 10 0, 10 10, 0 0), (5 1, 6 1, 6 2, 5 "
        "1)), "
        "MULTIPOINT (20 20, 21 21), MULTIPOLYGON (((30 0, 34 0, 30 3, 30 0))), CIRCULARSTRING (41 0, 40 1, 39 0), "
        "COMPOUNDCURVE ((50 0, 51 0), CIRCULARSTRING (51 0, 52 1, 53 0)), CURVEPOLYGON (CIRCULARSTRING (60 0, 62 0, "
        "60 0)), "
        "TRIANGLE ((70 0, 74 0, 70 3, 70 0)))");
    std::string upper = wkb.hex();
    std::ranges::transform(upper, upper.begin(), [](char c) { return c >= 'a' ? static_cast<char>(c - 32) : c; });
    for (const std::string& text : {wkb.text(), wkb.hex(), wkb.hex() + "\n", "\\x" + wkb.hex() + "\r\n\r\n",
                                    "0x" + upper, "\"" + upper + "\""}) {
      const LoadedFile file = read_map(text);
      CHECK(file.format == "wkb");
      CHECK(file.warnings.empty());
      check_same(file, wkt);
      CHECK(file.data.source->curves->curves == wkt.data.source->curves->curves);
    }
  }
}

TEST_CASE("heights, measures and reference systems of EWKB and ISO WKB are understood") {
  const std::vector<Vec2> line{{1, 2}, {4, 5}};
  CHECK(read_map(Bytes().type(1002).count(2).at({1, 2, 3, 4, 5, 6}).text()).data.positions == line);
  CHECK(read_map(Bytes().type(3002).count(2).at({1, 2, 3, NAN, 4, 5, 6, 7}).hex()).data.positions == line);
  const LoadedFile high = read_map(Bytes().type(kEwkbZ | 2U).count(2).at({1, 2, 3, 4, 5, 6}).hex());
  CHECK(high.data.positions == line);
  CHECK(high.warnings == std::vector<std::string>{"map: heights and measures are left out"});
  const std::string degrees = Bytes().type(kEwkbSystem | 2U).count(4326).count(2).at({29, 60, 31, 60}).hex();
  check_same(read_map(degrees), read_map("SRID=4326;LINESTRING (29 60, 31 60)"));
  CHECK_FALSE(read_map(Bytes().type(kEwkbSystem | 1U).count(3857).at({29, 60}).hex()).degrees.has_value());
  // One geometry a line, some of them empty.
  const std::string lines = Bytes().type(1).at({1, 2}).hex() + "\n" + Bytes(true).type(1).at({NAN, NAN}).hex() +
                            "\n\n" + Bytes(true).type(1).at({3, 4}).hex() + "\n" + Bytes().type(7).count(0).hex();
  CHECK(read_map(lines).data.positions == std::vector<Vec2>{{1, 2}, {3, 4}});
}

TEST_CASE("WKB that is wrong is refused where it is wrong") {
  const std::string line = Bytes().type(2).count(2).at({1, 2, 3, 4}).text();
  for (std::size_t size = 9; size < line.size(); ++size)
    CHECK_FALSE(read_sample_bytes(line.substr(0, size), "a.wkb"));
  CHECK(refusal(line.substr(0, 30)) == "a: at byte 9: it is too short for 2 parts");
  CHECK(refusal(Bytes().type(3).count(4000000000).text()) == "a: at byte 9: it is too short for 4000000000 parts");
  CHECK(refusal(Bytes().type(2).count(1).at({1, NAN}).text()) == "a: at byte 9: nan is not a finite number");
  CHECK(refusal(Bytes().type(7).count(1).type(99).count(0).text()) == "a: at byte 14: there is no type 99");
  CHECK(refusal(Bytes().type(9).count(1).type(1).at({1, 2}).text()).starts_with("a: at byte 14: this is no curve"));
  CHECK(refusal(Bytes().type(8).count(2).at({1, 2, 3, 4}).text()).contains("three positions"));
  const std::string good = Bytes().type(1).at({1, 2}).hex();
  CHECK(refusal(good + "\n" + good + "0\n") == "a:2:44: the line ends within a byte");
  CHECK(refusal(good + "\n01010000x0\n") == "a:2:9: expected a hexadecimal digit, found \"x\"");
  CHECK(refusal(good + "\n0101000000\n") == "a:2:1: at byte 5 of the geometry: the bytes end within a geometry");
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += Bytes().type(7).count(1).text();
  CHECK(refusal(deep + Bytes().type(1).at({1, 2}).text()).contains("nested too deeply"));
}

TEST_CASE("files that are not read are named for what they are") {
  using namespace std::string_literals;
  CHECK(refusal("SQLite format 3\0\x10\0"s) ==
        "a:1:1: this is an SQLite database, such as a GeoPackage, not a text of samples");
  CHECK(refusal("II*\0\x08\0\0\0"s) == "a:1:1: this is a TIFF picture, not a text of samples");
  CHECK(refusal("AC1032\0\0\0"s) == "a:1:1: this is a DWG drawing, not a text of samples");
  CHECK(refusal("<gml:FeatureCollection xmlns:gml=\"g\"/>") ==
        "a:1:1: this is XML (FeatureCollection) that carries no session, not a text of samples");
  CHECK(refusal("solid cube\nfacet normal 0 0 1\n").starts_with("a:1:1: this is an STL mesh, none of the formats"));
  CHECK(
      refusal(R"({"type": "Topology", "objects": {}})").starts_with("a:1:1: this is TopoJSON, none of the formats"));
  CHECK(refusal(R"({"type":"Topology"})", "a.json").starts_with("a.json:1:1: this is TopoJSON, none of the formats"));
}

TEST_CASE("a hole that another polygon fills is a border of both, whichever way around rings run") {
  for (const bool is_turned : {false, true}) {
    const std::string hole = is_turned ? "2 2, 2 4, 4 4, 4 2, 2 2" : "2 2, 4 2, 4 4, 2 4, 2 2";
    const std::string in_json = is_turned ? "[2,2],[2,4],[4,4],[4,2],[2,2]" : "[2,2],[4,2],[4,4],[2,4],[2,2]";
    const std::string in_kml = is_turned ? "2,2 2,4 4,4 4,2 2,2" : "2,2 4,2 4,4 2,4 2,2";
    const auto kml_ring = [](const std::string& at) {
      return "<LinearRing><coordinates>" + at + "</coordinates></LinearRing>";
    };
    Bytes wkb;
    wkb.type(7).count(2).type(3).count(2).count(4).at({0, 0, 9, 0, 0, 9, 0, 0}).count(5);
    if (is_turned)
      wkb.at({2, 2, 2, 4, 4, 4, 4, 2, 2, 2});
    else
      wkb.at({2, 2, 4, 2, 4, 4, 2, 4, 2, 2});
    wkb.type(3).count(1).count(5).at({4, 4, 2, 4, 2, 2, 4, 2, 4, 4});
    const std::string maps[] = {"POLYGON ((0 0, 9 0, 0 9, 0 0), (" + hole + ")), POLYGON ((4 4, 2 4, 2 2, 4 2, 4 4))",
                                "MULTIPOLYGON (((4 4, 2 4, 2 2, 4 2, 4 4)), ((0 0, 9 0, 0 9, 0 0), (" + hole + ")))",
                                R"({"type":"MultiPolygon","coordinates":[[[[0,0],[9,0],[0,9],[0,0]],[)" + in_json +
                                    "]],[[[4,4],[2,4],[2,2],[4,2],[4,4]]]]}",
                                kKml + "<Placemark><Polygon><outerBoundaryIs>" + kml_ring("0,0 9,0 0,9 0,0") +
                                    "</outerBoundaryIs><innerBoundaryIs>" + kml_ring(in_kml) +
                                    "</innerBoundaryIs></Polygon></Placemark><Placemark><Polygon><outerBoundaryIs>" +
                                    kml_ring("4,4 2,4 2,2 4,2 4,4") +
                                    "</outerBoundaryIs></Polygon></Placemark></Document></kml>",
                                wkb.text()};
    for (const std::string& map : maps) {
      INFO(map);
      CHECK(read_map(map).data.contours.size() == 3);
    }
  }
  // What is there twice is there once.
  CHECK(read_map("POLYGON ((0 0, 9 0, 0 9, 0 0)), POLYGON ((9 0, 0 9, 0 0, 9 0))").data.contours.size() == 1);
}
