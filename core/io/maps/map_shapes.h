// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the points, lines, arcs and rings of maps and samples them: for GeoJSON, WKT, WKB, KML, GPX and shapefiles.
// Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/curves/curve.h"
#include "core/io/format.h"
#include "core/io/systems/chosen_plane.h"
#include "core/io/systems/coordinate_system.h"
#include "core/io/text/read_job.h"

namespace mes {

class MapPlacement;

/// Positions in the order of the file, and their grouping into points, lines and rings. Samples are the positions, and
/// points between them on long lines (`default_sampling`).
///
/// Smallest use:
///     MapShapes shapes(request);
///     shapes.assume_degrees();
///     for (const Vec2 corner : {Vec2{23.9, 35.5}, Vec2{26.0, 35.2}, Vec2{24.8, 34.9}}) shapes.add(corner);
///     shapes.end_ring();
///     return std::move(shapes).load(name, job);
class MapShapes {
 public:
  /// Positions are coordinates of a plane without a coordinate system, until a call below or the request names a
  /// system.
  explicit MapShapes(const ReadRequest& request) : degrees_(request.degrees), wanted_(request.system) {}
  /// Positions are longitudes and latitudes on WGS 84, unless some are out of range or the file names a system.
  void assume_degrees() { assumed_ = CoordinateSystem{}; }
  /// The format has longitudes and latitudes alone, so that others are an error.
  void require_degrees() { named_ = CoordinateSystem{}; }
  void assume_plane() { assumed_.reset(); }
  /// Takes the system that the file names, as `find_coordinate_system` understands it. A request for another system
  /// takes precedence: then the name is not looked up. Error: `bad_input` without a place, if PROJ does not know it, or
  /// if the file has named another one.
  Expected<void> name_system(std::string_view text);
  /// The same by a number, as databases have it: a code of EPSG, or of ESRI; 0 stands for no system.
  Expected<void> name_srid(std::uint64_t number);

  void add(Vec2 position) { positions_.push_back(position); }
  /// Adds an arc from the last position along a circle through `through` to `to`; if `to` is the last position, a full
  /// circle with `through` opposite to it. Three collinear positions give a line. Must not begin a line or ring.
  void add_arc(Vec2 through, Vec2 to) {
    arcs_.push_back(positions_.size());
    positions_.insert(positions_.end(), {through, to});
  }
  /// Number of positions of the current line or ring, and the last one.
  std::size_t length() const { return positions_.size() - begin(); }
  Vec2 last() const { return positions_.back(); }
  /// Makes single points, a line, or a ring of the positions added since the last end. A line of at least four
  /// positions that ends at its start is a ring; a ring may repeat its first position at the end or not.
  void end_points() { end(Kind::points); }
  void end_line() { end(Kind::line); }
  void end_ring() {
    end(Kind::ring);
    if (!parts_.empty()) parts_.back().is_hole = rings_of_polygon_ && (*rings_of_polygon_)++ > 0;
  }
  /// Makes the next ring the outer one of a polygon, and the rings after it its holes, until the next call. A hole that
  /// another polygon fills then differs from a repeated polygon, whatever the directions of rings.
  void begin_polygon() { rings_of_polygon_ = 0; }

  /// Samples the shapes in the plane that `choose_plane` chooses; without a system their coordinates stay. A map across
  /// the 180th meridian stays in one piece, and polygons cut there are joined. Kept degrees stay bit for bit, so such a
  /// map has pieces at both ends. Long lines of projected degrees follow the straight line between degrees, by more
  /// vertices unless the job keeps vertices. A warning names system and plane, and the data keep them
  /// (`SampleData::map`). Error: as `load_samples`; for a position that is not in the named
  /// system; for a ring around a pole on a map that reaches beyond the hemisphere of the pole. Throws `Cancelled`.
  Expected<LoadedFile> load(const std::string& name, ReadJob& job) &&;

 private:
  enum class Kind : std::uint8_t { points, line, ring };
  struct Part {
    Kind kind;
    std::size_t end;
    bool is_hole = false;
  };
  void end(Kind kind);
  std::size_t begin() const { return parts_.empty() ? 0 : parts_.back().end; }
  Expected<std::optional<CoordinateSystem>> system_of_positions(std::string& remark) const;
  CurveSet curves(MapPlacement& placement, ReadJob& job);
  struct Turns {
    /// Number, among lines and rings, of the first ring that goes around the Earth without a corner at a pole; 0: none.
    /// With such a corner, as maps of the world draw Antarctica, it is a ring in a plane of longitude and latitude too.
    std::size_t around_pole = 0;
    SidesOnEarth sides{};
    std::size_t doubtful_sides = 0;  ///< between 180 and 315 degrees long
  };
  Turns turns(double half_turn) const;
  /// Lets lines and rings with sides across the 180th meridian go on beyond it, if they are then less than half a turn
  /// wide. A map of the world is not joined there as a whole.
  void unroll(double half_turn);
  /// Holes that lie outside their polygon, without those of maps with arcs.
  std::size_t holes_outside() const;
  /// Polygons with all corners within another one that has no hole there, or on its border, but not all there. Without
  /// those of maps with arcs, or whose polygons do not mark their holes.
  std::size_t polygons_inside() const;
  void turn_filled_holes(std::vector<PlaneCurve>& curves) const;

  MapDegrees degrees_;
  std::string wanted_;                       // the system of the request; empty: none
  std::optional<CoordinateSystem> assumed_;  // the system of the format
  std::optional<CoordinateSystem> named_;    // the system that the file names
  std::uint64_t srid_ = 0;                   // the last number that was looked up
  std::vector<Vec2> positions_;
  std::vector<Part> parts_;
  std::optional<std::size_t> rings_of_polygon_;  // nothing if polygons do not mark their holes
  std::vector<std::size_t> arcs_;                // for each arc, in order: index of the position that it goes through
};

}  // namespace mes
