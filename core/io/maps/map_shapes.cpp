// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/maps/map_shapes.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "core/base/counted.h"
#include "core/base/geometry/box2.h"
#include "core/base/geometry/box_tree.h"
#include "core/curves/cuts.h"
#include "core/curves/joined_ends.h"
#include "core/curves/resolution.h"
#include "core/io/curve_samples.h"
#include "core/io/systems/chosen_plane.h"
#include "core/io/systems/map_conversion.h"
#include "core/kernel/point_predicates.h"

namespace mes {
namespace {

constexpr std::size_t kTriangleAndRepetition = 4;

Box2 box_of(std::span<const Vec2> positions) {
  Box2 box;
  for (const Vec2 p : positions) box.add(p);
  return box;
}

/// Positions of a small place on the Earth: with decimals, in the range of degrees, and far from the origin, at which
/// drawings begin.
bool look_like_degrees(const std::vector<Vec2>& positions) {
  constexpr double kCoarsest = 1e-3;
  constexpr double kFar = 4.0;
  if (positions.empty()) return false;
  const Box2 box = box_of(positions);
  const double size = std::hypot(box.width(), box.height());
  const double resolution = resolution_of(positions);
  return box.low.x >= -180.0 && box.high.x <= 180.0 && box.low.y >= -90.0 && box.high.y <= 90.0 &&
         resolution <= kCoarsest && length(box.center()) >= kFar * size;
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

/// Tells on which side of a ring points lie, in O(log n) where few sides have one height.
class RingSides {
 public:
  explicit RingSides(std::span<const Vec2> ring) : ring_(ring) {
    std::vector<std::uint32_t> numbers(ring.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    tree_.build(
        std::span<const std::uint32_t>(numbers),
        [this](std::uint32_t i) {
          return TreeBounds{box_of(std::array{ring_[i], next(i)})};
        },
        [](std::uint32_t, std::uint32_t) {});
  }
  /// 1: enclosed an odd number of times; 0: on the ring; -1: neither.
  int place_of(Vec2 p) const {
    bool is_inside = false;
    bool is_on = false;
    const auto meets_ray = [p](const Box2& box, double) {
      return box.low.y <= p.y && p.y <= box.high.y && p.x <= box.high.x;
    };
    tree_.visit_where(meets_ray, [&](std::uint32_t i) {
      Vec2 low = ring_[i];
      Vec2 high = next(i);
      if (high.y < low.y) std::swap(low, high);
      const int turn = orientation(low, high, p);
      is_on = is_on || (turn == 0 && box_of(std::array{low, high}).contains(p));
      if (low.y <= p.y && p.y < high.y && turn > 0) is_inside = !is_inside;
    });
    return is_on ? 0 : is_inside ? 1 : -1;
  }

 private:
  Vec2 next(std::uint32_t i) const { return ring_[i + 1 < ring_.size() ? i + 1 : 0]; }

  std::span<const Vec2> ring_;
  BoxTree<std::uint32_t> tree_;
};

}  // namespace

/// Places positions and pieces of curves in the plane of a map. Without a map they stay as they are.
class MapPlacement {
 public:
  MapPlacement() = default;
  MapPlacement(const MapPlane& plane, const CoordinateSystem& system, MapConversion conversion)
      : plane_(plane), system_(system), conversion_(std::move(conversion)) {}

  /// Coordinates of the plane in a unit of the system.
  double size_of_unit() const {
    constexpr double kMetres = 6371008.8;  // of a radian
    constexpr double kKilometres = 1e-3 * kMetres;
    if (is_unchanged()) return 1.0;
    if (!system_.is_geographic) return system_.unit_size;
    return system_.unit_size * (is_azimuthal() ? kMetres : kKilometres);
  }

  std::vector<Vec2> place(std::span<const Vec2> positions) {
    std::vector<Vec2> out;
    out.reserve(positions.size());
    for (const Vec2 p : positions) out.push_back(placed(p));
    const Box2 box = box_of(out);
    tolerance_ = kLeastBend * std::hypot(box.width(), box.height());
    return out;
  }

  void split_lines(bool are_split) { splits_ = are_split && is_azimuthal(); }

  /// The azimuthal projection bends lines between degrees. Where this can be seen, the line gets vertices. It goes the
  /// short way across the 180th meridian, and along a meridian to a pole.
  void add_line(PlaneCurve& curve, Vec2 from, Vec2 to, Vec2 placed_to) {
    constexpr int kDeepest = 12;
    if (splits_) {
      if (system_.is_geographic) {
        const double half_turn = system_.half_turn();
        // Equal numbers in both directions, so that a line back has the same vertices.
        if (std::abs(to.x - from.x) > half_turn) (from.x < to.x ? from : to).x += 2.0 * half_turn;
        if (std::abs(from.y) == 0.5 * half_turn) from.x = to.x;
        if (std::abs(to.y) == 0.5 * half_turn) to.x = from.x;
      }
      split_line(curve, from, to, placed_to, kDeepest);
    }
    curve.line_to(placed_to);
  }

  /// `arc` is in coordinates of the system. It stays an arc if its image is that of an affine map, up to the tolerance,
  /// or if vertices are kept.
  void add_arc(PlaneCurve& curve, const EllipticArc& arc, Vec2 placed_to) {
    const auto at = [&](double angle) { return arc.center + std::cos(angle) * arc.u + std::sin(angle) * arc.v; };
    const Vec2 east = placed(arc.center + arc.u);
    const Vec2 west = placed(arc.center - arc.u);
    const Vec2 north = placed(arc.center + arc.v);
    const Vec2 south = placed(arc.center - arc.v);
    EllipticArc image = arc;
    image.center = is_unchanged() ? arc.center : 0.25 * (east + west + north + south);
    image.u = is_unchanged() ? arc.u : 0.5 * (east - west);
    image.v = is_unchanged() ? arc.v : 0.5 * (north - south);
    if (!is_azimuthal()) return curve.arc_to(image, placed_to);
    constexpr int kTried = 16;
    bool is_affine = true;
    for (int i = 0; i <= kTried; ++i) {
      const double angle = arc.start + arc.sweep * i / kTried;
      const Vec2 expected = image.center + std::cos(angle) * image.u + std::sin(angle) * image.v;
      is_affine = is_affine && distance(expected, placed(at(angle))) <= tolerance_;
    }
    if (is_affine || !splits_) return curve.arc_to(image, placed_to);
    // Lines that deviate from the arc by the tolerance.
    constexpr double kMostLines = 4096.0;
    const double step = std::sqrt(8.0 * tolerance_ / std::max(length(image.u), length(image.v)));
    const int lines = static_cast<int>(std::clamp(std::ceil(std::abs(arc.sweep) / step), 1.0, kMostLines));
    for (int i = 1; i < lines; ++i) add_vertex(curve, placed(at(arc.start + arc.sweep * i / lines)));
    curve.line_to(placed_to);
  }

  /// Images of positions on the 180th meridian, and added vertices.
  const MapPlaces& places() const { return places_; }

 private:
  // Part of the diagonal of the map by which a line may deviate.
  static constexpr double kLeastBend = 1e-5;

  void add_vertex(PlaneCurve& curve, Vec2 at) {
    curve.line_to(at);
    places_.added.emplace(at.x, at.y);
  }

  bool is_unchanged() const { return !conversion_ || plane_.projection == MapProjection::none; }
  bool is_azimuthal() const { return conversion_ && plane_.projection == MapProjection::azimuthal; }

  Vec2 placed(Vec2 p) {
    if (is_unchanged()) return p;
    if (!system_.is_geographic) return conversion_->to_plane(p);
    const double half_turn = system_.half_turn();
    const bool may_be_on_cut = std::abs(p.x) == half_turn;
    // Equal positions on the Earth have equal images.
    if (is_azimuthal() && p.x == -half_turn) p.x = half_turn;
    if (is_azimuthal() && std::abs(p.y) == 0.5 * half_turn) p.x = plane_.longitude;
    const Vec2 out = conversion_->to_plane(p);
    if (may_be_on_cut) places_.on_cut.emplace(out.x, out.y);
    return out;
  }

  /// Spares most lines the conversion of their middle. A parallel has the curvature tan(latitude) / radius; a quarter
  /// of the tolerance is allowed here, since this is not exact for other lines.
  bool is_surely_straight(Vec2 from, Vec2 to, double size) const {
    if (!system_.is_geographic) return false;
    constexpr double kRadius = 6.335e6;
    const double latitude = system_.unit_size * std::max(std::abs(from.y), std::abs(to.y));
    return size * size * std::max(1.0, std::tan(latitude)) < 2.0 * tolerance_ * kRadius;
  }

  /// Adds what comes before the end. A line there and back has the same vertices.
  void split_line(PlaneCurve& curve, Vec2 from, Vec2 to, Vec2 placed_to, int deepest) {
    const Vec2 start = curve.end();
    if (is_surely_straight(from, to, distance(start, placed_to))) return;
    const Vec2 middle = 0.5 * (from + to);
    const Vec2 placed_middle = placed(middle);
    const auto [low, high] = std::minmax(start, placed_to, lexicographically_less);
    const Vec2 along = high - low;
    const bool is_bent = std::abs(cross(along, placed_middle - low)) > tolerance_ * length(along);
    if (deepest == 0 || !is_bent) return;
    split_line(curve, from, middle, placed_middle, deepest - 1);
    add_vertex(curve, placed_middle);
    split_line(curve, middle, to, placed_to, deepest - 1);
  }

  MapPlane plane_{};
  CoordinateSystem system_{};
  std::optional<MapConversion> conversion_{};
  double tolerance_ = 0.0;
  bool splits_ = false;
  MapPlaces places_{};
};

void MapShapes::end(Kind kind) {
  const std::size_t begin = this->begin();
  if (begin == positions_.size()) return;
  const bool is_repeated =
      positions_.size() - begin >= kTriangleAndRepetition && positions_[begin] == positions_.back();
  const bool is_circle = !arcs_.empty() && arcs_.back() > begin && positions_[begin] == positions_.back();
  if (kind == Kind::line && (is_repeated || is_circle)) kind = Kind::ring;
  // A projection bends the two sides of a spike differently, so it has to go before. Sides across the 180th meridian
  // are no spikes.
  const auto ring = std::span(positions_).subspan(begin);
  const auto is_far = [](Vec2 a, Vec2 b) { return std::abs(a.x - b.x) > 180.0; };
  const bool is_straight = arcs_.empty() || arcs_.back() <= begin;
  if (kind == Kind::ring && is_straight && std::ranges::adjacent_find(ring, is_far) == ring.end())
    remove_spikes(positions_, begin);
  parts_.push_back({kind, positions_.size()});
}

Expected<void> MapShapes::name_system(std::string_view text) {
  if (!wanted_.empty()) return {};
  auto system = find_coordinate_system(text);
  if (!system) return std::unexpected(system.error());
  if (named_ && *named_ != *system)
    return std::unexpected(Error{
        ErrorCode::bad_input, fmt::format("this is in {}, and what comes before it in {}; a file may have only one "
                                          "coordinate system",
                                          system->title(), named_->title())});
  named_ = *std::move(system);
  return {};
}

Expected<void> MapShapes::name_srid(std::uint64_t number) {
  if (number == 0 || number == srid_ || !wanted_.empty()) return {};
  srid_ = number;
  const std::string of_esri = fmt::format("ESRI:{}", number);
  const std::string of_epsg = fmt::format("EPSG:{}", number);
  constexpr std::uint64_t kLeastOfEsri = 37000;
  const bool is_of_esri = number >= kLeastOfEsri && !find_coordinate_system(of_epsg);
  return name_system(is_of_esri && find_coordinate_system(of_esri) ? of_esri : of_epsg);
}

Expected<std::optional<CoordinateSystem>> MapShapes::system_of_positions(std::string& remark) const {
  std::optional<CoordinateSystem> system = named_ ? named_ : assumed_;
  const bool is_assumed = !named_ && wanted_.empty();
  if (!wanted_.empty()) {
    auto found = find_coordinate_system(wanted_);
    if (!found) return std::unexpected(found.error());
    system = *std::move(found);
  }
  if (!system || !system->is_geographic || positions_.empty()) return system;
  const double half_turn = system->half_turn();
  // Some files count longitudes from 0 to 360 degrees, or go on across 360, or have features of both kinds. Without a
  // system a map of more than half a turn that does so may have coordinates of a plane.
  const auto from_zero = [half_turn](Vec2 p) { return p.x < 0.0 ? p.x + 2.0 * half_turn : p.x; };
  const auto [west, east] = std::ranges::minmax(positions_, {}, from_zero);
  const bool is_narrow = from_zero(east) - from_zero(west) <= half_turn;
  const double longest = is_narrow && from_zero(west) > half_turn ? 3.0 * half_turn
                         : is_narrow || !is_assumed               ? 2.0 * half_turn
                                                                  : half_turn;
  const double shortest = is_assumed ? -half_turn : -longest;
  const auto outside = std::ranges::find_if(
      positions_, [&](Vec2 p) { return p.x < shortest || p.x > longest || std::abs(p.y) > 0.5 * half_turn; });
  if (outside == positions_.end()) return system;
  if (is_assumed) {
    remark = fmt::format("{:.12g}, {:.12g} is not a longitude and latitude, so the coordinates are those of a plane",
                         outside->x, outside->y);
    return std::nullopt;
  }
  return std::unexpected(
      Error{ErrorCode::bad_input, fmt::format("{:.12g}, {:.12g} is not a longitude and latitude, as {} needs",
                                              outside->x, outside->y, system->title())});
}

MapShapes::Turns MapShapes::turns(double half_turn) const {
  Turns out;
  std::size_t number = 0;
  std::size_t begin = 0;
  for (const Part& part : parts_) {
    const std::span<const Vec2> all = std::span(positions_).subspan(begin, part.end - begin);
    begin = part.end;
    if (part.kind == Kind::points) continue;
    ++number;
    const bool is_ring = part.kind == Kind::ring;
    double turned = 0.0;
    bool has_long_side = false;
    bool has_pole = false;
    std::size_t doubtful = 0;
    Vec2 before = is_ring ? all.back() : all.front();
    for (const Vec2 p : all) {
      const double step = p.x - before.x;
      turned += std::remainder(step, 2.0 * half_turn);
      has_long_side = has_long_side || std::abs(step) == 2.0 * half_turn;
      // Sides across the 180th meridian are short in maps; others that are read so may be meant the other way.
      constexpr double kShort = 0.25;
      if (half_turn < std::abs(step) && std::abs(step) < (2.0 - kShort) * half_turn) ++doubtful;
      has_pole = has_pole || std::abs(p.y) == 0.5 * half_turn;
      if (std::abs(step) <= half_turn && (p.x < 0.0) != (before.x < 0.0)) out.sides.cross_zero = true;
      before = p;
    }
    const bool is_around = is_ring && std::abs(turned) > half_turn;
    if (is_around && !has_pole && out.around_pole == 0) out.around_pole = number;
    if (has_long_side && !is_around) out.sides.are_long = true;
    if (!is_around) out.doubtful_sides += doubtful;
  }
  return out;
}

void MapShapes::unroll(double half_turn) {
  const double turn = 2.0 * half_turn;
  std::size_t begin = 0;
  for (const Part& part : parts_) {
    const std::span<Vec2> all = std::span(positions_).subspan(begin, part.end - begin);
    begin = part.end;
    if (part.kind == Kind::points) continue;
    double shift = 0.0;
    const auto follow = [&](double step) {
      if (half_turn < std::abs(step) && std::abs(step) < turn) shift -= std::copysign(turn, step);
    };
    std::vector<double> along{all.front().x};
    for (std::size_t i = 1; i < all.size(); ++i) {
      follow(all[i].x - all[i - 1].x);
      along.push_back(all[i].x + shift);
    }
    if (part.kind == Kind::ring) follow(all.front().x - all.back().x);
    const auto [low, high] = std::ranges::minmax(along);
    if (high - low > half_turn || (part.kind == Kind::ring && shift != 0.0)) continue;
    for (std::size_t i = 0; i < all.size(); ++i) all[i].x = along[i];
  }
}

std::size_t MapShapes::holes_outside() const {
  if (!arcs_.empty() || std::ranges::none_of(parts_, &Part::is_hole)) return 0;
  std::size_t out = 0;
  std::size_t begin = 0;
  std::span<const Vec2> shell;
  std::optional<RingSides> sides;
  for (const Part& part : parts_) {
    const auto ring = std::span(positions_).subspan(begin, part.end - begin);
    begin = part.end;
    if (part.kind == Kind::ring && !part.is_hole) {
      shell = ring;
      sides.reset();
    } else if (part.is_hole) {
      if (!sides) sides.emplace(shell);
      const auto is_at = [&](int place) { return [&, place](Vec2 p) { return sides->place_of(p) == place; }; };
      if (std::ranges::none_of(ring, is_at(1)) && std::ranges::any_of(ring, is_at(-1))) ++out;
    }
  }
  return out;
}

std::size_t MapShapes::polygons_inside() const {
  if (!arcs_.empty() || !rings_of_polygon_) return 0;
  struct Polygon {
    Box2 box;
    std::vector<std::span<const Vec2>> rings;  // the outer one first
    std::vector<RingSides> sides;              // of the rings, once they are asked for
  };
  std::vector<Polygon> polygons;
  std::size_t begin = 0;
  for (const Part& part : parts_) {
    const auto ring = std::span(positions_).subspan(begin, part.end - begin);
    begin = part.end;
    if (part.kind != Kind::ring) continue;
    if (!part.is_hole || polygons.empty()) polygons.push_back({box_of(ring), {}, {}});
    polygons.back().rings.push_back(ring);
  }
  if (polygons.size() < 2) return 0;
  std::vector<std::uint32_t> numbers(polygons.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  BoxTree<std::uint32_t> tree;
  tree.build(
      std::span<const std::uint32_t>(numbers), [&](std::uint32_t i) { return TreeBounds{polygons[i].box}; },
      [](std::uint32_t, std::uint32_t) {});
  const auto is_within = [](std::span<const Vec2> ring, Polygon& other) {
    if (other.sides.empty())
      for (const auto& one : other.rings) other.sides.emplace_back(one);
    bool is_inside = false;
    for (const Vec2 p : ring) {
      const int place = other.sides.front().place_of(p);
      if (place < 0) return false;
      if (place == 0) continue;
      int in_hole = -1;
      for (std::size_t i = 1; i < other.sides.size(); ++i) in_hole = std::max(in_hole, other.sides[i].place_of(p));
      if (in_hole > 0) return false;
      is_inside = is_inside || in_hole < 0;
    }
    return is_inside;
  };
  constexpr int kMostAsked = 16;  // bounds the cost where many boxes lie around one
  std::size_t out = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const Box2& box = polygons[i].box;
    const auto may_hold = [&box](const Box2& other, double) {
      return other.contains(box.low) && other.contains(box.high);
    };
    bool is_inside = false;
    int asked = 0;
    tree.visit_where(may_hold, [&](std::uint32_t j) {
      if (is_inside || j == i || !may_hold(polygons[j].box, 0.0) || ++asked > kMostAsked) return;
      is_inside = is_within(polygons[i].rings.front(), polygons[j]);
    });
    if (is_inside) ++out;
  }
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

Expected<LoadedFile> MapShapes::load(const std::string& name, ReadJob& job) && {
  const auto refused = [&](Error error) {
    error.file = name;
    error.line = error.column = 1;
    return std::unexpected(std::move(error));
  };
  std::string remark;
  const auto system = system_of_positions(remark);
  if (!system) return refused(system.error());
  const auto remark_on_holes = [&, outside = holes_outside(), inside = polygons_inside()](LoadedFile& file) {
    const auto say = [&](std::size_t count, std::string_view one, std::string_view many) {
      if (count != 0) file.warnings.push_back(Error{ErrorCode::bad_input, counted(count, one, many), name}.message());
    };
    say(outside, "hole lies outside its polygon, and encloses a shape",
        "holes lie outside their polygons, and enclose shapes");
    say(inside, "polygon lies inside another one, and cuts a hole into it",
        "polygons lie inside others, and cut holes into them");
  };
  if (!*system || positions_.empty()) {
    if (remark.empty() && look_like_degrees(positions_))
      remark =
          "the positions look like longitude and latitude, and are read as those of a plane, since no coordinate "
          "system is named (EPSG:4326 is that of degrees)";
    MapPlacement in_plane;
    auto file = load_samples(curves(in_plane, job), name, job);
    if (file && !remark.empty())
      file->warnings.insert(file->warnings.begin(), Error{ErrorCode::bad_input, remark, name}.message());
    if (file) remark_on_holes(*file);
    return file;
  }
  const Turns turns = (*system)->is_geographic ? this->turns((*system)->half_turn()) : Turns{};
  auto chosen = choose_plane(positions_, **system, degrees_, turns.sides);
  if (!chosen) return refused(chosen.error());
  if (chosen->plane.projection == MapProjection::equirectangular && turns.around_pole != 0)
    return refused({ErrorCode::bad_input,
                    fmt::format("outline {} goes around a pole, and the map reaches beyond the hemisphere of that "
                                "pole; no plane holds both",
                                turns.around_pole)});
  if (chosen->plane.projection == MapProjection::equirectangular) unroll((*system)->half_turn());
  auto conversion = MapConversion::of(chosen->plane, MapTarget::own_system);
  if (!conversion) return refused(conversion.error());
  MapPlacement placement(chosen->plane, **system, *std::move(conversion));
  CurveSet placed = curves(placement, job);
  auto file = load_samples(std::move(placed), name, job, placement.places());
  if (!file) return file;
  file->data.map = chosen->plane;
  if (chosen->is_choice) file->degrees = degrees_;
  // This is the first warning because the window offers there to change the treatment of degrees.
  file->warnings.insert(file->warnings.begin(), Error{ErrorCode::bad_input, chosen->remark, name}.message());
  remark_on_holes(*file);
  if (turns.doubtful_sides != 0)
    file->warnings.push_back(Error{
        ErrorCode::bad_input,
        fmt::format("{} of more than 180 degrees of longitude {} read as going the other way, across the 180th "
                    "meridian; vertices between would tell",
                    turns.doubtful_sides == 1 ? std::string("a side") : fmt::format("{} sides", turns.doubtful_sides),
                    turns.doubtful_sides == 1 ? "is" : "are"),
        name}
                                 .message());
  return file;
}

CurveSet MapShapes::curves(MapPlacement& placement, ReadJob& job) {
  CurveSet out;
  out.resolution = placement.size_of_unit() * resolution_of(positions_);
  const std::vector<Vec2> placed = placement.place(positions_);
  placement.split_lines(!job.keeps_vertices());
  std::size_t begin = 0;
  auto arc = arcs_.begin();
  for (const Part& part : parts_) {
    job.checkpoint();
    if (part.kind == Kind::points) {
      out.points.insert(out.points.end(), placed.begin() + static_cast<std::ptrdiff_t>(begin),
                        placed.begin() + static_cast<std::ptrdiff_t>(part.end));
      begin = part.end;
      continue;
    }
    PlaneCurve& curve = out.curves.emplace_back(placed[begin]);
    for (std::size_t i = begin + 1; i < part.end; ++i) {
      const bool is_arc = arc != arcs_.end() && *arc == i;
      if (!is_arc) {
        placement.add_line(curve, positions_[i - 1], positions_[i], placed[i]);
        continue;
      }
      ++arc;
      ++i;
      // A circle in file coordinates; the projection may make it an ellipse.
      if (const auto along = arc_through(positions_[i - 2], positions_[i - 1], positions_[i])) {
        placement.add_arc(curve, *along, placed[i]);
        continue;
      }
      if (positions_[i - 1] != positions_[i - 2])
        placement.add_line(curve, positions_[i - 2], positions_[i - 1], placed[i - 1]);
      placement.add_line(curve, positions_[i - 1], positions_[i], placed[i]);
    }
    if (part.kind == Kind::ring) {
      if (positions_[begin] != positions_[part.end - 1])
        placement.add_line(curve, positions_[part.end - 1], positions_[begin], placed[begin]);
      curve.close();
    }
    begin = part.end;
  }
  positions_ = {};
  turn_filled_holes(out.curves);
  return out;
}

}  // namespace mes
