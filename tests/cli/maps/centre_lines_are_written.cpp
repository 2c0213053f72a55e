// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina centerline`: lines and stations in every format, of maps in degrees, feature by feature, or one clear line.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

constexpr const char* kStrip = "POLYGON ((0 0, 8 0, 8 2, 0 2, 0 0))";

std::string lines_written(const std::vector<std::string>& arguments, const std::string& input = {}) {
  const RunResult result = run(with({"centerline"}, arguments), {.input = input});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

std::string line_fault(int code, const std::vector<std::string>& arguments, const std::string& input = {}) {
  const RunResult result = run(with({"centerline"}, arguments), {.input = input});
  INFO(result.err);
  CHECK(result.exit_code == code);
  CHECK(result.out.empty());
  // Remarks on reading may come before.
  CHECK(std::ranges::count(result.err, '\n') <= 3);
  return result.err.substr(result.err.rfind("mesecina: "));
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> out;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    out.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) out.back().push_back(cell);
  }
  return out;
}

}  // namespace

TEST_CASE("the centre line of a strip runs from side to side, in every format") {
  const TemporaryFolder folder;
  const std::string strip = folder.write("strip.wkt", kStrip).string();
  const Json all = Json::parse(lines_written({strip, "--extend"}));
  REQUIRE(all["features"].size() == 1);
  const Json& feature = all["features"][0];
  CHECK_FALSE(all.contains("crs"));
  CHECK(feature["properties"]["length"].get<double>() == Approx(8.0).epsilon(1e-3));
  CHECK(feature["properties"]["width_mean"].get<double>() == Approx(2.0).epsilon(1e-3));
  CHECK(feature["properties"]["shape"] == 1);
  CHECK(feature["properties"]["line"] == 1);
  const Json& places = feature["geometry"]["coordinates"];
  CHECK(feature["geometry"]["type"] == "LineString");
  CHECK(places.front()[0].get<double>() == Approx(0.0).margin(1e-9));
  CHECK(places.back()[0].get<double>() == Approx(8.0).margin(1e-9));
  for (const Json& place : places) CHECK(place[1].get<double>() == Approx(1.0).margin(1e-3));

  // The same line in the other formats, by option and by name, which the program reads back.
  for (const std::string format : {"wkt", "svg", "dxf", "csv", "geojson"}) {
    const std::string file = (folder / ("line." + format)).string();
    CHECK(lines_written({strip, "--extend", "-o", file}).empty());
    CHECK(contents_of(file) == lines_written({strip, "--extend", "--format", format}));
    if (format == "csv") continue;
    const RunResult read = run({"compute", file, "--vertices", "--layers", "points"});
    INFO(format << ": " << read.err);
    REQUIRE(read.exit_code == 0);
    CHECK(Json::parse(read.out)["input"]["samples"] == places.size());
  }
  const auto rows = rows_of(contents_of(folder / "line.csv"));
  REQUIRE(rows.size() == places.size() + 1);
  CHECK(rows[0] == std::vector<std::string>{"line", "x", "y"});
  CHECK(std::stod(rows[1][1]) == places[0][0].get<double>());
  CHECK(lines_written({"-"}, kStrip) == lines_written({strip}));
  CHECK(lines_written({strip, "--format", "wkt"}).starts_with("LINESTRING ("));
  CHECK(lines_written({strip}) == lines_written({strip}));
}

TEST_CASE("pruning, smoothing and branches are chosen") {
  const auto summary = [](const std::vector<std::string>& more) {
    const Json all = Json::parse(lines_written(with({"-"}, more), kStrip));
    std::vector<double> out;
    for (const Json& feature : all["features"]) out.push_back(feature["properties"]["length"]);
    return out;
  };
  CHECK(summary({}) == summary({"--prune", "0.5", "--smooth", "25%", "--branches", "1"}));
  CHECK(summary({}).at(0) == Approx(6.0).margin(0.1));
  CHECK(summary({"--branches", "9"}).size() == 1);
  const auto unpruned = summary({"--prune", "0", "--smooth", "0", "--branches", "9"});
  REQUIRE(unpruned.size() == 3);
  CHECK(unpruned[0] == Approx(6.0 + 2.0 * std::sqrt(2.0)).margin(0.01));
  CHECK(unpruned[1] == Approx(std::sqrt(2.0)).margin(0.02));
  // Smoothing cuts the bends at the corners short.
  CHECK(summary({"--prune", "0", "--smooth", "0.2"}).at(0) < unpruned[0] - 0.01);
  const auto ends = Json::parse(lines_written({"-", "--prune", "0", "--between", "-1,-1", "9,9", "--smooth", "0"},
                                              kStrip))["features"][0]["geometry"]["coordinates"];
  CHECK(ends.front()[0].get<double>() < 0.01);
  CHECK(ends.front()[1].get<double>() < 0.01);
  CHECK(ends.back()[0].get<double>() > 7.99);
  CHECK(ends.back()[1].get<double>() > 1.99);
}

