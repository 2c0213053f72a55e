// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "core/io/format.h"
#include "temporary_folder.h"
#include "tests/io/document_of.h"

using namespace mes;
using mes::test::document_of;

namespace {

void require_wpoff_round_trip(const std::vector<Disk>& balls) {
  const auto read = read_sample_bytes(write_wpoff(document_of({.balls = balls})), "test.wpoff");
  REQUIRE(read.has_value());
  CHECK(read->format == "wpoff");
  CHECK(read->warnings.empty());
  CHECK(read->data.positions.empty());
  REQUIRE(read->data.balls.size() == balls.size());
  std::size_t different = 0;
  const auto compare = [&different](double a, double b) {
    if (std::bit_cast<std::uint64_t>(a) != std::bit_cast<std::uint64_t>(b)) ++different;
  };
  for (std::size_t i = 0; i < balls.size(); ++i) {
    compare(read->data.balls[i].center.x, balls[i].center.x);
    compare(read->data.balls[i].center.y, balls[i].center.y);
    compare(read->data.balls[i].radius, balls[i].radius);
  }
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("the ends of the range survive as centre and as radius") {
  using Limits = std::numeric_limits<double>;
  for (const std::vector<double>& values :
       std::vector<std::vector<double>>{{0x1p-500, 1e-150, 0x1.fffffffffffffp-400},
                                        {0x1p399, 1e150, 0x1.fffffffffffffp499},
                                        {0.1, 1.0 / 3.0, 9007199254740993.0, 1.0 + Limits::epsilon(), 1e22, 1e23}}) {
    std::vector<Disk> balls;
    for (const double value : values) balls.push_back({{value, -value}, value});
    require_wpoff_round_trip(balls);
  }
}

TEST_CASE("balls of random bit patterns survive writing and reading bit for bit") {
  std::mt19937_64 random(20260102);
  for (const int lowest : {-500, -50, 399}) {
    const auto number = [&] {
      const std::uint64_t bits = random();
      const std::uint64_t exponent = static_cast<std::uint64_t>(1023 + lowest) + (bits >> 52U) % 101;
      return std::bit_cast<double>((bits & 0x800fffffffffffffU) | exponent << 52U);
    };
    std::vector<Disk> balls;
    for (int i = 0; i < 10000; ++i) {
      const double x = number();
      const double y = number();
      balls.push_back({{x, y}, std::abs(number())});
    }
    require_wpoff_round_trip(balls);
  }
}

TEST_CASE("the third number is the radius as it stands, and white space is free") {
  const auto read = read_sample_bytes("# two\r\n\tWPOFF\n2 0\r\n0 1 2\n+3e0 4 5 6 # end\n", "a");
  REQUIRE(read.has_value());
  CHECK(read->warnings.empty());
  CHECK(read->data.balls == std::vector<Disk>{{{1, 2}, 3}, {{4, 5}, 6}});
  CHECK(write_wpoff(read->data.balls) == "WPOFF 2 0 0\n1 2 3\n4 5 6\n");
}

TEST_CASE("balls of radius zero are kept, and said once") {
  const auto one = read_sample_bytes("WPOFF 2 0 0\n1 2 3\n4 5 -0\n", "a.wpoff");
  REQUIRE(one.has_value());
  CHECK(one->data.balls.size() == 2);
  REQUIRE(one->warnings.size() == 1);
  CHECK_THAT(one->warnings[0], Catch::StartsWith("a.wpoff:3:5: a ball has radius zero"));
  const auto many = read_sample_bytes("WPOFF 3 0 0\n1 2 0\n4 5 0.0\n4 5 0e7\n", "a.wpoff");
  REQUIRE(many.has_value());
  CHECK(many->data.balls.size() == 3);
  REQUIRE(many->warnings.size() == 1);
  CHECK_THAT(many->warnings[0], Catch::StartsWith("a.wpoff:2:5: 3 balls have radius zero"));
}

TEST_CASE("what follows the announced balls is ignored with a remark") {
  const auto read = read_sample_bytes("WPOFF 1 0 0\n1 2 3\n4 5 6\n", "a.wpoff");
  REQUIRE(read.has_value());
  CHECK(read->data.balls.size() == 1);
  REQUIRE(read->warnings.size() == 1);
  CHECK_THAT(read->warnings[0], Catch::StartsWith("a.wpoff:3:1: everything after the 1 announced balls"));
}

TEST_CASE("balls are known by their content, whatever the name, and written in input order") {
  const auto read = read_sample_bytes("WPOFF 0 0 0", "a.poff");
  REQUIRE(read.has_value());
  CHECK(read->format == "wpoff");
  CHECK(read->data.balls.empty());
  CHECK(write_wpoff(Document()) == "WPOFF 0 0 0\n");

  Document document = document_of({.balls = {{{1, 1}, 1}, {{2, 2}, 2}}});
  document.apply(remove_balls(document, std::vector{document.ball_id(BallSlot(0))}).value());
  document.apply(insert_balls(document, std::vector{Disk{{3, 3}, 3}}).value());
  CHECK(write_wpoff(document) == "WPOFF 2 0 0\n2 2 2\n3 3 3\n");
}

TEST_CASE("a file of contours beside a file of balls is none of its business") {
  const test::TemporaryFolder folder;
  folder.write("a.contours", "7\n");
  const auto read = read_sample_file(folder.write("a.wpoff", "WPOFF 1 0 0 1 2 3"));
  REQUIRE(read.has_value());
  CHECK(read->warnings.empty());
}
