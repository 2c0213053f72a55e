// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "run_binary.h"
#include "tests/cli/inputs.h"
#include "tests/io/temporary_folder.h"

using mes::test::kDude;
using mes::test::run;
using mes::test::RunResult;
using Json = nlohmann::json;

namespace {

constexpr const char* kHawaii = "tests/data/ne_hawaii.poff";

std::string exported(const std::string& file, const std::string& layer, const std::string& format,
                     const std::string& input = {}) {
  const RunResult result = run({"export", file, "--layer", layer, "--format", format}, {.input = input});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  return result.out;
}

/// The output of other options, whatever is said beside it.
std::string exported_with(const std::vector<std::string>& words, const std::string& input) {
  const RunResult result = run(words, {.input = input});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

/// Twice the signed area of a closed ring of positions.
double doubled_area(const Json& ring) {
  double out = 0.0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    out += ring[i - 1][0].get<double>() * ring[i][1].get<double>() -
           ring[i - 1][1].get<double>() * ring[i][0].get<double>();
  return out;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("csv has a header, one primitive a line and every digit") {
  CHECK(exported("-", "points", "csv", "0.1 0.2\n0.30000000000000004 -1e-30\n") ==
        "x,y,scalar\n0.1,0.2,0\n0.30000000000000004,-1e-30,1\n");
  CHECK(lines_of(exported("-", "delaunay", "csv", "0 0\n3 4\n")).at(0).starts_with("x1,y1,x2,y2"));
  CHECK(lines_of(exported(kDude, "interior-voronoi-disks", "csv")).at(0) == "x,y,r,scalar");
}

TEST_CASE("the second pair of numbers of a ray in csv is a direction, as help and manual say") {
  // Moved as a whole, segments have other ends, and rays the same directions.
  const auto rows = [](const std::string& layer, const std::string& kind, double by) {
    std::string samples;
    for (const auto& [x, y] : {std::pair{0, 0}, {8, 0}, {8, 4}, {0, 6}, {3, 1}})
      samples += std::to_string(x + by) + ' ' + std::to_string(y) + '\n';
    std::vector<std::vector<double>> out;
    for (const std::string& line : lines_of(exported("-", layer, "csv", samples))) {
      if (!line.starts_with(kind + ',')) continue;
      std::istringstream cells(line.substr(kind.size() + 1));
      out.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',') && out.back().size() < 4;)
        out.back().push_back(std::stod(cell));
    }
    std::ranges::sort(out);
    return out;
  };
  for (const std::string layer : {"voronoi", "all-medial-axis"}) {
    CAPTURE(layer);
    const auto rays = rows(layer, "ray", 0.0);
    const auto moved = rows(layer, "ray", 1024.0);
    REQUIRE_FALSE(rays.empty());
    REQUIRE(rays.size() == moved.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      CHECK(moved[i][0] == Approx(rays[i][0] + 1024.0));
      CHECK(moved[i][2] == Approx(rays[i][2]));
      CHECK(moved[i][3] == Approx(rays[i][3]));
    }
    const auto segments = rows(layer, "segment", 0.0);
    REQUIRE_FALSE(segments.empty());
    CHECK(rows(layer, "segment", 1024.0)[0][2] == Approx(segments[0][2] + 1024.0));
  }
  CHECK_THAT(run({"export", "--help"}).out, Catch::Contains("direction of a ray or a line"));
  CHECK_THAT(run({"manual"}).out, Catch::Contains("| ray | `x,y,dx,dy` |"));
}

TEST_CASE("csv has as many lines as compute counts, with the kind where there are several") {
  const Json layers = Json::parse(
      run({"compute", kHawaii, "--layers", "voronoi,medial-axis,points,interior-voronoi-disks"}).out)["layers"];
  for (const auto& [layer, counts] : layers.items()) {
    INFO(layer);
    std::size_t expected = 1;
    for (const char* kind : {"points", "segments", "rays", "lines", "disks"}) expected += counts.value(kind, 0U);
    const std::vector<std::string> lines = lines_of(exported(kHawaii, layer, "csv"));
    CHECK(lines.size() == expected);
    for (const std::string& line : lines)
      CHECK(std::ranges::count(line, ',') == std::ranges::count(lines.front(), ','));
  }
  const std::vector<std::string> voronoi = lines_of(exported(kHawaii, "voronoi", "csv"));
  CHECK(voronoi.at(0).starts_with("kind,x1,y1,x2,y2"));
  CHECK(std::ranges::any_of(voronoi, [](const std::string& line) { return line.starts_with("ray,"); }));
}

TEST_CASE("exported samples are the samples, with their curve order") {
  const std::string text = exported(kHawaii, "points", "poff");
  CHECK(text.starts_with("POFF 129 0 0\n"));
  CHECK_THAT(text, Catch::Contains("\n# loop closed 0 1 2 "));
  // Written and read again, nothing changes.
  CHECK(exported("-", "points", "poff", text) == text);
}

TEST_CASE("the curve is exported as the loops it consists of") {
  const std::string text = exported("-", "curve", "poff", "0 0\n4 0\n0 3\n4 3\n2 -1\n2 4\n");
  const std::vector<std::string> lines = lines_of(text);
  CHECK(lines.at(0) == "POFF 6 0 0");
  REQUIRE(lines.size() == 8);
  CHECK(lines.back().starts_with("# loop closed "));
  CHECK(std::ranges::count(lines.back(), ' ') == 8);
}

TEST_CASE("what is not a loop is exported as chains between ends and branch points") {
  // The inner axis of a shape without holes has no loop: half as many chains as edges meet at ends and branches.
  std::map<std::string, int> edges_at;
  int edges = 0;
  const std::vector<std::string> segments = lines_of(exported(kDude, "medial-axis", "csv"));
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const std::string& line = segments[i];
    const std::size_t middle = line.find(',', line.find(',') + 1);
    const std::size_t end = line.find(',', line.find(',', middle + 1) + 1);
    ++edges_at[line.substr(0, middle)];
    ++edges_at[line.substr(middle + 1, end - middle - 1)];
    ++edges;
  }
  int ends = 0;
  for (const auto& [point, count] : edges_at) ends += count != 2 ? count : 0;
  REQUIRE(ends > 2);

