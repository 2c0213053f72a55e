// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that are read many at a time, and long values that the parser of XML never sees, give what they give one by
// one.
#include <fmt/format.h>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/rng.h"
#include "core/document/curve_source.h"
#include "core/io/format.h"
#include "core/io/svg/svg_path.h"
#include "core/io/text/coordinate_pairs.h"
#include "core/io/xml/xml_long_values.h"

using namespace mes;

namespace {

struct Texts {
  std::string usual;
  std::string slow;  // each number with an exponent, which is read by itself
};

std::string random_number(Rng& random) {
  const char* const kSigns[] = {"", "", "", "-"};
  const std::uint64_t most = random.below(16) == 0 ? 20 : random.below(4) == 0 ? 14 : 6;
  std::string digits;
  const std::size_t count = 1 + random.below(most);
  for (std::size_t i = 0; i < count; ++i) digits += static_cast<char>('0' + random.below(10));
  if (random.below(4) != 0) digits.insert(random.below(digits.size() + 1), ".");
  return kSigns[random.below(4)] + digits;
}

/// Lists of coordinates, now and then with something that does not belong there.
Texts random_texts(Rng& random, char letter, std::uint64_t faults) {
  const char* const kGaps[] = {" ", ",", " ", ",", " , ", "\n", "\t ,", ", "};
  const char* const kFaults[] = {",,", "+", "-", "..", ".", "x", "e", ", L", "L,", "LL", "l", "--1", "1e2 "};
  Texts out;
  const auto both = [&](std::string_view text) {
    out.usual += text;
    out.slow += text;
  };
  const std::size_t pairs = random.below(200);
  for (std::size_t i = 0; i < 2 * pairs; ++i) {
    std::string gap;
    if (i != 0) {
      const bool may_have_letter = letter != '\0' && i % 2 == 0;
      if (may_have_letter && random.below(3) != 0)
        gap = random.below(4) == 0 ? fmt::format(" {} ", letter) : std::string(1, letter);
      else
        gap = kGaps[random.below(std::size(kGaps))];
    }
    const std::string number = random_number(random);
    const bool is_faulty = faults != 0 && random.below(faults) == 0;
    // Nothing need stand before a sign.
    const bool is_omitted = number.starts_with('-') && !is_faulty && random.below(2) == 0;
    if (!is_omitted) both(gap);
    if (is_faulty) both(kFaults[random.below(std::size(kFaults))]);
    out.usual += number;
    out.slow += number + "e0";
  }
  return out;
}

void same_paths(const SvgPath& a, const SvgPath& b) {
  REQUIRE(a.fault.has_value() == b.fault.has_value());
  REQUIRE(a.curves.size() == b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i) {
    const auto& here = a.curves[i].points();
    const auto& there = b.curves[i].points();
    for (std::size_t k = 0; k < here.size() && k < there.size(); ++k) {
      INFO(fmt::format("vertex {}: {} {} and {} {}", k, here[k].x, here[k].y, there[k].x, there[k].y));
      REQUIRE(here[k] == there[k]);
    }
    INFO(fmt::format("{} and {} points, {} and {}", here.size(), there.size(), a.fault.value_or(0),
                     b.fault.value_or(0)));
    REQUIRE(a.curves[i] == b.curves[i]);
  }
}

Expected<LoadedFile> drawing_of(const std::string& content) {
  return read_sample_bytes("<svg width='10' height='10'>" + content + "</svg>", "a.svg");
}

}  // namespace

TEST_CASE("paths of many lines are read as they are number by number, up to the same fault") {
  Rng random(3);
  for (int i = 0; i < 3000; ++i) {
    const char letter = random.below(2) == 0 ? 'L' : 'l';
    const Texts texts = random_texts(random, letter, i % 2 == 0 ? 0 : 100);
    INFO(texts.usual);
    const std::string begin = std::string("M1 2") + letter;
    same_paths(read_svg_path(begin + texts.usual), read_svg_path(begin + texts.slow));
    const std::string move = letter == 'L' ? "M" : "m";
    same_paths(read_svg_path(move + texts.usual + "Z"), read_svg_path(move + texts.slow + "Z"));
  }
}

TEST_CASE("polylines and polygons are read as they are number by number, up to the same fault") {
  Rng random(5);
  for (int i = 0; i < 3000; ++i) {
    const Texts texts = random_texts(random, '\0', i % 2 == 0 ? 0 : 100);
    INFO(texts.usual);
    same_paths(read_svg_points(texts.usual, false), read_svg_points(texts.slow, false));
    same_paths(read_svg_points(texts.usual, true), read_svg_points(texts.slow, true));
  }
}

