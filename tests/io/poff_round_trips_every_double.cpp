// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "core/io/format.h"
#include "tests/io/document_of.h"

using namespace mes;
using mes::test::document_of;

namespace {

void require_poff_round_trip(const SampleData& data) {
  const auto read = read_sample_bytes(write_poff(document_of(data)), "test.poff");
  REQUIRE(read.has_value());
  CHECK(read->format == "poff");
  CHECK(read->warnings.empty());
  REQUIRE(read->data.positions.size() == data.positions.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < data.positions.size(); ++i) {
    const Vec2 a = data.positions[i];
    const Vec2 b = read->data.positions[i];
    if (std::bit_cast<std::uint64_t>(a.x) != std::bit_cast<std::uint64_t>(b.x)) ++different;
    if (std::bit_cast<std::uint64_t>(a.y) != std::bit_cast<std::uint64_t>(b.y)) ++different;
  }
  CHECK(different == 0);
  REQUIRE(read->data.contours.size() == data.contours.size());
  for (std::size_t i = 0; i < data.contours.size(); ++i) {
    CHECK(read->data.contours[i].closed == data.contours[i].closed);
    CHECK(read->data.contours[i].points == data.contours[i].points);
  }
}

}  // namespace

TEST_CASE("the ends of the range survive writing and reading bit for bit") {
  using Limits = std::numeric_limits<double>;
  const double least = 0x1p-500;
  const double most = std::nextafter(0x1p500, 0.0);
  for (const std::vector<double>& values : std::vector<std::vector<double>>{
           {0.0, least, std::nextafter(least, 1.0), 1e-150, 0x1.fffffffffffffp-400},
           {0.0, most, std::nextafter(most, 0.0), 1e150, 0x1p399},
           {0.1, 1.0 / 3.0, 1e15 + 0.125, 9007199254740993.0, 0x1p-40, 1.0 + Limits::epsilon(), 1e14, 3e14}}) {
    SampleData data;
    for (const double value : values)
      for (const double sign : {1.0, -1.0}) data.positions.push_back({sign * value + 0.0, values.back()});
    require_poff_round_trip(data);
  }
}

TEST_CASE("random bit patterns survive writing and reading bit for bit") {
  std::mt19937_64 random(20260101);
  for (const int lowest : {-500, -50, 399}) {
    const auto number = [&] {
      const std::uint64_t bits = random();
      const std::uint64_t exponent = static_cast<std::uint64_t>(1023 + lowest) + (bits >> 52U) % 101;
      return std::bit_cast<double>((bits & 0x800fffffffffffffU) | exponent << 52U);
    };
    SampleData data;
    for (int i = 0; i < 20000; ++i) {
      const double x = number();
      data.positions.push_back({x, number()});
    }
    require_poff_round_trip(data);
  }
}

TEST_CASE("the curve order is written as loops and comes back") {
  SampleData data;
  for (int i = 0; i < 9; ++i) data.positions.push_back({0.5 * i, 0.25 * i * i});
  data.contours = {{true, {2, 1, 0}}, {false, {3, 4, 5, 8}}, {true, {7}}};
  require_poff_round_trip(data);
}

TEST_CASE("loops leave out samples that are gone, and follow the numbering of what is left") {
  SampleData data;
  for (int i = 0; i < 6; ++i) data.positions.push_back({1.0 * i, 2.0 * i});
  data.contours = {{true, {0, 1, 2, 3}}, {false, {4}}};
  Document document = document_of(data);
  const std::vector<SampleId> gone{document.id(SampleSlot(1)), document.id(SampleSlot(4))};
  document.apply(remove_samples(document, gone).value());
  CHECK(write_poff(document) == "POFF 4 0 0\n0 0\n2 4\n3 6\n5 10\n# loop closed 0 1 2\n");
}

TEST_CASE("samples are written in input order, although rows are used again") {
  Document document = document_of({.positions = {{1, 1}, {2, 2}, {3, 3}}, .contours = {}});
  const std::vector<SampleId> first{document.id(SampleSlot(0))};
  document.apply(remove_samples(document, first).value());
  const std::vector<Vec2> added{{4, 4}};
  document.apply(insert_samples(document, added).value());
  CHECK(write_poff(document) == "POFF 3 0 0\n2 2\n3 3\n4 4\n");
}

TEST_CASE("an empty document is a file without points") {
  CHECK(write_poff(Document()) == "POFF 0 0 0\n");
  const auto read = read_sample_bytes("POFF 0 0 0\n", "empty.poff");
  REQUIRE(read.has_value());
  CHECK(read->data.positions.empty());
}
