// SPDX-License-Identifier: GPL-3.0-or-later
// What maps consist of, points, lines, arcs and rings, on their way to samples: GeoJSON, WKT, WKB, KML, GPX and
// shapefiles.
// Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/vec2.h"
#include "core/curves/curve.h"
#include "core/io/format.h"
#include "core/io/read_job.h"

namespace mes {

/// Positions in the order of the file, and which of them follow each other. Samples are the positions, and places
/// between them where lines are long (`default_sampling`).
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
  /// From the position before along a circle through the first to the second; a full circle where this is the position
  /// before, with the first opposite to it. Of three in a line it is that line. Not at the beginning of a line or ring.
  void add_arc(Vec2 through, Vec2 to) {
    arcs_.push_back(positions_.size());
    positions_.insert(positions_.end(), {through, to});
  }
  /// How many positions the present line or ring has, and the last of them.
  std::size_t length() const { return positions_.size() - begin(); }
  Vec2 last() const { return positions_.back(); }
  /// Positions added since the last end become points by themselves, a line, or a ring. A line of four positions or
  /// more that ends where it begins is a ring; a ring has its closing position or not.
  void end_points() { end(Kind::points); }
  void end_line() { end(Kind::line); }
  void end_ring() {
    end(Kind::ring);
    if (!parts_.empty()) parts_.back().is_hole = rings_of_polygon_ && (*rings_of_polygon_)++ > 0;
  }
  /// The next ring is the outer one of a polygon, and those after it are its holes, until this is called again. A hole
  /// that another polygon fills is then told from a polygon that is there twice, whichever way around rings run.
  void begin_polygon() { rings_of_polygon_ = 0; }

  /// Degrees for codes of EPSG that are longitude and latitude on WGS 84 or within about two metres of it.
  static Unit unit_of_epsg(std::uint64_t code);
  /// Degrees are projected to kilometres about the middle of the map, equirectangularly: true to scale there and along
  /// meridians. A map across the 180th meridian stays in one piece, and polygons cut there are put together. Degrees that
  /// are kept stay bit for bit, so such a map has pieces at both ends. A warning says which it was, and the data keep it
  /// (`SampleData::map`). Error: as `load_samples`, and `Cancelled` is thrown as there.
  Expected<LoadedFile> load(const std::string& name, Unit unit, MapDegrees degrees, ReadJob& job) &&;

 private:
  enum class Kind : std::uint8_t { points, line, ring };
  struct Part {
    Kind kind;
    std::size_t end;
    bool is_hole = false;
  };
  void end(Kind kind);
  std::size_t begin() const { return parts_.empty() ? 0 : parts_.back().end; }
  bool is_on_earth() const;
  MapPlane project();
  CurveSet curves(const MapPlane& plane, ReadJob& job);
  void turn_filled_holes(std::vector<PlaneCurve>& curves) const;

  std::vector<Vec2> positions_;
  std::vector<Part> parts_;
  std::optional<std::size_t> rings_of_polygon_;  // nothing where polygons do not say which of their rings are holes
  std::vector<std::size_t> arcs_;  // of which place among the positions is the one that each goes through, in order
};

}  // namespace mes
