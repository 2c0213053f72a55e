// SPDX-License-Identifier: GPL-3.0-or-later
// A house in Germany stays in Germany: whatever coordinate system a map has, results are in it again, lengths are
// metres, and a system that makes no sense is one line.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

/// A house of 12 m by 8 m in Hanover: in UTM zone 32, and in degrees by cs2cs.
constexpr const char* kHouse =
    "POLYGON ((548200 5803100, 548212 5803100, 548212 5803108, 548200 5803108, 548200 5803100))";
constexpr const char* kHouseInDegrees =
    "POLYGON ((9.708059376978 52.376042809237, 9.708235642704 52.376041753165, 9.708236793236 52.376113670722, "
    "9.708060527224 52.376114726796, 9.708059376978 52.376042809237))";
constexpr double kMiddleEast = 9.708148085036;
constexpr double kMiddleNorth = 52.376078240013;

std::string house_as_geojson() {
  return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},)"
         R"("features":[{"type":"Feature","properties":{"street":"Am Markt"},"geometry":{"type":"Polygon",)"
         R"("coordinates":[[[548200,5803100],[548212,5803100],[548212,5803108],[548200,5803108],[548200,5803100]]]}}]})";
}

std::string well_done(const std::vector<std::string>& command, std::string* remarks = nullptr) {
  const RunResult result = run(command);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  if (remarks != nullptr) *remarks = result.err;
  return result.out;
}

/// All pairs of numbers after the first letter of `text` that starts a list of positions.
std::vector<std::pair<double, double>> positions_of_wkt(const std::string& text) {
  std::vector<std::pair<double, double>> out;
  std::string list = text.substr(text.find('('));
  std::ranges::replace_if(
      list, [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream numbers(list);
  for (double x = 0.0, y = 0.0; numbers >> x >> y;) out.emplace_back(x, y);
  return out;
}

std::vector<std::pair<double, double>> positions_of_csv(const std::string& text, std::size_t column) {
  std::vector<std::pair<double, double>> out;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream cells(line);
    std::vector<double> values;
    for (double x = 0.0; cells >> x;) values.push_back(x);
    out.emplace_back(values.at(column), values.at(column + 1));
  }
  return out;
}

void check_in_house(const std::vector<std::pair<double, double>>& positions) {
  REQUIRE_FALSE(positions.empty());
  for (const auto& [x, y] : positions) {
    CHECK((x >= 548200 - 1e-6 && x <= 548212 + 1e-6));
    CHECK((y >= 5803100 - 1e-6 && y <= 5803108 + 1e-6));
  }
}

void check_in_house_in_degrees(const std::vector<std::pair<double, double>>& positions) {
  REQUIRE_FALSE(positions.empty());
  for (const auto& [x, y] : positions) {
    CHECK(std::abs(x - kMiddleEast) < 0.0000890);
    CHECK(std::abs(y - kMiddleNorth) < 0.0000366);
  }
}

std::string refusal_of(const std::vector<std::string>& command, int code) {
  const RunResult result = run(command);
  INFO(result.err);
  CHECK(result.exit_code == code);
  CHECK(result.out.empty());
  CHECK(std::ranges::count(result.err, '\n') == 1);
  return result.err;
}

}  // namespace

TEST_CASE("the axis of a house in Germany is in the house, in every format") {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> inputs{
      {folder.write("a.wkt", std::string("SRID=25832;") + kHouse).string()},
      {folder.write("b.wkt", kHouse).string(), "--crs", "EPSG:25832"},
      {folder.write("c.geojson", house_as_geojson()).string()}};
  for (const auto& input : inputs) {
    INFO(input.front());
    const auto centerline = [&](const std::string& format, std::vector<std::string> more = {}) {
      std::vector<std::string> command{"centerline", "--format", format};
      command.insert(command.end(), input.begin(), input.end());
      command.insert(command.end(), more.begin(), more.end());
      std::string remarks;
      const std::string out = well_done(command, &remarks);
      CHECK_THAT(remarks,
                 Catch::Contains("coordinates are those of ETRS89 / UTM zone 32N (EPSG:25832), in m; lengths "
                                 "are right to 0.037 %"));
      CHECK_THAT(remarks, Catch::Contains(" m in all, width "));
      return out;
    };
    const Json features = Json::parse(centerline("geojson"));
    CHECK_THAT(features["crs"].dump(), Catch::Contains("CRS84"));
    std::vector<std::pair<double, double>> degrees;
    for (const Json& at : features["features"][0]["geometry"]["coordinates"]) degrees.emplace_back(at[0], at[1]);
    check_in_house_in_degrees(degrees);
    CHECK(features["features"][0]["properties"]["width_largest"].get<double>() == Approx(8.0).epsilon(0.01));
    const std::string wkt = centerline("wkt");
    CHECK_THAT(wkt, Catch::StartsWith("SRID=25832;LINESTRING ("));
    check_in_house(positions_of_wkt(wkt));
    check_in_house(positions_of_csv(centerline("csv"), 1));
    check_in_house(positions_of_csv(centerline("csv", {"--every", "1"}), 3));
    CHECK_THAT(centerline("dxf"), Catch::Contains("\n10\n5482") && Catch::Contains("\n20\n58031"));
  }
}

