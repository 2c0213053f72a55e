// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/sampling/scale_hairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/sum.h"

namespace mes {
namespace {

constexpr double kRounding = 1e-9;  // relative to a radius: shorter pieces have no length but for rounding

class HairCutter {
 public:
  HairCutter(UnionTables& tables, const Table<FamilySlot, double>& spacing)
      : t_(tables),
        spacing_(spacing_of_v_points(tables, spacing)),
        joined_(tables.node_count()),
        degree_(tables.node_count(), 0),
        pieces_(tables.node_count(), 0),
        is_cut_off_(tables.node_count(), false) {}

  ScaleHairs cut() {
    join_ends();
    keep_one_of_each_component();
    for (const AxisPieceSlot piece : t_.axis.rows())
      if (is_edge(piece) && may_go(piece)) cut_from(piece);
    cut_pieces_without_length();
    return {cut_, length_.value()};
  }

 private:
  bool is_edge(AxisPieceSlot piece) const { return t_.axis[piece].is_alive() && t_.axis[piece].is_zero == 0; }
  AxisNodeSlot end(AxisPieceSlot piece, std::size_t i) { return joined_.root(t_.axis[piece].node[i]); }
  double chord(const AxisPiece& piece) const {
    return distance(t_.v_points[piece.v[0]].position, t_.v_points[piece.v[1]].position);
  }

  /// The smallest distance of a point of the piece from its v-points: there they are seen at the largest angle.
  double nearest(const AxisPiece& piece) const {
    const Vec2 middle = place_of_middle(piece);
    const Vec2 along = piece.b - piece.a;
    if (dot(middle - piece.a, along) >= 0.0 && dot(middle - piece.b, along) <= 0.0) return 0.5 * chord(piece);
    return std::min(piece.radius_a, piece.radius_b);
  }
  Vec2 place_of_middle(const AxisPiece& piece) const {
    return 0.5 * t_.v_points[piece.v[0]].position + 0.5 * t_.v_points[piece.v[1]].position;
  }

  bool is_short(AxisPieceSlot row) const {
    const AxisPiece& piece = t_.axis[row];
    // A crossing that rounding has lost, as the number type `naive` may, decides nothing.
    if (piece.v[0] == kNoSlot || piece.v[1] == kNoSlot) return false;
    if (distance(piece.a, piece.b) <= kRounding * piece.radius_a) return true;
    const double across = chord(piece);
    return across <= spacing_[piece.v[0]] + spacing_[piece.v[1]] && across < nearest(piece);
  }
  bool may_go(AxisPieceSlot piece) const { return may_go_[piece] != 0; }

  // Ends of pieces of length zero are one node.
  void join_ends() {
    for (const AxisPiece& piece : t_.axis)
      if (piece.is_alive() && piece.is_zero != 0)
        joined_.join(joined_.root(piece.node[0]), joined_.root(piece.node[1]));
    may_go_.assign(t_.axis.size(), 0);
    for (const AxisPieceSlot piece : t_.axis.rows()) {
      if (!is_edge(piece)) continue;
      may_go_[piece] = is_short(piece) ? 1 : 0;
      for (const std::size_t i : {0U, 1U}) {
        ++degree_[end(piece, i)];
        pieces_[end(piece, i)] ^= piece.index();
      }
    }
  }

  /// Compares two pieces of one component, all of which may go.
  bool is_better(AxisPieceSlot a, AxisPieceSlot b) const {
    const auto key = [&](AxisPieceSlot row) {
      const AxisPiece& piece = t_.axis[row];
      const bool is_turned = lexicographically_less(piece.b, piece.a);
      const Vec2 first = is_turned ? piece.b : piece.a;
      const Vec2 second = is_turned ? piece.a : piece.b;
      return std::tuple(chord(piece) / nearest(piece), first.x, first.y, second.x, second.y);
    };
    return key(a) > key(b);
  }

