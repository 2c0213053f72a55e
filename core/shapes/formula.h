// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas of one variable as people type them: "2 + cos(3 t)" is written "2 + cos(3*t)". Read by muParser, which
// knows + - * / ^, comparisons, ?:, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, ln, log2, log10, sqrt, cbrt,
// abs, sign, rint, min, max, sum, avg; here also the constants pi and e. Nothing else is evaluated.
//
// Smallest use:
//     auto radius = Formula::parse("1 + t/10", "r");
//     if (radius) use(radius->at(0.5));
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"

namespace mes {

/// Threads: one at a time.
class Formula {
 public:
  /// `name` stands for the formula in messages. Error: `usage`, with the place of what is not understood.
  static Expected<Formula> parse(const std::string& text, const std::string& name);

  /// Not a number where it has no value.
  double at(double t) const;

 private:
  struct Parsed;
  explicit Formula(std::shared_ptr<Parsed> parsed) : parsed_(std::move(parsed)) {}
  std::shared_ptr<Parsed> parsed_;
};

}  // namespace mes
