// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/glyphs/internal/united_contours.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <map>
#include <utility>

namespace mes {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double kStepsAUnit = 1024.0;

IntPoint rounded(Vec2 p) {
  return {std::llround(kStepsAUnit * p.x), std::llround(kStepsAUnit * p.y)};
}

/// Straight pieces that are as near to a piece as asked. The error of n equal steps of a curve is at most
/// |second derivative| / (8 n^2).
int steps_of(const Piece& piece, double tolerance) {
  const auto& p = piece.points;
  const auto bend = [](Vec2 a, Vec2 b, Vec2 c) { return length(a - 2.0 * b + c); };
  constexpr double kMost = 256.0;
  // Few enough are a polygon whose corners are seen: the tangent should turn little from step to step.
  constexpr double kLeast = 8.0;
  double second = 0.0;
  switch (piece.kind) {
    case PieceKind::line: return 1;
    case PieceKind::quadratic: second = 2.0 * bend(p[0], p[1], p[2]); break;
    case PieceKind::cubic: second = 6.0 * std::max(bend(p[0], p[1], p[2]), bend(p[1], p[2], p[3])); break;
    case PieceKind::arc: return static_cast<int>(kMost);
  }
  return static_cast<int>(std::clamp(std::ceil(std::sqrt(second / (8.0 * tolerance))), kLeast, kMost));
}

/// Corners without repetitions.
Path path_of(const PlaneCurve& contour, double tolerance) {
  Path out;
  const auto add = [&out](IntPoint p) {
    if (out.empty() || out.back() != p) out.push_back(p);
  };
  contour.for_each_piece([&](const Piece& piece) {
    const int steps = steps_of(piece, tolerance);
    for (int i = 0; i < steps; ++i) add(rounded(piece.at(static_cast<double>(i) / steps)));
  });
  while (out.size() > 1 && out.back() == out.front()) out.pop_back();
  return out;
}

/// What two paths of the same corners have in common, whatever their beginning and direction.
using Corners = std::vector<std::pair<ClipperLib::cInt, ClipperLib::cInt>>;
Corners corners_of(const Path& path) {
  Corners out;
  for (const IntPoint& p : path) out.emplace_back(p.X, p.Y);
  std::ranges::sort(out);
  return out;
}

PlaneCurve curve_of(const Path& path) {
  const auto at = [](const IntPoint& p) {
    return Vec2{static_cast<double>(p.X) / kStepsAUnit, static_cast<double>(p.Y) / kStepsAUnit};
  };
  PlaneCurve out(at(path.front()));
  for (std::size_t i = 1; i < path.size(); ++i) out.line_to(at(path[i]));
  out.close();
  return out;
}

}  // namespace

std::vector<PlaneCurve> united_contours(std::vector<PlaneCurve> contours, double tolerance) {
  Paths paths;
  std::map<Corners, std::size_t> contour_with;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    Path path = path_of(contours[i], tolerance);
    contour_with.emplace(corners_of(path), i);
    paths.push_back(std::move(path));
  }
  ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple | ClipperLib::ioPreserveCollinear);
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  Paths united;
  clipper.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);

  // What stays, in its own order; then what is new.
  std::vector<bool> stays(contours.size());
  std::vector<PlaneCurve> made;
  for (const Path& path : united) {
    if (path.size() < 3) continue;
    const auto same = contour_with.find(corners_of(path));
    if (same != contour_with.end() && !stays[same->second]) {
      stays[same->second] = true;
    } else {
      made.push_back(curve_of(path));
    }
  }
  std::vector<PlaneCurve> out;
  for (std::size_t i = 0; i < contours.size(); ++i)
    if (stays[i]) out.push_back(std::move(contours[i]));
  std::ranges::move(made, std::back_inserter(out));
  return out;
}

}  // namespace mes
