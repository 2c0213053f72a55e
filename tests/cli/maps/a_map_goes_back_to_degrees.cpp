// SPDX-License-Identifier: GPL-3.0-or-later
// What was read from a map in degrees is written in degrees wherever a file claims to be a map, at the places that it
// came from, whatever was done in between.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

using Places = std::vector<std::pair<double, double>>;

/// A coast with many corners, about 24.9 E, 35.2 N.
Places coast() {
  Places out;
  for (int i = 0; i < 40; ++i) {
    const double w = 6.283185307179586 * i / 40;
    const double r = 1.0 + 0.3 * std::cos(3 * w);
    out.emplace_back(24.90137780000012 + 1.1 * r * std::cos(w), 35.22716705900011 + 0.2 * r * std::sin(w));
  }
  return out;
}

std::string geojson(const Places& places) {
  Json ring = Json::array();
  for (const auto& [x, y] : places) ring.push_back({x, y});
  ring.push_back(ring.front());
  return Json{{"type", "Feature"},
              {"properties", nullptr},
              {"geometry", {{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}}
      .dump();
}

std::string wkt(const Places& places) {
  std::ostringstream out;
  out.precision(17);
  out << "SRID=4326;POLYGON ((";
  for (const auto& [x, y] : places) out << x << ' ' << y << ", ";
  out << places.front().first << ' ' << places.front().second << "))\n";
  return out.str();
}

std::string done(const std::vector<std::string>& command, const std::string& input = {}) {
  const RunResult result = run(command, {.input = input});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

/// The points of a layer of samples, from GeoJSON.
Places points_in(const std::string& text) {
  Places out;
  const Json all = Json::parse(text);
  for (const Json& feature : all["features"]) {
    const Json& at = feature["geometry"]["coordinates"];
    out.emplace_back(at[0].get<double>(), at[1].get<double>());
  }
  return out;
}

/// The first place of each line of WKT.
Places points_in_wkt(const std::string& text) {
  Places out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    REQUIRE(line.starts_with("SRID=4326;POINT ("));
    std::istringstream numbers(line.substr(17));
    double x = 0.0;
    double y = 0.0;
    numbers >> x >> y;
    out.emplace_back(x, y);
  }
  return out;
}

/// Each corner of the map is among the places, up to 1e-9 degrees.
void check_has(const Places& places, const Places& corners) {
  CHECK(places.size() >= corners.size());
  double worst = 0.0;
  for (const auto& [x, y] : corners) {
    double nearest = 1e9;
    for (const auto& [u, v] : places) nearest = std::min(nearest, std::max(std::abs(u - x), std::abs(v - y)));
    worst = std::max(worst, nearest);
  }
  CHECK(worst < 1e-9);
}

std::vector<std::string> exporting(const std::string& file, const std::string& layer, const std::string& format) {
  return {"export", file, "--layer", layer, "--format", format};
}

}  // namespace

TEST_CASE("the samples of a map in degrees are exported at the places of its corners") {
  const TemporaryFolder folder;
  for (const std::string& file :
       {folder.write("a.geojson", geojson(coast())).string(), folder.write("a.wkt", wkt(coast())).string()}) {
    const std::string text = done(exporting(file, "points", "geojson"));
    CHECK_THAT(text, Catch::Contains("CRS84"));
    check_has(points_in(text), coast());
    check_has(points_in_wkt(done(exporting(file, "points", "wkt"))), coast());
    // Read again, it is the same map once more.
    check_has(points_in(done(exporting("-", "points", "geojson"), text)), coast());
    check_has(points_in(done(exporting("-", "points", "geojson"), done(exporting(file, "points", "wkt")))), coast());
    // Kept degrees are degrees, too.
    std::vector<std::string> kept = exporting(file, "points", "geojson");
    kept.emplace_back("--degrees");
    check_has(points_in(done(kept)), coast());
  }
}

TEST_CASE("every layer of a map lies where the map does") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.geojson", geojson(coast())).string();
  for (const char* layer : {"curve", "medial-axis", "interior-voronoi-disks", "delaunay"}) {
    INFO(layer);
    const Json all = Json::parse(done(exporting(file, layer, "geojson")));
    REQUIRE_FALSE(all["features"].empty());
    for (const Json& feature : all["features"]) {
      Json list = feature["geometry"]["coordinates"];
      if (feature["geometry"]["type"] == "Polygon") list = Json(list[0]);
      for (const Json& at : list) {
        CHECK(std::abs(at[0].get<double>() - 24.9) < 1.6);
        CHECK(std::abs(at[1].get<double>() - 35.2) < 0.4);
      }
      if (!feature["properties"].contains("center")) continue;
      // The radius is in metres; from 35.2 to 35.3 degrees north there are 11094.516 of them, by geod.
      const double radius = feature["properties"]["radius"].get<double>();
      double highest = 0.0;
      for (const Json& at : list)
        highest = std::max(highest, at[1].get<double>() - feature["properties"]["center"][1].get<double>());
      CHECK(highest * 110945.16 == Approx(radius).epsilon(2e-3));
    }
  }
}

