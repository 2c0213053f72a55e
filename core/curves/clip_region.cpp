// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/clip_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/geometry/box_tree.h"
#include "core/curves/curve_bounds.h"
#include "core/curves/internal/flat_curves.h"
#include "core/curves/internal/traced_sides.h"

namespace mes {
namespace {

using ClipperLib::cInt;

/// Bounds in grid steps, both inclusive.
struct GridBox {
  ClipperPoint low;
  ClipperPoint high;
};

/// Whether the boxes of so many pairs of pieces overlap that Clipper would have crossings by the million to compute.
bool overlap_too_often(std::span<const PlaneCurve> curves) {
  constexpr std::size_t kMostOverlaps = 2'000'000;
  constexpr std::size_t kFewPieces = 2000;  // all of them may overlap
  std::size_t count = 0;
  for (const PlaneCurve& curve : curves) count += curve.piece_count();
  if (count <= kFewPieces) return false;
  std::vector<Box2> boxes;
  for (const PlaneCurve& curve : curves)
    curve.for_each_piece([&boxes](const Piece& piece) { boxes.push_back(bounds_of(piece)); });
  BoxTree<std::uint32_t> tree;
  std::vector<std::uint32_t> all(boxes.size());
  std::iota(all.begin(), all.end(), 0U);
  tree.build(
      all, [&](std::uint32_t i) { return TreeBounds{.box = boxes[i]}; }, [](std::uint32_t, std::uint32_t) {});
  const std::size_t most = 2 * kMostOverlaps + 8 * boxes.size();  // each pair twice, and a piece and its neighbours
  std::size_t overlaps = 0;
  for (const Box2& box : boxes) {
    tree.visit_where([&](const Box2& other, double) { return overlaps <= most && overlap(box, other); },
                     [&](std::uint32_t i) { overlaps += overlap(box, boxes[i]) ? 1U : 0U; });
    if (overlaps > most) return true;
  }
  return false;
}

/// The flatness at which so many pieces together have hardly more sides than `kUsualPieces` have at the usual one. The
/// number of sides of a piece grows with one over the root of its flatness.
double flatness_of(std::size_t pieces) {
  constexpr double kUsualPieces = 1000.0;
  constexpr double kCoarsest = 300.0;
  const double more = std::max(1.0, static_cast<double>(pieces) / kUsualPieces);
  return FlatCurves::kFlatness * std::min(more * more, kCoarsest);
}

GridBox grid_box(const GridPaths& paths) {
  GridBox out{paths.front().front(), paths.front().front()};
  for (const GridPath& path : paths)
    for (const ClipperPoint p : path) {
      out.low = {std::min(out.low.X, p.X), std::min(out.low.Y, p.Y)};
      out.high = {std::max(out.high.X, p.X), std::max(out.high.Y, p.Y)};
    }
  return out;
}

double extent_of(const GridBox& box) {
  return static_cast<double>(std::max(box.high.X - box.low.X, box.high.Y - box.low.Y));
}

ClipperLib::PolyFillType fill_of(FillRule rule) {
  return rule == FillRule::nonzero ? ClipperLib::pftNonZero : ClipperLib::pftEvenOdd;
}

GridPaths combined(const GridPaths& subject, FillRule rule, const GridPaths& clip, ClipperLib::ClipType how) {
  ClipperLib::Clipper clipper(ClipperLib::ioPreserveCollinear);
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  GridPaths out;
  clipper.Execute(how, out, fill_of(rule), ClipperLib::pftNonZero);
  return out;
}

/// The part of a path on one side of a level line; the rest is replaced by a section of the line.
template <class Inside, class Crossing>
GridPath cut_off(const GridPath& path, Inside is_inside, Crossing crossing) {
  GridPath out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const ClipperPoint from = path[i];
    const ClipperPoint to = path[(i + 1) % path.size()];
    if (is_inside(from)) out.push_back(from);
    if (is_inside(from) != is_inside(to)) out.push_back(crossing(from, to));
  }
  return out;
}

cInt at_level(cInt level, cInt from, cInt to, cInt other_from, cInt other_to) {
  const double share = static_cast<double>(level - from) / static_cast<double>(to - from);
  return other_from + std::llround(share * static_cast<double>(other_to - other_from));
}

/// Crops outlines to a box with a margin, by Sutherland and Hodgman's algorithm. Linear, and faster than Clipper.
GridPaths cropped(const GridPaths& paths, GridBox box, double room) {
  const cInt margin = 64 + static_cast<cInt>(2.0 * room);
  box = {{box.low.X - margin, box.low.Y - margin}, {box.high.X + margin, box.high.Y + margin}};
  GridPaths out;
  for (const GridPath& path : paths) {
    GridPath rest = path;
    const auto at_x = [](cInt x) {
      return [x](ClipperPoint a, ClipperPoint b) { return ClipperPoint{x, at_level(x, a.X, b.X, a.Y, b.Y)}; };
    };
    const auto at_y = [](cInt y) {
      return [y](ClipperPoint a, ClipperPoint b) { return ClipperPoint{at_level(y, a.Y, b.Y, a.X, b.X), y}; };
    };
    rest = cut_off(
        rest, [&](ClipperPoint p) { return p.X >= box.low.X; }, at_x(box.low.X));
    rest = cut_off(
        rest, [&](ClipperPoint p) { return p.X <= box.high.X; }, at_x(box.high.X));
    rest = cut_off(
        rest, [&](ClipperPoint p) { return p.Y >= box.low.Y; }, at_y(box.low.Y));
    rest = cut_off(
        rest, [&](ClipperPoint p) { return p.Y <= box.high.Y; }, at_y(box.high.Y));
    if (rest.size() >= 3) out.push_back(std::move(rest));
  }
  return out;
}

}  // namespace

