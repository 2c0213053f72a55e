// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas of shapes, in one variable. Private to core/shapes.
#pragma once

#include <string>
#include <utility>

#include "core/formula/formula.h"

namespace mes {

class FormulaInT {
 public:
  /// `name` stands for the formula in messages. Error: `usage`, with what is wrong.
  static Expected<FormulaInT> parse(const std::string& text, const std::string& name) {
    auto formula = Formula::parse(text, {"t"});
    if (!formula)
      return std::unexpected(Error{ErrorCode::usage, "the formula of " + name + ": " + formula.error().text});
    return FormulaInT(*std::move(formula));
  }

  /// Not a number where it has no value.
  double at(double t) const {
    const double values[]{t};
    return formula_.value(values);
  }

 private:
  explicit FormulaInT(Formula formula) : formula_(std::move(formula)) {}
  Formula formula_;
};

}  // namespace mes
