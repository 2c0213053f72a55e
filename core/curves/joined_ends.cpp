// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/joined_ends.h"

#include <algorithm>
#include <array>
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
    pair_crossings();
  }

  /// The only other end at the same position, or else the only other end nearby; nothing if there are none or several.
  /// The search ends at the second, so many ends at one place cost no more than two.
  std::size_t partner_of(std::size_t end) const {
    return through_.empty() || through_[end] == kNone ? only_partner_of(end) : through_[end];
  }

 private:
  std::size_t only_partner_of(std::size_t end) const {
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

  /// All ends within the tolerance, itself included; more than `kMostAtCrossing` if so many are near, or not much
  /// farther away.
  std::vector<std::size_t> ends_near(std::size_t end) const {
    std::vector<std::size_t> out;
    constexpr std::size_t kMostCompared = 8 * kMostAtCrossing;
    std::size_t compared = 0;
    const Cell cell = cell_of(place_of(end));
    for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x)
      for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y) {
        const auto found = cells_.find(key_of(x, y));
        if (found == cells_.end()) continue;
        for (const std::size_t other : found->second) {
          if (distance(place_of(other), place_of(end)) <= tolerance_) out.push_back(other);
          if (++compared > kMostCompared) out.resize(kMostAtCrossing + 1);
          if (out.size() > kMostAtCrossing) return out;
        }
      }
    std::ranges::sort(out);
    return {out.begin(), std::ranges::unique(out).begin()};
  }

  /// How a curve leaves one of its ends.
  struct Departure {
    std::size_t end;
    Vec2 direction{};  // of length 1
    double curvature;  // positive to the left
    double size;       // over which it was measured
  };
  Departure departure_of(std::size_t end) const {
    Piece piece;
    bool is_first = true;
    curves_[end / 2].for_each_piece([&](const Piece& one) {
      if (is_first || end % 2 != 0) piece = one;
      is_first = false;
    });
    constexpr double kShare = 0.125;
    const Vec2 along = end % 2 == 0 ? piece.first_direction() : -piece.last_direction();
    const Vec2 way = piece.at(end % 2 == 0 ? kShare : 1.0 - kShare) - place_of(end);
    const double size = length(way);
    const double speed = length(along);
    if (!(size > 0.0) || !(speed > 0.0)) return {end, {}, 0.0, size};
    const Vec2 direction{along.x / speed, along.y / speed};
    return {end, direction, 2.0 * cross(direction, {way.x / size, way.y / size}) / size, size};
  }
  /// True if the turn from one curve to the other is at most a quarter.
  static bool goes_on(const Departure& a, const Departure& b) {
    constexpr double kRounded = 1e-9;
    return dot(a.direction, b.direction) <= kRounded && (a.direction != Vec2{} && b.direction != Vec2{});
  }

  /// Where an even number of ends meet, curves cross or touch. Each goes on most straight, if all do within a quarter
  /// of a turn, unless the only ends at the same positions do that already.
  void pair_crossings() {
    if (std::ranges::none_of(cells_, [](const auto& cell) { return cell.second.size() > 1; })) return;
    through_.assign(2 * curves_.size(), kNone);
    std::vector<bool> is_seen(through_.size());
    for (std::size_t end = 0; end < through_.size(); ++end) {
      if (is_seen[end] || curves_[end / 2].is_closed()) continue;
      is_seen[end] = true;
      const std::vector<std::size_t> group = ends_near(end);
      if (group.size() < 4 || group.size() > kMostAtCrossing || group.size() % 2 != 0) continue;
      if (!std::ranges::all_of(group, [&](std::size_t other) { return ends_near(other) == group; })) continue;
      for (const std::size_t other : group) is_seen[other] = true;
      pair_group(group);
    }
  }
  void pair_group(const std::vector<std::size_t>& group) {
    std::vector<Departure> out;
    double size = std::numeric_limits<double>::infinity();
    for (const std::size_t end : group) {
      out.push_back(departure_of(end));
      size = std::min(size, out.back().size);
    }
    const bool are_paired = std::ranges::all_of(out, [&](const Departure& one) {
      const std::size_t other = only_partner_of(one.end);
      const auto its = std::ranges::find(out, other, &Departure::end);
      return its != out.end() && only_partner_of(other) == one.end && goes_on(one, *its);
    });
    if (are_paired) return;
    struct Pair {
      double turn;
      std::size_t a;
      std::size_t b;
    };
    // A curve that touches another goes on where the bend is alike: its turn is measured a little way on.
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < out.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        if (out[a].end == (out[b].end ^ 1U) && !may_close(out[a].end / 2)) continue;
        if (!goes_on(out[a], out[b])) continue;
        const Vec2 sum = out[a].direction + out[b].direction;
        pairs.push_back({length(sum) + size * std::abs(out[a].curvature + out[b].curvature), b, a});
      }
    // Symmetric crossings have equal turns; the directions decide, since the order of the curves must not.
    const auto key = [&out](const Pair& one) {
      const Vec2 p = out[one.a].direction;
      const Vec2 q = out[one.b].direction;
      return lexicographically_less(p, q) ? std::array{p.x, p.y, q.x, q.y} : std::array{q.x, q.y, p.x, p.y};
    };
    std::ranges::sort(
        pairs, [&](const Pair& p, const Pair& q) { return p.turn != q.turn ? p.turn < q.turn : key(p) < key(q); });
    std::vector<std::size_t> partner(out.size(), kNone);
    for (const Pair& pair : pairs) {
      if (partner[pair.a] != kNone || partner[pair.b] != kNone) continue;
      partner[pair.a] = pair.b;
      partner[pair.b] = pair.a;
    }
    if (std::ranges::find(partner, kNone) != partner.end()) return;
    for (std::size_t i = 0; i < out.size(); ++i) through_[out[i].end] = out[partner[i]].end;
  }

  // More ends than these are a star, which stays apart.
  static constexpr std::size_t kMostAtCrossing = 64;

  const std::vector<PlaneCurve>& curves_;
  std::vector<std::size_t> through_;  ///< for each end, the one on which its curve goes on at a crossing
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

}  // namespace

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