/// The sides of the boundary, in a tree of their own, and the curves that they come from.
struct ClipRegion::Body {
  explicit Body(double grid, double flatness = FlatCurves::kFlatness) : curves(grid, flatness) {}

  void finish() {
    curves.build();
    for (const GridPath& path : outline)
      for (std::size_t i = 0; i < path.size(); ++i) sides.emplace_back(path[i], path[(i + 1) % path.size()]);
    std::vector<std::uint32_t> all(sides.size());
    std::iota(all.begin(), all.end(), 0U);
    tree.build(
        all, [this](std::uint32_t side) { return TreeBounds{.box = box_of_side(side)}; },
        [](std::uint32_t, std::uint32_t) {});
  }
  /// The box in steps of the grid, with a margin for rounding to it.
  Box2 on_grid(const Box2& box) const {
    const double grid = curves.grid();
    const Vec2 margin{2.0 * grid, 2.0 * grid};
    return {(1.0 / grid) * (box.low - margin), (1.0 / grid) * (box.high + margin)};
  }
  Box2 box_of_side(std::uint32_t side) const {
    Box2 box;
    box.add(as_vec(sides[side].first));
    box.add(as_vec(sides[side].second));
    return box;
  }
  template <class CostOf>
  std::size_t cost_near(const Box2& box, std::size_t most, CostOf cost_of) const {
    std::size_t out = 0;
    tree.visit_where([&](const Box2& other, double) { return out < most && overlap(box, other); },
                     [&](std::uint32_t side) {
                       if (out < most && overlap(box, box_of_side(side))) out += cost_of(sides[side]);
                     });
    return out;
  }
  /// For a point in the box of no side: then each side at its height lies entirely to its left or to its right.
  bool holds(ClipperPoint p) const {
    const Vec2 at = as_vec(p);
    bool out = false;
    const auto is_beside = [&](const Box2& box, double) {
      return box.low.y <= at.y && at.y <= box.high.y && box.high.x >= at.x;
    };
    tree.visit_where(is_beside, [&](std::uint32_t side) {
      const auto& [a, b] = sides[side];
      if ((a.Y > p.Y) != (b.Y > p.Y) && std::min(a.X, b.X) > p.X) out = !out;
    });
    return out;
  }

  GridPaths outline;  // boundaries, each once; those of holes in reverse direction
  FlatCurves curves;
  std::vector<std::pair<ClipperPoint, ClipperPoint>> sides;
  BoxTree<std::uint32_t> tree;
};

namespace {

using Seen = ClippedCurves::Seen;

/// Clips curves with Clipper, and maps its polygons and lines back to the curves that they are parts of.
class CurveClipper {
 public:
  CurveClipper(std::vector<PlaneCurve> curves, const GridPaths& outline, const FlatCurves& region)
      : curves_(std::move(curves)), outline_(outline), region_(region), subject_(region.grid()) {}

