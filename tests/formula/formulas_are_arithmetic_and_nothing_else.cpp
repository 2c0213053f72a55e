// SPDX-License-Identifier: GPL-3.0-or-later
#include <muParser.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "core/base/rng.h"
#include "core/formula/formula.h"

using namespace mes;

TEST_CASE("a field for a number takes what arithmetic can say") {
  const auto value = [](const char* text) {
    const auto number = number_of(text);
    INFO(text);
    REQUIRE(number);
    return *number;
  };
  CHECK(value("3") == 3.0);
  CHECK(value(" -2.5e-3 ") == -2.5e-3);
  CHECK(value("1/3") == 1.0 / 3.0);
  CHECK(value("2 + 3 * 4 ^ 2") == 50.0);
  CHECK(value("sqrt(2)") == std::sqrt(2.0));
  CHECK(value("sin(30 * deg)") == Approx(0.5));
  CHECK(value("pi / e") == Approx(3.141592653589793 / 2.718281828459045));
  CHECK(value("min(3, 1, 2)") == 1.0);
  CHECK(value("1 < 2 ? 10 : 20") == 10.0);
  CHECK(value("2 == 2") == 1.0);
}

TEST_CASE("variables are given by their place, and it is known which ones count") {
  const auto formula = Formula::parse("2 * x - i", {"x", "y", "i"});
  REQUIRE(formula);
  const double first[]{3.0, 100.0, 1.0};
  const double second[]{-1.0, 100.0, 2.0};
  CHECK(formula->value(first) == 5.0);
  CHECK(formula->value(second) == -4.0);
  CHECK(formula->value(first) == 5.0);
  CHECK(formula->uses(0));
  CHECK_FALSE(formula->uses(1));
  CHECK(formula->uses(2));
}

TEST_CASE("each function that is listed is known, and each that is known is listed") {
  for (const FormulaFunction& function : formula_functions()) {
    CAPTURE(function.name);
    const std::string name(function.name);
    // Each is defined at 1.
    const auto value = number_of(name + (function.arguments == 2 ? "(1, 1)" : "(1)"));
    if (function.name == "atanh")
      CHECK_FALSE(value);  // infinite there
    else
      CHECK(value);
    CHECK(number_of(name + (function.arguments == 2 ? "(0.5, 0.5)" : "(0.5)")).has_value() ==
          (function.name != "acosh"));
    if (function.arguments != 0) CHECK_FALSE(number_of(name + "(1, 1, 1)"));
    CHECK(formula_functions_in_words().find(name) != std::string::npos);
  }
  const mu::Parser library;
  for (const auto& [name, callback] : library.GetFunDef()) {
    CAPTURE(name);
    CHECK(std::ranges::find(formula_functions(), name, &FormulaFunction::name) != formula_functions().end());
  }
}

TEST_CASE("the cube root is that of negative numbers, too, and log is the natural logarithm") {
  CHECK(*number_of("cbrt(27)") == Approx(3.0).epsilon(1e-15));
  CHECK(*number_of("cbrt(-8)") == -2.0);
  CHECK(*number_of("log(e)") == Approx(1.0));
  CHECK(*number_of("ln(e)") == Approx(1.0));
}

TEST_CASE("what is not an expression is refused with a reason in one line") {
  for (const char* text : {"", "  ", "1 +", "(1", "1)", "foo", "foo(1)", "1 2", "x = 3", "1, 2", "sin()", "\"text\"",
                           "sin(1, 2)", "1..2", "#", "x", "\xff\xfe", "2 x"}) {
    INFO(text);
    const auto formula = Formula::parse(text, {});
    REQUIRE_FALSE(formula);
    CHECK_FALSE(formula.error().text.empty());
    CHECK(formula.error().text.find('\n') == std::string::npos);
  }
  CHECK_FALSE(Formula::parse("x = 3", {"x"}));
  CHECK_FALSE(Formula::parse(std::string(1001, '1'), {}));
  CHECK_FALSE(Formula::parse(std::string(500, '('), {}));
  CHECK_FALSE(number_of("1/0"));
  CHECK_FALSE(number_of("sqrt(-1)"));
  CHECK(Formula::parse("foo + 1", {"x"}).error().text.find("foo") != std::string::npos);
  CHECK(Formula::parse("1 + foo", {"x"}).error().text.find("column 5") != std::string::npos);
}

TEST_CASE("a number beyond what a double holds is said to be that") {
  for (const std::string text : {"1e400", "2*1e400"}) {
    const auto number = number_of(text);
    INFO(text);
    REQUIRE_FALSE(number);
    CHECK_THAT(number.error().message(), Catch::Contains("\"1e400\" is not a number that a double can hold"));
  }
}

TEST_CASE("no text of letters that occur in expressions ends the program") {
  const std::string letters = "xysin(),.+-*/^?:<>=!& 0123456789e";
  Rng random(11);
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::uint64_t i = 0, n = random.below(12); i < n; ++i) text += letters[random.below(letters.size())];
    const auto formula = Formula::parse(text, {"x", "y"});
    if (!formula) continue;
    ++accepted;
    const double values[]{1.5, -2.0};
    static_cast<void>(formula->value(values));
  }
  CHECK(accepted > 100);
}