TEST_CASE("the exact axis of an outline has an exact line, however thin the outline is") {
  const Json strip = Json::parse(lines_written({"-", "--exact", "--smooth", "0"}, kStrip));
  REQUIRE(strip["features"].size() == 1);
  CHECK(strip["features"][0]["properties"]["length"] == 6.0);
  CHECK(strip["features"][0]["properties"]["width_least"] == 2.0);
  CHECK(strip["features"][0]["properties"]["width_largest"] == 2.0);
  const auto rows =
      rows_of(lines_written({"-", "--exact", "--smooth", "0", "--every", "3", "--format", "csv"}, kStrip));
  REQUIRE(rows.size() == 4);
  CHECK(rows[2] == std::vector<std::string>{"1", "1", "3", "4", "1", "2", "4", "2", "4", "0", "0"});
  const Json thin =
      Json::parse(lines_written({"-", "--exact", "--extend"}, "POLYGON ((0 0, 4000000 0, 4000000 1, 0 1, 0 0))"));
  REQUIRE(thin["features"].size() == 1);
  CHECK(thin["features"][0]["properties"]["length"].get<double>() == Approx(4e6).epsilon(1e-12));
  CHECK_THAT(line_fault(1, {"-", "--exact"}, "0 0\n8 0\n8 2\n0 2\n"),
             Catch::Contains("there is no centre line: no closed outline encloses anything"));
}

TEST_CASE("stations have widths, both banks and a direction") {
  const std::string wedge = "POLYGON ((0 0, 10 -1, 10 1, 0 0))";
  const auto rows =
      rows_of(lines_written({"-", "--every", "0.5", "--format", "csv", "--prune", "1", "--smooth", "0"}, wedge));
  CHECK(rows[0] == std::vector<std::string>{"shape", "line", "station", "x", "y", "width", "left_x", "left_y",
                                            "right_x", "right_y", "direction"});
  REQUIRE(rows.size() > 15);
  const double sine = 1.0 / std::sqrt(101.0);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    REQUIRE(rows[i].size() == 11);
    const double x = std::stod(rows[i][3]);
    CHECK(std::stod(rows[i][2]) == Approx(0.5 * static_cast<double>(i - 1)));
    if (x < 0.5 || i + 2 > rows.size()) continue;
    CHECK(std::stod(rows[i][4]) == Approx(0.0).margin(0.01));
    CHECK(std::stod(rows[i][5]) == Approx(2.0 * x * sine).epsilon(0.01));
    CHECK(std::stod(rows[i][7]) == Approx(0.1 * std::stod(rows[i][6])).margin(1e-6));
    CHECK(std::stod(rows[i][9]) == Approx(-0.1 * std::stod(rows[i][8])).margin(1e-6));
  }
  // Other formats have a line across the shape for each.
  const Json across = Json::parse(lines_written({"-", "--every", "0.5", "--prune", "1", "--smooth", "0"}, wedge));
  REQUIRE(across["features"].size() + 1 == rows.size());
  const Json& one = across["features"][10];
  CHECK(one["properties"]["station"] == 5.0);
  CHECK(one["properties"]["width"].get<double>() == Approx(std::stod(rows[11][5])));
  REQUIRE(one["geometry"]["coordinates"].size() == 3);
  CHECK(one["geometry"]["coordinates"][0][1].get<double>() == Approx(std::stod(rows[11][7])));
}

