// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/model/parameter_sweep.h"

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

std::optional<Expected<std::string>> wait_for(SweepDesk& desk) {
  while (desk.is_under_way())
    if (auto done = desk.poll()) return done;
  return std::nullopt;
}

}  // namespace

TEST_CASE("a table has a line for each value, the same aside as at once") {
  JobControl job;
  std::vector<double> shares;
  const auto text = sweep_as_csv(
      sweep_of_square(2), [&](double share) { shares.push_back(share); }, job);
  REQUIRE(text.has_value());
  CHECK(text->starts_with("alpha-radius,layers.alpha-edges.segments,layers.alpha-edges.length,"));
  CHECK(text->find("\n0.5,0,0,") != std::string::npos);
  CHECK(text->find("\n1,4,8,") != std::string::npos);
  CHECK(std::ranges::count(*text, '\n') == 4);
  CHECK(shares == std::vector{0.0, 0.5, 1.0});
  SweepDesk desk([] {});
  CHECK_FALSE(desk.poll().has_value());
  desk.begin(sweep_of_square(2));
  const auto aside = wait_for(desk);
  REQUIRE(aside.has_value());
  REQUIRE(aside->has_value());
  CHECK(**aside == *text);
  CHECK(desk.progress() == 1.0);
}

TEST_CASE("a sweep that is given up brings nothing, and the next one brings its own") {
  SweepDesk desk([] {});
  desk.begin(sweep_of_square(ParameterAnimation::kMostSteps));
  desk.give_up();
  CHECK_FALSE(desk.is_under_way());
  CHECK_FALSE(desk.poll().has_value());
  desk.begin(sweep_of_square(1));
  const auto done = wait_for(desk);
  REQUIRE(done.has_value());
  REQUIRE(done->has_value());
  CHECK(std::ranges::count(**done, '\n') == 3);
  JobControl stopped;
  stopped.stop_at_look(1);
  CHECK_THROWS_AS(sweep_as_csv(sweep_of_square(1), {}, stopped), Cancelled);
}
