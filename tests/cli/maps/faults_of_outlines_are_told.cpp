// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines of outlines that cross, overlap, have spikes or are very thin, and of maps whose positions are doubtful.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"

using namespace mes::test;
using Json = nlohmann::json;

TEST_CASE("a remark names outlines that cross or repeat themselves, and their lines are written") {
  const auto remarks = [](const std::string& input, const std::vector<std::string>& options = {}) {
    const RunResult result = run(with({"centerline", "-"}, options), {.input = input});
    CHECK(result.exit_code == 0);
    CHECK_FALSE(Json::parse(result.out)["features"].empty());
    return result.err;
  };
  CHECK_THAT(remarks("POLYGON ((0 0, 20 5, 20 0, 0 5, 0 0))"), Catch::Contains("-: sides of outlines cross once"));
  CHECK_THAT(remarks("POLYGON ((0 0, 20 5, 20 0, 0 5, 0 0))", {"--exact"}), Catch::Contains("cross once"));
  CHECK_THAT(remarks("MULTIPOLYGON (((0 0, 9 0, 9 3, 0 3, 0 0)), ((5 1, 15 1, 15 2, 5 2, 5 1)))"),
             Catch::Contains("cross 2 times"));
  CHECK_THAT(remarks("MULTIPOLYGON (((0 0, 9 0, 9 3, 0 3, 0 0)), ((5 0, 15 0, 15 3, 5 3, 5 0)))"),
             Catch::Contains("outlines overlap along 2 sides") && Catch::Contains("because they overlap"));
  CHECK_THAT(remarks("POLYGON ((0 0, 9 0, 9 3, 0 3, 0 0, 9 0, 4 1, 0 0))"),
             Catch::Contains("outlines run along a side of their own again"));
  const std::string slots = R"(<svg xmlns="http://www.w3.org/2000/svg"><ellipse cx="50" cy="50" rx="40" ry="15"/>)"
                            R"(<ellipse cx="50" cy="50" rx="15" ry="40"/></svg>)";
  CHECK_THAT(remarks(slots), Catch::Contains("sides of outlines cross 4 times"));
  const std::string apart_circles =
      R"(<svg xmlns="http://www.w3.org/2000/svg"><ellipse cx="20" cy="50" rx="20" ry="15"/>)"
      R"(<ellipse cx="60" cy="50" rx="20" ry="15"/></svg>)";
  CHECK_THAT(remarks(apart_circles), !Catch::Contains("cross"));
  CHECK_THAT(remarks("MULTIPOLYGON (((0 0, 9 0, 9 3, 0 3, 0 0)), ((9 0, 9 3, 0 3, 0 0, 9 0)))", {"--exact"}),
             Catch::Contains("-: an outline repeats another one, and counts once"));
  // Parcels with a common border, and a hole that touches the outline, are no faults.
  CHECK_THAT(remarks("MULTIPOLYGON (((0 0, 9 0, 9 3, 0 3, 0 0)), ((0 3, 9 3, 9 6, 0 6, 0 3)))"),
             !Catch::Contains("cross") && !Catch::Contains("again"));
  CHECK_THAT(remarks("POLYGON ((0 0, 9 0, 9 3, 0 3, 0 0), (0 0, 3 1, 3 2, 0 0))"),
             !Catch::Contains("cross") && !Catch::Contains("again"));
  std::string features;
  for (int i = 0; i < 20; ++i)
    features += R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[2000,)" +
                std::to_string(500 + i) + "],[2000,0],[0,500],[0,0]]]}}\n";
  const std::string apart = remarks(features, {"--each", "--crs", "EPSG:25832"});
  CHECK_THAT(apart, Catch::Contains("-: feature 1: sides of outlines cross once") &&
                        Catch::Contains("; likewise 19 other features"));
  CHECK(std::ranges::count(apart, '\n') == 4);
}

TEST_CASE("outlines with a very sharp corner or a very thin part have lines of their exact axis") {
  const auto lines_of = [](const std::string& input, std::string_view reason) {
    const RunResult result = run({"centerline", "-"}, {.input = input});
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, Catch::Contains(std::string("because ") + std::string(reason)));
    const RunResult exact = run({"centerline", "-", "--exact"}, {.input = input});
    CHECK(result.out == exact.out);
    CHECK(result.out.size() < 100'000);
  };
  lines_of("POLYGON ((0 0, 100 0, 100 20, 50.01 20, 50 60, 49.99 20, 0 20, 0 0))",
           "the outline has a corner of 0.029 degrees");
  lines_of("POLYGON ((0 0, 100 0, 100 20, 50.001 20, 50.001 60, 50 60, 50 20, 0 20, 0 0))",
           "a part of them is very thin");
}

