// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/maps/map_shapes.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <span>
#include <utility>

#include "core/base/box2.h"
#include "core/curves/affine.h"
#include "core/curves/joined_ends.h"
#include "core/curves/resolution.h"
#include "core/io/curve_samples.h"

namespace mes {
namespace {

constexpr std::size_t kTriangleAndRepetition = 4;

Box2 box_of(std::span<const Vec2> positions) {
  Box2 box;
  for (const Vec2 p : positions) box.add(p);
  return box;
}

/// Shifts positions west of the 180th meridian to the east of it, if this makes the map narrower.
void join_across_the_antimeridian(std::vector<Vec2>& positions) {
  const auto eastern = [](Vec2 p) { return p.x < 0.0 ? Vec2{p.x + 360.0, p.y} : p; };
  const Box2 box = box_of(positions);
  Box2 turned;
  for (const Vec2 p : positions) turned.add(eastern(p));
  if (turned.high.x - turned.low.x < box.high.x - box.low.x)
    std::ranges::transform(positions, positions.begin(), eastern);
}

std::string in_degrees(double value, char positive, char negative) {
  return fmt::format("{:.4g} {}", std::abs(value), value < 0.0 ? negative : positive);
}

std::string remark_of(const MapPlane& plane) {
  if (plane.degrees == MapDegrees::kept) return "degrees are kept as coordinates of the plane";
  const double longitude = plane.longitude > 180.0 ? plane.longitude - 360.0 : plane.longitude;
  return fmt::format("degrees are projected to kilometres about {}, {}", in_degrees(longitude, 'E', 'W'),
                     in_degrees(plane.latitude, 'N', 'S'));
}

/// The arc along the circle through three points. Nothing if they are collinear.
std::optional<EllipticArc> arc_through(Vec2 from, Vec2 through, Vec2 to) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const auto about = [](Vec2 center, Vec2 start, double sweep) {
    const Vec2 u = start - center;
    return EllipticArc{center, u, perpendicular(u), 0.0, sweep};
  };
  if (from == to) {
    if (from == through) return std::nullopt;
    return about(0.5 * (from + through), from, kTurn);
  }
  const Vec2 p = through - from;
  const Vec2 q = to - from;
  const double turn = cross(p, q);
  const double scale = 0.5 / turn;
  const Vec2 center = from + scale * Vec2{q.y * dot(p, p) - p.y * dot(q, q), p.x * dot(q, q) - q.x * dot(p, p)};
  if (turn == 0.0 || !is_finite(center)) return std::nullopt;
  const Vec2 u = from - center;
  const Vec2 v = to - center;
  // For a flatter arc the centre is so far away that rounding moves it by more than the arc's height.
  constexpr double kFlat = 1e7;
  if (length(u) > kFlat * distance(from, to)) return std::nullopt;
  double sweep = std::atan2(cross(u, v), dot(u, v));
  if (turn > 0.0 && sweep <= 0.0) sweep += kTurn;
  if (turn < 0.0 && sweep >= 0.0) sweep -= kTurn;
  return about(center, from, sweep);
}

}  // namespace

void MapShapes::end(Kind kind) {
  const std::size_t begin = this->begin();
  if (begin == positions_.size()) return;
  const bool is_repeated =
      positions_.size() - begin >= kTriangleAndRepetition && positions_[begin] == positions_.back();
  const bool is_circle = !arcs_.empty() && arcs_.back() > begin && positions_[begin] == positions_.back();
  if (kind == Kind::line && (is_repeated || is_circle)) kind = Kind::ring;
  parts_.push_back({kind, positions_.size()});
}

MapShapes::Unit MapShapes::unit_of_epsg(std::uint64_t code) {
  // WGS 84 in the plane and with heights, ETRS89, NAD83 and its versions, GDA94 and 2020, SIRGAS 2000.
  constexpr std::array<std::uint64_t, 10> kDegrees{4326, 4979, 4258, 4269, 4617, 6318, 4283, 7844, 4674, 4148};
  return std::ranges::find(kDegrees, code) != kDegrees.end() ? Unit::degrees : Unit::plane;
}

bool MapShapes::is_on_earth() const {
  const auto is_position = [](Vec2 p) { return std::abs(p.x) <= 180.0 && std::abs(p.y) <= 90.0; };
  return !positions_.empty() && std::ranges::all_of(positions_, is_position);
}

/// Projects about the middle of the map.
MapPlane MapShapes::project() {
  join_across_the_antimeridian(positions_);
  const Box2 box = box_of(positions_);
  const Vec2 middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
  return {MapDegrees::projected, middle.x, middle.y};
}