  int chains = 0;
  int links = 0;
  for (const std::string& line : lines_of(exported(kDude, "medial-axis", "poff"))) {
    if (!line.starts_with("# loop open")) continue;
    ++chains;
    links += static_cast<int>(std::ranges::count(line, ' ')) - 3;
  }
  CHECK(chains == ends / 2);
  CHECK(links == edges);
}

TEST_CASE("exports are equal from run to run") {
  for (const char* layer : {"voronoi", "curve", "interior-voronoi-disks"})
    CHECK(exported(kDude, layer, "csv") == exported(kDude, layer, "csv"));
}

TEST_CASE("exported points are read as a table again") {
  const std::string csv = exported(kDude, "points", "csv");
  const RunResult result = run({"compute", "-", "--layers", "points"}, {.input = csv});
  REQUIRE(result.exit_code == 0);
  CHECK(Json::parse(result.out)["input"]["samples"] == 104);
}

TEST_CASE("balls are exported as they were read, those of radius zero included") {
  const std::string text = "WPOFF 3 0 0\n0.1 0.2 0.30000000000000004\n-1e-15 5 1e+15\n1 1 5e-15\n";
  CHECK(exported("-", "b-inner-disks", "wpoff", text) == text);
  CHECK(exported("-", "b-inner-circles", "wpoff", text) == text);
  CHECK(exported("-", "b-inner-centers", "wpoff", text) == text);
  const RunResult with_zero =
      run({"export", "-", "--layer", "b-inner-centers", "--format", "wpoff"}, {.input = "WPOFF 1 0 0 1 2 0"});
  CHECK(with_zero.out == "WPOFF 1 0 0\n1 2 0\n");
}

TEST_CASE("arcs are exported by their angles, counter-clockwise, and only as a table") {
  const std::string balls = "WPOFF 3 0 0\n0 0 5\n6 0 5\n20 1 2\n";
  const std::vector<std::string> lines = lines_of(exported("-", "b-union-boundary", "csv", balls));
  REQUIRE(lines.size() == 4);
  CHECK(lines[0] == "x,y,r,a0,a1");
  CHECK_THAT(lines[1], Catch::StartsWith("0,0,5,0.92729521800161"));
  CHECK_THAT(lines[1], Catch::Contains(",5.35589008917797"));
  CHECK_THAT(lines[2], Catch::StartsWith("6,0,5,-2.2142974355881"));
  CHECK(lines[3] == "20,1,2,0,6.283185307179586");
  const RunResult refused = run({"export", "-", "--layer", "b-union-boundary", "--format", "poff"}, {.input = balls});
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("csv can hold it"));
}