TEST_CASE("lines of a map in degrees are in degrees, and feature by feature with properties") {
  const TemporaryFolder folder;
  const auto parcel = [](double x, double y) {
    return Json{{"type", "Polygon"},
                {"coordinates",
                 Json::array({Json::array({{x, y}, {x + 0.1, y}, {x + 0.1, y + 0.01}, {x, y + 0.01}, {x, y}})})}};
  };
  const Json map{{"type", "FeatureCollection"},
                 {"features",
                  {{{"type", "Feature"},
                    {"id", "a"},
                    {"properties", {{"name", "long \"lot\", {1}"}, {"length", 7}}},
                    {"geometry", parcel(9, 50)}},
                   {{"type", "Feature"}, {"id", 2}, {"properties", {{"name", "empty"}}}, {"geometry", nullptr}},
                   {{"type", "Feature"}, {"properties", nullptr}, {"geometry", parcel(20, 60)}}}}};
  const std::string file = folder.write("map.geojson", map.dump(1)).string();

  const Json together = Json::parse(lines_written({file, "--extend"}));
  REQUIRE(together["features"].size() == 2);
  CHECK(together.contains("crs"));

  const RunResult apart = run({"centerline", file, "--each", "--extend"});
  INFO(apart.err);
  REQUIRE(apart.exit_code == 1);
  CHECK_THAT(apart.err, Catch::Contains("feature 2, id 2: "));
  const Json each = Json::parse(apart.out);
  REQUIRE(each["features"].size() == 2);
  const Json& first = each["features"][0];
  CHECK(first["id"] == "a");
  CHECK(first["properties"]["name"] == "long \"lot\", {1}");
  CHECK(first["properties"]["length"] == 7);
  // Each feature is projected about its own middle, where a degree of longitude is as long as it is: in metres by geod.
  const double width = 7168.83;
  CHECK(first["properties"]["centerline_length"].get<double>() == Approx(width).epsilon(1e-3));
  CHECK(first["geometry"]["coordinates"].front()[0].get<double>() == Approx(9.0).margin(1e-6));
  CHECK(first["geometry"]["coordinates"].front()[1].get<double>() == Approx(50.005).margin(1e-4));
  CHECK_FALSE(each["features"][1].contains("id"));
  CHECK(each["features"][1]["properties"]["shape"] == 1);
  // A name has one meaning in the whole file.
  CHECK_FALSE(each["features"][1]["properties"].contains("length"));
  CHECK(each["features"][1]["properties"]["centerline_length"].get<double>() > 1000.0);
  CHECK(each["features"][1]["geometry"]["coordinates"].back()[0].get<double>() == Approx(20.1).margin(1e-6));

  const Json chosen = Json::parse(lines_written({file, "--between", "20,60", "20.2,60"}));
  REQUIRE(chosen["features"].size() == 1);
  CHECK(chosen["features"][0]["geometry"]["coordinates"].front()[0].get<double>() > 19.9);

  CHECK_THAT(line_fault(2, {file, "--each", "--format", "wkt"}), Catch::Contains("geojson, gpkg and fgb can"));
  CHECK_THAT(line_fault(2, {file, "--each", "--crs", "EPSG:999999"}), Catch::Contains("--crs: \"EPSG:999999\""));
  CHECK_THAT(line_fault(2, {file, "--each", "--from", "gpx"}), Catch::Contains("features of geojson, "));
  CHECK_THAT(line_fault(3, {folder.write("a.json", "[[0,0],[1,1]]").string(), "--each"}),
             Catch::Contains("reads features"));
  CHECK_THAT(
      line_fault(3, {folder.write("b.json", "{\"type\": \"FeatureCollection\", \"features\": [").string(), "--each"}),
      Catch::Contains("b.json:1:"));
  CHECK_THAT(
      line_fault(3, {folder.write("c.json", R"({"type": "FeatureCollection", "features": []})").string(), "--each"}),
      Catch::Contains("no features"));
  CHECK_THAT(line_fault(2, {file, "--between", "9,50", "20,60"}), Catch::Contains("two shapes"));
}

