// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines as lines for other programs, and their totals in words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "app/store/texts/line_text.h"
#include "core/base/sum.h"
#include "core/document/map_plane.h"
#include "core/structures/filters/center_lines.h"

namespace mes {

/// The line with its numbers: shape and line, counted from 1, length, least, mean and largest width. `unit` is the
/// size of a length of the plane in the written unit. Points are left out where the line without them leaves neither
/// them nor their radii by more than 2^-12 of the radius, so that straight lines have two.
TextLine text_line_of(const CenterLine& line, const std::optional<MapPlane>& map, double unit);

struct CenterLineTotals {
  std::size_t lines = 0;
  std::size_t points = 0;  ///< shapes without a line
  Sum length{};
  Widths widths{std::numeric_limits<double>::infinity(), 0.0, 0.0};

  void add(const CenterLines& found, double unit);
  /// "2 lines of length 12.6 m in all, width 1.1 to 1.3 m"; without a map lengths have no unit. `off_earth` lines were
  /// left out of the text.
  std::string text(const std::optional<MapPlane>& map, std::uint64_t off_earth, std::size_t stations = 0) const;
};

}  // namespace mes
