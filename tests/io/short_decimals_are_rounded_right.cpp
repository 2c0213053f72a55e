// SPDX-License-Identifier: GPL-3.0-or-later
// The quick way of reading numbers gives the bits of the slow one, or leaves the number to it.
#include <fmt/format.h>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include "core/base/rng.h"
#include "core/io/svg/svg_values.h"
#include "core/io/text/short_decimal.h"

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

TEST_CASE("decimals in the middle of a text end where their digits do, and are rounded as the library rounds them") {
  Rng random(11);
  const char* const kSigns[] = {"", "-", "+"};
  const char* const kTails[] = {"",         " ",         ",",      "L",       "-4.5",       ".25 17.5 1",
                                " 17.5 18", ",17.5,185", "\n-1.5", "em 1234", "\xb9 12345", ":/12345678"};
  std::size_t quick = 0;
  std::string text;
  for (int i = 0; i < 2'000'000; ++i) {
    const std::size_t before = random.below(8);
    const std::size_t after = random.below(8);
    text = kSigns[random.below(3)];
    for (std::size_t k = 0; k < before; ++k) text += static_cast<char>('0' + random.below(10));
    if (after != 0 || random.below(2) != 0) text += '.';
    for (std::size_t k = 0; k < after; ++k) text += static_cast<char>('0' + random.below(10));
    const std::size_t size = text.size();
    const bool is_number = before + after != 0;
    const bool has_point = text.contains('.');
    const std::string_view tail = kTails[random.below(std::size(kTails))];
    text += tail;
    double value = 0.0;
    const std::size_t found = short_decimal(text, value);
    const bool goes_on = tail.starts_with('e') || (tail.starts_with('.') && !has_point);
    if (goes_on || !is_number) continue;
    ++quick;
    if (found == size && bits_of(value) == bits_of(by_library(text.substr(0, size)))) continue;
    FAIL(text << " was read as " << value << ", " << found << " bytes");
  }
  CHECK(quick > 1'500'000);
  // An e makes another number of it, if digits follow.
  double value = 4.0;
  CHECK(short_decimal("12.5e1 12345678", value) == 0);
  CHECK(short_decimal("12.5E1 12345678", value) == 0);
  CHECK(value == 4.0);
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