TEST_CASE("a line in space has the radii of the largest disks as heights") {
  // A wedge from half width 1 to half width 2 along 20.
  const std::string wedge = "POLYGON ((0 -1, 20 -2, 20 2, 0 1, 0 -1))";
  const std::string text = lines_written({"-", "--format", "dxf-3d", "--smooth", "0", "--prune", "1"}, wedge);
  std::istringstream lines(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  std::size_t vertices = 0;
  for (std::size_t i = 0; i + 9 < all.size(); i += 2) {
    if (all[i] != "0" || all[i + 1] != "VERTEX") continue;
    ++vertices;
    CHECK(all[i + 4] == "10");
    CHECK(all[i + 8] == "30");
    const double x = std::stod(all[i + 5]);
    // The distance to the sides, which rise by 1 in 20.
    CHECK(std::stod(all[i + 9]) == Approx((1 + x / 20) / std::hypot(1, 0.05)).epsilon(2e-3));
  }
  CHECK(vertices == 2);  // the radius is linear along the line
  CHECK(text.contains("POLYLINE\n8\ncenterline\n66\n1\n70\n8\n"));
  // Its reader takes it for the same line.
  const TemporaryFolder folder;
  const RunResult read = run({"compute", folder.write("a.dxf", text).string(), "--vertices", "--layers", "points"});
  REQUIRE(read.exit_code == 0);
  CHECK(Json::parse(read.out)["input"]["samples"] == vertices);
  CHECK_THAT(line_fault(2, {"-", "--format", "dxf-3d", "--extend"}, wedge), Catch::Contains("--extend"));
  CHECK_THAT(line_fault(2, {"-", "--format", "dxf-3d", "--every", "1"}, wedge), Catch::Contains("--every"));
}

TEST_CASE("lines and messages are in the order of the features, whichever is finished first") {
  // Each third feature is a square, which has no line, and the others are of very different size.
  Json features = Json::array();
  for (int i = 0; i < 30; ++i) {
    const double x = 9.0 + 0.1 * i;
    const double wide = i % 3 == 0 ? 0.01 : 0.05;
    const double high = i % 3 == 0 ? 0.01 * 0.6445 : 0.05 / (2.0 + i);
    const Json ring =
        Json::array({{x, 50.0}, {x + wide, 50.0}, {x + wide, 50.0 + high}, {x, 50.0 + high}, {x, 50.0}});
    features.push_back({{"type", "Feature"},
                        {"id", i},
                        {"properties", Json::object()},
                        {"geometry", {{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}});
  }
  const TemporaryFolder folder;
  const Json map{{"type", "FeatureCollection"}, {"features", features}};
  const RunResult apart = run({"centerline", folder.write("map.json", map.dump()).string(), "--each"});
  INFO(apart.err);
  REQUIRE(apart.exit_code == 1);
  const Json lines = Json::parse(apart.out)["features"];
  int last = -1;
  for (const Json& line : lines) {
    CHECK(line["id"].get<int>() > last);
    last = line["id"];
  }
  std::istringstream messages(apart.err);
  std::vector<int> without;
  for (std::string message; std::getline(messages, message);)
    if (const auto at = message.find(", id "); message.contains("there is no centre line"))
      without.push_back(std::stoi(message.substr(at + 5)));
  CHECK(without.size() + lines.size() == 30);
  CHECK(
      apart.err.ends_with(std::to_string(without.size()) + " of 30 features have no line; the others are written\n"));
  CHECK(without.size() > 5);
  CHECK(std::ranges::is_sorted(without));
}

TEST_CASE("a feature with a digit too many in a coordinate is one of the exact axis at once") {
  const auto feature = [](const std::string& name, const std::string& corners) {
    return R"({"type":"Feature","properties":{"name":")" + name +
           R"("},"geometry":{"type":"Polygon","coordinates":[[)" + corners + "]]}}";
  };
  const std::string good = feature("good", "[4290,5540],[4680,5540],[4680,5650],[4290,5650],[4290,5540]");
  const std::string bad = feature("bad", "[4283,5539],[488946728,5539],[488946728,5649],[4283,5649],[4283,5539]");
  const std::string map =
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"none"}},"features":[)";
  const RunResult apart = run({"centerline", "-", "--each"}, {.input = map + bad + "," + good + "]}"});
  CHECK(apart.exit_code == 0);
  CHECK_THAT(apart.err,
             Catch::Contains("-: feature 1: the lines are those of the exact axis of the outlines, because "
                             "the outline is 4.44e+06 times as long as it is wide"));
  REQUIRE(Json::parse(apart.out)["features"].size() == 2);
  CHECK(Json::parse(apart.out)["features"][1]["properties"]["name"] == "good");

  const RunResult together = run({"centerline", "-"}, {.input = map + bad + "," + good + "]}"});
  CHECK(together.exit_code == 0);
  CHECK_THAT(together.err, Catch::Contains("because they cross"));
  CHECK(Json::parse(together.out)["features"].size() == 2);
  const RunResult strip = run({"centerline", "-"}, {.input = "POLYGON ((0 0, 1000000 0, 1000000 1, 0 1, 0 0))"});
  CHECK(strip.exit_code == 0);
  CHECK(Json::parse(strip.out)["features"][0]["properties"]["length"].get<double>() == Approx(999999.0).margin(0.5));
  // A strip that is 10,000 times as long as wide has its line.
  CHECK(run({"centerline", "-"}, {.input = "POLYGON ((0 0, 10000 0, 10000 1, 0 1, 0 0))"}).exit_code == 0);
}

