// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments that come with the program and take long to compile, for they use CGAL: each is compiled once here.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "workshop.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

const std::string kMoebius = "examples/experiments/moebius_diagram.cpp";
const std::string kAxis = "examples/experiments/polygon_axis.cpp";
const std::string kDifference = "examples/experiments/polygon_axis_difference.cpp";

using Segment = std::array<double, 4>;

/// The rows of a table of numbers in CSV, without the header.
std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> out;
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    out.emplace_back();
    std::istringstream cells(line);
    while (std::getline(cells, cell, ',')) out.back().push_back(std::stod(cell));
  }
  return out;
}

double distance(double x, double y, const Segment& s) {
  const double dx = s[2] - s[0], dy = s[3] - s[1], square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((x - s[0]) * dx + (y - s[1]) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(s[0] + t * dx - x, s[1] + t * dy - y);
}

/// The largest distance of points on `from` to the nearest point of `to`, by comparing all pairs.
double one_sided_distance(const std::vector<Segment>& from, const std::vector<Segment>& to) {
  constexpr int kSteps = 64;
  double largest = 0.0;
  for (const Segment& s : from)
    for (int k = 0; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      double nearest = std::numeric_limits<double>::infinity();
      for (const Segment& other : to)
        nearest = std::min(nearest, distance(s[0] + t * (s[2] - s[0]), s[1] + t * (s[3] - s[1]), other));
      largest = std::max(largest, nearest);
    }
  return largest;
}

/// A closed polygon as a document, with its contour.
std::string closed(const std::vector<std::array<double, 2>>& corners) {
  std::ostringstream out;
  out.precision(17);
  out << "POFF " << corners.size() << " 0 0\n";
  for (const auto& [x, y] : corners) out << x << ' ' << y << '\n';
  out << "# loop closed";
  for (std::size_t k = 0; k < corners.size(); ++k) out << ' ' << k;
  return out.str() + '\n';
}

/// What `compute` says of the difference between both axes.
Json difference_of(const Workshop& workshop, const std::string& file) {
  const Json out = Json::parse(workshop.output_of({"compute", file, "--with", kAxis, "--with", kDifference,
                                                   "--layers", "polygon-axis-difference", "--no-timing"}));
  return out["structures"]["polygon-axis-difference"];
}

}  // namespace

TEST_CASE("examples have the exact axis of a polygon and its difference to the axis of samples") {
  // The sources are compiled once for all that is tried.
  const Workshop workshop;
  CHECK_THAT(workshop.output_of({"check", kAxis, kDifference}), Catch::Contains("polygon-axis-difference"));
  {
    const std::string file = workshop.write("box.poff", "POFF 4 0 0\n0 0\n4 0\n4 2\n0 2\n# loop closed 0 1 2 3\n");
    const Json out =
        Json::parse(workshop.output_of({"compute", file, "--with", "examples/experiments/polygon_axis.cpp",
                                        "--layers", "polygon-axis-lines,polygon-axis-arcs", "--no-timing"}));
    // The middle, and a diagonal to each corner.
    CHECK(out["layers"]["polygon-axis-lines"]["segments"] == 5);
    CHECK(out["layers"]["polygon-axis-lines"]["length"].get<double>() == Approx(2.0 + 4.0 * std::sqrt(2.0)));
    CHECK(out["layers"]["polygon-axis-arcs"]["segments"] == 0);
  }
  // The axis of the samples of a rectangle lies on that of the rectangle, and ends in front of its corners.
  {
    constexpr double kStep = 0.25;
    std::vector<std::array<double, 2>> corners;
    for (int k = 0; k < 16; ++k) corners.push_back({k * kStep, 0.0});
    for (int k = 0; k < 8; ++k) corners.push_back({4.0, k * kStep});
    for (int k = 16; k > 0; --k) corners.push_back({k * kStep, 2.0});
    for (int k = 8; k > 0; --k) corners.push_back({0.0, k * kStep});
    const std::string file = workshop.write("rectangle.poff", closed(corners));
    const Json found = difference_of(workshop, file);
    // The axis of the samples lies on that of the rectangle and ends half a step in front of each corner, in x and y.
    CHECK(found["distance_from_polygon_axis_to_medial_axis"].get<double>() == Approx(kStep / std::sqrt(2.0)));
    CHECK(found["distance_from_medial_axis_to_polygon_axis"].get<double>() == Approx(0.0).margin(1e-12));
  }
  // The difference for a curved polygon is that of all pairs of pieces.
  {
    std::vector<std::array<double, 2>> corners;
    for (int k = 0; k < 60; ++k) {
      const double t = std::acos(-1.0) * k / 30.0;
      corners.push_back({(10.0 + 2.0 * std::cos(3.0 * t)) * std::cos(t), (6.0 + std::sin(2.0 * t)) * std::sin(t)});
    }
    const std::string file = workshop.write("wave.poff", closed(corners));
    const Json found = difference_of(workshop, file);
    const auto segments = [&](const std::vector<std::string>& layers, const std::string& angle) {
      std::vector<Segment> all;
      for (const std::string& layer : layers)
        for (const std::vector<double>& row :
             numbers_of(workshop.output_of({"export", file, "--with", kAxis, "--set", "polygon-axis-angle=" + angle,
                                            "--layer", layer, "--format", "csv"})))
          all.push_back({row.at(0), row.at(1), row.at(2), row.at(3)});
      return all;
    };
    const std::vector<std::string> polygon{"polygon-axis-lines", "polygon-axis-arcs"};
    const std::vector<Segment> shown = segments(polygon, "20"), all = segments(polygon, "0");
    const std::vector<Segment> sampled = segments({"medial-axis"}, "20");
    CHECK(shown.size() < all.size());
    // The structure measures at points that are at most a thousandth of the diagonal apart, and the loop above closer.
    constexpr double kTolerance = 27.0 / 2000.0;
    const double there = one_sided_distance(shown, sampled), back = one_sided_distance(sampled, all);
    CHECK(there > 2.0 * kTolerance);
    CHECK(back > 2.0 * kTolerance);
    CHECK(found["distance_from_polygon_axis_to_medial_axis"].get<double>() == Approx(there).margin(kTolerance));
    CHECK(found["distance_from_medial_axis_to_polygon_axis"].get<double>() == Approx(back).margin(kTolerance));
  }
}