  ClippedCurves area(FillRule rule) {
    GridPaths paths;
    for (const PlaneCurve& curve : curves_) paths.push_back(subject_.add(curve, true));
    const GridBox box = grid_box(paths);
    const GridPaths clip = cropped(outline_, box, 0.0);
    const double width =
        4.0 + std::min(2.0 * subject_.tolerance() + 2.0 * region_.tolerance(), 1e-3 * extent_of(box));
    GridPaths seen = combined(paths, rule, clip, ClipperLib::ctIntersection);
    drop_slivers(seen, width);
    GridPaths hidden = combined(paths, rule, clip, ClipperLib::ctDifference);
    drop_slivers(hidden, width);
    if (seen.empty() && hidden.empty()) return CurveClipper(std::move(curves_), outline_, region_).lines();
    if (hidden.empty()) return whole();
    ClippedCurves out{Seen::nothing, {}};
    if (seen.empty()) return out;
    out.seen = Seen::part;
    subject_.build();
    const SideTracer tracer(subject_, &region_);
    for (const GridPath& path : seen) {
      const TracedPath traced = tracer.closed(path);
      if (const auto same = whole_curve(traced, subject_)) {
        out.curves.push_back(curves_[*same]);
        out.curves.back().close();
      } else if (PlaneCurve curve = curve_of(traced, true); curve.piece_count() > 1 || !curve.is_polyline()) {
        out.curves.push_back(std::move(curve));
      }
    }
    return out;
  }