TEST_CASE(
    "features that are not on the Earth, cross themselves or enclose nothing are named, and the rest is written") {
  const auto feature = [](int id, const std::string& geometry) {
    return R"({"type":"Feature","id":)" + std::to_string(id) + R"(,"properties":{},"geometry":)" + geometry + "}";
  };
  const auto polygon = [](const std::string& rings) { return R"({"type":"Polygon","coordinates":[)" + rings + "]}"; };
  const std::string map =
      R"({"type":"FeatureCollection","features":[)" +
      feature(1, polygon("[[8,91],[8.004,91],[8.004,91.001],[8,91.001],[8,91]]")) + ',' +
      feature(2, polygon("[[8,50],[8.004,50.002],[8.004,50],[8,50.002],[8,50]]")) + ',' +
      feature(3, polygon("[[8,50],[8.004,50],[8.008,50],[8,50]]")) + ',' + feature(4, "null") + ',' +
      feature(5, R"({"type":"Point","coordinates":[8,50]})") + ',' +
      feature(6, polygon("[[8,50],[8.001,50],[8.001,50.0006],[8,50.0006],[8,50]]")) + ',' +
      feature(7, polygon("[[8,50],[8.004,50],[8.004,50.001],[8,50.001],[8,50]],"
                         "[[9,50],[9.004,50],[9.004,50.001],[9,50.001],[9,50]]")) +
      ',' + feature(8, polygon("[[179.99,50],[-179.99,50],[-179.99,50.002],[179.99,50.002],[179.99,50]]")) + "]}";
  const RunResult result = run({"centerline", "-", "--each", "--prune", "2"}, {.input = map});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  std::map<int, int> lines;
  const Json written = Json::parse(result.out);
  for (const Json& line : written["features"]) {
    ++lines[line["id"].get<int>()];
    if (line["id"] == 8) CHECK(line["geometry"]["type"] == "MultiLineString");
  }
  // A hole outside is a shape of its own, and the two triangles of a bow tie are compact.
  CHECK(lines == std::map<int, int>{{7, 2}, {8, 1}});
  // A remark of each kind as well: on the plane of feature 1, that of the others, samples, a hole and a crossing.
  CHECK(std::ranges::count(result.err, '\n') == 13);
  for (const char* const named :
       {"feature 1, id 1: its positions are not on the Earth", "feature 2, id 2: there is no centre line",
        "feature 3, id 3: ", "feature 4, id 4: ", "feature 5, id 5: there is no centre line",
        "feature 6, id 6: there is no centre line: every shape", "feature 2, id 2: sides of outlines cross once",
        "feature 7, id 7: 1 hole lies outside its polygon"})
    CHECK_THAT(result.err, Catch::Contains(named));
}