TEST_CASE("an example has the Moebius diagram of two, three and five balls") {
  const Workshop workshop;
  CHECK_THAT(workshop.output_of({"check", kMoebius}), Catch::Contains("moebius-diagram"));
  const std::string file = workshop.write("two.wpoff", "WPOFF 2 0 0\n0 0 1\n4 0 2\n");
  const std::vector<std::string> layers{"--layers", "moebius-diagram,moebius-vertices,moebius-vanishing",
                                        "--no-timing"};
  const auto compute = [&](const std::string& name) {
    std::vector<std::string> words{"compute", name, "--with", kMoebius};
    words.insert(words.end(), layers.begin(), layers.end());
    return Json::parse(workshop.output_of(words));
  };
  const Json out = compute(file);
  CHECK(out["layers"]["moebius-diagram"]["arcs"] == 1);
  CHECK(out["layers"]["moebius-vertices"]["points"] == 0);
  // The smaller ball vanishes where it touches the larger one from inside, at the factor 4 / (2 - 1).
  CHECK(out["layers"]["moebius-vanishing"]["points"] == 1);
  CHECK(out["structures"]["moebius-diagram"]["first_vanishing_date"].get<double>() == Approx(4.0));
  // Points that are twice as far from (4, 0) as from (0, 0) lie between (-4, 0) and (4/3, 0).
  const auto rows = numbers_of(workshop.output_of(
      {"export", file, "--with", kMoebius, "--structure", "moebius-diagram", "--table", "edges", "--format", "csv"}));
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].at(4) == Approx(-4.0 / 3.0));
  CHECK(rows[0].at(5) == Approx(0.0).margin(1e-15));
  CHECK(rows[0].at(6) == Approx(8.0 / 3.0));

  const Json line = compute(workshop.write("equal.wpoff", "WPOFF 2 0 0\n0 0 1\n4 0 1\n"));
  CHECK(line["layers"]["moebius-diagram"]["lines"] == 1);
  CHECK(line["layers"]["moebius-diagram"]["arcs"] == 0);
  CHECK(line["layers"]["moebius-vanishing"]["points"] == 0);

  const std::string three = workshop.write("three.wpoff", "WPOFF 3 0 0\n0 0 1\n4 0 2\n1 3 1\n");
  const auto vertices = numbers_of(workshop.output_of({"export", three, "--with", kMoebius, "--structure",
                                                       "moebius-diagram", "--table", "vertices", "--format", "csv"}));
  REQUIRE(vertices.size() == 2);
  for (const std::vector<double>& row : vertices) {
    const double x = row.at(1), y = row.at(2), factor = row.at(3);
    CHECK(std::hypot(x, y) == Approx(factor));
    CHECK(std::hypot(x - 4.0, y) / 2.0 == Approx(factor));
    CHECK(std::hypot(x - 1.0, y - 3.0) == Approx(factor));
  }
  // The cell of the middle one of five equal balls is a square, whose corners are as far from it as its radius.
  const std::string five = workshop.write("five.wpoff", "WPOFF 5 0 0\n0 0 1\n1 1 1\n1 -1 1\n-1 1 1\n-1 -1 1\n");
  const Json square = Json::parse(workshop.output_of(
      {"compute", five, "--with", kMoebius, "--layers", "moebius-diagram,moebius-vertices", "--no-timing"}));
  CHECK(square["layers"]["moebius-diagram"]["segments"] == 4);
  CHECK(square["layers"]["moebius-diagram"]["rays"] == 4);
  CHECK(square["layers"]["moebius-vertices"]["points"] == 4);
  CHECK(square["structures"]["moebius-diagram"]["first_vanishing_date"].get<double>() == Approx(1.0));
}
