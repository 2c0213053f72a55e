// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formula/formula.h"

#include <fmt/core.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace mes {

struct Formula::Parsed {
  mu::Parser parser;
  std::vector<std::string> names;
  std::vector<double> values;  // the parser keeps pointers to these
  std::vector<bool> is_used;
};

namespace {

constexpr std::size_t kMostBytes = 1000;

// The functions of muParser, and the cube root.
constexpr std::array<FormulaFunction, 27> kFunctions{
    {{"sin"},  {"cos"},   {"tan"},   {"asin"},  {"acos"}, {"atan"},   {"atan2", 2}, {"sinh"},   {"cosh"},
     {"tanh"}, {"asinh"}, {"acosh"}, {"atanh"}, {"exp"},  {"ln"},     {"log"},      {"log2"},   {"log10"},
     {"sqrt"}, {"cbrt"},  {"abs"},   {"sign"},  {"rint"}, {"min", 0}, {"max", 0},   {"sum", 0}, {"avg", 0}}};

std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

Error error_of(const mu::Parser::exception_type& problem, std::string_view text) {
  // The position is past the end if something is missing, and unset if the error has no position.
  const auto at = static_cast<std::size_t>(std::max(0, static_cast<int>(problem.GetPos())));
  const std::string token = printable(problem.GetToken());
  const std::size_t column = std::min(at, text.size()) + 1;
  switch (problem.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      if (!token.empty() && token.front() >= '0' && token.front() <= '9')
        return {ErrorCode::bad_input,
                fmt::format("\"{}\" is not a number that a double can hold (column {})", token, column)};
      return {ErrorCode::bad_input, fmt::format("\"{}\" is not known here (column {})", token, column)};
    case mu::ecUNEXPECTED_EOF:
    case mu::ecEMPTY_EXPRESSION: return {ErrorCode::bad_input, "the expression is not complete"};
    case mu::ecMISSING_PARENS: return {ErrorCode::bad_input, "a parenthesis is not closed"};
    case mu::ecUNEXPECTED_PARENS:
      return {ErrorCode::bad_input, fmt::format("the parenthesis at column {} closes nothing", column)};
    case mu::ecTOO_FEW_PARAMS: return {ErrorCode::bad_input, fmt::format("{} needs more arguments", token)};
    case mu::ecTOO_MANY_PARAMS: return {ErrorCode::bad_input, fmt::format("{} takes fewer arguments", token)};
    default: break;
  }
  return {ErrorCode::bad_input, fmt::format("\"{}\" is not expected here (column {})", token, column)};
}

}  // namespace

std::span<const FormulaFunction> formula_functions() {
  return kFunctions;
}

std::string formula_functions_in_words() {
  std::string out;
  for (const FormulaFunction& function : kFunctions) {
    if (!out.empty()) out += ", ";
    out += function.name;
  }
  return out;
}

Formula::Formula(std::unique_ptr<Parsed> parsed) : parsed_(std::move(parsed)) {}
Formula::~Formula() = default;
Formula::Formula(Formula&& other) noexcept = default;
Formula& Formula::operator=(Formula&& other) noexcept = default;

Expected<Formula> Formula::parse(std::string_view text, std::vector<std::string> names) {
  if (text.size() > kMostBytes)
    return std::unexpected(
        Error{ErrorCode::bad_input, fmt::format("the expression is longer than {} bytes", kMostBytes)});
  auto parsed = std::make_unique<Parsed>();
  parsed->names = std::move(names);
  parsed->values.assign(parsed->names.size(), 1.0);
  mu::Parser& parser = parsed->parser;
  try {
    parser.ClearConst();
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    parser.DefineConst("deg", std::numbers::pi / 180.0);
    parser.DefineFun("cbrt", static_cast<mu::fun_type1>([](double x) { return std::cbrt(x); }));
    parser.EnableOptimizer(false);  // evaluates the expression exactly as written
    for (std::size_t i = 0; i < parsed->names.size(); ++i) parser.DefineVar(parsed->names[i], &parsed->values[i]);
    parser.SetExpr(std::string(text));
    // Assignment is the only operator that writes a variable.
    const std::size_t assigned = [&] {
      for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '=') continue;
        const bool is_comparison = (i + 1 < text.size() && text[i + 1] == '=') ||
                                   (i > 0 && std::string_view("=<>!").find(text[i - 1]) != std::string_view::npos);
        if (!is_comparison) return i;
      }
      return std::string_view::npos;
    }();
    if (assigned != std::string_view::npos)
      return std::unexpected(
          Error{ErrorCode::bad_input, fmt::format("nothing can be assigned here (column {})", assigned + 1)});
    int results = 0;
    parser.Eval(results);
    if (results != 1)
      return std::unexpected(Error{ErrorCode::bad_input, "one number is expected, and a comma separates several"});
    for (const std::string& name : parsed->names) parsed->is_used.push_back(parser.GetUsedVar().contains(name));
    // A query for the variables discards the compiled expression of the parser.
    parser.SetExpr(std::string(text));
    parser.Eval();
  } catch (const mu::Parser::exception_type& problem) {
    return std::unexpected(error_of(problem, text));
  }
  return Formula(std::move(parsed));
}

double Formula::value(std::span<const double> values) const {
  std::ranges::copy(values, parsed_->values.begin());
  try {
    return parsed_->parser.Eval();
  } catch (const mu::Parser::exception_type&) {
    return std::nan("");  // a function refused its arguments
  }
}

bool Formula::uses(std::size_t variable) const {
  return parsed_->is_used[variable];
}

Expected<double> number_of(std::string_view text) {
  const auto formula = Formula::parse(text, {});
  if (!formula) return std::unexpected(formula.error());
  const double value = formula->value({});
  if (!std::isfinite(value)) return std::unexpected(Error{ErrorCode::bad_input, "the value is not a finite number"});
  return value;
}

}  // namespace mes
