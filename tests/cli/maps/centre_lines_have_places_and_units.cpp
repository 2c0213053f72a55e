// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines lie where their drawing or map lies, with lengths in its unit, and what is doubtful about that is said.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"

using namespace mes::test;
using Json = nlohmann::json;

TEST_CASE("lines of a drawing lie on its page, in its unit") {
  const auto drawing = [](const std::string& unit) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" width="100)" + unit + R"(" height="50)" + unit +
           R"(" viewBox="0 0 200 100"><rect x="20" y="10" width="120" height="20"/></svg>)";
  };
  const std::vector<std::string> command{"centerline", "-", "--exact", "--prune", "1"};
  const RunResult svg = run(with(command, {"--format", "svg"}), {.input = drawing("mm")});
  CHECK_THAT(svg.out, Catch::Contains(R"(width="100mm" height="50mm" viewBox="0 0 100 50")"));
  CHECK_THAT(svg.out, Catch::Contains("M 15 10 ") && Catch::Contains("L 65 10\""));
  // The lines are those of the drawing that they make.
  const RunResult again = run({"compute", "-", "--vertices", "--layers", "curve"}, {.input = svg.out});
  CHECK(Json::parse(again.out)["input"]["unit"] == "mm");
  CHECK(Json::parse(again.out)["layers"]["curve"]["length"].get<double>() == Approx(50.0));
  const RunResult dxf = run(with(command, {"--format", "dxf"}), {.input = drawing("in")});
  CHECK(dxf.out.starts_with("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n"));
  // A drawing without a page gets one around its lines, and one without a unit has no header.
  const RunResult plain =
      run(with(command, {"--format", "svg"}), {.input = "POLYGON ((0 0, 60 0, 60 10, 0 10, 0 0))"});
  CHECK_THAT(plain.out, Catch::Contains(R"(svg" viewBox="4 -6 52 2")"));
  CHECK(run(with(command, {"--format", "dxf"}), {.input = "POLYGON ((0 0, 60 0, 60 10, 0 10, 0 0))"})
            .out.starts_with("0\nSECTION\n2\nENTITIES\n"));
}

TEST_CASE("contours whose samples are their corners alone are outlines, and those with many samples stay") {
  const auto ring = [](int along, int across) {
    std::string out = "x,y\n";
    const auto side = [&](double x, double y, double dx, double dy, int count) {
      for (int i = 0; i < count; ++i)
        out += std::to_string(x + dx * i / count) + ',' + std::to_string(y + dy * i / count) + '\n';
    };
    side(0, 0, 100, 0, along);
    side(100, 0, 0, 20, across);
    side(100, 20, -100, 0, along);
    side(0, 20, 0, -20, across);
    return out + "0,0\n";
  };
  for (const bool is_coarse : {true, false}) {
    const RunResult result = run({"centerline", "-"}, {.input = is_coarse ? ring(1, 1) : ring(100, 20)});
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.contains("too few for their contours") == is_coarse);
    const Json lines = Json::parse(result.out)["features"];
    REQUIRE(lines.size() == 1);
    CHECK(lines[0]["properties"]["length"].get<double>() == Approx(80).epsilon(0.01));
  }
}