TEST_CASE("a map around a pole is computed about it, or is one line if no plane holds it") {
  using Ring = std::vector<std::pair<double, double>>;
  const auto around = [](double latitude, double wave = 0.0) {
    Ring out;
    for (int i = -18; i < 18; ++i) out.emplace_back(10.0 * i, latitude + (i % 2 == 0 ? wave : -wave));
    return out;
  };
  const auto feature = [](const std::vector<Ring>& rings) {
    Json all = Json::array();
    for (const Ring& ring : rings) {
      Json& one = all.emplace_back(Json::array());
      for (const auto& [x, y] : ring) one.push_back({x, y});
      one.push_back(one.front());
    }
    return Json{{"type", "Feature"},
                {"properties", Json::object()},
                {"geometry", {{"type", "Polygon"}, {"coordinates", all}}}};
  };
  const auto map_of = [](const std::vector<Json>& features) {
    return Json{{"type", "FeatureCollection"}, {"features", features}}.dump();
  };
  const auto house = feature({{{8.0, 50.0}, {8.0004, 50.0}, {8.0004, 50.0001}, {8.0, 50.0001}}});
  const auto lines_of = [&](const std::vector<Json>& features, const std::vector<std::string>& more = {}) {
    return Json::parse(lines_written(with({"-"}, more), map_of(features)))["features"];
  };

  // Between two parallels, whether they are cut at the 180th meridian or not.
  for (const double latitude : {60.0, -80.0}) {
    for (const bool is_cut : {false, true}) {
      Ring outer = around(latitude);
      if (is_cut) outer.emplace_back(180.0, latitude);
      const Json lines = lines_of({feature({outer, around(latitude + 10.0)})});
      REQUIRE(lines.size() == 1);
      for (const Json& part : lines[0]["geometry"]["coordinates"])
        for (const Json& place : part) CHECK(place[1].get<double>() == Approx(latitude + 5.0).margin(0.1));
    }
  }
  CHECK(lines_of({feature({around(70)}), house}).size() == 1);
  // A wedge to the pole is between two meridians.
  const Json wedge = lines_of({feature({{{0, 90}, {0, 89}, {20, 89}}})}, {"--prune", "1"});
  REQUIRE(wedge.size() == 1);
  for (const Json& place : wedge[0]["geometry"]["coordinates"])
    CHECK(place[0].get<double>() == Approx(10.0).margin(0.5));

  const std::string elsewhere = map_of({feature({around(-70)}), house});
  CHECK_THAT(line_fault(3, {"-"}, elsewhere), Catch::Contains("-:1:1: outline 1 goes around a pole"));
  CHECK_THAT(line_fault(3, {"-"}, map_of({house, feature({around(0, 10)})})),
             Catch::Contains("outline 2 goes around"));
  const RunResult apart = run({"centerline", "-", "--each"},
                              {.input = map_of({feature({around(0, 10)}), feature({around(-70)}), house})});
  CHECK(apart.exit_code == 1);
  INFO(apart.err);
  // The planes of features 2 and 3 are of two kinds.
  CHECK(std::ranges::count(apart.err, '\n') == 6);
  CHECK_THAT(apart.err, Catch::Contains("feature 1: outline 1 goes around a pole") &&
                            Catch::Contains("feature 2: there is no centre line: every shape"));
  REQUIRE(Json::parse(apart.out)["features"].size() == 1);

  // A frame of the world, and Antarctica as maps of the world draw it, are in one plane with all others.
  const Ring frame{{-180, -90}, {180, -90}, {180, 90}, {-180, 90}};
  Ring antarctica = around(-70);
  antarctica.insert(antarctica.end(), {{180, -70}, {180, -90}, {-180, -90}});
  const Json world = lines_of({feature({frame, {{7.0, 49.0}, {7.0, 51.0}, {9.0, 51.0}, {9.0, 49.0}}})});
  REQUIRE(world.size() == 1);
  CHECK(lines_of({feature({antarctica}), house}).size() == 2);
  // So are islands across the 180th meridian, though the map cannot be joined there as a whole.
  const Json islands = lines_of({feature({{{-0.1, 50}, {0.1, 50}, {0.1, 50.05}, {-0.1, 50.05}}}),
                                 feature({{{-71, -30}, {-70, -30}, {-70, -29.8}, {-71, -29.8}}}),
                                 feature({{{177, -18}, {-178, -18}, {-178, -17}, {177, -17}}})});
  REQUIRE(islands.size() == 3);
  CHECK(islands[0]["geometry"]["type"] == "MultiLineString");
  CHECK(islands[0]["properties"]["length"].get<double>() < 600'000.0);
  for (const Json& part : islands[0]["geometry"]["coordinates"])
    for (const Json& place : part) CHECK(std::abs(place[0].get<double>()) > 177.0);
}

TEST_CASE("an outline without a width is named as such") {
  const auto polygon = [](const std::string& corners) {
    return R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)" + corners + "]]}}";
  };
  const auto map_of = [](const std::string& features) {
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
  };
  const std::string along = polygon("[8,50],[8.004,50],[8.008,50],[8,50]");
  const std::string spike = polygon("[9,50],[9.003,50],[9.003,50.002],[9.003,50],[9,50]");
  const std::string house = polygon("[8,50],[8.0004,50],[8.0004,50.0001],[8,50.0001],[8,50]");
  CHECK_THAT(line_fault(3, {"-"}, map_of(along)), Catch::EndsWith("its outline has no width\n"));
  CHECK_THAT(line_fault(3, {"-"}, map_of(along + ',' + spike)), Catch::EndsWith("its 2 outlines have no width\n"));
  CHECK_THAT(line_fault(3, {"-"}, "POLYGON ((0 0, 3 1, 9 3, 0 0))"), Catch::Contains("no width"));
  CHECK_THAT(line_fault(3, {"-"}, "POLYGON ((0 0, 10 0, 10 10, 10 0, 0 0))"), Catch::Contains("no width"));
  const RunResult apart = run({"centerline", "-", "--each"}, {.input = map_of(along + ',' + house + ',' + spike)});
  CHECK(apart.exit_code == 1);
  CHECK_THAT(apart.err, Catch::Contains("feature 1: its outline has no width") &&
                            Catch::Contains("feature 3: its outline has no width"));
  CHECK(Json::parse(apart.out)["features"].size() == 1);
  const RunResult together = run({"centerline", "-"}, {.input = map_of(spike + ',' + house)});
  CHECK(together.exit_code == 0);
  CHECK_THAT(together.err, Catch::Contains("an outline without a width is left out"));
  CHECK(Json::parse(together.out)["features"].size() == 1);
}

