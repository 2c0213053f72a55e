// SPDX-License-Identifier: GPL-3.0-or-later
// What of a picture is to be traced (core/raster/trace.h). Plain data.
#pragma once

#include <cstdint>
#include <optional>

namespace mes {

enum class FigureSide : std::uint8_t {
  found,  ///< that of fewer pixels along the edge of the picture, or of the picture where those are equal
  dark,
  light,
};

/// What to trace, where it is not found out.
struct TraceRequest {
  std::optional<int> threshold{};  ///< the figure parts between this value and the next, from 0 to 254; none: Otsu's
  std::optional<double>
      specks{};  ///< square pixels: outlines and holes around less are left out; none: `default_specks`
  FigureSide figure = FigureSide::found;
  double pixel_area =
      1.0;  ///< of a reduced picture: how many square pixels of the whole one are one here, for messages

  bool is_default() const { return *this == TraceRequest{}; }
  friend bool operator==(const TraceRequest&, const TraceRequest&) = default;
};

}  // namespace mes
