// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/axis_deviation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <tuple>

#include "core/base/geometry/box_tree.h"
#include "core/base/jobs/parallel.h"

namespace mes {
namespace {

using DeviationPiece = AxisDeviation::Piece;

double distance_from(const DeviationPiece& piece, Vec2 p) {
  const Vec2 along = piece.to - piece.from;
  const double squared = dot(along, along);
  const double at = squared > 0.0 ? std::clamp(dot(p - piece.from, along) / squared, 0.0, 1.0) : 0.0;
  return distance(p, piece.from + at * along);
}

/// An order that does not depend on rows: of several nearest segments, the first counts.
bool comes_before(const DeviationPiece& a, const DeviationPiece& b) {
  return std::tie(a.from.x, a.from.y, a.to.x, a.to.y) < std::tie(b.from.x, b.from.y, b.to.x, b.to.y);
}

/// Segments that are searched.
class Segments {
 public:
  explicit Segments(std::span<const DeviationPiece> pieces) {
    tree_.build(
        pieces,
        [](const DeviationPiece& piece) {
          TreeBounds bounds;
          bounds.box.add(piece.from);
          bounds.box.add(piece.to);
          return bounds;
        },
        [](const DeviationPiece&, std::uint32_t) {});
  }

  /// The largest distance of the points of a segment from these.
  double farthest(Vec2 from, Vec2 to) const {
    const Near first = nearest(from);
    const Near last = nearest(to);
    return farthest(from, first, to, last, std::max(first.distance, last.distance), kMostHalvings);
  }

 private:
  static constexpr int kMostHalvings = 32;
  struct Near {
    DeviationPiece piece{};
    double distance = std::numeric_limits<double>::infinity();
  };

  Near nearest(Vec2 p) const {
    Near out;
    double squared = std::numeric_limits<double>::infinity();
    tree_.visit_near(p, squared, [&](const DeviationPiece& piece) {
      const double own = distance_from(piece, p);
      if (!(own < out.distance || (own == out.distance && comes_before(piece, out.piece)))) return;
      out = {piece, own};
      squared = own * own * (1.0 + 0x1p-50);  // equally near ones are visited too
    });
    return out;
  }

  /// The distance from one segment is a convex function, so its largest value lies at an end. The distance from all is
  /// at most that from any one. So halving is needed only where the nearest segment changes.
  double farthest(Vec2 from, const Near& first, Vec2 to, const Near& last, double known, int halvings) const {
    const double by_first = std::max(first.distance, distance_from(first.piece, to));
    const double by_last = std::max(last.distance, distance_from(last.piece, from));
    constexpr double kFactor = 1.0 + 0x1p-10;
    if (halvings == 0 || std::min(by_first, by_last) <= kFactor * known) return known;
    const Vec2 middle = 0.5 * from + 0.5 * to;
    const Near between = nearest(middle);
    known = std::max(known, between.distance);
    known = farthest(from, first, middle, between, known, halvings - 1);
    return farthest(middle, between, to, last, known, halvings - 1);
  }

  BoxTree<DeviationPiece> tree_;
};

void measure(std::span<DeviationPiece> pieces, const Segments& others, JobControl& job) {
  parallel_for(pieces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    constexpr std::size_t kOften = 256;
    for (std::size_t i = begin; i < end; ++i) {
      if (i % kOften == 0) job.checkpoint();
      pieces[i].distance = others.farthest(pieces[i].from, pieces[i].to);
    }
  });
}

}  // namespace

AxisDeviation::AxisDeviation(Delaunay& delaunay, MedialAxis& axis, OutlineAxis& outline)
    : Structure("axis-deviation", {&delaunay, &axis, &outline}),
      delaunay_(delaunay),
      axis_(axis),
      outline_(outline) {}

void AxisDeviation::rebuild(JobControl& job) {
  pieces_ = {};
  std::vector<DeviationPiece> sampled;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (!row.is_alive() || !axis_.is_axis_edge(edge) || axis_.is_zero_length(edge)) continue;
    const Vec2 first = delaunay_.circumcenter(row.f[0]);
    const Vec2 second = delaunay_.circumcenter(row.f[1]);
    const auto [from, to] = std::minmax(first, second, lexicographically_less);
    sampled.push_back({from, to, 0.0, false});
  }
  std::vector<DeviationPiece> exact;
  for (const OutlinePiece& piece : outline_.pieces()) exact.push_back({piece.from, piece.to, 0.0, true});
  if (sampled.empty() || exact.empty()) return;
  const Segments sampled_axis(sampled);
  const Segments exact_axis(exact);
  measure(sampled, exact_axis, job);
  measure(exact, sampled_axis, job);
  for (const std::vector<DeviationPiece>* some : {&sampled, &exact})
    for (const DeviationPiece& piece : *some) pieces_.push_back(piece);
}

bool AxisDeviation::update(JobControl&) {
  return outline_.pieces().empty() || axis_.touched() == 0;
}

double AxisDeviation::largest(bool is_of_outline) const {
  double out = 0.0;
  for (const DeviationPiece& piece : pieces_)
    if (piece.is_of_outline == is_of_outline) out = std::max(out, piece.distance);
  return out;
}

StatList AxisDeviation::statistics() const {
  if (pieces_.empty()) {
    const bool is_outline = outline_.pieces().empty();
    return {{"nothing_because",
             std::string(is_outline ? "the axis of the outline is empty" : "the medial axis is empty")}};
  }
  return {{"axis_from_outline", largest(false)},
          {"outline_from_axis", largest(true)},
          {"hausdorff_distance", std::max(largest(false), largest(true))}};
}

}  // namespace mes
