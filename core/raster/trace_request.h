// SPDX-License-Identifier: GPL-3.0-or-later
// The request to trace a picture (core/raster/trace.h). Plain data.
#pragma once

#include <cstdint>
#include <optional>

namespace mes {

enum class FigureSide : std::uint8_t {
  found,  ///< the side with fewer pixels along the edge of the picture; if equal, with fewer pixels in the picture
  dark,
  light,
};

/// Options of a tracing; missing ones are chosen automatically.
struct TraceRequest {
  std::optional<int> threshold{};  ///< divides between this value and the next, from 0 to 254; none: Otsu's
  std::optional<double>
      specks{};  ///< square pixels: outlines and holes around less are left out; none: `default_specks`
  FigureSide figure = FigureSide::found;
  double pixel_area =
      1.0;  ///< for a reduced picture: square pixels of the whole one in each pixel here, for messages

  bool is_default() const { return *this == TraceRequest{}; }
  friend bool operator==(const TraceRequest&, const TraceRequest&) = default;
};

}  // namespace mes