  ClippedCurves lines() {
    GridPaths paths;
    for (const PlaneCurve& curve : curves_) {
      paths.push_back(subject_.add(curve, false));
      if (paths.back().size() < 2) paths.pop_back();
    }
    if (paths.empty()) return whole();  // a point on the grid
    const GridBox box = grid_box(paths);
    // Curves on the boundary count as visible.
    const double wider = 4.0 + 2.0 * (subject_.tolerance() + region_.tolerance());
    ClipperLib::ClipperOffset offset;
    offset.AddPaths(cropped(outline_, box, wider), ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    GridPaths clip;
    offset.Execute(clip, wider);
    ClipperLib::Clipper clipper(ClipperLib::ioPreserveCollinear);
    clipper.AddPaths(paths, ClipperLib::ptSubject, false);
    clipper.AddPaths(clip, ClipperLib::ptClip, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftEvenOdd, ClipperLib::pftNonZero);
    GridPaths seen;
    ClipperLib::OpenPathsFromPolyTree(tree, seen);
    ClippedCurves out{Seen::nothing, {}};
    if (seen.empty()) return out;
    subject_.build();
    const SideTracer tracer(subject_, &region_);
    std::vector<TracedPath> parts;
    for (const GridPath& path : seen) {
      TracedPath part = tracer.open(path, 3.0 * wider);
      if (!part.runs.empty()) parts.push_back(forwards(std::move(part)));
    }
    return joined(std::move(parts));
  }

 private:
  ClippedCurves whole() { return {Seen::whole, std::move(curves_)}; }

  /// Turns the path to the direction of its curve.
  static TracedPath forwards(TracedPath path) {
    const TracedRun& first = path.runs.front();
    if (first.of == nullptr || !first.is_backwards()) return path;
    TracedPath out{.start = path.runs.back().to};
    for (std::size_t i = path.runs.size(); i-- > 0;) {
      TracedRun run = path.runs[i];
      std::swap(run.begin, run.end);
      run.to = i == 0 ? path.start : path.runs[i - 1].to;
      out.runs.push_back(run);
    }
    return out;
  }

  bool begins_its_curve(const TracedPath& path) const {
    const TracedRun& run = path.runs.front();
    return run.of == &subject_ && run.begin == 0.0 && subject_.is_first(run.piece);
  }
  bool ends_its_curve(const TracedPath& path) const {
    const TracedRun& run = path.runs.back();
    return run.of == &subject_ && run.end == 1.0 && subject_.is_last(run.piece);
  }

  /// Joins the parts in the order of their curves; a line continues across the start of a closed curve.
  ClippedCurves joined(std::vector<TracedPath> parts) {
    ClippedCurves out{Seen::part, {}};
    const auto place = [](const TracedPath& path) {
      const TracedRun& run = path.runs.front();
      return std::pair(run.of == nullptr ? 0U : run.piece, run.begin);
    };
    std::ranges::stable_sort(parts, {}, place);
    std::size_t whole_ones = 0;
    for (std::size_t i = 0; i < parts.size();) {
      const std::uint32_t curve = subject_.curve_of(place(parts[i]).first);
      std::size_t end = i;
      while (end < parts.size() && subject_.curve_of(place(parts[end]).first) == curve) ++end;
      if (end == i + 1 && begins_its_curve(parts[i]) && ends_its_curve(parts[i]) && is_all_whole(parts[i])) {
        out.curves.push_back(curves_[curve]);
        ++whole_ones;
        i = end;
        continue;
      }
      TracedPath& last = parts[end - 1];
      const bool goes_over =
          curves_[curve].is_closed() && end > i + 1 && begins_its_curve(parts[i]) && ends_its_curve(last);
      if (goes_over) last.runs.insert(last.runs.end(), parts[i].runs.begin(), parts[i].runs.end());
      for (std::size_t k = goes_over ? i + 1 : i; k < end; ++k)
        if (PlaneCurve part = curve_of(parts[k], false); part.piece_count() > 0)
          out.curves.push_back(std::move(part));
      i = end;
    }
    if (whole_ones == curves_.size()) return whole();
    if (out.curves.empty()) out.seen = Seen::nothing;
    return out;
  }
  static bool is_all_whole(const TracedPath& path) { return std::ranges::all_of(path.runs, &TracedRun::is_whole); }

  std::vector<PlaneCurve> curves_;
  const GridPaths& outline_;
  const FlatCurves& region_;
  FlatCurves subject_;
};

}  // namespace

double clip_grid(double extent) {
  constexpr int kSteps = 36;
  const double usual = extent > 0x1p-900 && extent < 0x1p900 ? extent : 1.0;
  return std::ldexp(1.0, std::ilogb(usual) - kSteps);
}

bool ClipRegion::fits(std::span<const PlaneCurve> curves, double grid) {
  return std::ranges::all_of(curves, [grid](const PlaneCurve& curve) { return FlatCurves::fits(curve, grid); }) &&
         !overlap_too_often(curves);
}

std::size_t ClipRegion::cost_near(const Box2& box, std::size_t most) const {
  if (is_plane()) return 0;
  return body_->cost_near(body_->on_grid(box), most,
                          [this](const auto& side) { return 1 + body_->curves.looks_at(side.first); });
}

ClipRegion ClipRegion::of(std::span<const PlaneCurve> curves, FillRule rule, double grid, std::size_t companions) {
  std::size_t pieces = 0;
  for (const PlaneCurve& curve : curves) pieces += curve.piece_count();
  auto body = std::make_shared<Body>(grid, flatness_of(pieces * (1 + companions)));
  GridPaths paths;
  for (const PlaneCurve& curve : curves) paths.push_back(body->curves.add(curve, true));
  body->outline = combined(paths, rule, {}, ClipperLib::ctUnion);
  body->finish();
  return ClipRegion(std::move(body));
}

ClipRegion ClipRegion::united(std::span<const ClipRegion> regions, double grid) {
  if (regions.size() == 1) return regions.front();
  auto body = std::make_shared<Body>(grid);
  GridPaths paths;
  for (const ClipRegion& region : regions) {
    if (region.is_plane()) return region;
    paths.insert(paths.end(), region.body_->outline.begin(), region.body_->outline.end());
    body->curves.add(region.body_->curves);
  }
  body->outline = combined(paths, FillRule::nonzero, {}, ClipperLib::ctUnion);
  body->finish();
  return ClipRegion(std::move(body));
}

ClipRegion ClipRegion::common(const ClipRegion& a, const ClipRegion& b) {
  if (a.is_plane() || a.body_ == b.body_) return b;
  if (b.is_plane()) return a;
  auto body = std::make_shared<Body>(a.body_->curves.grid());
  body->curves.add(a.body_->curves);
  body->curves.add(b.body_->curves);
  body->outline = combined(a.body_->outline, FillRule::nonzero, b.body_->outline, ClipperLib::ctIntersection);
  body->finish();
  return ClipRegion(std::move(body));
}

ClippedCurves ClipRegion::clipped(std::vector<PlaneCurve> curves, Ink ink) const {
  if (is_plane() || curves.empty()) return {Seen::whole, std::move(curves)};
  const FlatCurves& region = body_->curves;
  // Boxes show for most curves that nothing cuts them.
  if (body_->cost_near(body_->on_grid(bounds_of(curves)), 1, [](const auto&) { return std::size_t{1}; }) == 0) {
    const Vec2 start = (1.0 / region.grid()) * curves.front().start();
    const bool is_inside = body_->holds({std::llround(start.x), std::llround(start.y)});
    if (is_inside) return {Seen::whole, std::move(curves)};
    return {Seen::nothing, {}};
  }
  CurveClipper clipper(std::move(curves), body_->outline, region);
  if (ink == Ink::line) return clipper.lines();
  return clipper.area(ink == Ink::nonzero_area ? FillRule::nonzero : FillRule::even_odd);
}

}  // namespace mes
