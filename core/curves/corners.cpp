// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/curves/internal/stretches.h"

namespace mes {
namespace {

constexpr double kPi = std::numbers::pi;

Vec2 unit(Vec2 v) {
  const double size = length(v);
  return size > 0.0 ? 1.0 / size * v : Vec2{};
}

/// The angle between the end of one stretch and the beginning of the next; positive to the left.
double turn_between(Vec2 last, Vec2 first) {
  const Vec2 a = unit(last);
  const Vec2 b = unit(first);
  return std::atan2(cross(a, b), dot(a, b));
}

struct Cut {
  std::size_t piece = 0;  // index in the curve
  double parameter = 0.0;
};

/// The point at length `passed` from the beginning of the stretch.
Cut cut_at(const MeasuredCurve& curve, const Stretch& stretch, double passed) {
  const std::size_t last = stretch.first + stretch.count - 1;
  std::size_t piece = stretch.first;
  while (piece < last && passed >= curve.lengths[piece].total()) passed -= curve.lengths[piece++].total();
  return {piece, curve.lengths[piece].parameter_at(passed)};
}

/// The stretch, cut back at both ends; empty if only rounding is left.
std::vector<Piece> shortened(const MeasuredCurve& curve, const Stretch& stretch, double begin, double end) {
  constexpr double kRounding = 1e-9;
  if (begin > 0.0 && end > 0.0 && begin + end >= stretch.length * (1.0 - kRounding)) return {};
  const Cut from = begin > 0.0 ? cut_at(curve, stretch, begin) : Cut{stretch.first, 0.0};
  const Cut to =
      end > 0.0 ? cut_at(curve, stretch, stretch.length - end) : Cut{stretch.first + stretch.count - 1, 1.0};
  std::vector<Piece> out;
  for (std::size_t i = from.piece; i <= to.piece; ++i) {
    const double low = i == from.piece ? from.parameter : 0.0;
    const double high = i == to.piece ? to.parameter : 1.0;
    if (low < high) out.push_back(low == 0.0 && high == 1.0 ? curve.pieces[i] : curve.pieces[i].part(low, high));
  }
  return out;
}

/// An arc tangent to both lines, which would meet at the corner. `away` is the distance from the corner to both ends.
Piece rounding_arc(Vec2 from, Vec2 to, Vec2 first, double turn, double away) {
  const double radius = away / std::tan(0.5 * std::abs(turn));
  const Vec2 left{-first.y, first.x};
  const Vec2 out = (turn > 0.0 ? -radius : radius) * left;  // vector from the centre to the start of the arc
  return {.kind = PieceKind::arc,
          .points = {from, to},
          .arc = {.center = from - out, .u = out, .v = radius * first, .start = 0.0, .sweep = std::abs(turn)}};
}

/// A cubic between sides with end directions `first` and `last`; it approximates the arc that would round two lines.
Piece rounding_cubic(Vec2 from, Vec2 to, Vec2 first, Vec2 last, double away) {
  const double turn = std::abs(turn_between(first, last));
  // Handle length for an arc that turns by that angle and whose tangents are `away` long.
  const double handle =
      turn > 0.0 ? 4.0 / 3.0 * std::tan(0.25 * turn) / std::tan(0.5 * turn) * away : 2.0 / 3.0 * away;
  const double bounded = std::min(handle, away);
  return {.kind = PieceKind::cubic, .points = {from, from + bounded * first, to - bounded * last, to}};
}

PlaneCurve rounded(const PlaneCurve& curve, double corner_angle, double radius) {
  const MeasuredCurve all = measured(curve, corner_angle, 0.0);
  const std::size_t count = all.stretches.size();
  if (count == 0 || !all.has_corner_at_start || (!all.is_closed && count < 2)) return curve;
  const auto last_piece = [&](std::size_t i) -> const Piece& {
    return all.pieces[all.stretches[i].first + all.stretches[i].count - 1];
  };
  // The cut at the corner where each stretch begins; the first stretch of an open curve has no corner.
  std::vector<double> away(count, 0.0);
  for (std::size_t i = all.is_closed ? 0 : 1; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    const double turn = std::abs(
        turn_between(last_piece(before).last_direction(), all.pieces[all.stretches[i].first].first_direction()));
    constexpr double kMostTurn = 0.999 * kPi;  // near pi the tangent length is unbounded
    const double wanted = radius * std::tan(0.5 * std::min(turn, kMostTurn));
    away[i] = std::min({wanted, 0.5 * all.stretches[before].length, 0.5 * all.stretches[i].length});
  }

  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const bool has_corner_after = all.is_closed || i + 1 < count;
    const double end = has_corner_after ? away[next] : 0.0;
    for (const Piece& piece : shortened(all, all.stretches[i], away[i], end)) pieces.push_back(piece);
    if (!has_corner_after || end == 0.0) continue;
    // Cut each side only at this corner: nothing may be left between its two cuts.
    const std::vector<Piece> before = shortened(all, all.stretches[i], 0.0, end);
    const std::vector<Piece> after = shortened(all, all.stretches[next], away[next], 0.0);
    if (before.empty() || after.empty()) continue;
    const Vec2 from = before.back().to();
    const Vec2 to = after.front().from();
    if (from == to) continue;
    const Piece& side = last_piece(i);
    const Piece& other = all.pieces[all.stretches[next].first];
    const bool are_lines = side.kind == PieceKind::line && other.kind == PieceKind::line &&
                           end <= distance(side.from(), side.to()) && end <= distance(other.from(), other.to());
    const Vec2 first = unit(before.back().last_direction());
    const Vec2 last = unit(after.front().first_direction());
    pieces.push_back(are_lines ? rounding_arc(from, to, first, turn_between(first, last), end)
                               : rounding_cubic(from, to, first, last, end));
  }
  if (pieces.empty()) return curve;
  PlaneCurve out(pieces.front().from());
  out.name = curve.name;
  for (const Piece& piece : pieces) {
    // The next piece starts where the last one ended, despite rounding in between.
    if (out.end() != piece.from() && piece.kind != PieceKind::arc && piece.kind != PieceKind::cubic)
      out.line_to(piece.from());
    out.add(piece);
  }
  if (all.is_closed) out.close();
  return out;
}

}  // namespace

std::vector<CurveCorner> corners_of(const CurveSet& curves, double corner_angle) {
  std::vector<CurveCorner> out;
  for (std::size_t c = 0; c < curves.curves.size(); ++c) {
    const MeasuredCurve all = measured(curves.curves[c], corner_angle, 0.0);
    if (!all.has_corner_at_start) continue;
    const std::size_t count = all.stretches.size();
    for (std::size_t i = all.is_closed ? 0 : 1; i < count; ++i) {
      const Stretch& before = all.stretches[(i + count - 1) % count];
      const Piece& first = all.pieces[all.stretches[i].first];
      const double turn = std::abs(
          turn_between(all.pieces[before.first + before.count - 1].last_direction(), first.first_direction()));
      out.push_back({first.from(), kPi - turn, c});
    }
  }
  return out;
}

CurveSet with_round_corners(const CurveSet& curves, double corner_angle, double radius) {
  CurveSet out{.points = curves.points};
  out.curves.reserve(curves.curves.size());
  for (const PlaneCurve& curve : curves.curves) out.curves.push_back(rounded(curve, corner_angle, radius));
  return out;
}

}  // namespace mes
