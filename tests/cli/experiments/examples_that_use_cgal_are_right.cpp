// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment that comes with the program and takes long to compile, for it uses CGAL: it is compiled once here.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "workshop.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

const std::string kMoebius = "examples/experiments/moebius_diagram.cpp";

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

}  // namespace

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