TEST_CASE("the disks of any layer are exported as balls that can be read again") {
  const std::string text = exported(kDude, "interior-voronoi-disks", "wpoff");
  const Json read = Json::parse(run({"compute", "-", "--layers", "b-inner-disks"}, {.input = text}).out);
  const Json made = Json::parse(run({"compute", kDude, "--layers", "interior-voronoi-disks"}).out);
  CHECK(read["input"]["balls"] == made["layers"]["interior-voronoi-disks"]["disks"]);
  CHECK(read["layers"]["b-inner-disks"]["radius_sum"].get<double>() ==
        Approx(made["layers"]["interior-voronoi-disks"]["radius_sum"].get<double>()));
}

TEST_CASE("GeoJSON has a feature for each primitive, and rings that are closed and counter-clockwise") {
  const Json counts =
      Json::parse(run({"compute", kDude, "--layers", "points,a-dual-faces,interior-voronoi-disks"}).out)["layers"];
  const Json all = Json::parse(exported(kDude, "points,a-dual-faces,interior-voronoi-disks", "geojson"));
  CHECK(all["type"] == "FeatureCollection");
  std::map<std::string, std::map<std::string, int>> seen;
  for (const Json& feature : all["features"]) {
    const Json& geometry = feature["geometry"];
    const Json& properties = feature["properties"];
    ++seen[properties["layer"]][properties["kind"]];
    if (geometry["type"] != "Polygon") continue;
    const Json& ring = geometry["coordinates"][0];
    CHECK(ring.front() == ring.back());
    CHECK(doubled_area(ring) > 0.0);
    if (properties["kind"] == "disk") {
      const double r = properties["radius"];
      CHECK(doubled_area(ring) / 2.0 == Approx(3.14159265358979 * r * r).epsilon(0.002));
    }
  }
  CHECK(seen["points"]["point"] == counts["points"]["points"]);
  CHECK(seen["a-dual-faces"]["triangle"] == counts["a-dual-faces"]["triangles"]);
  CHECK(seen["interior-voronoi-disks"]["disk"] == counts["interior-voronoi-disks"]["disks"]);
  CHECK(seen.size() == 3);
}

TEST_CASE("the curve is one closed line in GeoJSON, WKT and SVG, upright in each") {
  const std::string square = "0 0\n4 0\n4 3\n0 3\n";
  const Json all = Json::parse(exported("-", "curve", "geojson", square));
  REQUIRE(all["features"].size() == 1);
  const Json& line = all["features"][0]["geometry"];
  CHECK(line["type"] == "LineString");
  REQUIRE(line["coordinates"].size() == 5);
  CHECK(line["coordinates"].front() == line["coordinates"].back());
  // The certainty of each side, in their order.
  CHECK(all["features"][0]["properties"]["scalars"].size() == 4);

  const std::vector<std::string> wkt = lines_of(exported("-", "curve", "wkt", square));
  REQUIRE(wkt.size() == 1);
  CHECK(wkt[0].starts_with("LINESTRING ("));
  CHECK(std::ranges::count(wkt[0], ',') == 4);
  CHECK(exported("-", "points", "wkt", "0.1 -2\n") == "POINT (0.1 -2)\n");

  const std::string path = exported("-", "curve", "svg-path", square);
  CHECK(path.starts_with("M "));
  CHECK(path.ends_with(" Z\n"));
  CHECK_THAT(path, Catch::Contains(" 4 -3"));
  CHECK_THAT(path, !Catch::Contains("-0"));
}

TEST_CASE("a path of SVG lies on the page of its drawing") {
  const std::string drawing = R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" )"
                              R"(viewBox="0 0 200 100"><rect x="20" y="10" width="120" height="20"/></svg>)";
  const RunResult out =
      run({"export", "-", "--vertices", "--layer", "curve", "--format", "svg-path"}, {.input = drawing});
  CHECK_THAT(out.out, Catch::Contains("10 5") && Catch::Contains("70 15") && !Catch::Contains("-"));
}

