// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/box2.h"
#include "core/base/box_tree.h"
#include "core/base/parallel.h"
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

Box2 grown(Box2 box, double by) {
  return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

bool overlap(const Box2& a, const Box2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
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
  const Box2 box = box_of(piece);
  return std::max(box.width(), box.height());
}

/// Parameter of the point on the piece; negative if it is not on the piece.
double parameter_of_contact(const Piece& piece, Vec2 p, double tolerance, double tolerance_if_slanted) {
  if (distance(piece.from(), p) <= tolerance) return 0.0;
  if (distance(piece.to(), p) <= tolerance) return 1.0;
  const Vec2 along = piece.to() - piece.from();
  const bool is_slanted = piece.kind != PieceKind::line || (along.x != 0.0 && along.y != 0.0);
  const double t = nearest_parameter(piece, p);
  const bool is_on =
      t > 0.0 && t < 1.0 && distance(piece.at(t), p) <= (is_slanted ? tolerance_if_slanted : tolerance);
  return is_on ? t : -1.0;
}

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
      curves[i].for_each_piece([&](const Piece& piece) { boxes[i].add(box_of(piece)); });
      boxes[i].add(curves[i].start());
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
  // For each vertex, the size of the smallest piece at it.
  std::vector<double> local(out.vertices.size(), std::numeric_limits<double>::infinity());
  for (const TouchingPiece& piece : out.pieces)
    for (const std::uint32_t vertex : {piece.from, piece.to})
      local[vertex] = std::min(local[vertex], size_of(piece.piece));
  std::vector<std::uint32_t> numbers(out.pieces.size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  BoxTree<std::uint32_t> tree;
  tree.build(
      std::span<const std::uint32_t>(numbers),
      [&](std::uint32_t i) { return TreeBounds{box_of(out.pieces[i].piece)}; }, [](std::uint32_t, std::uint32_t) {});
  std::vector<std::vector<Contact>> found(chunk_count(out.vertices.size()));
  parallel_for(out.vertices.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    checkpoint();
    for (std::size_t v = begin; v < end; ++v) {
      const Vec2 p = out.vertices[v];
      const Box2 around = grown({p, p}, out.tolerance);
      std::size_t left = kMostContacts;
      tree.visit_where([&](const Box2& box, double) { return left > 0 && overlap(around, box); },
                       [&](std::uint32_t number) {
                         const TouchingPiece& other = out.pieces[number];
                         if (left == 0 || other.from == v || other.to == v) return;
                         if (!overlap(around, box_of(other.piece))) return;
                         const double here = std::min(local[v], size_of(other.piece));
                         const double t =
                             parameter_of_contact(other.piece, p, std::clamp(kOfOthers * here, least, out.tolerance),
                                                  std::clamp(kOfSlanted * here, least, out.tolerance));
                         if (t < 0.0) return;
                         found[chunk].push_back({static_cast<std::uint32_t>(v), number, t});
                         --left;
                       });
    }
  });
  for (const std::vector<Contact>& part : found) out.contacts.insert(out.contacts.end(), part.begin(), part.end());
  return out;
}

}  // namespace mes
