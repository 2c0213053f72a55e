// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps: which colour a scalar has. Plain data and arithmetic.
//
// What it guarantees:
//  1. A graded map runs through its colours linearly from the low end of a range to the high one, and keeps its end
//     colours beyond. Infinities are beyond; what is not a number has no colour.
//  2. A categorical map gives the whole number nearest to the scalar a colour of its own, whatever the range; numbers
//     a multiple of its size apart share one. Beyond some millions, and infinite, they have the first or last colour.
//
// Smallest use:
//     const ColorMap map = grey_map();
//     if (const auto color = map.color_of(0.3, {0.0, 1.0})) ...
//
// Cost: O(1) a colour. Threads: const is safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/color.h"

namespace mes::render {

/// Ends included; empty when low > high.
struct ScalarRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool is_empty() const { return !(low <= high); }
  /// What is not finite is left out.
  void add(double value) {
    if (!(value - value == 0.0)) return;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  void add(const ScalarRange& other) {
    if (other.low < low) low = other.low;
    if (other.high > high) high = other.high;
  }
  friend bool operator==(const ScalarRange&, const ScalarRange&) = default;
};

/// Red, green and blue, each in [0, 1].
using MapColor = glm::vec3;

struct ColorMap {
  std::string name;
  std::vector<MapColor> colors;  ///< two at least
  bool is_categorical = false;

  /// Linear between the colours, t from 0 to 1.
  Rgb at(double t) const;
  /// None for what is not a number. In an empty or single-valued range, its value has the middle colour.
  std::optional<Rgb> color_of(double scalar, const ScalarRange& range) const;
};

/// Where a value stands in a range, in [0, 1], also when the ends are as far apart as doubles go.
double place_in(double value, const ScalarRange& range);

/// From a dark grey to a light one, both of which are seen on white.
ColorMap grey_map();
/// `count` colours that differ, neighbours most of all; another seed gives others.
ColorMap categorical_map(std::uint64_t seed = 0, std::size_t count = 64);
/// Those that need no file: grey and categories.
std::vector<ColorMap> builtin_color_maps();

}  // namespace mes::render