TEST_CASE("what is done to a map is still on the map") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.geojson", geojson(coast())).string();
  for (const std::vector<std::string>& command : {std::vector<std::string>{"sample", file, "--rule", "vertices"},
                                                  {"repair", file},
                                                  {"decimate", file},
                                                  {"evolve", file, "--evolution", "subdivide", "--steps", "0"},
                                                  exporting(file, "points", "poff")}) {
    INFO(command.front());
    const std::string poff = done(command);
    CHECK_THAT(poff, Catch::Contains("\n# map metres about 25."));
    const Places places = points_in(done(exporting("-", "points", "geojson"), poff));
    for (const auto& [x, y] : places) CHECK((std::abs(x - 24.9) < 1.6 && std::abs(y - 35.2) < 0.4));
    if (command.front() != "decimate") check_has(places, coast());
  }
  // The axis as POFF, and that as GeoJSON.
  const std::string axis = done(exporting(file, "medial-axis", "poff"));
  CHECK(Json::parse(done(exporting("-", "points", "geojson"), axis)).contains("crs"));
  // A picture carries its session, which knows where it lies.
  const std::string picture = (folder.path() / "a.svg").string();
  done({"render", file, "--layers", "curve", "-o", picture});
  check_has(points_in(done(exporting(picture, "points", "geojson"))), coast());
}

TEST_CASE("maps across the 180th meridian are cut there, and join again") {
  const TemporaryFolder folder;
  const Places fiji{{179, -17}, {-179.5, -16.5}, {-179, -18}, {178.5, -18.5}};
  const std::string file = folder.write("a.geojson", geojson(fiji)).string();
  const std::string points = done(exporting(file, "points", "geojson"));
  check_has(points_in(points), fiji);
  for (const auto& [x, y] : points_in(points)) CHECK(std::abs(x) <= 180.0);
  const Json curve = Json::parse(done(exporting(file, "curve", "geojson")))["features"];
  bool is_cut = false;
  for (const Json& feature : curve) {
    const bool is_multi = feature["geometry"]["type"] == "MultiLineString";
    is_cut = is_cut || is_multi;
    const Json parts =
        is_multi ? feature["geometry"]["coordinates"] : Json::array({feature["geometry"]["coordinates"]});
    for (const Json& part : parts)
      for (std::size_t i = 1; i < part.size(); ++i)
        CHECK(std::abs(part[i][0].get<double>() - part[i - 1][0].get<double>()) < 3.0);
  }
  CHECK(is_cut);
  CHECK_THAT(done(exporting(file, "curve", "wkt")), Catch::Contains("SRID=4326;MULTILINESTRING (("));
  const Json disks = Json::parse(done(exporting(file, "interior-voronoi-disks", "geojson")))["features"];
  CHECK(std::ranges::any_of(disks, [](const Json& f) { return f["geometry"]["type"] == "MultiPolygon"; }));
}

TEST_CASE("what is of the plane stays in the plane") {
  CHECK_FALSE(Json::parse(done(exporting("-", "points", "geojson"), "1 2\n3 4\n")).contains("crs"));
  CHECK(done(exporting("-", "points", "wkt"), "1 2\n3 4\n") == "POINT (1 2)\nPOINT (3 4)\n");
  CHECK_THAT(done(exporting("-", "points", "poff"), "1 2\n3 4\n"), !Catch::Contains("map"));
  // Comments of POFF that speak of something else.
  for (const char* note :
       {"# map of Crete", "# map metre of Crete", "# map metres about 1 2 of", "# map kilometres about here 3",
        "# map kilometres about 1 95", "# map degrees of freedom"})
    CHECK_FALSE(Json::parse(done(exporting("-", "points", "geojson"), std::string("POFF 1 0 0\n1 2\n") + note + "\n"))
                    .contains("crs"));
  // A drawing has a unit, and no place on the Earth: lines beyond 180 units are not cut.
  const std::string drawing = "POFF 2 0 0\n100 200\n300 200\n# loop open 0 1\n# unit mm\n";
  CHECK_FALSE(Json::parse(done(exporting("-", "contours", "geojson"), drawing)).contains("crs"));
  CHECK(done(exporting("-", "contours", "wkt"), drawing) == "LINESTRING (100 200,300 200)\n");
  CHECK_THAT(done(exporting("-", "points", "poff"), drawing), Catch::Contains("# unit mm\n"));
  const Json input = Json::parse(done({"compute", "-", "--layers", "points"}, drawing))["input"];
  CHECK(input["unit"] == "mm");
  CHECK_FALSE(input.contains("system"));
  CHECK_THAT(done(exporting("-", "points", "poff"), drawing + "# page 400 250.5\n"),
             Catch::Contains("# unit mm\n# page 400 250.5\n"));
  for (const char* note : {"# page 400", "# page 400 -1", "# page 1 2 3"})
    CHECK_THAT(done(exporting("-", "points", "poff"), drawing + note + "\n"), !Catch::Contains("# page"));
  for (const char* note : {"# unit", "# unit of lengths", "# unit degree"})
    CHECK_FALSE(Json::parse(done({"compute", "-", "--layers", "points"},
                                 std::string("POFF 1 0 0\n1 2\n") + note + "\n"))["input"]
                    .contains("unit"));
}
