// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/joined_ends.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace mes {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Ends of curves: 2 i is the start of curve i, and 2 i + 1 its end.
class CurveEnds {
 public:
  CurveEnds(const std::vector<PlaneCurve>& curves, double tolerance)
      : curves_(curves), tolerance_(tolerance), origin_(curves.empty() ? Vec2{} : curves.front().start()) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (curves[i].is_closed()) continue;
      for (const std::size_t end : {2 * i, 2 * i + 1}) {
        const Cell cell = cell_of(place_of(end));
        cells_[key_of(cell.x, cell.y)].push_back(end);
      }
    }
    for (auto& [key, ends] : cells_)
      std::ranges::stable_sort(ends, lexicographically_less, [this](std::size_t end) { return place_of(end); });
  }

  /// The only other end at the same position, or else the only other end nearby; nothing if there are none or several.
  /// The search ends at the second, so many ends at one place cost no more than two.
  std::size_t partner_of(std::size_t end) const {
    const auto is_candidate = [&](std::size_t other) {
      return other != end && (other != (end ^ 1U) || may_close(end / 2));
    };
    const Cell cell = cell_of(place_of(end));
    Only here;
    for (const std::size_t other :
         std::ranges::equal_range(cells_.at(key_of(cell.x, cell.y)), place_of(end), lexicographically_less,
                                  [this](std::size_t one) { return place_of(one); })) {
      if (is_candidate(other)) here.add(other);
      if (here.count > 1) return kNone;
    }
    if (here.count == 1) return here.end;
    Only near;
    for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x)
      for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y) {
        const auto found = cells_.find(key_of(x, y));
        if (found == cells_.end()) continue;
        for (const std::size_t other : found->second) {
          if (is_candidate(other) && distance(place_of(other), place_of(end)) <= tolerance_) near.add(other);
          if (near.count > 1) return kNone;
        }
      }
    return near.end;
  }

 private:
  struct Cell {
    std::int64_t x;
    std::int64_t y;
  };
  struct Only {
    std::size_t end = kNone;
    std::size_t count = 0;
    void add(std::size_t other) {
      end = other;
      ++count;
    }
  };
  /// False for a single line or an arc below half a turn, however short it is.
  bool may_close(std::size_t curve) const {
    const PlaneCurve& c = curves_[curve];
    if (c.piece_count() != 1) return c.piece_count() > 1;
    if (c.kinds().front() == PieceKind::line) return false;
    return c.kinds().front() != PieceKind::arc || std::abs(c.arcs().front().sweep) > std::numbers::pi;
  }
  Vec2 place_of(std::size_t end) const { return end % 2 == 0 ? curves_[end / 2].start() : curves_[end / 2].end(); }
  Cell cell_of(Vec2 p) const {
    constexpr double kFar = 1e15;
    const auto index = [&](double x) {
      return static_cast<std::int64_t>(std::fmax(-kFar, std::fmin(kFar, std::floor(x / tolerance_))));
    };
    return {index(p.x - origin_.x), index(p.y - origin_.y)};
  }
  // Cells may share a key; the distance of the ends in them tells them apart.
  static std::uint64_t key_of(std::int64_t x, std::int64_t y) {
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;
    std::uint64_t key = static_cast<std::uint64_t>(x) * kOdd;
    key ^= key >> 29U;
    return (key ^ static_cast<std::uint64_t>(y)) * kOdd;
  }

  const std::vector<PlaneCurve>& curves_;
  double tolerance_;
  Vec2 origin_;                                                        // origin of the cells
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;  ///< ends at one position are side by side
};

void append(PlaneCurve& out, const Piece& piece) {
  switch (piece.kind) {
    case PieceKind::line: return out.line_to(piece.points[1]);
    case PieceKind::quadratic: return out.quadratic_to(piece.points[1], piece.points[2]);
    case PieceKind::cubic: return out.cubic_to(piece.points[1], piece.points[2], piece.points[3]);
    case PieceKind::arc: return out.arc_to(piece.arc, piece.points[1]);
  }
}

Piece reversed(const Piece& piece) {
  Piece out = piece;
  switch (piece.kind) {
    case PieceKind::line: std::swap(out.points[0], out.points[1]); break;
    case PieceKind::quadratic: std::swap(out.points[0], out.points[2]); break;
    case PieceKind::cubic:
      std::swap(out.points[0], out.points[3]);
      std::swap(out.points[1], out.points[2]);
      break;
    case PieceKind::arc:
      std::swap(out.points[0], out.points[1]);
      out.arc.start = piece.arc.start + piece.arc.sweep;
      out.arc.sweep = -piece.arc.sweep;
      break;
  }
  return out;
}

std::vector<Piece> pieces_of(const PlaneCurve& curve) {
  std::vector<Piece> out;
  curve.for_each_piece([&out](const Piece& piece) { out.push_back(piece); });
  return out;
}

}  // namespace

PlaneCurve reversed(const PlaneCurve& curve) {
  PlaneCurve out(curve.end());
  const std::vector<Piece> pieces = pieces_of(curve);
  for (std::size_t i = pieces.size(); i > 0; --i) append(out, reversed(pieces[i - 1]));
  if (curve.is_closed()) out.close();
  out.name = curve.name;
  return out;
}

std::vector<PlaneCurve> joined_ends(std::vector<PlaneCurve> curves, double tolerance) {
  if (!(tolerance > 0.0)) return curves;
  const CurveEnds ends(curves, tolerance);
  // Ends are joined only if each is the partner of the other: nearness is not transitive.
  const auto partner = [&](std::size_t end) {
    const std::size_t other = ends.partner_of(end);
    return other != kNone && ends.partner_of(other) == end ? other : kNone;
  };
  std::vector<bool> is_used(curves.size());
  std::vector<PlaneCurve> out;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (is_used[i]) continue;
    is_used[i] = true;
    if (curves[i].is_closed()) {
      out.push_back(std::move(curves[i]));
      continue;
    }
    // Follow the chain back to its beginning, or around to where it closes.
    std::size_t begin = 2 * i;
    for (std::size_t before = partner(begin); before != kNone; before = partner(begin)) {
      begin = before ^ 1U;
      if (begin / 2 != i) continue;
      begin = 2 * i;
      break;
    }
    PlaneCurve chain = begin % 2 == 0 ? curves[begin / 2] : reversed(curves[begin / 2]);
    is_used[begin / 2] = true;
    std::size_t end = begin ^ 1U;
    bool is_closed = false;
    for (std::size_t next = partner(end); next != kNone; next = partner(end)) {
      if (next == begin) {
        is_closed = true;
        break;
      }
      const PlaneCurve& added = curves[next / 2];
      std::vector<Piece> pieces = pieces_of(next % 2 == 0 ? added : reversed(added));
      for (const Piece& piece : pieces) append(chain, piece);
      is_used[next / 2] = true;
      end = next ^ 1U;
    }
    if (is_closed) {
      // A ring ends exactly at its start.
      std::vector<Piece> pieces = pieces_of(chain);
      PlaneCurve ring(chain.start());
      ring.name = chain.name;
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (k + 1 == pieces.size()) {
          Piece& last = pieces[k];
          last.points[last.kind == PieceKind::cubic ? 3 : last.kind == PieceKind::quadratic ? 2 : 1] = chain.start();
        }
        append(ring, pieces[k]);
      }
      ring.close();
      chain = std::move(ring);
    }
    out.push_back(std::move(chain));
  }
  return out;
}

}  // namespace mes