TEST_CASE("a single open line has no centre line, by itself or as a feature") {
  for (const char* const line : {"LINESTRING (0 0, 100 0, 100 50)", "LINESTRING (0 0, 100 0)"})
    for (const std::vector<std::string>& options : {std::vector<std::string>{}, {"--exact"}, {"--vertices"}})
      CHECK_THAT(line_fault(1, with({"-"}, options), line), Catch::Contains("no closed outline encloses anything"));
  const std::string feature =
      R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0],[9,0],[9,5]]}})";
  const RunResult each = run({"centerline", "-", "--each", "--crs", "EPSG:25832"}, {.input = feature});
  CHECK(each.exit_code == 1);
  CHECK_THAT(each.err, Catch::Contains("no closed outline encloses anything"));
}

TEST_CASE("where a map has areas, its lines and points have no part in centre lines") {
  const RunResult result =
      run({"centerline", "-"},
          {.input = "POLYGON ((0 0, 10 0, 10 2, 0 2, 0 0))\nLINESTRING (0 3, 10 3)\nPOINT (5 8)\nPOINT (5 1.5)"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("1 open line and 2 points are left out, since there are closed outlines"));
  const Json lines = Json::parse(result.out)["features"];
  REQUIRE(lines.size() == 1);
  CHECK(lines[0]["properties"]["length"].get<double>() == Approx(8.0).margin(0.1));
  // A line across the shape would cut its exact axis in two.
  const std::string crossed =
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 100 0, 100 20, 0 20, 0 0)), LINESTRING (50 -10, 50 30))";
  const RunResult exact = run({"centerline", "-", "--exact"}, {.input = crossed});
  CHECK_THAT(exact.err, Catch::Contains("1 open line is left out") && !Catch::Contains("samples"));
  REQUIRE(Json::parse(exact.out)["features"].size() == 1);
  CHECK(Json::parse(exact.out)["features"][0]["properties"]["length"].get<double>() == Approx(80.0).margin(0.1));
  CHECK(lines[0]["properties"]["width_mean"].get<double>() == Approx(2.0).margin(0.01));
}

TEST_CASE("outlines that need too many samples have the lines of their exact axis") {
  // A comb, whose widest part is its back.
  std::string comb = "POLYGON ((0 0";
  constexpr int kTeeth = 400;
  const auto add = [&](double x, const char* y) { comb += ", " + std::to_string(x) + y; };
  for (int i = 0; i < kTeeth; ++i) {
    const double x = 0.002 * i;
    add(x, " 0");
    add(x, " 100");
    add(x + 0.001, " 100");
    add(x + 0.001, " 0");
  }
  comb += ", 1 0, 1 -0.3, 0 -0.3, 0 0))";
  const RunResult result = run({"centerline", "-"}, {.input = comb});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err,
             Catch::Contains("the lines are those of the exact axis of the outlines, because the curves"));
  const Json line = Json::parse(result.out)["features"][0]["properties"];
  CHECK(line["width_largest"].get<double>() < 0.4);
}

TEST_CASE("a polygon with very many sides along a circle has a point for an axis") {
  constexpr int kSides = 40'000;
  std::ostringstream places;
  places.precision(15);
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * (i % kSides) / kSides;
    places << (i == 0 ? "" : ", ") << std::cos(angle) << ' ' << std::sin(angle);
  }
  CHECK_THAT(line_fault(1, {"-"}, "POLYGON ((" + places.str() + "))"), Catch::Contains("its pruned axis is a point"));
}

TEST_CASE("a coordinate system is chosen by its whole name or its code") {
  for (const char* const name : {"EPSG:25832", "25832", "ETRS89 / UTM zone 32N", "etrs89/utm zone 32n"}) {
    const RunResult result = run({"centerline", "-", "--crs", name}, {.input = kStrip});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Catch::Contains("ETRS89 / UTM zone 32N (EPSG:25832)"));
  }
  for (const char* const part : {"foo", "WGS", "Amersf"})
    CHECK_THAT(line_fault(2, {"-", "--crs", part}, kStrip), Catch::Contains("names no coordinate system"));
  const RunResult nameless = run({"centerline", "-", "--crs", "+proj=utm +zone=32"}, {.input = kStrip});
  CHECK(nameless.exit_code == 0);
  CHECK_THAT(nameless.err, Catch::Contains("coordinates are those of +proj=utm +zone=32, in m"));
  CHECK_THAT(line_fault(2, {"-", "--crs", "+proj=nothing"}, kStrip),
             Catch::Contains("\"+proj=nothing\" is not a coordinate system"));
  CHECK_THAT(line_fault(2, {"-", "--crs", "+proj=pipeline +step +proj=utm +zone=32"}, kStrip),
             Catch::Contains("is a conversion, not a coordinate system"));
}