TEST_CASE("lengths are metres in a map of degrees, whatever its extent") {
  const auto feature = [](const std::string& corners) {
    return R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)" + corners + "]]}}\n";
  };
  const std::string wide = feature("[-100,-5],[0,-5],[100,-5],[100,5],[0,5],[-100,5],[-100,-5]");
  const std::string house = feature("[8,47],[8.01,47],[8.01,47.003],[8,47.003],[8,47]");
  for (const std::string& map : {wide + house, house + wide}) {
    const RunResult result = run({"centerline", "-", "--each", "--exact"}, {.input = map});
    CHECK(result.exit_code == 0);
    std::vector<double> widths;
    const Json lines = Json::parse(result.out)["features"];
    for (const Json& line : lines) widths.push_back(line["properties"]["width_largest"].get<double>());
    std::ranges::sort(widths);
    REQUIRE(widths.size() == 2);
    CHECK(widths[0] == Approx(333.5).epsilon(1e-3));
    CHECK(widths[1] == Approx(1.1119e6).epsilon(1e-3));
  }
  // Stations every 2,000 km.
  const RunResult stations =
      run({"centerline", "-", "--exact", "--every", "2000000", "--format", "csv"}, {.input = wide});
  CHECK(std::ranges::count(stations.out, '\n') == 12);
  CHECK_THAT(stations.out, Catch::Contains("\n1,1,2e+06,"));
  // Radii are lengths of the plane, and so are the positions with them.
  const RunResult tool = run({"centerline", "-", "--exact", "--format", "dxf-3d"}, {.input = house});
  CHECK_THAT(tool.out, Catch::Contains("$INSUNITS\n70\n6\n") && Catch::Contains("\n30\n166.75"));
  CHECK_THAT(tool.out, !Catch::Contains("10\n8.0"));
}

TEST_CASE("longitudes may count to 360, and what is doubtful about places is said") {
  const auto remarks = [](const std::string& corners, const std::vector<std::string>& options = {}) {
    const RunResult result = run(with({"centerline", "-", "--exact"}, options),
                                 {.input = R"({"type":"Polygon","coordinates":[[)" + corners + "]]}"});
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(remarks("[190,-20],[190.01,-20],[190.01,-19.997],[190,-19.997],[190,-20]"),
             Catch::Contains("projected to metres about 170 W, 20 S") && !Catch::Contains("plane"));
  CHECK_THAT(remarks("[179.99,10],[180.02,10],[180.02,10.005],[179.99,10.005],[179.99,10]"),
             Catch::Contains("projected to metres") && !Catch::Contains("read as going"));
  CHECK_THAT(remarks("[0,0],[300,0],[300,80],[0,80],[0,0]"), Catch::Contains("those of a plane"));
  CHECK_THAT(remarks("[-100,-5],[100,-5],[100,5],[-100,5],[-100,-5]"),
             Catch::Contains("2 sides of more than 180 degrees of longitude are read as going the other way"));
  CHECK_THAT(remarks("[179.9,0],[-179.9,0],[-179.9,0.1],[179.9,0.1],[179.9,0]"), !Catch::Contains("other way"));
  const std::string house = "[8,47],[8.01,47],[8.01,47.003],[8,47.003],[8,47]";
  CHECK_THAT(remarks(house, {"--crs", "EPSG:25832"}), Catch::Contains("where that system is not used"));
  CHECK_THAT(remarks("[500000,5500000],[500900,5500000],[500900,5500200],[500000,5500200],[500000,5500000]",
                     {"--crs", "EPSG:25832"}),
             !Catch::Contains("not used"));
}

TEST_CASE("stations lie where their widths are measured") {
  const RunResult result = run({"centerline", "-", "--exact", "--every", "5", "--format", "csv"},
                               {.input = "POLYGON ((0 0, 100 0, 100 20, 60 20, 60 60, 40 60, 40 20, 0 20, 0 0))"});
  std::istringstream rows(result.out);
  std::string row;
  std::getline(rows, row);
  int count = 0;
  for (; std::getline(rows, row); ++count) {
    std::ranges::replace(row, ',', ' ');
    std::istringstream numbers(row);
    double shape = 0.0, line = 0.0, along = 0.0, x = 0.0, y = 0.0, width = 0.0, lx = 0.0, ly = 0.0, rx = 0.0,
           ry = 0.0;
    numbers >> shape >> line >> along >> x >> y >> width >> lx >> ly >> rx >> ry;
    CHECK(std::hypot(lx - x, ly - y) + std::hypot(rx - x, ry - y) == Approx(width).epsilon(1e-9));
  }
  CHECK(count > 10);
}