namespace {

/// As files write them: any sign, points anywhere, exponents, many digits.
std::string spelled_number(Rng& random) {
  const char* const kOdd[] = {"4.9e-324",
                              "1e-400",
                              "2.2250738585072011e-308",
                              "9007199254740993",
                              "0.1234567890123456789",
                              "1e-1",
                              "5E+2",
                              "-0",
                              "+7",
                              "12345678.12345678",
                              "99999999",
                              ".00000001",
                              "1e22",
                              "-1.e1",
                              "123456789.5"};
  if (random.below(8) == 0) return kOdd[random.below(std::size(kOdd))];
  return random_number(random);
}

bool has_digits(const std::string& number) {
  return number.find_first_of("0123456789") != number.npos;
}

/// Nothing where it is beyond the range.
double value_of(std::string_view number) {
  if (number.starts_with('+')) number.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  REQUIRE(end == number.data() + number.size());
  return error == std::errc() ? value : 0.0;  // those beyond the range are near to zero here
}

/// Whether they may follow each other without anything between.
bool may_touch(const std::string& before, const std::string& after) {
  const bool ends_mantissa = before.find_first_of("eE") != before.npos || before.find('.') != before.npos;
  return after[0] == '-' || after[0] == '+' || (after[0] == '.' && ends_mantissa);
}

}  // namespace

TEST_CASE("numbers of paths are what std::from_chars says, however they are spelled and run together") {
  Rng random(11);
  for (int i = 0; i < 4000; ++i) {
    std::string text = "M";
    std::vector<Vec2> expected;
    std::string last = "M";
    const auto add = [&](const std::string& number, bool may_have_letter) {
      const char* const kGaps[] = {" ", ",", " ", ",", " , ", "\n", "  "};
      if (last == "M" || last == "A") {
      } else if (may_have_letter && random.below(2) == 0) {
        text += random.below(8) == 0 ? " L " : "L";
      } else if (!may_touch(last, number) || random.below(2) == 0) {
        text += kGaps[random.below(random.below(4) == 0 ? std::size(kGaps) : 4)];
      }
      text += number;
      last = number;
      return value_of(number);
    };
    const auto number = [&] {
      std::string out = spelled_number(random);
      while (!has_digits(out)) out = spelled_number(random);
      return out;
    };
    const std::size_t pairs = 2 + random.below(60);
    for (std::size_t k = 0; k < pairs; ++k) {
      const double x = add(number(), k > 0);
      const double y = add(number(), false);
      expected.push_back({x, y});
    }
    // Flags of an arc that is a line, for its radii are zero, and what follows them without a gap.
    text += "A0 0 0 1";
    text += random.below(2) == 0 ? "0" : " ,1";
    last = "A";
    const double x = add(number(), false);
    const double y = add(number(), false);
    expected.push_back({x, y});
    INFO(text);
    const SvgPath path = read_svg_path(text);
    REQUIRE(!path.fault);
    REQUIRE(path.curves.size() == 1);
    const std::vector<Vec2>& points = path.curves[0].points();
    REQUIRE(points.size() == expected.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      INFO(fmt::format("vertex {}: {} {} for {} {}", k, points[k].x, points[k].y, expected[k].x, expected[k].y));
      REQUIRE(std::bit_cast<std::uint64_t>(points[k].x) == std::bit_cast<std::uint64_t>(expected[k].x));
      REQUIRE(std::bit_cast<std::uint64_t>(points[k].y) == std::bit_cast<std::uint64_t>(expected[k].y));
    }
  }
}

#ifdef __SSE2__
TEST_CASE("a gap before the first pair, or none after another, is left to others") {
  std::array<Vec2, 4> pairs;
  for (const char* const text : {" 1 2 3 4", ",1 2 3 4", "L1 2 3 4", "x1 2"})
    CHECK(read_coordinate_pairs(text, 'L', pairs).count == 0);
  CHECK(read_coordinate_pairs("-1-2-3-4", 'L', pairs).count == 2);
  CHECK(read_coordinate_pairs("1 2", 'L', pairs, true).count == 0);
  CHECK(read_coordinate_pairs("L1 2", 'L', pairs, true).count == 1);
  CHECK(read_coordinate_pairs(std::string_view("1 2\0003 4", 7), '\0', pairs).count == 1);
  CHECK(read_coordinate_pairs("1 2 3 4e1", 'L', pairs).count == 1);
  CHECK(read_coordinate_pairs("1 2 3L4", 'L', pairs).count == 1);
}

