// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/flat_curves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mes {
namespace {

Box2 control_box(const PlaneCurve& curve) {
  Box2 box;
  for (const Vec2 p : curve.points()) box.add(p);
  for (const EllipticArc& arc : curve.arcs()) {
    const Vec2 reach{std::abs(arc.u.x) + std::abs(arc.v.x), std::abs(arc.u.y) + std::abs(arc.v.y)};
    box.add(arc.center - reach);
    box.add(arc.center + reach);
  }
  return box;
}

/// The number of equal steps for an error of at most |second derivative| / (8 n^2) with n steps.
int steps_of(const Piece& piece, double tolerance) {
  const auto& p = piece.points;
  const auto bend = [](Vec2 a, Vec2 b, Vec2 c) { return length(a - 2.0 * b + c); };
  constexpr double kLeast = 4.0;
  constexpr double kMost = 4096.0;
  double second = 0.0;
  switch (piece.kind) {
    case PieceKind::line: return 1;
    case PieceKind::quadratic: second = 2.0 * bend(p[0], p[1], p[2]); break;
    case PieceKind::cubic: second = 6.0 * std::max(bend(p[0], p[1], p[2]), bend(p[1], p[2], p[3])); break;
    case PieceKind::arc:
      second = piece.arc.sweep * piece.arc.sweep * (length(piece.arc.u) + length(piece.arc.v));
      break;
  }
  const double steps = std::ceil(std::sqrt(second / (8.0 * tolerance)));
  return static_cast<int>(steps >= kLeast ? std::min(steps, kMost) : kLeast);
}

Box2 side_box(const FlatSide& side) {
  Box2 box;
  box.add(as_vec(side.from));
  box.add(as_vec(side.to));
  return box;
}

}  // namespace

bool FlatCurves::fits(const PlaneCurve& curve, double grid) {
  const Box2 box = control_box(curve);
  const double most = 0x1p55 * grid;
  return std::abs(box.low.x) < most && std::abs(box.low.y) < most && std::abs(box.high.x) < most &&
         std::abs(box.high.y) < most;
}

GridPath FlatCurves::add(const PlaneCurve& curve, bool closes) {
  const Box2 box = control_box(curve);
  const double tolerance = std::max(flatness_ * std::max(box.width(), box.height()), grid_);
  if (!curve.is_polyline()) tolerance_ = std::max(tolerance_, tolerance / grid_);
  const auto rounded = [&](Vec2 p) { return ClipperPoint{std::llround(p.x / grid_), std::llround(p.y / grid_)}; };
  GridPath out{rounded(curve.start())};
  const auto add_piece = [&](const Piece& piece) {
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back(piece);
    curves_.push_back(curve_count_);
    const int steps = steps_of(piece, tolerance);
    double begin = 0.0;
    for (int i = 1; i <= steps; ++i) {
      const double end = static_cast<double>(i) / steps;
      const ClipperPoint to = rounded(piece.at(end));
      if (to == out.back()) continue;
      sides_.push_back({out.back(), to, number, begin, end});
      out.push_back(to);
      begin = end;
    }
    // Steps shorter than the grid belong to the side before them.
    if (!sides_.empty() && sides_.back().piece == number) sides_.back().end = 1.0;
  };
  curve.for_each_piece(add_piece);
  if (closes && curve.end() != curve.start())
    add_piece({.kind = PieceKind::line, .points = {curve.end(), curve.start()}});
  if (closes && out.size() > 1 && out.back() == out.front()) out.pop_back();
  ++curve_count_;
  return out;
}

void FlatCurves::add(const FlatCurves& other) {
  const auto first = static_cast<std::uint32_t>(pieces_.size());
  pieces_.insert(pieces_.end(), other.pieces_.begin(), other.pieces_.end());
  for (const std::uint32_t curve : other.curves_) curves_.push_back(curve_count_ + curve);
  for (FlatSide side : other.sides_) {
    side.piece += first;
    sides_.push_back(side);
  }
  curve_count_ += other.curve_count_;
  tolerance_ = std::max(tolerance_, other.tolerance_);
}

void FlatCurves::build() {
  std::vector<std::uint32_t> all(sides_.size());
  std::iota(all.begin(), all.end(), 0U);
  tree_.build(
      all, [this](std::uint32_t side) { return TreeBounds{.box = side_box(sides_[side])}; },
      [](std::uint32_t, std::uint32_t) {});
}

std::size_t FlatCurves::looks_at(ClipperPoint corner) const {
  std::size_t out = 0;
  tree_.visit_where([p = as_vec(corner)](const Box2& box, double) { return box.contains(p); },
                    [&out](std::uint32_t) { ++out; });
  return out;
}

std::vector<SideAt> FlatCurves::sides_at(ClipperPoint corner, double reach) const {
  std::vector<SideAt> out;
  const Vec2 p = as_vec(corner);
  const auto may_hold = [&](const Box2& box, double) {
    return box.low.x - reach <= p.x && p.x <= box.high.x + reach && box.low.y - reach <= p.y &&
           p.y <= box.high.y + reach;
  };
  tree_.visit_where(may_hold, [&](std::uint32_t number) {
    const FlatSide& side = sides_[number];
    if (!may_hold(side_box(side), 0.0)) return;
    const Vec2 along{static_cast<double>(side.to.X - side.from.X), static_cast<double>(side.to.Y - side.from.Y)};
    const Vec2 here{static_cast<double>(corner.X - side.from.X), static_cast<double>(corner.Y - side.from.Y)};
    const double share = std::clamp(dot(here, along) / dot(along, along), 0.0, 1.0);
    const double apart = length(here - share * along);
    if (apart > reach) return;
    const double parameter = corner == side.to     ? side.end
                             : corner == side.from ? side.begin
                                                   : side.begin + share * (side.end - side.begin);
    out.push_back({number, apart, parameter});
  });
  return out;
}

void drop_slivers(GridPaths& paths, double width) {
  std::erase_if(paths, [width](const GridPath& path) {
    double around = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i)
      around += length(as_vec(path[(i + 1) % path.size()]) - as_vec(path[i]));
    return path.size() < 3 || std::abs(ClipperLib::Area(path)) <= 0.5 * width * around;
  });
}

}  // namespace mes