TEST_CASE("the same house in degrees has the same axis, in degrees and in metres") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.wkt", std::string("SRID=4326;") + kHouseInDegrees).string();
  std::string remarks;
  const std::string wkt = well_done({"centerline", file, "--format", "wkt"}, &remarks);
  CHECK_THAT(remarks,
             Catch::Contains("degrees are projected to metres about 9.708 E, 52.38 N: azimuthal equidistant, "
                             "lengths are right to 0.0001 %"));
  CHECK_THAT(wkt, Catch::StartsWith("SRID=4326;LINESTRING ("));
  check_in_house_in_degrees(positions_of_wkt(wkt));
  check_in_house_in_degrees(positions_of_csv(well_done({"centerline", file, "--format", "csv"}), 1));
  check_in_house_in_degrees(positions_of_csv(well_done({"centerline", file, "--every", "1", "--format", "csv"}), 3));
  // The factor of UTM there is 0.99963.
  const Json sizes = Json::parse(well_done({"compute", file, "--layers", "curve", "--no-timing"}))["layers"];
  CHECK(sizes["curve"]["length"].get<double>() == Approx(40.0 / 0.99963).epsilon(1e-5));
  // A line is asked for by points of the map.
  const std::string between =
      well_done({"centerline", file, "--format", "wkt", "--between", "9.70809,52.376078", "9.70821,52.376078"});
  const auto ends = positions_of_wkt(between);
  CHECK(std::abs(ends.front().first - ends.back().first) > 0.00005);
}

TEST_CASE("layers of a map are written in its system") {
  const TemporaryFolder folder;
  const std::string grid = folder.write("a.wkt", std::string("SRID=25832;") + kHouse).string();
  const std::string degrees = folder.write("b.wkt", std::string("SRID=4326;") + kHouseInDegrees).string();
  const auto layer = [](const std::string& file, const std::string& name, const std::string& format) {
    return well_done({"export", file, "--layer", name, "--format", format});
  };
  for (const char* name : {"medial-axis", "curve", "points"}) {
    INFO(name);
    check_in_house(positions_of_csv(layer(grid, name, "csv"), 0));
    check_in_house_in_degrees(positions_of_csv(layer(degrees, name, "csv"), 0));
    CHECK_THAT(layer(grid, name, "wkt"), Catch::StartsWith("SRID=25832;"));
    CHECK_THAT(layer(degrees, name, "wkt"), Catch::StartsWith("SRID=4326;"));
    const Json features = Json::parse(layer(grid, name, "geojson"))["features"];
    for (const Json& feature : features) {
      Json list = feature["geometry"]["coordinates"];
      if (feature["geometry"]["type"] == "Point") list = Json::array({list});
      for (const Json& at : list) check_in_house_in_degrees({{at[0].get<double>(), at[1].get<double>()}});
    }
  }
  // Radii are metres beside degrees.
  const std::string disks = layer(degrees, "interior-voronoi-disks", "csv");
  check_in_house_in_degrees(positions_of_csv(disks, 0));
  double largest = 0.0;
  for (const auto& [y, radius] : positions_of_csv(disks, 1)) largest = std::max(largest, radius);
  CHECK(largest == Approx(4.0).epsilon(0.01));
}