TEST_CASE("circles and arcs keep their radius in a path of SVG") {
  CHECK(exported("-", "b-inner-circles", "svg-path", "WPOFF 1 0 0\n1 2 3\n") ==
        "M 4 -2 A 3 3 0 0 0 -2 -2 A 3 3 0 0 0 4 -2 Z\n");
  const std::string arcs = exported("-", "b-union-boundary", "svg-path", "WPOFF 2 0 0\n0 0 5\n6 0 5\n");
  // Both arcs of two equal disks turn by more than half a circle, counter-clockwise in the plane.
  REQUIRE(lines_of(arcs).size() == 2);
  for (const std::string& arc : lines_of(arcs)) CHECK_THAT(arc, Catch::Contains(" A 5 5 0 1 0 "));
}

TEST_CASE("parabolas of the axis are curves in a path of SVG and a table, and chains of sides elsewhere") {
  // An L: two arcs, with their focus at (1, 1), meet on its diagonal.
  const std::string l_shape = "POFF 6 0 0\n0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n# loop closed 0 1 2 3 4 5\n";
  const auto of = [&](const char* format) {
    return exported_with(
        {"export", "-", "--from", "poff", "--vertices", "--layer", "outline-axis", "--format", format}, l_shape);
  };
  std::vector<std::vector<double>> arcs;
  for (const std::string& line : lines_of(of("csv"))) {
    if (!line.starts_with("parabola,")) continue;
    std::istringstream cells(line.substr(9));
    arcs.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) arcs.back().push_back(std::stod(cell));
    REQUIRE(arcs.back().size() == 7);
  }
  REQUIRE(arcs.size() == 2);
  const std::string path = of("svg-path");
  CHECK(std::ranges::count(path, 'Q') == 2);
  for (const std::vector<double>& arc : arcs)
    CHECK(path.find(fmt::format(" Q {} {} ", arc[2], -arc[3])) != std::string::npos);
  // In GeoJSON each chain leads from a node of three edges, or a corner, to another one, along whole curves.
  const Json map = Json::parse(of("geojson"));
  std::size_t on_arcs = 0;
  for (const Json& feature : map["features"]) {
    const Json& points = feature["geometry"]["coordinates"];
    CHECK(feature["properties"]["scalars"].size() == points.size() - 1);
    for (const Json& point : points) {
      const double x = point[0];
      const double y = point[1];
      const double to_side = std::min(x, y);
      const double to_corner = std::hypot(x - 1.0, y - 1.0);
      if (std::abs(to_side - to_corner) < 1e-12) ++on_arcs;
    }
  }
  CHECK(on_arcs > 16);
  CHECK(of("dxf").find("POLYLINE") != std::string::npos);
  CHECK(of("poff").find("# loop open") != std::string::npos);
}

TEST_CASE("a layer in DXF has polylines, circles and arcs, on a layer with its id") {
  CHECK(exported("-", "b-inner-circles", "dxf", "WPOFF 1 0 0\n1 2 3\n") ==
        "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nb-inner-circles\n10\n1\n20\n2\n30\n0\n40\n3\n0\nENDSEC\n0\nEOF\n");
  CHECK_THAT(exported("-", "points", "dxf", "0.1 -2\n"), Catch::Contains("0\nPOINT\n8\npoints\n10\n0.1\n20\n-2\n"));
  const std::string square = "POFF 4 0 0\n0 0\n4 0\n4 3\n0 3\n# loop closed 0 1 2 3\n";
  const std::string polyline = exported("-", "contours", "dxf", square);
  CHECK_THAT(polyline, Catch::Contains("0\nPOLYLINE\n8\ncontours\n66\n1\n70\n1\n"));
  const auto count = [](const std::string& text, std::string_view word) {
    std::size_t out = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++out;
    return out;
  };
  CHECK(count(polyline, "0\nVERTEX\n") == 4);
  // Two disks whose circles meet at (3, 4) and (3, -4).
  const std::string arcs = exported("-", "b-union-boundary", "dxf", "WPOFF 2 0 0\n0 0 5\n6 0 5\n");
  CHECK(count(arcs, "0\nARC\n8\nb-union-boundary\n") == 2);
  const double angle = std::atan2(4.0, 3.0) * 180.0 / std::acos(-1.0);
  const auto angles_of = [&](const std::string& center) {
    const std::size_t at = arcs.find("10\n" + center + "\n20\n0\n30\n0\n40\n5\n50\n");
    REQUIRE(at != std::string::npos);
    const std::size_t first = arcs.find("\n50\n", at) + 4, second = arcs.find("\n51\n", at) + 4;
    return std::pair(std::stod(arcs.substr(first)), std::stod(arcs.substr(second)));
  };
  CHECK(angles_of("0").first == Approx(angle));
  CHECK(angles_of("0").second == Approx(360.0 - angle));
  CHECK(angles_of("6").first == Approx(180.0 + angle));
  CHECK(angles_of("6").second == Approx(180.0 - angle));
  // Read back, the arcs are the two circles beyond their crossings.
  const mes::test::TemporaryFolder folder;
  const std::string file = folder.write("a.dxf", arcs).string();
  std::size_t seen = 0;
  for (const std::string& line : lines_of(exported(file, "points", "csv"))) {
    double x = 0.0, y = 0.0;
    if (std::sscanf(line.c_str(), "%lf,%lf", &x, &y) != 2) continue;
    CHECK(std::min(std::abs(std::hypot(x, y) - 5.0), std::abs(std::hypot(x - 6.0, y) - 5.0)) < 1e-9);
    ++seen;
  }
  CHECK(seen > 100);
}