CurveSet MapShapes::curves(const MapPlane& plane, ReadJob& job) {
  const Vec2 scale = plane.scale();
  const Vec2 origin = plane.origin();
  const auto placed = [&](Vec2 p) { return Vec2{scale.x * (p.x - origin.x), scale.y * (p.y - origin.y)}; };
  CurveSet out;
  out.resolution = resolution_of(positions_);
  if (plane.degrees == MapDegrees::projected) out.resolution *= scale.y;
  std::size_t begin = 0;
  auto arc = arcs_.begin();
  for (const Part& part : parts_) {
    job.checkpoint();
    if (part.kind == Kind::points) {
      for (std::size_t i = begin; i < part.end; ++i) out.points.push_back(placed(positions_[i]));
      begin = part.end;
      continue;
    }
    PlaneCurve& curve = out.curves.emplace_back(placed(positions_[begin]));
    for (std::size_t i = begin + 1; i < part.end; ++i) {
      const bool is_arc = arc != arcs_.end() && *arc == i;
      if (!is_arc) {
        curve.line_to(placed(positions_[i]));
        continue;
      }
      ++arc;
      ++i;
      // A circle in file coordinates; the projection makes it an ellipse.
      auto along = arc_through(positions_[i - 2], positions_[i - 1], positions_[i]);
      if (!along) {
        if (positions_[i - 1] != positions_[i - 2]) curve.line_to(placed(positions_[i - 1]));
        curve.line_to(placed(positions_[i]));
        continue;
      }
      along->center = placed(along->center);
      along->u = {scale.x * along->u.x, scale.y * along->u.y};
      along->v = {scale.x * along->v.x, scale.y * along->v.y};
      curve.arc_to(*along, placed(positions_[i]));
    }
    if (part.kind == Kind::ring) curve.close();
    begin = part.end;
  }
  positions_ = {};
  turn_filled_holes(out.curves);
  return out;
}

// A hole that repeats an outer ring in the same direction would be dropped as a duplicate; in the other direction it is
// the border of both.
void MapShapes::turn_filled_holes(std::vector<PlaneCurve>& curves) const {
  if (std::ranges::none_of(parts_, &Part::is_hole)) return;
  using Key = std::array<double, 6>;  // equal for rings that differ only in direction and start
  const auto key_of = [](const PlaneCurve& curve) {
    const Box2 box = box_of(curve.points());
    double twice_area = 0.0;
    const Vec2 origin = box.low;
    for (std::size_t i = 0; i + 1 < curve.points().size(); ++i)
      twice_area += cross(curve.points()[i] - origin, curve.points()[i + 1] - origin);
    return Key{box.low.x,
               box.low.y,
               box.high.x,
               box.high.y,
               static_cast<double>(curve.points().size()),
               twice_area > 0.0 ? 1.0 : -1.0};
  };
  std::set<Key> outer;
  std::vector<std::size_t> holes;
  std::size_t curve = 0;
  for (const Part& part : parts_) {
    if (part.kind == Kind::points) continue;
    if (part.is_hole)
      holes.push_back(curve);
    else if (part.kind == Kind::ring)
      outer.insert(key_of(curves[curve]));
    ++curve;
  }
  for (const std::size_t hole : holes)
    if (outer.contains(key_of(curves[hole]))) curves[hole] = reversed(curves[hole]);
}

Expected<LoadedFile> MapShapes::load(const std::string& name, Unit unit, MapDegrees degrees, ReadJob& job) && {
  std::optional<MapPlane> map;
  if (unit == Unit::degrees && is_on_earth())
    map = degrees == MapDegrees::projected ? project() : MapPlane{.degrees = MapDegrees::kept};
  const MapPlane plane = map.value_or(MapPlane{.degrees = MapDegrees::kept});
  // Polygons that cross the antimeridian are cut there.
  constexpr double kAntimeridian = 180.0;
  const bool is_projected = plane.degrees == MapDegrees::projected;
  const double end =
      is_projected ? plane.scale().x * (kAntimeridian - plane.origin().x) : std::numeric_limits<double>::infinity();
  auto file = load_samples(curves(plane, job), name, job, [end](Vec2 p) { return p.x == end; });
  if (file && map) {
    file->data.map = map;
    file->degrees = degrees;
    // This is the first warning because the window offers there to change the treatment of degrees.
    file->warnings.insert(file->warnings.begin(), Error{ErrorCode::bad_input, remark_of(*map), name}.message());
  }
  return file;
}

}  // namespace mes