TEST_CASE("a GeoPackage or a FlatGeobuf has the positions of its map, but for rounding") {
  const TemporaryFolder folder;
  // Long Island in feet, and the same datum in degrees: ways to WGS 84 and back differ there by a metre.
  for (const std::string text :
       {"SRID=2263;POLYGON ((1000000 200000, 1000600 200000, 1000600 200100, 1000000 200100, 1000000 200000))",
        "SRID=4269;POLYGON ((-73.94 40.71, -73.937 40.71, -73.937 40.7105, -73.94 40.7105, -73.94 40.71))"}) {
    const std::string file = folder.write("a.wkt", text).string();
    for (const std::string format : {"gpkg", "fgb"}) {
      INFO(text << " as " << format);
      const std::string copy = (folder / ("line." + format)).string();
      well_done({"centerline", file, "--exact", "--extend", "-o", copy, "--force"});
      const auto positions = [&](const std::string& map) {
        return positions_of_csv(
            well_done({"export", map, "--vertices", "--degrees", "--layer", "points", "--format", "csv"}), 0);
      };
      const std::string wkt = (folder / "line.wkt").string();
      well_done({"centerline", file, "--exact", "--extend", "-o", wkt, "--force"});
      const auto there = positions(wkt);
      const auto back = positions(copy);
      REQUIRE(back.size() == there.size());
      for (std::size_t i = 0; i < there.size(); ++i) {
        CHECK(back[i].first == Approx(there[i].first).epsilon(1e-14));
        CHECK(back[i].second == Approx(there[i].second).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("positions in tables of structures are those of the map") {
  const TemporaryFolder folder;
  const std::string grid = folder.write("a.wkt", std::string("SRID=25832;") + kHouse).string();
  const std::string degrees = folder.write("b.wkt", std::string("SRID=4326;") + kHouseInDegrees).string();
  const auto table = [](const std::string& file, const char* structure, const char* name) {
    const std::string csv = well_done({"export", file, "--structure", structure, "--table", name, "--format", "csv"});
    return positions_of_csv(csv, 1);
  };
  check_in_house(table(grid, "samples", "samples"));
  check_in_house_in_degrees(table(degrees, "samples", "samples"));
  check_in_house_in_degrees(table(degrees, "outline-axis", "nodes"));
  // Directions have no place on a map.
  for (const auto& [x, y] : table(degrees, "curve", "sites")) CHECK(std::hypot(x, y) <= 1.0 + 1e-12);
  std::string told;
  well_done({"export", degrees, "--structure", "a-power-diagram", "--table", "edges", "--format", "csv"}, &told);
  CHECK_THAT(told, Catch::Contains("edges: positions are those of the plane, since the table has directions"));
  CHECK(table(degrees, "outline-axis", "nodes").size() == table(grid, "outline-axis", "nodes").size());
}

TEST_CASE("POFF and sessions keep the system on the way from map to map") {
  const TemporaryFolder folder;
  const std::string map = folder.write("a.wkt", std::string("SRID=25832;") + kHouse).string();
  const std::string poff = (folder / "a.poff").string();
  well_done({"sample", map, "--rule", "vertices", "-o", poff});
  CHECK_THAT(contents_of(poff), Catch::Contains("\n# map metre of EPSG:25832\n"));
  const std::string wkt = well_done({"export", poff, "--layer", "points", "--format", "wkt"});
  CHECK_THAT(wkt, Catch::Contains("SRID=25832;POINT (548212 5803108)\n"));
  const std::string picture = (folder / "a.svg").string();
  well_done({"render", map, "--vertices", "--layers", "curve", "-o", picture});
  CHECK(well_done({"export", picture, "--layer", "points", "--format", "wkt"}) == wkt);
  // Old files say where they lie in kilometres, and are computed in these.
  const std::string old = folder
                              .write("old.poff",
                                     "POFF 3 0 0\n-1 -1\n2 -1\n0 3\n# map kilometres about 9.7 52.3\n"
                                     "# loop closed 0 1 2\n")
                              .string();
  const Json points = Json::parse(well_done({"export", old, "--layer", "points", "--format", "geojson"}))["features"];
  constexpr double kKilometresADegree = 6371.0088 * 3.14159265358979323846 / 180.0;
  CHECK(points[2]["geometry"]["coordinates"][1].get<double>() ==
        Approx(52.3 + 3 / kKilometresADegree).epsilon(1e-14));
  CHECK_THAT(well_done({"export", old, "--layer", "points", "--format", "poff"}),
             Catch::Contains("0 3\n# map kilometres about 9.7 52.3\n"));
}

TEST_CASE("a coordinate system that makes no sense is one line with exit code 3") {
  const TemporaryFolder folder;
  const std::string plain = folder.write("a.wkt", kHouse).string();
  CHECK_THAT(refusal_of({"centerline", plain, "--crs", "EPSG:999999"}, 2),
             Catch::Contains("--crs: \"EPSG:999999\" is not a coordinate system that PROJ knows"));
  CHECK_THAT(refusal_of({"centerline", plain, "--crs", "EPSG:4326"}, 3),
             Catch::Contains("not a longitude and latitude"));
  CHECK_THAT(refusal_of({"centerline", plain, "--crs", "EPSG:5773"}, 2),
             Catch::Contains("not a coordinate system of the Earth's surface"));
  const std::string unknown = folder.write("b.wkt", std::string("SRID=99999;") + kHouse).string();
  CHECK_THAT(refusal_of({"centerline", unknown}, 3), Catch::Contains("b.wkt:1:6: \"EPSG:99999\" is not"));
  const std::string mixed =
      folder.write("c.wkt", std::string("SRID=25832;") + kHouse + "\nSRID=4326;" + kHouseInDegrees).string();
  CHECK_THAT(refusal_of({"compute", mixed}, 3),
             Catch::Contains("c.wkt:2:6: this is in WGS 84, and what comes before"));
  const std::string beyond = folder.write("d.wkt", "SRID=4326;POINT (9 91)").string();
  CHECK_THAT(refusal_of({"compute", beyond}, 3), Catch::Contains("9, 91 is not a longitude and latitude"));
  const std::string picture = folder.write("e.pbm", "P1\n3 3\n0 0 0\n0 1 0\n0 0 0\n").string();
  CHECK_THAT(refusal_of({"compute", picture, "--crs", "EPSG:25832"}, 2), Catch::Contains("pictures have none"));
  // No point, one and two.
  CHECK_THAT(refusal_of({"compute", folder.write("f.wkt", "SRID=25832;POINT EMPTY").string()}, 3),
             Catch::Contains("nothing in it"));
  for (const char* points : {"POINT (548200 5803100)", "MULTIPOINT (548200 5803100, 548212 5803108)"}) {
    const std::string file = folder.write("g.wkt", std::string("SRID=25832;") + points).string();
    CHECK_THAT(well_done({"export", file, "--layer", "points", "--format", "wkt"}),
               Catch::StartsWith("SRID=25832;POINT (548200 5803100)\n"));
  }
}

TEST_CASE("a shape around a pole is left out and counted, and those beside it are written") {
  const TemporaryFolder folder;
  std::string ring;
  for (int longitude = -180; longitude <= 180; longitude += 5) ring += std::to_string(longitude) + " 85, ";
  const std::string file =
      folder.write("a.wkt", "SRID=4326;POLYGON ((" + ring + "180 90, -180 90, -180 85))").string();
  std::string remarks;
  const Json disks =
      Json::parse(well_done({"export", file, "--layer", "interior-voronoi-disks", "--format", "geojson"}, &remarks));
  CHECK_THAT(remarks, Catch::Contains("metres about 0, 90 N"));
  CHECK_THAT(remarks, Catch::Contains("beyond the poles or around the Earth"));
  // The samples have their places, from -180 to 180 degrees.
  const Json points =
      Json::parse(well_done({"export", file, "--layer", "points", "--format", "geojson"}))["features"];
  CHECK(points.size() >= 72);
  for (const Json& point : points) {
    CHECK(point["geometry"]["coordinates"][1].get<double>() == Approx(85.0).margin(1e-6));
    CHECK(std::abs(point["geometry"]["coordinates"][0].get<double>()) <= 180.0);
  }
}

TEST_CASE(
    "long sides that a projection bends have no corner between their ends, so that the axis has no branch there") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.wkt", "SRID=4326;POLYGON ((10 50, 11 50, 11 51, 10 51, 10 50))").string();
  const auto length_of_axis = [&](std::vector<std::string> options) {
    std::vector<std::string> command{"compute", file, "--layers", "outline-axis"};
    command.insert(command.end(), options.begin(), options.end());
    return Json::parse(well_done(command))["layers"]["outline-axis"]["length"].get<double>();
  };
  // Between four vertices alone sides are straight.
  CHECK(length_of_axis({}) == Approx(length_of_axis({"--vertices"})).epsilon(1e-4));
}
