// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/insight/parameter_sweep.h"
#include "core/builtins/builtins.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

ParameterSweep sweep_of_square(int steps) {
  ParameterSweep out;
  out.data.positions = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  out.range.parameter = Parameter::alpha_radius;
  out.range.from = 0.5;
  out.range.to = 1.5;
  out.range.steps = steps;
  out.layers = {find_layer("alpha-edges")};
  return out;
}

/// By the value of the parameter, cells that are not empty by the name of their column.
using CellsByValue = std::map<std::string, std::map<std::string, std::string>>;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream in(line + ',');
  for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
  return out;
}

CellsByValue cells_by_value(const std::string& csv) {
  std::istringstream in(csv);
  std::string line;
  REQUIRE(std::getline(in, line));
  const std::vector<std::string> columns = cells_of(line);
  CHECK(std::set<std::string>(columns.begin(), columns.end()).size() == columns.size());
  CellsByValue out;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = cells_of(line);
    REQUIRE(cells.size() == columns.size());
    for (std::size_t i = 1; i < cells.size(); ++i)
      if (!cells[i].empty()) out[cells[0]][columns[i]] = cells[i];
  }
  return out;
}

std::optional<Expected<std::string>> wait_for_sweep(SweepJob& sweep) {
  while (sweep.is_under_way())
    if (auto done = sweep.poll()) return done;
  return std::nullopt;
}

}  // namespace

TEST_CASE("a table has a line for each value, the same aside as at once") {
  JobControl job;
  std::vector<double> shares;
  const auto text = sweep_as_csv(
      builtins(), sweep_of_square(2), [&](double share) { shares.push_back(share); }, job);
  REQUIRE(text.has_value());
  CHECK(text->starts_with("alpha-radius,layers.alpha-edges.segments,layers.alpha-edges.length,"));
  CHECK(text->find("\n0.5,0,0,") != std::string::npos);
  CHECK(text->find("\n1,4,8,") != std::string::npos);
  CHECK(std::ranges::count(*text, '\n') == 4);
  CHECK(shares == std::vector{0.0, 0.5, 1.0});
  SweepJob sweep(builtins(), [] {});
  CHECK_FALSE(sweep.poll().has_value());
  sweep.begin(sweep_of_square(2));
  const auto aside = wait_for_sweep(sweep);
  REQUIRE(aside.has_value());
  REQUIRE(aside->has_value());
  CHECK(**aside == *text);
  CHECK(sweep.progress() == 1.0);
}

TEST_CASE("a table holds what only some of its values have, whichever comes first") {
  // At 1 the balls along the axis are those of samples, and counted with them; grown ones are not.
  ParameterSweep sweep;
  for (int i = 0; i < 40; ++i) {
    const double t = 6.283185307179586 * (i + 0.3) / 40.0;
    sweep.data.positions.push_back({2.0 * std::cos(t), std::sin(t)});
  }
  sweep.range.parameter = Parameter::scale_axis_factor;
  sweep.range.steps = 2;
  sweep.layers = {find_layer("scale-axis")};
  const auto between = [&](double from, double to) {
    sweep.range.from = from;
    sweep.range.to = to;
    JobControl job;
    const auto text = sweep_as_csv(builtins(), sweep, {}, job);
    REQUIRE(text.has_value());
    return cells_by_value(*text);
  };
  CellsByValue up = between(1.0, 1.5);
  CellsByValue down = between(1.5, 1.0);
  REQUIRE(up.size() == 3);
  CHECK(up["1"].size() != up["1.5"].size());
  CHECK(up == down);
}

TEST_CASE("a sweep that is given up brings nothing, and the next one brings its own") {
  SweepJob sweep(builtins(), [] {});
  sweep.begin(sweep_of_square(ParameterAnimation::kMostSteps));
  sweep.give_up();
  CHECK_FALSE(sweep.is_under_way());
  CHECK_FALSE(sweep.poll().has_value());
  sweep.begin(sweep_of_square(1));
  const auto done = wait_for_sweep(sweep);
  REQUIRE(done.has_value());
  REQUIRE(done->has_value());
  CHECK(std::ranges::count(**done, '\n') == 3);
  JobControl stopped;
  stopped.stop_at_look(1);
  CHECK_THROWS_AS(sweep_as_csv(builtins(), sweep_of_square(1), {}, stopped), Cancelled);
}
