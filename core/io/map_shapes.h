// SPDX-License-Identifier: GPL-3.0-or-later
// What maps consist of, points, lines and rings, on their way to samples: GeoJSON, WKT and shapefiles.
// Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/vec2.h"
#include "core/io/format.h"
#include "core/io/read_job.h"

namespace mes {

/// Positions in the order of the file, and which of them follow each other. Samples are the positions themselves.
///
/// Smallest use:
///     MapShapes shapes;
///     for (const Vec2 corner : {Vec2{23.9, 35.5}, Vec2{26.0, 35.2}, Vec2{24.8, 34.9}}) shapes.add(corner);
///     shapes.end_ring();
///     return std::move(shapes).load(name, MapShapes::Unit::degrees, MapDegrees::projected, job);
class MapShapes {
 public:
  /// What the numbers of a position mean.
  enum class Unit : std::uint8_t {
    plane,    ///< coordinates of the plane
    degrees,  ///< longitude and latitude, unless some are none
  };

  void add(Vec2 position) { positions_.push_back(position); }
  /// Positions added since the last end become points by themselves, a line, or a ring. A line of four positions or
  /// more that ends where it begins is a ring; a ring has its closing position or not.
  void end_points() { end(Kind::points); }
  void end_line() { end(Kind::line); }
  void end_ring() { end(Kind::ring); }

  /// Degrees are projected to kilometres about the middle of the map, equirectangularly: true to scale there and along
  /// meridians. A map across the 180th meridian stays in one piece. Degrees that are kept stay bit for bit, so such a
  /// map has pieces at both ends. A warning says which it was. Error: as `load_samples`, and
  /// `Cancelled` is thrown as there.
  Expected<LoadedFile> load(const std::string& name, Unit unit, MapDegrees degrees, ReadJob& job) &&;

 private:
  enum class Kind : std::uint8_t { points, line, ring };
  struct Part {
    Kind kind;
    std::size_t end;
  };
  void end(Kind kind);
  bool is_on_earth() const;
  std::string project();

  std::vector<Vec2> positions_;
  std::vector<Part> parts_;
};

}  // namespace mes
