// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/filled_area.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/box_tree.h"
#include "core/curves/clip_region.h"
#include "core/curves/curve_bounds.h"
#include "core/curves/internal/flat_curves.h"
#include "core/curves/internal/traced_sides.h"

namespace mes {
namespace {

/// Whether lines from a to b and from c to d may have a common point; false only where they surely have none.
bool may_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side_of = [](Vec2 from, Vec2 to, Vec2 p) {
    const Vec2 along = to - from;
    const Vec2 off = p - from;
    const double left = along.x * off.y;
    const double right = along.y * off.x;
    const double error = 0x1p-48 * (std::abs(left) + std::abs(right));
    return left - right > error ? 1 : (left - right < -error ? -1 : 0);
  };
  return side_of(a, b, c) * side_of(a, b, d) <= 0 && side_of(c, d, a) * side_of(c, d, b) <= 0;
}

/// Pieces in boxes that only touch do not cross.
bool overlap_inside(const Box2& a, const Box2& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

double angle_of_turn(Vec2 a, Vec2 b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

/// The angle in radians by which the control polygon of a piece turns; its tangent turns by no more. Infinite for arcs.
double turning_of(const Piece& piece) {
  if (piece.kind == PieceKind::arc) return std::numeric_limits<double>::infinity();
  const std::size_t last = piece.kind == PieceKind::line ? 1 : (piece.kind == PieceKind::quadratic ? 2 : 3);
  double out = 0.0;
  Vec2 before{};
  for (std::size_t i = 0; i < last; ++i) {
    const Vec2 leg = piece.points[i + 1] - piece.points[i];
    if (leg == Vec2{}) continue;
    if (before != Vec2{}) out += angle_of_turn(before, leg);
    before = leg;
  }
  return out;
}

/// Whether the pieces are arcs of one ellipse that go around it once, up to rounding.
bool is_ellipse(const PlaneCurve& curve) {
  constexpr double kRounding = 1e-9;
  const std::vector<EllipticArc>& arcs = curve.arcs();
  if (arcs.empty() || arcs.size() != curve.piece_count()) return false;
  const double most = kRounding * (length(arcs[0].u) + length(arcs[0].v));
  const auto are_near = [most](Vec2 a, Vec2 b) { return std::abs(a.x - b.x) <= most && std::abs(a.y - b.y) <= most; };
  double sweep = 0.0;
  for (const EllipticArc& arc : arcs) {
    const bool is_of_first =
        are_near(arc.center, arcs[0].center) && are_near(arc.u, arcs[0].u) && are_near(arc.v, arcs[0].v);
    if (!is_of_first || arc.sweep * arcs[0].sweep <= 0.0) return false;
    sweep += std::abs(arc.sweep);
  }
  return sweep <= 2.0 * std::numbers::pi * (1.0 + kRounding);
}

/// True only if the curve does not cross itself. Two successive pieces that turn by less than half a circle together do
/// not cross, and neither do pieces whose boxes do not overlap. False also for curves of more than 64 pieces.
bool is_surely_simple(const PlaneCurve& curve) {
  if (is_ellipse(curve)) return true;
  constexpr std::size_t kFew = 64;
  constexpr double kHalfTurn = 3.14;
  const std::size_t n = curve.piece_count();
  if (n < 3 || n > kFew) return false;
  std::vector<Piece> pieces;
  std::vector<Box2> boxes;
  std::vector<double> turning;
  curve.for_each_piece([&](const Piece& piece) {
    pieces.push_back(piece);
    boxes.push_back(bounds_of(piece));
    turning.push_back(turning_of(piece));
  });
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const double bend = angle_of_turn(pieces[i].last_direction(), pieces[next].first_direction());
    if (!(turning[i] + bend + turning[next] < kHalfTurn)) return false;
    for (std::size_t k = i + 2; k < n; ++k) {
      if ((k + 1) % n == i || !overlap_inside(boxes[i], boxes[k])) continue;
      const bool are_lines = pieces[i].kind == PieceKind::line && pieces[k].kind == PieceKind::line;
      if (!are_lines || may_meet(pieces[i].from(), pieces[i].to(), pieces[k].from(), pieces[k].to())) return false;
    }
  }
  return true;
}

/// Whether the boxes of two of the curves touch.
bool touch_each_other(const std::vector<const PlaneCurve*>& curves) {
  std::vector<Box2> boxes;
  for (const PlaneCurve* const curve : curves) boxes.push_back(bounds_of(std::span(curve, 1)));
  BoxTree<std::uint32_t> tree;
  std::vector<std::uint32_t> all(boxes.size());
  std::iota(all.begin(), all.end(), 0U);
  tree.build(
      all, [&](std::uint32_t i) { return TreeBounds{.box = boxes[i]}; }, [](std::uint32_t, std::uint32_t) {});
  bool out = false;
  for (std::uint32_t i = 0; i < boxes.size() && !out; ++i)
    tree.visit_where([&](const Box2& other, double) { return !out && overlap(boxes[i], other); },
                     [&](std::uint32_t k) { out = out || (k != i && overlap(boxes[i], boxes[k])); });
  return out;
}

/// The sides of polygons in a tree.
class Sides {
 public:
  explicit Sides(const GridPaths& paths) {
    for (std::uint32_t path = 0; path < paths.size(); ++path) {
      const auto first = static_cast<std::uint32_t>(sides_.size());
      const auto count = static_cast<std::uint32_t>(paths[path].size());
      for (std::uint32_t i = 0; i < count; ++i)
        sides_.push_back(
            {as_vec(paths[path][i]), as_vec(paths[path][(i + 1) % count]), path, first + (i + 1) % count});
    }
    std::vector<std::uint32_t> all(sides_.size());
    std::iota(all.begin(), all.end(), 0U);
    tree_.build(
        all, [this](std::uint32_t side) { return TreeBounds{.box = box_of(side)}; },
        [](std::uint32_t, std::uint32_t) {});
  }

  /// Counts pairs of sides that may meet, up to `most`. Successive sides count only if one goes back along the other.
  std::size_t meetings(std::size_t most) const {
    std::size_t out = 0;
    for (std::uint32_t i = 0; i < sides_.size() && out < most; ++i) {
      const Side& side = sides_[i];
      const Side& after = sides_[side.next];
      const Vec2 along = side.to - side.from;
      const Vec2 on = after.to - after.from;
      if (dot(along, on) < 0.0 && may_meet(side.from, side.to, after.to, after.to)) ++out;
      const Box2 box = box_of(i);
      tree_.visit_where([&](const Box2& other, double) { return out < most && overlap(box, other); },
                        [&](std::uint32_t k) {
                          const Side& other = sides_[k];
                          if (k <= i || other.next == i || side.next == k) return;
                          if (overlap(box, box_of(k)) && may_meet(side.from, side.to, other.from, other.to)) ++out;
                        });
    }
    return out;
  }

  /// How often the other polygons go around a corner of this one, counter-clockwise.
  int winding_around(std::uint32_t path, Vec2 corner) const {
    int out = 0;
    tree_.visit_where(
        [&](const Box2& box, double) {
          return box.low.y <= corner.y && corner.y <= box.high.y && box.high.x >= corner.x;
        },
        [&](std::uint32_t i) {
          const Side& side = sides_[i];
          if (side.path == path || (side.from.y > corner.y) == (side.to.y > corner.y)) return;
          const double share = (corner.y - side.from.y) / (side.to.y - side.from.y);
          if (side.from.x + share * (side.to.x - side.from.x) < corner.x) return;
          out += side.to.y > side.from.y ? 1 : -1;
        });
    return out;
  }

 private:
  struct Side {
    Vec2 from{};
    Vec2 to{};
    std::uint32_t path = 0;
    std::uint32_t next = 0;
  };
  Box2 box_of(std::uint32_t side) const {
    Box2 out;
    out.add(sides_[side].from);
    out.add(sides_[side].to);
    return out;
  }

  std::vector<Side> sides_;
  BoxTree<std::uint32_t> tree_;
};

/// Estimates how many sides Clipper looks at: at the height of each corner all sides there, and once more for each local
/// minimum of a path at that height.
double sweep_cost(const GridPaths& paths) {
  std::vector<ClipperLib::cInt> heights;
  for (const GridPath& path : paths)
    for (const ClipperPoint p : path) heights.push_back(p.Y);
  std::ranges::sort(heights);
  const auto [rest, end] = std::ranges::unique(heights);
  heights.erase(rest, end);
  const auto rank = [&](ClipperPoint p) {
    return static_cast<std::size_t>(std::ranges::lower_bound(heights, p.Y) - heights.begin());
  };
  std::vector<double> sides(heights.size() + 1, 0.0);  // how many more than at the height below
  std::vector<double> looks(heights.size() + 1, 1.0);
  for (const GridPath& path : paths)
    for (std::size_t i = 0; i < path.size(); ++i) {
      const ClipperPoint here = path[i];
      const ClipperPoint next = path[(i + 1) % path.size()];
      const auto [low, high] = std::minmax({rank(here), rank(next)});
      sides[low] += 1.0;
      sides[high] -= 1.0;
      const ClipperPoint before = path[(i + path.size() - 1) % path.size()];
      if (before.Y >= here.Y && next.Y >= here.Y) looks[rank(here)] += 1.0;
    }
  double out = 0.0;
  double now = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    now += sides[i];
    out += now * looks[i];
  }
  return out;
}

/// What Clipper may cost: about a second for one shape, and a tenth of a millisecond for each piece, so that the time for
/// many shapes grows no faster than their file.
double most_cost(const std::vector<const PlaneCurve*>& curves) {
  constexpr double kOfSecond = 3e7;
  constexpr double kOfPiece = 3e3;
  constexpr double kPiecesGiven = 10.0;
  double pieces = kPiecesGiven;
  for (const PlaneCurve* const curve : curves) pieces += static_cast<double>(curve->piece_count());
  return std::min(kOfSecond, kOfPiece * pieces);
}

GridPaths united(const GridPaths& paths, ClipperLib::PolyFillType rule) {
  ClipperLib::Clipper clipper(ClipperLib::ioPreserveCollinear);
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  GridPaths out;
  clipper.Execute(ClipperLib::ctUnion, out, rule, rule);
  return out;
}

/// Whether an area is larger than a part of it by more than slivers of this width.
bool exceeds(const GridPaths& area, const GridPaths& part, double width) {
  if (area == part) return false;
  ClipperLib::Clipper clipper;
  clipper.AddPaths(area, ClipperLib::ptSubject, true);
  clipper.AddPaths(part, ClipperLib::ptClip, true);
  GridPaths rest;
  clipper.Execute(ClipperLib::ctDifference, rest, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  drop_slivers(rest, width);
  return !rest.empty();
}

}  // namespace

FilledArea nonzero_area(std::vector<PlaneCurve> curves) {
  FilledArea out;
  std::vector<const PlaneCurve*> closed;
  for (const PlaneCurve& curve : curves)
    if (curve.is_closed()) closed.push_back(&curve);
  const auto as_given = [&](bool is_unknown) {
    out.is_unknown = is_unknown;
    out.curves = std::move(curves);
    return std::move(out);
  };
  const auto changed = [&] {
    for (PlaneCurve& curve : curves)
      if (!curve.is_closed()) out.curves.push_back(std::move(curve));
    out.is_changed = true;
    return std::move(out);
  };
  const auto is_simple = [](const PlaneCurve* curve) { return is_surely_simple(*curve); };
  if (closed.empty() || (std::ranges::all_of(closed, is_simple) && !touch_each_other(closed))) return as_given(false);
  const Box2 box = bounds_of(curves);
  const double grid =
      clip_grid(std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)}));
  if (!ClipRegion::fits(curves, grid)) return as_given(true);
  FlatCurves subject(grid);
  GridPaths paths;
  for (const PlaneCurve* const curve : closed) {
    paths.push_back(subject.add(*curve, true));
    if (paths.back().size() < 3) return as_given(false);
  }
  constexpr std::size_t kMostMeetings = 2000;
  const Sides sides(paths);
  const std::size_t meetings = sides.meetings(kMostMeetings + 1);
  if (meetings == 0) {
    for (std::uint32_t i = 0; i < closed.size(); ++i) {
      const int outside = sides.winding_around(i, as_vec(paths[i].front()));
      const int inside = outside + (ClipperLib::Orientation(paths[i]) ? 1 : -1);
      if ((outside == 0) != (inside == 0)) out.curves.push_back(*closed[i]);
    }
    if (out.curves.size() == closed.size()) {
      out.curves.clear();
      return as_given(false);
    }
    return changed();
  }
  if (meetings > kMostMeetings || sweep_cost(paths) > most_cost(closed)) return as_given(true);
  const GridPaths area = united(paths, ClipperLib::pftNonZero);
  const double width = 4.0 + 2.0 * subject.tolerance();
  if (!exceeds(area, united(paths, ClipperLib::pftEvenOdd), width)) return as_given(false);
  subject.build();
  const SideTracer tracer(subject, nullptr);
  for (const GridPath& path : area) {
    if (path.size() < 3) continue;
    const TracedPath traced = tracer.closed(path);
    if (const auto same = whole_curve(traced, subject)) {
      out.curves.push_back(*closed[*same]);
    } else if (PlaneCurve curve = curve_of(traced, true); curve.piece_count() > 1 || !curve.is_polyline()) {
      out.curves.push_back(std::move(curve));
    }
  }
  return changed();
}

}  // namespace mes