TEST_CASE("spikes of an outline are no part of it, in plain coordinates and in degrees") {
  const auto length = [](const std::string& input, const std::vector<std::string>& options = {}) {
    const RunResult result = run(with({"centerline", "-"}, options), {.input = input});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, !Catch::Contains("again") && !Catch::Contains("because"));
    const Json lines = Json::parse(result.out)["features"];
    REQUIRE(lines.size() == 1);
    CHECK(lines[0]["properties"]["width_least"].get<double>() ==
          Approx(lines[0]["properties"]["width_largest"].get<double>()).epsilon(1e-3));
    return lines[0]["properties"]["length"].get<double>();
  };
  for (const std::vector<std::string>& options : {std::vector<std::string>{}, {"--exact"}}) {
    CHECK(length("POLYGON ((0 0, 120 0, 100 0, 100 20, 0 20, 0 0))", options) == Approx(80.0).epsilon(1e-3));
    CHECK(length("POLYGON ((0 0, 100 0, 50 0, 50 20, 0 20, 0 0))", options) == Approx(30.0).epsilon(1e-2));
    CHECK(length("POLYGON ((0 0, 9 0, 9 3, 0 3, 0 0, 9 0, 0 0))", options) == Approx(6.0).epsilon(1e-3));
    const auto in_degrees = [&](const std::string& ring) {
      return length(R"({"type":"Polygon","coordinates":[[)" + ring + "]]}", options);
    };
    CHECK(in_degrees("[10,50],[10.012,50],[10.01,50],[10.01,50.002],[10,50.002],[10,50]") ==
          Approx(in_degrees("[10,50],[10.01,50],[10.01,50.002],[10,50.002],[10,50]")).epsilon(1e-5));
    // Longitudes jump across the 180th meridian, where no spike is.
    CHECK(in_degrees("[179.995,50],[-179.995,50],[-179.995,50.002],[179.995,50.002],[179.995,50]") ==
          Approx(in_degrees("[10,50],[10.01,50],[10.01,50.002],[10,50.002],[10,50]")).epsilon(1e-3));
  }
}

TEST_CASE("WKT that looks like degrees is a plane, and that is said") {
  const std::string lake = "POLYGON ((8.5 47.2, 8.85 47.21, 8.852 47.235, 8.51 47.22, 8.5 47.2))";
  const auto told = [](const std::string& input, const std::vector<std::string>& options = {}) {
    const RunResult result = run(with({"centerline", "-"}, options), {.input = input});
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(told(lake), Catch::Contains("look like longitude and latitude") && Catch::Contains("EPSG:4326"));
  CHECK_THAT(told(lake, {"--crs", "EPSG:4326"}), !Catch::Contains("look like") && Catch::Contains("projected"));
  for (const char* const drawing :
       {"POLYGON ((0 0, 30.255 0, 30.255 8.001, 0 8.001, 0 0))", "POLYGON ((85 47, 88 47, 88 48, 85 48, 85 47))",
        "POLYGON ((508.5 47.2, 508.85 47.21, 508.852 47.235, 508.5 47.22, 508.5 47.2))"})
    CHECK_THAT(told(drawing), !Catch::Contains("look like"));
}

TEST_CASE("longitudes may go on across 180 and 360, and features may count them differently") {
  const auto box = [](double west) {
    const Json low = west;
    const Json high = west + 0.01;
    const Json ring = {{low, 10}, {high, 10}, {high, 10.002}, {low, 10.002}, {low, 10}};
    return Json{{"type", "Feature"},
                {"properties", Json::object()},
                {"geometry", {{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}}
        .dump();
  };
  const auto line = [](const std::string& feature) {
    const RunResult result =
        run({"centerline", "-"}, {.input = R"({"type":"FeatureCollection","features":[)" + feature + "]}"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, Catch::Contains("degrees are projected"));
    return Json::parse(result.out)["features"];
  };
  const double length = line(box(10.0))[0]["properties"]["length"];
  for (const double west : {179.995, -179.995, 200.0, 359.995, 355.0}) {
    const Json found = line(box(west));
    CHECK(found[0]["properties"]["length"].get<double>() == Approx(length).epsilon(1e-6));
    const double start = found[0]["geometry"]["type"] == "MultiLineString"
                             ? found[0]["geometry"]["coordinates"][0][0][0].get<double>()
                             : found[0]["geometry"]["coordinates"][0][0].get<double>();
    CHECK(std::abs(std::remainder(start - west, 360.0)) < 0.01);
  }
  const Json both = line(box(190.0) + ',' + box(-170.02));
  REQUIRE(both.size() == 2);
  for (const Json& found : both) CHECK(found["properties"]["length"].get<double>() == Approx(length).epsilon(1e-3));
}
