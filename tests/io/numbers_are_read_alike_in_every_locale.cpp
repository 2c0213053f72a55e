// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text/text_numbers.h"

#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <limits>

using namespace mes;

TEST_CASE("numbers that are too small become zero, numbers that are too large are refused") {
  for (const char* text :
       {"1e-400", "-1e-9999999999999999999", "0.0000000001e-330", "0e999", "0.0e99999999999999999999"}) {
    INFO(text);
    REQUIRE(parse_number(text).has_value());
    CHECK(*parse_number(text) == 0.0);
  }
  for (const char* text : {"1e309", "-1e309", "123456789e301", "1e9999999999999999999", "0.1e310"}) {
    INFO(text);
    REQUIRE_FALSE(parse_number(text).has_value());
    CHECK(parse_number(text).error() == NumberFault::too_large);
  }
  CHECK(*parse_number("1.7976931348623157e308") == std::numeric_limits<double>::max());
  CHECK(*parse_number("4.9406564584124654e-324") == std::numeric_limits<double>::denorm_min());
}

TEST_CASE("the longest correct numbers are read correctly") {
  const std::string zeros(1'000'000, '0');
  CHECK(*parse_number("0." + zeros + "1e1000001") == 1.0);
  CHECK(*parse_number("0." + zeros + "1") == 0.0);
  CHECK(*parse_number("1" + zeros + "e-1000000") == 1.0);
  CHECK(*parse_number("1." + zeros) == 1.0);
}

TEST_CASE("the decimal sign is a point whatever the locale, and a comma only on request") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"C", "de_DE.UTF-8", "fr_FR.UTF-8"}) {
    // Locales that are not installed leave the one before in place: nothing to test, nothing to fail.
    std::setlocale(LC_ALL, locale);
    CHECK(*parse_number("1.5") == 1.5);
    CHECK_FALSE(parse_number("1,5").has_value());
    CHECK(*parse_number("1,5", true) == 1.5);
    CHECK_FALSE(parse_number("1.000,5", true).has_value());
    CHECK_FALSE(parse_number("1,000,5", true).has_value());
    std::string out;
    append_number(out, 1.5);
    CHECK(out == "1.5");
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("quoted tokens are short and printable") {
  CHECK(in_quotes("abc") == "\"abc\"");
  CHECK(in_quotes("caf\xc3\xa9") == "\"caf\xc3\xa9\"");
  CHECK(in_quotes("a\tb\x1b[31m") == "\"a\\x09b\\x1b[31m\"");
  CHECK(in_quotes("\xe2\x80\xae") == "\"\\xe2\\x80\\xae\"");
  // Half a surrogate pair, an overlong form, what lies beyond Unicode.
  CHECK(in_quotes("\xed\xa0\x80") == "\"\\xed\\xa0\\x80\"");
  CHECK(in_quotes("\xed\x9f\xbf") == "\"\xed\x9f\xbf\"");
  CHECK(in_quotes("\xe0\x9f\xbf") == "\"\\xe0\\x9f\\xbf\"");
  CHECK(in_quotes("\xf0\x8f\xbf\xbf") == "\"\\xf0\\x8f\\xbf\\xbf\"");
  CHECK(in_quotes("\xf4\x90\x80\x80") == "\"\\xf4\\x90\\x80\\x80\"");
  CHECK(in_quotes(std::string(500, 'a')).size() < 80);
  // Cut between characters, not within one.
  const std::string accents = [] {
    std::string out;
    for (int i = 0; i < 100; ++i) out += "\xc3\xa9";
    return out;
  }();
  CHECK_THAT(in_quotes(accents), !Catch::Contains("\\x"));
}