TEST_CASE("the samples of a session stay, and those of a drawing are taken again") {
  const TemporaryFolder folder;
  const std::string strip = folder.write("strip.wkt", kStrip).string();
  // Four samples at the corners make two balls on one centre.
  CHECK_THAT(line_fault(1, {strip, "--vertices"}), Catch::Contains("no centre line"));
  const std::string picture = (folder / "strip.svg").string();
  REQUIRE(run({"render", strip, "--vertices", "--layers", "points", "-o", picture}).exit_code == 0);
  CHECK_THAT(line_fault(1, {picture}), Catch::Contains("no centre line"));
  CHECK_FALSE(lines_written({kEditedBean}).empty());
}

TEST_CASE("what has no centre line gets one line and an exit code") {
  CHECK_THAT(line_fault(1, {"-"}, "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"),
             Catch::Contains("no centre line: every shape"));
  CHECK_THAT(line_fault(1, {"-", "--exact"}, "<svg><circle cx='3' cy='3' r='2'/></svg>"),
             Catch::Contains("no centre line: every shape"));
  CHECK_THAT(line_fault(1, {"-"}, "POINT (1 2)"), Catch::Contains("no centre line"));
  CHECK_THAT(line_fault(1, {"-"}, "LINESTRING (0 0, 1 3)"),
             Catch::Contains("no centre line: no closed outline encloses anything"));
  CHECK_THAT(line_fault(1, {"-"}, "MULTIPOINT ((1 2), (3 4))"), Catch::Contains("no centre line"));
  CHECK_THAT(line_fault(3, {"-", "--from", "poff"}, "POFF 0 0 0\n"), Catch::Contains("no samples"));
  line_fault(3, {"-"}, "\x01\x02 nonsense");
  line_fault(3, {"no-such-file.svg"});
  line_fault(4, {"-", "-o", "/no/such/folder/a.wkt"}, kStrip);
  // Crossing outlines are shapes by parity: a bow tie is two triangles that meet.
  const Json tie = Json::parse(lines_written({"-", "--extend"}, "POLYGON ((0 0, 8 3, 8 0, 0 3, 0 0))"));
  CHECK_FALSE(tie["features"].empty());
  for (const Json& feature : tie["features"])
    for (const Json& place : feature["geometry"]["coordinates"]) {
      const double x = place[0].get<double>() - 4.0;
      CHECK(std::abs(place[1].get<double>() - 1.5) <= 0.375 * std::abs(x) + 0.01);
    }

  const auto usage = [](const std::vector<std::string>& more) { return line_fault(2, with({"-"}, more), kStrip); };
  CHECK_THAT(usage({"--prune", "-1"}), Catch::Contains("--prune expects"));
  CHECK_THAT(usage({"--smooth", "x%"}), Catch::Contains("--smooth expects"));
  CHECK_THAT(usage({"--smooth", "-3"}), Catch::Contains("--smooth expects"));
  CHECK_THAT(usage({"--branches", "0"}), Catch::Contains("--branches expects"));
  CHECK_THAT(usage({"--every", "0"}), Catch::Contains("--every expects"));
  CHECK_THAT(usage({"--every", "1e-9"}), Catch::Contains("stations"));
  CHECK_THAT(usage({"--every", "1", "--extend"}), Catch::Contains("--extend"));
  CHECK_THAT(usage({"--between", "1,2", "3"}), Catch::Contains("X,Y"));
  CHECK_THAT(usage({"--between", "1,2", "3,4", "--branches", "2"}), Catch::Contains("--branches"));
  CHECK_THAT(usage({"--between", "0,1", "1,1"}), Catch::Contains("same end"));
  CHECK_THAT(usage({"--format", "pdf"}), Catch::Contains("geojson"));
  CHECK_THAT(usage({"-o", "lines.pdf"}), Catch::Contains("--format expects"));
  CHECK_FALSE(std::filesystem::exists("lines.pdf"));
}
