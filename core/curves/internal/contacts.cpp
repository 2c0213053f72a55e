// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/contacts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/box_tree.h"
#include "core/base/jobs/parallel.h"
#include "core/curves/curve_bounds.h"
#include "core/curves/internal/slab_tree.h"
#include "core/curves/nearest_place.h"

namespace mes {
namespace {

// Rounding to a grid moves a point by at most half a diagonal of a cell. It moved the vertex, and the ends of the piece
// that the vertex lay on.
constexpr double kRounded = 1.5;
// Rounding error of computed numbers, relative to the extent of all curves.
constexpr double kComputed = 1e-11;
// Points farther apart than this share of the pieces there are meant to be apart, however coarse the grid. This is the
// share for slanted pieces, on which a rounded vertex does not lie exactly, ...
constexpr double kOfSlanted = 1.0 / 128.0;
// ... and this is the share for other pieces, and for vertices, which rounding keeps equal.
constexpr double kOfOthers = 1.0 / 4096.0;
// Limit for one vertex. More pieces this near to it, none of which ends in it, are noise.
constexpr std::size_t kMostContacts = 256;
// To compare a vertex with a piece takes as long as with so many boxes.
constexpr std::size_t kWorkOfPiece = 16;
// A cancelled search ends after so many vertices.
constexpr std::size_t kVertices = 256;

Box2 grown(Box2 box, double by) {
  return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

/// For each curve, whether its box overlaps that of another curve.
std::vector<bool> overlapping(const std::vector<PlaneCurve>& curves, const std::vector<Box2>& boxes,
                              double tolerance) {
  std::vector<std::uint32_t> numbers(curves.size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  BoxTree<std::uint32_t> tree;
  tree.build(
      std::span<const std::uint32_t>(numbers), [&](std::uint32_t i) { return TreeBounds{boxes[i]}; },
      [](std::uint32_t, std::uint32_t) {});
  std::vector<std::uint8_t> out(curves.size(), 0);
  parallel_for(curves.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Box2 box = grown(boxes[i], tolerance);
      bool is_found = false;
      tree.visit_where(
          [&](const Box2& other, double) { return !is_found && overlap(box, other); },
          [&](std::uint32_t other) { is_found = is_found || (other != i && overlap(box, boxes[other])); });
      out[i] = is_found ? 1 : 0;
    }
  });
  return {out.begin(), out.end()};
}

double size_of(const Piece& piece) {
  if (piece.kind == PieceKind::line) return distance(piece.from(), piece.to());
  const Box2 box = bounds_of(piece);
  return std::max(box.width(), box.height());
}

// True if the point is certainly farther than `reach` from the whole ellipse of the arc. A map with the least stretch s
// takes the unit circle to the ellipse, so a point whose preimage is r from the centre is at least s |r - 1| away.
bool is_far_from(const EllipticArc& arc, Vec2 p, double reach) {
  const double area = cross(arc.u, arc.v);
  const double most = dot(arc.u, arc.u) + dot(arc.v, arc.v);
  const Vec2 q = p - arc.center;
  const double r = length({cross(q, arc.v), cross(arc.u, q)}) / std::abs(area);
  const double least = std::sqrt(0.5 * (most - std::sqrt(std::max(most * most - 4.0 * area * area, 0.0))));
  constexpr double kLessRounding = 1.0 - 1e-6;
  return kLessRounding * least * std::abs(r - 1.0) > 2.0 * reach;
}

/// Parameter of the point on the piece; negative if it is not on the piece.
double parameter_of_contact(const Piece& piece, Vec2 p, double tolerance, double tolerance_if_slanted) {
  if (distance(piece.from(), p) <= tolerance) return 0.0;
  if (distance(piece.to(), p) <= tolerance) return 1.0;
  if (piece.kind == PieceKind::arc && is_far_from(piece.arc, p, std::max(tolerance, tolerance_if_slanted)))
    return -1.0;
  const Vec2 along = piece.to() - piece.from();
  const bool is_slanted = piece.kind != PieceKind::line || (along.x != 0.0 && along.y != 0.0);
  const double t = nearest_parameter(piece, p);
  const bool is_on =
      t > 0.0 && t < 1.0 && distance(piece.at(t), p) <= (is_slanted ? tolerance_if_slanted : tolerance);
  return is_on ? t : -1.0;
}

/// Finds the pieces near a point, by their boxes.
class FinderByBoxes {
 public:
  explicit FinderByBoxes(const std::vector<TouchingPiece>& pieces) {
    std::vector<std::uint32_t> numbers(pieces.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    for (const TouchingPiece& one : pieces) boxes_.push_back(bounds_of(one.piece));
    tree_.build(
        std::span<const std::uint32_t>(numbers), [&](std::uint32_t i) { return TreeBounds{boxes_[i]}; },
        [](std::uint32_t, std::uint32_t) {});
  }

  /// Visits pieces while `visit` returns true. Returns the number of boxes that it compared with the point.
  template <class Visit>
  std::size_t visit_near(Vec2 p, double reach, Visit visit) const {
    const Box2 around = grown({p, p}, reach);
    bool goes_on = true;
    std::size_t compared = 0;
    tree_.visit_where([&](const Box2& box, double) { return ++compared != 0 && goes_on && overlap(around, box); },
                      [&](std::uint32_t number) {
                        ++compared;
                        if (goes_on && overlap(around, boxes_[number])) goes_on = visit(number);
                      });
    return compared;
  }

 private:
  std::vector<Box2> boxes_;
  BoxTree<std::uint32_t> tree_;
};

/// A convex polygon around a part of a piece, its ends first. An arc is at most half a turn.
SlabItem slab_item_of(const Piece& part, std::uint32_t number) {
  const Vec2 from = part.from();
  const Vec2 to = part.to();
  SlabItem out{{from, to, from, to}, number};
  if (part.kind == PieceKind::quadratic) out.hull[2] = part.points[1];
  if (part.kind == PieceKind::cubic) {
    out.hull[2] = part.points[1];
    out.hull[3] = part.points[2];
  }
  if (part.kind == PieceKind::arc) {
    // The tangents at the ends meet there. Measured from the chord, it is exact for flat arcs of a huge circle too.
    const double half = 0.5 * part.arc.sweep;
    const double middle = part.arc.start + half;
    const double height = std::sin(half) * std::tan(half);
    out.hull[2] = 0.5 * (from + to) + height * (std::cos(middle) * part.arc.u + std::sin(middle) * part.arc.v);
  }
  return out;
}

/// Finds the pieces near a point, by slabs around their parts. Slower to build than boxes, but few of the slabs of
/// nested or parallel pieces hold one point.
class FinderBySlabs {
 public:
  FinderBySlabs(const std::vector<TouchingPiece>& pieces, int parts_per_bend)
      : tree_(parts_of(pieces, parts_per_bend)) {}

