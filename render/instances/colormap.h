// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps: the colour of a scalar. Plain data and arithmetic.
//
// Guarantees:
//  1. A graded map interpolates its colours linearly over a range. Scalars beyond an end of the range, including
//     infinite ones, have the colour of that end. NaN has no colour.
//  2. A categorical map rounds the scalar to a whole number and gives each number a colour, whatever the range; numbers
//     whose difference is a multiple of the map's size share a colour. Scalars beyond some millions, including infinite
//     ones, have the first or the last colour.
//
// Smallest use:
//     const ColorMap map = grey_map();
//     if (const auto color = map.color_of(0.3, {0.0, 1.0})) ...
//
// Cost: O(1) a colour. Threads: const calls may run at the same time.
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

/// A closed interval; empty if low > high.
struct ScalarRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool is_empty() const { return !(low <= high); }
  /// Ignores values that are not finite.
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
  std::vector<MapColor> colors;  ///< at least two
  bool is_categorical = false;

  /// The colour at `t` in [0, 1], interpolated linearly.
  Rgb at(double t) const;
  /// No colour for NaN. The middle colour for any scalar in an empty range, and for the value of a single-value range.
  std::optional<Rgb> color_of(double scalar, const ScalarRange& range) const;
};

/// Position of a value in a range, from 0 at its low end to 1 at its high end. Does not overflow for any range.
double place_in(double value, const ScalarRange& range);

/// Grades from a dark grey to a light one, both visible on white.
ColorMap grey_map();
/// `count` different colours, with the largest differences between neighbours. Another seed gives other colours.
ColorMap categorical_map(std::uint64_t seed = 0, std::size_t count = 64);
/// The maps that need no file: grey and categories.
std::vector<ColorMap> builtin_color_maps();

}  // namespace mes::render
