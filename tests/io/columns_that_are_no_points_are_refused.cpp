// SPDX-License-Identifier: GPL-3.0-or-later
// White space is free in POFF and WPOFF, but never against what the lines say.
#include <catch2/catch.hpp>

#include "core/io/format.h"

using namespace mes;

namespace {

struct Refused {
  std::string bytes;
  std::uint64_t line;
  std::uint64_t column;
  std::string says;
};

void require_refused_columns(const std::string& name, const Refused& test) {
  INFO(test.bytes);
  const auto read = read_sample_bytes(test.bytes, name);
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().line == test.line);
  CHECK(read.error().column == test.column);
  CHECK_THAT(read.error().text, Catch::Contains(test.says));
}

SampleData read_columns(const std::string& bytes, const std::string& name, std::size_t warnings = 0) {
  auto read = read_sample_bytes(bytes, name);
  INFO(bytes);
  if (!read) FAIL(read.error().message());
  CHECK(read->warnings.size() == warnings);
  return std::move(read->data);
}

}  // namespace

TEST_CASE("three columns are no points") {
  const auto read = read_sample_file("tests/data/three_columns.poff");
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().message() ==
        "tests/data/three_columns.poff:2:5: 3 numbers a line, but points have 2: probably balls (WPOFF) or points in "
        "space");
  const std::string guess = "probably balls (WPOFF) or points in space";
  for (const Refused& test : std::vector<Refused>{
           {"POFF 2 0 0\r\n0 0 5\r\n1 0 6\r\n", 2, 5, guess},
           {"POFF 2 0 0\r0 0 5\r1 0 6\r", 2, 5, guess},
           // Whatever the header says, and however many numbers that makes.
           {"POFF 3 0 0\n0 0 5\n1 0 6\n", 2, 5, guess},
           {"POFF 40 0 0\n0 0 5\n1 0 6\n", 2, 5, guess},
           // The file ends too early.
           {"POFF 4 0 0\n0 0 5\n1 0 6\n1 1 7\n0", 2, 5, guess},
           {"POFF 3 0 0\n# a comment\n\n 0 0 5 # another\n# loop closed 0 1 2\n1 0 6\n1 1 7\n", 4, 6, guess},
           {"POFF 2 0 0\n0 0 1 1 7\n1 0 2 2 6\n", 2, 5, "5 numbers a line, but points have 2"},
           // What stands there need not be a number.
           {"POFF 2 0 0\n0 0 a\n1 0 b\n", 2, 5, guess},
       })
    require_refused_columns("a.poff", test);
}

TEST_CASE("two or four columns are no balls") {
  for (const Refused& test : std::vector<Refused>{
           {"WPOFF 3 0 0\n1 2\n4 5\n6 7\n", 2, 4, "2 numbers a line, but balls have 3: probably points (POFF)"},
           {"WPOFF 2 0 0\n1 2\n4 5\n6 7\n", 2, 4, "probably points (POFF)"},
           {"WPOFF 2 0 0\n1 2 # c\n4 5\n", 2, 4, "probably points (POFF)"},
           {"WPOFF 2 0 0\n1 2 3 4\n4 5 -6 4\n", 2, 7, "4 numbers a line, but balls have 3: probably balls in space"},
       })
    require_refused_columns("a.wpoff", test);
}

TEST_CASE("a line that stands out among as many lines as points is refused") {
  require_refused_columns("a.poff",
                          {"POFF 4 0 0\n0 0\n1 0 6\n1 1\n0 1\n", 3, 5, "3 numbers on this line, but points have 2"});
  require_refused_columns("a.poff",
                          {"POFF 4 0 0\n0 0\n1\n1 1\n0 1\n", 3, 2, "1 number on this line, but points have 2"});
  require_refused_columns("a.wpoff", {"WPOFF 3 0 0\n0 0 1\n1 0 6 7\n1 1 2\n", 3, 7, "4 numbers on this line"});
}

TEST_CASE("numbers are spread freely where no line contradicts it") {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const char* bytes :
       {"POFF 4 0 0\n0 0\n1 0\n1 1\n0 1\n", "POFF 4 0 0 0 0 1 0 1 1 0 1", "POFF 4 0 0\n0 0 1 0 1 1 0 1",
        "POFF 4 0 0\n0 0 1 0\n1 1 0 1\n", "POFF\n4 0 0\n0\n0\n1\n0\n1\n1\n0\n1\n", "POFF 4 0 0\n0 0 1\n0\n1 1 0 1\n",
        // Wrapped after so many numbers.
        "POFF 4 0 0\n0 0 1\n0 1 1\n0 1\n", "POFF 4 0 0 0 0 1\n0 1 1\n0 1\n", "POFF 4 0 0\n0\n0 1 0\n1 1 0\n1\n"})
    CHECK(read_columns(bytes, "a.poff").positions == square);
  const std::vector<Disk> balls{{{0, 0}, 1}, {{2, 0}, 3}};
  for (const char* bytes :
       {"WPOFF 2 0 0\n0 0 1\n2 0 3\n", "WPOFF 2 0 0\n0 0 1 2 0 3\n", "WPOFF 2 0 0\n0 0\n1\n2 0\n3\n",
        "WPOFF 2 0 0 0 0\n1 2\n0 3\n", "WPOFF 2 0 0\n0 0 1 2\n0 3\n"})
    CHECK(read_columns(bytes, "a.wpoff").balls == balls);
}

TEST_CASE("a header that announces too few is believed, with a warning") {
  CHECK(read_columns("POFF 2 0 0\n0 0\n1 0\n1 1\n", "a.poff", 1).positions.size() == 2);
  CHECK(read_columns("POFF 1 0 0\n0 0 1 1\n", "a.poff", 1).positions.size() == 1);
}