  /// Visits pieces, some of them several times, while `visit` returns true. Returns the number of nodes and parts that
  /// it compared with the point.
  template <class Visit>
  std::size_t visit_near(Vec2 p, double reach, Visit visit) const {
    // Covers the rounding of distances from slabs, which is far below any reach.
    constexpr double kMore = 1.01;
    return tree_.visit_near(p, kMore * reach, visit);
  }

 private:
  static std::vector<SlabItem> parts_of(const std::vector<TouchingPiece>& pieces, int parts_per_bend) {
    std::vector<SlabItem> out;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = pieces[i].piece;
      if (piece.kind == PieceKind::line) {
        out.push_back(slab_item_of(piece, i));
        continue;
      }
      const double share = 1.0 / parts_per_bend;
      for (int k = 0; k < parts_per_bend; ++k)
        out.push_back(slab_item_of(piece.part(share * k, k + 1 == parts_per_bend ? 1.0 : share * (k + 1)), i));
    }
    return out;
  }

  SlabTree tree_;
};

/// Merges equal vertices.
void number_equal_vertices(Contacts& out) {
  std::vector<std::uint32_t> order(out.vertices.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    const Vec2 p = out.vertices[a];
    const Vec2 q = out.vertices[b];
    if (p.x != q.x) return p.x < q.x;
    return p.y != q.y ? p.y < q.y : a < b;
  });
  // The first one in the order of the curves represents all.
  std::vector<std::uint32_t> same_as(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_same = k > 0 && out.vertices[order[k]] == out.vertices[order[k - 1]];
    same_as[order[k]] = is_same ? same_as[order[k - 1]] : order[k];
  }
  std::vector<std::uint32_t> number(order.size());
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < same_as.size(); ++v) {
    if (same_as[v] != v) continue;
    number[v] = count;
    out.vertices[count++] = out.vertices[v];
  }
  out.vertices.resize(count);
  for (TouchingPiece& piece : out.pieces) {
    piece.from = number[same_as[piece.from]];
    piece.to = number[same_as[piece.to]];
  }
}

}  // namespace

