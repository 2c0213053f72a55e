// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <vector>

#include "app/actions/messages.h"
#include "app/insight/computation_control.h"
#include "app/insight/parameter_animation.h"
#include "core/builtins/builtins.h"

using namespace mes;

namespace {

std::vector<double> values_of(ParameterAnimation& animation) {
  std::vector<double> out;
  animation.start();
  do out.push_back(animation.value());
  while (animation.advance());
  return out;
}

}  // namespace

TEST_CASE("a parameter begins and ends exactly where it was set to") {
  ParameterAnimation animation;
  animation.parameter = Parameter::medial_sampling_angle;
  animation.from = 0.1;
  animation.to = 170.3;
  animation.steps = 7;
  const auto values = values_of(animation);
  REQUIRE(values.size() == 8);
  CHECK(values.front() == 0.1);
  CHECK(values.back() == 170.3);
  for (std::size_t i = 1; i < values.size(); ++i) CHECK(values[i] > values[i - 1]);
  CHECK_FALSE(animation.is_running());
  // Downwards, and once more.
  std::swap(animation.from, animation.to);
  CHECK(values_of(animation).back() == 0.1);
}

TEST_CASE("whole parameters stay whole, and steps within their range") {
  ParameterAnimation animation;
  animation.parameter = Parameter::union_shortcut;
  animation.steps = 4;
  for (const double value : values_of(animation)) CHECK((value == 0.0 || value == 1.0));
  animation.steps = -3;
  CHECK(values_of(animation).size() == 2);
}

TEST_CASE("a range to begin with starts from the value of now where magnitudes count") {
  ParameterAnimation animation;
  animation.aim(Parameter::a_scale, 1.5);
  CHECK(animation.parameter == Parameter::a_scale);
  CHECK(animation.from == 1.5);
  CHECK(animation.to == 3.0);
  animation.aim(Parameter::a_scale, 80.0);
  CHECK(animation.to == 100.0);
  animation.aim(Parameter::a_scale, 100.0);
  CHECK(animation.to == 50.0);
  animation.aim(Parameter::medial_sampling_angle, 175.0);
  CHECK(animation.from == 90.0);
  CHECK(animation.to == 179.9);
}

TEST_CASE("a parameter that ran has the value back that it had before, at its end or when it is asked for") {
  Engine engine(builtins(), {});
  ComputationControl control(builtins(), engine);
  control.set(Parameter::a_scale, 1.25);
  ParameterAnimation& animation = control.animation();
  animation.aim(Parameter::a_scale, 1.25);
  animation.steps = 3;
  control.start_animation();
  std::vector<double> seen;
  for (double now = 0.0; animation.is_running(); now += 1.0) {
    control.advance(now);
    seen.push_back(control.settings()[Parameter::a_scale]);
  }
  REQUIRE(seen.size() >= 2);
  CHECK(seen[seen.size() - 2] == 2.5);
  CHECK(seen.back() == 1.25);
  control.start_animation();
  control.advance(100.0);
  control.advance(200.0);
  CHECK(control.settings()[Parameter::a_scale] != 1.25);
  control.give_back();
  CHECK(control.settings()[Parameter::a_scale] == 1.25);
  CHECK_FALSE(animation.is_running());
}

TEST_CASE("the log keeps what was said, counts repetitions and does not grow without end") {
  Messages messages;
  messages.remark("Saved");
  messages.problem("No");
  messages.problem("No");
  REQUIRE(messages.entries().size() == 2);
  CHECK_FALSE(messages.entries()[0].is_problem);
  CHECK(messages.entries()[1].times == 2);
  messages.clear_problem();
  CHECK(messages.entries().size() == 2);
  for (int i = 0; i < 3000; ++i) messages.remark(std::to_string(i));
  CHECK(messages.entries().size() == 1000);
  CHECK(messages.entries().back().text == "2999");
}
