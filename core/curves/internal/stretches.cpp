// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/stretches.h"

#include <algorithm>
#include <cmath>

#include "core/base/geometry/coordinate_range.h"

namespace mes {
namespace {

constexpr double kCornerRounding = 1e-9;
// A shorter piece is a point in every document (core/base/geometry/coordinate_range.h); its parts may not be representable.
constexpr double kLeastLength = 0x1p-500;
static_assert(kLeastExponent == -500);

double angle_between(Vec2 a, Vec2 b) {
  const Vec2 p = 1.0 / length(a) * a;
  const Vec2 q = 1.0 / length(b) * b;
  return std::abs(std::atan2(cross(p, q), dot(p, q)));
}

/// Whether each piece begins at a corner. The first piece of an open curve does.
std::vector<bool> corners_of(const MeasuredCurve& curve, double corner_angle, double negligible) {
  const std::size_t count = curve.pieces.size();
  std::vector<bool> out(count, false);
  double longest = 0.0;
  for (const PieceLength& length : curve.lengths) longest = std::max(longest, length.total());
  // The limit never removes all pieces of a curve.
  const double least = std::max(kCornerRounding * longest, std::min(negligible, 0.5 * longest));
  const auto counts = [&](std::size_t i) { return curve.lengths[i].total() > least; };
  std::size_t last = count;
  if (curve.is_closed)
    for (std::size_t i = count; i-- > 0 && last == count;)
      if (counts(i)) last = i;
  for (std::size_t i = 0; i < count; ++i) {
    if (!counts(i)) continue;
    if (last != count)
      out[i] = corner_angle < 0.0 ||
               angle_between(curve.pieces[last].last_direction(), curve.pieces[i].first_direction()) > corner_angle;
    last = i;
  }
  if (!curve.is_closed) out[0] = true;
  return out;
}

}  // namespace

double negligible_length(const CurveSet& curves, const SamplingRequest& request) {
  double spacing = request.spacing;
  if (request.rule != SamplingRule::spacing) {
    spacing = 0.0;
    for (const PlaneCurve& curve : curves.curves)
      curve.for_each_piece([&](const Piece& piece) { spacing += distance(piece.from(), piece.to()); });
    spacing /= static_cast<double>(std::max<std::size_t>(request.count, 1));
  }
  constexpr double kShare = 0.01;
  return kShare * spacing;
}

double MeasuredCurve::length() const {
  double sum = 0.0;
  for (const PieceLength& piece : lengths) sum += piece.total();
  return sum;
}

MeasuredCurve measured(const PlaneCurve& curve, double corner_angle, double negligible, JobControl* job,
                       bool starts_at_corner) {
  constexpr std::size_t kOften = 1024;
  std::size_t count = 0;
  MeasuredCurve out;
  out.is_closed = curve.is_closed();
  out.pieces.reserve(curve.piece_count());
  out.lengths.reserve(curve.piece_count());
  curve.for_each_piece([&](const Piece& piece) {
    if (job != nullptr && count++ % kOften == 0) job->checkpoint();
    out.lengths.emplace_back(piece);
    if (out.lengths.back().total() < kLeastLength) return out.lengths.pop_back();
    out.pieces.push_back(piece);
  });
  if (out.pieces.empty()) return out;

  std::vector<bool> begins = corners_of(out, corner_angle, negligible);
  if (starts_at_corner) begins[0] = true;
  const auto first = std::ranges::find(begins, true);
  out.has_corner_at_start = first != begins.end();
  const auto turn = out.has_corner_at_start && !starts_at_corner ? first - begins.begin() : 0;
  std::rotate(begins.begin(), begins.begin() + turn, begins.end());
  std::ranges::rotate(out.pieces, out.pieces.begin() + turn);
  std::ranges::rotate(out.lengths, out.lengths.begin() + turn);
  for (std::size_t i = 0; i < out.pieces.size(); ++i) {
    if (i == 0 || begins[i]) out.stretches.push_back({.first = i});
    ++out.stretches.back().count;
    out.stretches.back().length += out.lengths[i].total();
  }
  return out;
}

}  // namespace mes
