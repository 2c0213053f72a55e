// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>

#include "app/layers/changed_parameters.h"
#include "core/builtins/builtins.h"

using namespace mes;

namespace {

std::string names_of_changed(const ComputationSettings& settings) {
  std::string out;
  for (const ChangedParameter& changed : changed_parameters(builtins().parameters(), settings))
    out += '[' + changed.text + ']';
  return out;
}

}  // namespace

TEST_CASE("each parameter that is not at its default is named with its value, the document's first") {
  ComputationSettings settings;
  CHECK(names_of_changed(settings).empty());
  settings[Parameter::union_shortcut] = 0.0;
  settings[Parameter::medial_sampling_angle] = 150.25;
  CHECK(names_of_changed(settings) == "[Certified shortcut for unions off][Angle of sampled balls 150.2\u00b0]");
  settings[Parameter::b_scale] = 0.5;
  settings[Parameter::a_scale] = 2.14;
  settings[Parameter::pole_propagation] = 1.0;
  CHECK(names_of_changed(settings) ==
        "[Inner balls: scale 2.14 \u00d7][Own balls: scale 0.5 \u00d7][Certified shortcut for unions off][Pole "
        "labels by propagation on]"
        "[Angle of sampled balls 150.2\u00b0]");
  // The number type is not a parameter, and has its own place.
  settings = {};
  settings.precision = Precision::exact;
  CHECK(names_of_changed(settings).empty());
}

TEST_CASE("a value next to its default is not written like the default") {
  ComputationSettings settings;
  settings[Parameter::a_scale] = 1.0000001;
  CHECK(names_of_changed(settings) == "[Inner balls: scale 1.0000001 \u00d7]");
}

TEST_CASE("another document begins with its own parameters and the number type and methods in use") {
  ComputationSettings settings;
  for (const Parameter& parameter : computation_parameters()) settings[parameter] = 0.0;
  settings[Parameter::medial_sampling_angle] = 120.0;
  settings.precision = Precision::exact_roots;
  const ComputationSettings next = for_another_document(settings);
  for (const Parameter& scale : {Parameter::a_scale, Parameter::p_scale, Parameter::b_scale})
    CHECK(next[scale] == 1.0);
  CHECK(next[Parameter::union_shortcut] == 0.0);
  CHECK(next[Parameter::pole_propagation] == 0.0);
  CHECK(next[Parameter::medial_sampling_angle] == 120.0);
  CHECK(next.precision == Precision::exact_roots);
}

TEST_CASE("what does not fit leaves room for a sign that there is more") {
  constexpr std::array<float, 3> kWidths{30, 40, 50};
  const auto fit = [&](float room) { return how_many_fit(kWidths, 5, 10, room); };
  CHECK(fit(130) == 3);
  CHECK(fit(129) == 2);
  CHECK(fit(90) == 2);
  CHECK(fit(89) == 1);
  CHECK(fit(45) == 1);
  CHECK(fit(44) == 0);
  CHECK(fit(-10) == 0);
  CHECK(how_many_fit({}, 5, 10, 100) == 0);
}
