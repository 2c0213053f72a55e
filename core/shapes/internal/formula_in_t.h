// SPDX-License-Identifier: GPL-3.0-or-later
// Shape formulas in one variable. Private to core/shapes.
#pragma once

#include <string>
#include <utility>

#include "core/formula/formula.h"

namespace mes {

class FormulaInT {
 public:
  /// `name` is the formula's name in messages. Error: `usage`, with the fault.
  static Expected<FormulaInT> parse(const std::string& text, const std::string& name) {
    auto formula = Formula::parse(text, {"t"});
    if (!formula)
      return std::unexpected(Error{ErrorCode::usage, "the formula of " + name + ": " + formula.error().text});
    return FormulaInT(*std::move(formula));
  }

  /// Value at t; NaN where the formula has no value.
  double at(double t) const {
    const double values[]{t};
    return formula_.value(values);
  }

 private:
  explicit FormulaInT(Formula formula) : formula_(std::move(formula)) {}
  Formula formula_;
};

}  // namespace mes
