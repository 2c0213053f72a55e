// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas as they are typed for shapes, and the curves around the origin that they give.
#include "core/formula/formula.h"

#include <algorithm>
#include <string>

#include "core/shapes/shape.h"
#include "tests/fuzz/reader_checks.h"

void mes::fuzz::run_formula(std::string_view bytes) {
  const std::string text(bytes);
  const auto formula = mes::Formula::parse(text, {"t"});
  const mes::ShapeDescriptor* const polar = mes::find_shape("polar");
  require(polar != nullptr, "there are curves around the origin");
  mes::ShapeRequest request{.values = mes::values_of(*polar), .sampling = {.samples = 20}};
  request.values.formulas.front() = text;
  const auto made = mes::make_shape(*polar, request);
  if (!formula) {
    require_message(formula.error().text);
    require(!made && made.error().code == mes::ErrorCode::usage, "what is typed is to blame");
    require(made.error().text == "the formula of r: " + formula.error().text, "a shape refuses it in the same words");
    return;
  }
  for (const double t : {0.0, 0.5, -3.0, 1e6}) {
    const double at[]{t};
    const double value = formula->value(at);
    const double again = formula->value(at);
    require(value == again || (value != value && again != again), "a formula has one value at one place");
  }
  if (!made) {
    require_message(made.error().text);
    return;
  }
  require(std::ranges::all_of(made->positions, [](mes::Vec2 p) { return mes::is_finite(p); }), "samples are finite");
}
