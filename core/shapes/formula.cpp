// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/formula.h"

#include <fmt/core.h>
#include <muParser.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace mes {

struct Formula::Parsed {
  double t = 0.0;
  mu::Parser parser;
};

namespace {

constexpr std::size_t kMostCharacters = 1000;

std::unexpected<Error> refused(const std::string& name, std::string text) {
  // It repeats what was typed, which may be anything.
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  while (text.ends_with('.') || text.ends_with(' ')) text.pop_back();
  return std::unexpected(Error{ErrorCode::usage, fmt::format("the formula of {}: {}", name, text)});
}

}  // namespace

Expected<Formula> Formula::parse(const std::string& text, const std::string& name) {
  if (text.size() > kMostCharacters)
    return refused(name, fmt::format("it has more than {} characters", kMostCharacters));
  if (text.find_first_not_of(" \t") == std::string::npos) return refused(name, "it is empty");
  auto parsed = std::make_shared<Parsed>();
  try {
    parsed->parser.DefineConst("pi", std::numbers::pi);
    parsed->parser.DefineConst("e", std::numbers::e);
    parsed->parser.DefineVar("t", &parsed->t);
    parsed->parser.SetExpr(text);
    parsed->parser.Eval();
    if (parsed->parser.GetNumResults() != 1) return refused(name, "it has several values, separated by commas");
  } catch (const mu::Parser::exception_type& error) {
    return refused(name, error.GetMsg());
  }
  return Formula(std::move(parsed));
}

double Formula::at(double t) const {
  try {
    parsed_->t = t;
    return parsed_->parser.Eval();
  } catch (const mu::Parser::exception_type&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace mes