  void keep_one_of_each_component() {
    DisjointSets<AxisNodeSlot> whole = joined_;
    for (const AxisPieceSlot piece : t_.axis.rows())
      if (is_edge(piece)) whole.join(whole.root(end(piece, 0)), whole.root(end(piece, 1)));
    struct Component {
      bool stays = false;  ///< a piece of it may not go, or there is a cycle
      std::int64_t pieces = 0, nodes = 0;
      AxisPieceSlot best;
    };
    Table<AxisNodeSlot, Component> components(t_.node_count());
    for (const AxisNodeSlot node : degree_.rows())
      if (degree_[node] != 0) ++components[whole.root(node)].nodes;
    for (const AxisPieceSlot piece : t_.axis.rows()) {
      if (!is_edge(piece)) continue;
      Component& at = components[whole.root(end(piece, 0))];
      ++at.pieces;
      if (!may_go(piece))
        at.stays = true;
      else if (at.best == kNoSlot || is_better(piece, at.best))
        at.best = piece;
    }
    for (const Component& at : components)
      if (!at.stays && at.best != kNoSlot && at.pieces == at.nodes - 1) may_go_[at.best] = 0;
  }

  /// Cuts the piece if it is at a free end, and then those that become free.
  void cut_from(AxisPieceSlot piece) {
    for (;;) {
      const std::size_t free = degree_[end(piece, 0)] == 1 ? 0 : 1;
      if (degree_[end(piece, free)] != 1) return;
      const AxisNodeSlot free_end = end(piece, free);
      const AxisNodeSlot rest = end(piece, 1 - free);
      for (const std::size_t i : {0U, 1U}) {
        --degree_[end(piece, i)];
        pieces_[end(piece, i)] ^= piece.index();
      }
      length_.add(distance(t_.axis[piece].a, t_.axis[piece].b));
      ++cut_;
      t_.axis[piece].node[0] = t_.axis[piece].node[1] = kNoSlot;
      is_cut_off_[free_end] = true;
      if (degree_[rest] != 1) return;
      piece = AxisPieceSlot(pieces_[rest]);
      // A piece that stays ends the run; later pieces are tried on their own.
      if (!may_go(piece)) return;
    }
  }

  void cut_pieces_without_length() {
    for (const AxisPieceSlot row : t_.axis.rows()) {
      AxisPiece& piece = t_.axis[row];
      if (!piece.is_alive() || piece.is_zero == 0 || !is_cut_off_[joined_.root(piece.node[0])]) continue;
      piece.node[0] = piece.node[1] = kNoSlot;
    }
  }

  UnionTables& t_;
  Table<VPointSlot, double> spacing_;
  DisjointSets<AxisNodeSlot> joined_;
  Table<AxisNodeSlot, std::uint32_t> degree_;  // number of edges left
  Table<AxisNodeSlot, RowNumber> pieces_;      // xor of the rows of these edges: for a free end, its only one
  Table<AxisNodeSlot, bool> is_cut_off_;       // was a free end and has been cut off
  Table<AxisPieceSlot, std::uint8_t> may_go_;
  std::int64_t cut_ = 0;
  Sum length_;
};

}  // namespace

double distance_of_sampled(double sampling_angle) {
  return 2.0 * std::sin((180.0 - sampling_angle) * std::numbers::pi / 360.0);
}

double share_of_spacing(double factor) {
  constexpr double kWholeFrom = 1.02;
  return std::min(1.0, std::abs(factor - 1.0) / (kWholeFrom - 1.0));
}

Table<VPointSlot, double> spacing_of_v_points(const UnionTables& tables, const Table<FamilySlot, double>& spacing) {
  Table<VPointSlot, double> out(tables.v_points.size(), 0.0);
  for (const VOrigin& origin : tables.v_origins) {
    if (!origin.is_alive()) continue;
    for (const FamilySlot ball : tables.dual_edges[origin.edge].ball)
      out[origin.v] = std::max(out[origin.v], spacing[ball]);
  }
  return out;
}

ScaleHairs cut_hairs(UnionTables& tables, const Table<FamilySlot, double>& spacing) {
  return HairCutter(tables, spacing).cut();
}

}  // namespace mes
