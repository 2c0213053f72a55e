// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/glyphs/internal/united_contours.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/slot.h"

namespace mes {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double kStepsAUnit = 1024.0;

IntPoint rounded(Vec2 p) {
  return {std::llround(kStepsAUnit * p.x), std::llround(kStepsAUnit * p.y)};
}

/// The number of straight pieces that approximate a piece within the tolerance. n equal steps of a curve have an error
/// of at most |second derivative| / (8 n^2).
int chord_count(const Piece& piece, double tolerance) {
  const auto& p = piece.points;
  const auto bend = [](Vec2 a, Vec2 b, Vec2 c) { return length(a - 2.0 * b + c); };
  constexpr double kMost = 256.0;
  // Fewer steps would show as corners: the tangent should turn little from step to step.
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

/// The corners, without repetitions.
Path path_of(const PlaneCurve& contour, double tolerance) {
  Path out;
  const auto add = [&out](IntPoint p) {
    if (out.empty() || out.back() != p) out.push_back(p);
  };
  contour.for_each_piece([&](const Piece& piece) {
    const int steps = chord_count(piece, tolerance);
    for (int i = 0; i < steps; ++i) add(rounded(piece.at(static_cast<double>(i) / steps)));
  });
  while (out.size() > 1 && out.back() == out.front()) out.pop_back();
  return out;
}

/// Identifies paths with the same corners, whatever their start and direction.
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

/// Bounding box of the corners.
struct PathBox {
  IntPoint low;
  IntPoint high;
};
PathBox box_of(const Path& path) {
  PathBox out{path.front(), path.front()};
  for (const IntPoint& p : path) {
    out.low = {std::min(out.low.X, p.X), std::min(out.low.Y, p.Y)};
    out.high = {std::max(out.high.X, p.X), std::max(out.high.Y, p.Y)};
  }
  return out;
}

using PathSlot = Slot<struct PathTag>;

/// Groups of paths that can be united independently: their boxes meet none of the other groups'. Each group keeps the
/// order of its paths; groups are in the order of their first paths. Paths must have corners.
std::vector<std::vector<PathSlot>> parts_of(const std::vector<Path>& paths) {
  std::vector<PathBox> boxes;
  std::vector<PathSlot> from_left;
  for (const PathSlot path : slots_below<PathSlot>(paths.size())) {
    boxes.push_back(box_of(paths[path.index()]));
    from_left.push_back(path);
  }
  std::ranges::stable_sort(from_left, {}, [&](PathSlot path) { return boxes[path.index()].low.X; });
  DisjointSets<PathSlot> sets(paths.size());
  std::vector<PathSlot> across;  // paths that the sweep has reached and not left
  for (const PathSlot path : from_left) {
    const PathBox& box = boxes[path.index()];
    std::erase_if(across, [&](PathSlot other) { return boxes[other.index()].high.X < box.low.X; });
    for (const PathSlot other : across) {
      const PathBox& its = boxes[other.index()];
      if (its.low.Y <= box.high.Y && box.low.Y <= its.high.Y) sets.join(sets.root(path), sets.root(other));
    }
    across.push_back(path);
  }
  std::vector<std::vector<PathSlot>> out;
  std::vector<std::optional<std::size_t>> part_of(paths.size());  // indexed by root
  for (const PathSlot path : slots_below<PathSlot>(paths.size())) {
    std::optional<std::size_t>& part = part_of[sets.root(path).index()];
    if (!part) {
      part = out.size();
      out.emplace_back();
    }
    out[*part].push_back(path);
  }
  return out;
}

/// Computes the boundary of a group: marks the paths that stay, and adds the new ones.
class PartUnion {
 public:
  PartUnion(const std::vector<Path>& paths, std::vector<bool>& stays, std::vector<PlaneCurve>& made)
      : paths_(paths), stays_(stays), made_(made) {}

  void unite(const std::vector<PathSlot>& part) {
    ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple | ClipperLib::ioPreserveCollinear);
    std::map<Corners, PathSlot> path_with;
    for (const PathSlot path : part) {
      path_with.emplace(corners_of(paths_[path.index()]), path);
      clipper.AddPath(paths_[path.index()], ClipperLib::ptSubject, true);
    }
    Paths united;
    clipper.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    for (const Path& path : united) {
      if (path.size() < 3) continue;
      const auto same = path_with.find(corners_of(path));
      if (same != path_with.end() && !stays_[same->second.index()]) {
        stays_[same->second.index()] = true;
      } else {
        made_.push_back(curve_of(path));
      }
    }
  }

 private:
  const std::vector<Path>& paths_;
  std::vector<bool>& stays_;
  std::vector<PlaneCurve>& made_;
};

}  // namespace

std::vector<PlaneCurve> united_contours(std::vector<PlaneCurve> contours, double tolerance, JobControl* job) {
  std::vector<Path> paths;
  for (const PlaneCurve& contour : contours) {
    if (job != nullptr) job->checkpoint();
    paths.push_back(path_of(contour, tolerance));
  }
  std::vector<bool> stays(contours.size());
  std::vector<PlaneCurve> made;
  PartUnion all(paths, stays, made);
  const std::vector<std::vector<PathSlot>> parts = parts_of(paths);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (job != nullptr) job->checkpoint(i, parts.size());
    all.unite(parts[i]);
  }
  // First the contours that stay, in their order, then the new ones.
  std::vector<PlaneCurve> out;
  for (std::size_t i = 0; i < contours.size(); ++i)
    if (stays[i]) out.push_back(std::move(contours[i]));
  std::ranges::move(made, std::back_inserter(out));
  return out;
}

}  // namespace mes
