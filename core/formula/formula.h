// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic as people type it into a field for a number.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace mes {

/// A function that expressions know.
struct FormulaFunction {
  std::string_view name;
  int arguments = 1;  ///< 0: any number from 1 on
};
/// All of them. `log` and `ln` are the natural logarithm.
std::span<const FormulaFunction> formula_functions();
/// "sin, cos, ...", as a sentence lists them.
std::string formula_functions_in_words();

/// An expression in named variables: + - * / ^, comparisons, `a ? b : c`, parentheses, `formula_functions()`, pi, e, and
/// deg for pi / 180. Nothing else: no assignment, no text, no file.
///
/// What it guarantees: the same numbers on every machine and in every locale, as far as its mathematical functions are.
///
/// Smallest use:
///     const auto formula = Formula::parse("2 * x + 1", {"x"});
///     const double values[]{3.0};
///     const double seven = formula->value(values);
///
/// Threads: one at a time, since an evaluation writes the variables.
class Formula {
 public:
  /// Error: what is wrong and at which column, from 1; text of more than 1000 bytes.
  static Expected<Formula> parse(std::string_view text, std::vector<std::string> names);
  ~Formula();
  Formula(Formula&& other) noexcept;
  Formula& operator=(Formula&& other) noexcept;

  /// `values`: of the variables, in the order of their names. Not finite where the expression is not, as in 1 / 0.
  double value(std::span<const double> values) const;
  /// Whether the variable, by its place among the names, is in the expression.
  bool uses(std::size_t variable) const;

 private:
  struct Parsed;
  explicit Formula(std::unique_ptr<Parsed> parsed);
  std::unique_ptr<Parsed> parsed_;
};

/// The number that an expression without variables stands for. Error: as for `Formula::parse`; a value that is not
/// finite.
Expected<double> number_of(std::string_view text);

}  // namespace mes
