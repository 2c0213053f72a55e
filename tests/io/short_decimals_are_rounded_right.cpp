// SPDX-License-Identifier: GPL-3.0-or-later
// The quick way of reading numbers gives the bits of the slow one, or leaves the number to it.
#include <fmt/format.h>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cstdint>
#include <string>

#include "core/base/rng.h"
#include "core/io/short_decimal.h"
#include "core/io/svg_values.h"

using namespace mes;

namespace {

std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

double by_library(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double out = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), out);
  REQUIRE(fault == std::errc());
  REQUIRE(end == text.data() + text.size());
  return out;
}

}  // namespace

TEST_CASE("decimals of every length are read as the library reads them") {
  Rng random(7);
  const char* const kSigns[] = {"", "-", "+"};
  std::size_t quick = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t digits = random.next() >> random.below(64);
    std::string text = fmt::format("{:0{}}", digits, 1 + random.below(20));
    if (random.below(4) != 0) text.insert(random.below(text.size() + 1), ".");
    text = kSigns[random.below(3)] + text;
    double value = 0.0;
    const std::size_t size = short_decimal(text, value);
    if (size == 0) continue;
    ++quick;
    INFO(text);
    REQUIRE(size == text.size());
    REQUIRE(bits_of(value) == bits_of(by_library(text)));
  }
  CHECK(quick > 100'000);
}

TEST_CASE("texts that are not short decimals are not read") {
  for (const char* text : {"", "-", "+", ".", "-.", "+.", "e5", "1e5", "1.5E-3", "2em", "nan", "inf", "--1", "+-1",
                           "1234567890123456789", "9007199254740993", "0.0000000000000000001"}) {
    INFO(text);
    double value = 4.0;
    CHECK(short_decimal(text, value) == 0);
    CHECK(value == 4.0);
  }
  double value = 0.0;
  CHECK(short_decimal("9007199254740992", value) == 16);
  CHECK(value == 9007199254740992.0);
  CHECK(short_decimal("-0", value) == 2);
  CHECK(bits_of(value) == bits_of(-0.0));
}

TEST_CASE("a number ends where the next one begins") {
  SvgText text("1-2.5.5+.25e1,-3.em");
  CHECK(text.number() == 1.0);
  CHECK(text.number() == -2.5);
  CHECK(text.number() == 0.5);
  CHECK(text.number() == 2.5);
  text.skip_comma();
  // An e without digits is the beginning of a unit.
  CHECK(text.number() == -3.0);
  CHECK(text.word() == "em");
  CHECK_FALSE(text.number());
}
