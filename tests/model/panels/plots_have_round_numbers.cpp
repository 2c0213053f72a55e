// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "app/ui/widgets/plot.h"
#include "core/base/rng.h"

using namespace mes;

namespace {

/// 1, 2 or 5 times a power of ten.
bool is_round(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  const double factor = step / power;
  return std::abs(factor - 1) < 1e-6 || std::abs(factor - 2) < 1e-6 || std::abs(factor - 5) < 1e-6;
}

}  // namespace

TEST_CASE("the numbers of an axis are multiples of a round step, within it, apart and different") {
  Rng random(3);
  for (int turn = 0; turn < 500; ++turn) {
    const double size = std::pow(10.0, 40.0 * random.uniform() - 20.0);
    const PlotAxis axis{-size * random.uniform(), size * (0.01 + random.uniform()), ""};
    const double length = 20.0 + 600.0 * random.uniform();
    const auto ticks = plot_ticks(axis, length, 40.0);
    INFO(axis.low << " to " << axis.high << " on " << length);
    std::set<std::string> texts;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      CHECK(ticks[i].value >= axis.low);
      CHECK(ticks[i].value <= axis.high);
      CHECK(texts.insert(ticks[i].text).second);
      if (i == 0) continue;
      const double step = ticks[i].value - ticks[i - 1].value;
      CHECK(is_round(step));
      CHECK(step / (axis.high - axis.low) * length >= 40.0 * (1 - 1e-6));
    }
    // Steps are at most five times as large as necessary.
    if (length >= 400.0) CHECK(ticks.size() >= 2);
  }
}

TEST_CASE("on an axis of square roots numbers are apart where they are drawn") {
  for (const double high : {1.0, 7.3, 104.0, 2.6e-7, 9.9e12}) {
    const auto ticks = plot_ticks({0.0, high, "", true}, 300.0, 40.0);
    REQUIRE(ticks.size() >= 3);
    CHECK(ticks.front().value == 0.0);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      CHECK(ticks[i].value <= high);
      CHECK(is_round(ticks[i].value));
      CHECK(300.0 * (std::sqrt(ticks[i].value / high) - std::sqrt(ticks[i - 1].value / high)) >= 40.0);
    }
  }
}

TEST_CASE("an axis whose numbers cannot be told apart has none") {
  CHECK(plot_ticks({1.0, 1.0, ""}, 300.0, 40.0).empty());
  CHECK(plot_ticks({1e15, 1e15 + 1, ""}, 300.0, 40.0).empty());
  CHECK(plot_ticks({0.0, std::numeric_limits<double>::infinity(), ""}, 300.0, 40.0).empty());
  CHECK(plot_ticks({0.0, 1.0, ""}, 0.0, 40.0).empty());
}