TEST_CASE("samples of the curve are exported with their normals, a block a chain") {
  // Two concentric circles: a ring.
  std::string ring;
  for (const double radius : {2.0, 1.0})
    for (int i = 0; i < 40; ++i)
      ring += std::to_string(radius * std::cos(0.157079632679 * i + 0.1)) + ' ' +
              std::to_string(radius * std::sin(0.157079632679 * i + 0.1)) + '\n';
  const std::vector<std::string> lines = lines_of(exported("-", "curve", "npoff", ring));
  REQUIRE(lines.size() == 81);
  CHECK(std::ranges::count(lines, std::string()) == 1);
  CHECK(lines[40].empty());
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    std::istringstream in(line);
    double x = 0.0, y = 0.0, nx = 0.0, ny = 0.0;
    in >> x >> y >> nx >> ny;
    CHECK(std::hypot(nx, ny) == Approx(1.0));
    // Outside is away from the centre on the outer circle, and towards it on the inner one.
    const bool is_outer = std::hypot(x, y) > 1.5;
    CHECK((x * nx + y * ny > 0.0) == is_outer);
  }
}

TEST_CASE("rays and lines are counted where a format cannot hold them") {
  const RunResult result = run({"export", kHawaii, "--layer", "voronoi", "--format", "wkt"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("rays and lines are left out: wkt holds finite shapes only"));
  CHECK(result.out.starts_with("LINESTRING ("));
}

TEST_CASE("areas of a union are polygons with holes, as large as the union") {
  const std::string ring = [] {
    std::string out = "WPOFF 12 0 0\n";
    for (int i = 0; i < 12; ++i)
      out += fmt::format("{} {} 0.7\n", 2.0 * std::cos(0.5236 * i), 2.0 * std::sin(0.5236 * i));
    return out;
  }();
  const Json all = Json::parse(exported("-", "b-union-boundary", "geojson-areas", ring));
  REQUIRE(all["features"].size() == 1);
  const Json& geometry = all["features"][0]["geometry"];
  CHECK(geometry["type"] == "Polygon");
  REQUIRE(geometry["coordinates"].size() == 2);
  CHECK(doubled_area(geometry["coordinates"][0]) > 0.0);
  CHECK(doubled_area(geometry["coordinates"][1]) < 0.0);
  const double area = 0.5 * (doubled_area(geometry["coordinates"][0]) + doubled_area(geometry["coordinates"][1]));
  const Json numbers = Json::parse(
      run({"compute", "-", "--layers", "b-union-boundary"}, {.input = ring}).out)["structures"]["b-union"];
  // Arcs are chords here, with 96 sides per turn.
  CHECK(std::abs(area / numbers["area"].get<double>() - 1.0) < 2e-3);
  // The word "all" stands for the layers that have areas.
  const RunResult every = run({"export", "-", "--layer", "all", "--format", "geojson-areas"}, {.input = ring});
  REQUIRE(every.exit_code == 0);
  CHECK_FALSE(Json::parse(every.out)["features"].empty());
  CHECK_THAT(exported("-", "b-union-boundary", "wkt-areas", ring),
             Catch::StartsWith("POLYGON ((") && Catch::Contains("), ("));

  const RunResult none =
      run({"export", "-", "--layer", "delaunay", "--format", "wkt-areas"}, {.input = "0 0\n3 4\n"});
  CHECK(none.exit_code == 0);
  CHECK(none.err == "mesecina: 1 line is left out, because it branches or has free ends\n");
}

TEST_CASE("Voronoi cells are exported as polygons within a box, a hull or an outline") {
  const auto cells_of = [](const std::string& file, const std::string& region, const std::string& input) {
    return Json::parse(exported_with({"export", file, "--cells", region, "--format", "geojson"}, input))["features"];
  };
  const auto sum_of = [](const Json& cells) {
    double out = 0.0;
    for (const Json& cell : cells) out += cell["properties"]["area"].get<double>();
    return out;
  };
  // The squares of a lattice of 3 by 2; the box is wider by 0.2.
  const std::string lattice = "0 0\n1 0\n2 0\n0 1\n1 1\n2 1\n";
  const Json box = cells_of("-", "box", lattice);
  REQUIRE(box.size() == 6);
  CHECK(sum_of(box) == Approx(2.4 * 1.4));
  CHECK(box[4]["properties"]["sample"] == 4);
  CHECK(box[4]["properties"]["center"] == Json::array({1.0, 1.0}));
  CHECK(box[4]["geometry"]["type"] == "Polygon");
  CHECK(box[4]["geometry"]["coordinates"][0].size() == 5);
  CHECK(box[4]["properties"]["area"].get<double>() == Approx(0.7));
  CHECK(sum_of(cells_of("-", "hull", lattice)) == Approx(2.0));

  // Three wells, and a county with a lake between them and with one of them outside.
  const std::string county = R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":
      [[[0,0],[6,0],[6,4],[0,4],[0,0]],[[2,1],[2,3],[4,3],[4,1],[2,1]]]}},
    {"type":"Feature","properties":{},"geometry":{"type":"MultiPoint","coordinates":[[3,-6],[3,0.5],[3,10.5]]}}]})";
  const Json wells = Json::parse(
      exported_with({"export", "-", "--cells", "outline", "--format", "geojson", "--degrees"}, county))["features"];
  REQUIRE(wells.size() == 1);
  CHECK(wells[0]["properties"]["sample"] == 1);
  CHECK(wells[0]["properties"]["area"].get<double>() == Approx(20.0));
  REQUIRE(wells[0]["geometry"]["type"] == "Polygon");
  CHECK(wells[0]["geometry"]["coordinates"].size() == 2);

  const std::string text = exported_with({"export", "-", "--cells", "box", "--format", "wkt"}, "3 4\n");
  CHECK(exported_with({"export", "-", "--cells", "box", "--format", "wkt"}, "x y\n").empty());
  CHECK(text == "POLYGON ((2 3,4 3,4 5,2 5,2 3))\n");
}