TEST_CASE("usual pairs are all read together, to the end of the text") {
  std::string text = "1,2";
  for (int i = 1; i < 100; ++i) text += fmt::format("L{}.25 -{}.5", i, i);
  std::array<Vec2, 256> pairs;
  const PairRun run = read_coordinate_pairs(text, 'L', pairs);
  CHECK(run.size == text.size());
  REQUIRE(run.count == 100);
  CHECK(pairs[0] == Vec2{1.0, 2.0});
  CHECK(pairs[99] == Vec2{99.25, -99.5});
  const PairRun some = read_coordinate_pairs(text, 'L', std::span(pairs).first(3));
  CHECK(some.count == 3);
  CHECK(text.substr(0, some.size) == "1,2L1.25 -1.5L2.25 -2.5");
}
#endif

TEST_CASE("long values are taken out of XML and nothing else is") {
  const std::string blanks(3000, ' ');
  const std::string value = "M0 0" + blanks + "L1 1";
  const std::string bytes = "<?xml d=\"" + value + "\"?><!DOCTYPE svg PUBLIC \"" + value + "\"><!-- d=\"" + value +
                            "\"--><svg><![CDATA[<path d=\"" + value + "\"/>]]> d=\"" + value + "\" <path id='" +
                            value + "' xd='" + value + "' d = '" + value + "' d='short' points=\"" + value +
                            "\"/><path d='" + value + "&#32;'/></svg>";
  ReadJob job;
  job.begin(bytes);
  std::string rest;
  const auto found = take_long_values(bytes, {"d", "points"}, rest, job);
  REQUIRE(found.size() == 2);
  std::string again;
  std::size_t from = 0;
  for (const LongValue& one : found) {
    CHECK(one.value == value);
    again += rest.substr(from, one.place - from) + std::string(one.value);
    from = one.place + 1;
  }
  CHECK(again + rest.substr(from) == bytes);
  CHECK(bytes.substr(0, static_cast<std::size_t>(found[0].value.data() - bytes.data())).ends_with(" d = '"));
  CHECK(take_long_values(bytes, {}, rest, job).empty());
  CHECK(rest == bytes);
  CHECK(take_long_values("<!DOCTYPE svg [<!ENTITY a 'b'>]><path d='" + value + "'/>", {"d"}, rest, job).empty());
}

TEST_CASE("a drawing is the same whether its values are long or short") {
  const std::string blanks(5000, ' ');
  const auto content = [](const std::string& more) {
    return "<g transform='translate(1,2)'><path id='a' d=\"M1 1L5 1" + more +
           "L5 5Q1 5 2 3Z\"/></g><polygon points='" + more + "1,1 2,1 2,2'/><polyline points='7,7 8,8 " + more +
           "9,7'/><path d='M3 3L4 4" + more + "&#32;L9 1'/>";
  };
  const auto few = drawing_of(content(""));
  const auto many = drawing_of(content(blanks));
  REQUIRE(few.has_value());
  REQUIRE(many.has_value());
  CHECK(few->data.positions == many->data.positions);
  CHECK(*few->data.source->curves == *many->data.source->curves);
}

TEST_CASE("places after long values, and in them, are those of the file") {
  const std::string value = "M1 1L5 1" + std::string(5000, ' ') + "L5 5Z";
  const auto broken = drawing_of("<path d='" + value + "'/>\n<path d='" + value + "'/></h>");
  REQUIRE(!broken.has_value());
  CHECK(broken.error().line == 2);
  CHECK(broken.error().column == std::string("<path d=''/></h").size() + value.size());
  const auto faulty = drawing_of("<path d='" + value + "'/>\n<path d='" + value + "X'/>");
  REQUIRE(faulty.has_value());
  REQUIRE(faulty->warnings.size() == 1);
  const std::string place = fmt::format("a.svg:2:{}:", std::string("<path d='").size() + value.size() + 1);
  CHECK(faulty->warnings[0].starts_with(place));
  const auto ignored = drawing_of("<path d='" + value + "'/>\n<path d='" + value + "' transform='x'/>");
  REQUIRE(ignored.has_value());
  REQUIRE(ignored->warnings.size() == 1);
  CHECK(ignored->warnings[0].starts_with(
      fmt::format("a.svg:2:{}:", std::string("<path d='' transform='").size() + value.size() + 1)));
}

TEST_CASE("the parser of XML is stopped wherever it is") {
  std::string bytes = "<svg>";
  for (int i = 0; i < 100'000; ++i) bytes += "<g/>";
  bytes += "</svg>";
  std::int64_t look = 1;
  for (; look < 1000; ++look) {
    JobControl job;
    job.stop_at_look(look);
    const auto file = read_sample_bytes(bytes, "a", {}, {}, &job);
    REQUIRE(!file.has_value());
    if (file.error().code == ErrorCode::bad_input) break;  // for nothing is drawn in it
    REQUIRE(file.error().code == ErrorCode::cancelled);
  }
  CHECK(look > 100);
  CHECK(look < 1000);
}
