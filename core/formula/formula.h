// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic that people type into number fields.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace mes {

/// A function that may occur in expressions.
struct FormulaFunction {
  std::string_view name;
  int arguments = 1;  ///< 0: any number, at least one
};
/// All functions. `log` and `ln` are the natural logarithm.
std::span<const FormulaFunction> formula_functions();
/// The functions in words: "sin, cos, ...".
std::string formula_functions_in_words();

/// An expression in named variables: + - * / ^, comparisons, `a ? b : c`, parentheses, `formula_functions()`, pi, e,
/// and deg for pi / 180. Nothing else: no assignment, no text, no file.
///
/// Guarantees: equal numbers on every machine and in every locale, as far as the mathematical functions allow.
///
/// Smallest use:
///     const auto formula = Formula::parse("2 * x + 1", {"x"});
///     const double values[]{3.0};
///     const double seven = formula->value(values);
///
/// Threads: one at a time, because an evaluation writes the variables.
class Formula {
 public:
  /// Error: a description of the mistake with its column, from 1; text of more than 1000 bytes.
  static Expected<Formula> parse(std::string_view text, std::vector<std::string> names);
  ~Formula();
  Formula(Formula&& other) noexcept;
  Formula& operator=(Formula&& other) noexcept;

  /// `values` belong to the variables, in the order of their names. Not finite if the expression is not: 1 / 0.
  double value(std::span<const double> values) const;
  /// Whether the variable with this index occurs in the expression.
  bool uses(std::size_t variable) const;

 private:
  struct Parsed;
  explicit Formula(std::unique_ptr<Parsed> parsed);
  std::unique_ptr<Parsed> parsed_;
};

/// The value of an expression without variables. Error: as for `Formula::parse`; a value that is not finite.
Expected<double> number_of(std::string_view text);

}  // namespace mes
