// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"
#include "core/document/annotation.h"
#include "core/document/map_plane.h"

namespace mes {

struct CurveSource;

/// Content for a document, e.g. that of a file.
struct SampleData {
  struct Contour {
    bool closed = true;
    std::vector<std::uint32_t> points;  ///< indices into `positions`
    friend bool operator==(const Contour&, const Contour&) = default;
  };
  std::vector<Vec2> positions{};
  std::vector<Contour> contours{};
  std::vector<Disk> balls{};
  Annotations annotations{};                    ///< refer to samples by index in `positions`
  std::shared_ptr<const CurveSource> source{};  ///< curves that samples were taken from, or null
  std::optional<MapPlane> map{};                ///< where on the Earth they lie; set only for a map
};

}  // namespace mes