TEST_CASE("cells that cannot be are refused in one line") {
  const auto refused = [](std::vector<std::string> words, const std::string& input, int code,
                          const std::string& says) {
    words.insert(words.begin(), {"export", "-"});
    const RunResult result = run(words, {.input = input});
    INFO(result.err);
    CHECK(result.exit_code == code);
    CHECK(result.out.empty());
    CHECK(std::ranges::count(result.err, '\n') == 1);
    CHECK_THAT(result.err, Catch::Contains(says));
  };
  refused({"--cells", "circle", "--format", "wkt"}, "0 0\n", 2, "box, hull or outline");
  refused({"--cells", "box", "--format", "dxf"}, "0 0\n", 2, "geojson, wkt, gpkg or fgb");
  refused({"--cells", "box", "--layer", "curve", "--format", "wkt"}, "0 0\n", 2, "one of them");
  refused({"--cells", "outline", "--format", "wkt"}, "0 0\n1 0\n", 2, "no outline");
  refused({"--cells", "hull", "--format", "wkt"}, "0 0\n1 1\n2 2\n", 1, "on a line");
  std::string ring;
  for (int i = 0; i < 60000; ++i) ring += fmt::format("{} {}\n", std::cos(1e-4 * i), std::sin(1e-4 * i));
  refused({"--cells", "hull", "--format", "wkt"}, ring, 1, "end at the box");
}