Contacts contacts_of(const std::vector<PlaneCurve>& curves, double resolution, bool within_curves, JobControl* job) {
  Contacts out;
  if (curves.size() < 2 && !within_curves) return out;
  const auto checkpoint = [job] {
    if (job != nullptr && job->stop_requested()) throw Cancelled{};
  };
  std::vector<Box2> boxes(curves.size());
  Box2 extent;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].is_polyline()) {
      for (const Vec2 p : curves[i].points()) boxes[i].add(p);
    } else {
      boxes[i] = bounds_of(std::span(&curves[i], 1));
    }
    extent.add(boxes[i]);
  }
  const double size = std::max(extent.width(), extent.height());
  const double least = kComputed * std::max({size, std::abs(extent.low.x), std::abs(extent.low.y),
                                             std::abs(extent.high.x), std::abs(extent.high.y)});
  // A document treats such a small drawing as one point, so nothing can touch.
  constexpr double kLeastSize = 0x1p-500;
  if (!std::isfinite(size) || size < kLeastSize) return out;
  out.tolerance = std::max(kRounded * resolution, least);
  out.is_candidate =
      within_curves ? std::vector<bool>(curves.size(), true) : overlapping(curves, boxes, out.tolerance);

  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    if (!out.is_candidate[c]) continue;
    checkpoint();
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    const std::size_t first_piece = out.pieces.size();
    curves[c].for_each_piece([&](const Piece& piece) {
      if (piece.kind == PieceKind::line && piece.from() == piece.to()) return;
      const auto vertex = static_cast<std::uint32_t>(out.vertices.size());
      out.pieces.push_back({piece, c, vertex, vertex + 1});
      out.vertices.push_back(piece.from());
    });
    if (out.pieces.size() == first_piece) continue;
    if (curves[c].is_closed())
      out.pieces.back().to = first;
    else
      out.vertices.push_back(curves[c].end());
  }
  number_equal_vertices(out);
  std::vector<double> sizes;
  // For each vertex, the size of the smallest piece at it.
  std::vector<double> local(out.vertices.size(), std::numeric_limits<double>::infinity());
  for (const TouchingPiece& piece : out.pieces) {
    sizes.push_back(size_of(piece.piece));
    for (const std::uint32_t vertex : {piece.from, piece.to}) local[vertex] = std::min(local[vertex], sizes.back());
  }
  std::vector<std::vector<Contact>> found;
  // Gives up, and returns false, after `most_work`.
  const auto find = [&](const auto& finder, std::size_t most_work) {
    found.assign(chunk_count(out.vertices.size()), {});
    std::atomic<std::size_t> work = 0;
    parallel_for(out.vertices.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      std::vector<Contact>& here = found[chunk];
      for (std::size_t v = begin; v < end; ++v) {
        if (v % kVertices == 0) checkpoint();
        const Vec2 p = out.vertices[v];
        const std::size_t first = here.size();
        std::size_t met = 0;
        const std::size_t compared = finder.visit_near(p, out.tolerance, [&](std::uint32_t number) {
          const TouchingPiece& other = out.pieces[number];
          if (other.from == v || other.to == v) return true;
          ++met;
          const double of_both = std::min(local[v], sizes[number]);
          const double t = parameter_of_contact(other.piece, p, std::clamp(kOfOthers * of_both, least, out.tolerance),
                                                std::clamp(kOfSlanted * of_both, least, out.tolerance));
          if (t < 0.0) return true;
          const auto before = here.begin() + static_cast<std::ptrdiff_t>(first);
          if (std::ranges::find(before, here.end(), number, &Contact::piece) == here.end())
            here.push_back({static_cast<std::uint32_t>(v), number, t});
          return here.size() - first < kMostContacts;
        });
        // The order does not depend on the finder.
        std::ranges::sort(here.begin() + static_cast<std::ptrdiff_t>(first), here.end(), {}, &Contact::piece);
        if ((work += compared + kWorkOfPiece * met) > most_work) return;
      }
    });
    out.work = work;
    return work <= most_work;
  };
  // Boxes compare a few pieces too many, which costs less than slabs.
  constexpr std::size_t kLittleWork = 256;
  const std::size_t little = kLittleWork * (out.vertices.size() + kVertices);
  const bool has_bends =
      std::ranges::any_of(out.pieces, [](const TouchingPiece& one) { return one.piece.kind != PieceKind::line; });
  constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  if (!find(FinderByBoxes(out.pieces), little) && !find(FinderBySlabs(out.pieces, 4), has_bends ? little : kNoLimit))
    find(FinderBySlabs(out.pieces, 16), kNoLimit);
  for (const std::vector<Contact>& part : found) out.contacts.insert(out.contacts.end(), part.begin(), part.end());
  return out;
}

}  // namespace mes
