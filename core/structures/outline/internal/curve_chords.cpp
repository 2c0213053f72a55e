// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/internal/curve_chords.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "core/curves/joined_ends.h"
#include "core/structures/outline/internal/outline_pieces.h"
#include "core/structures/outline/internal/side_geometry.h"

namespace mes {

/// An arc of a circle, in parts that end where other curves do.
struct CurveChords::Arc {
  std::size_t piece = 0;
  Piece whole;
  std::vector<std::pair<double, Vec2>> cuts{};  // by parameter
  std::vector<Piece> parts{};
  bool is_shared = false;  // its chords are made anew, from its parts
};

namespace {

/// The parameter of a point of the circle, which lies beyond 1 unless the point is on the arc.
double parameter_on(const EllipticArc& arc, Vec2 p) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double sweep = arc.sweep < 0.0 ? arc.start - angle_on(arc, p) : angle_on(arc, p) - arc.start;
  return (sweep - kTurn * std::floor(sweep / kTurn)) / std::abs(arc.sweep);
}

/// The parts of an arc between cuts that are in order.
std::vector<Piece> parts_between(const Piece& whole, std::span<const std::pair<double, Vec2>> cuts) {
  std::vector<Piece> out;
  double begin = 0.0;
  Vec2 from = whole.from();
  const auto add = [&](double end, Vec2 to) {
    Piece part = whole.part(begin, end);
    part.points[0] = std::exchange(from, to);
    part.points[1] = to;
    out.push_back(part);
    begin = end;
  };
  for (const auto& [parameter, point] : cuts) add(parameter, point);
  add(1.0, whole.to());
  return out;
}

}  // namespace

CurveChords::CurveChords(std::span<const PlaneCurve> curves, double tolerance, JobControl& job) {
  std::vector<Arc> arcs;
  for_each_outline(curves, [&](const PlaneCurve& /*curve*/, std::span<const Piece> pieces) {
    for (const Piece& piece : pieces) {
      starts_.push_back(piece.from());
      add_chords_of(piece, tolerance, chords_);
      if (chords_.back().is_arc) arcs.push_back({.piece = ends_.size(), .whole = piece});
      ends_.push_back(chords_.size());
    }
  });
  if (arcs.size() > 1) {
    split_at_ends(arcs, job);
    unite_shared_parts(arcs, least_height(sides()));
    replace_chords_of(arcs, tolerance);
  }
  // Chords of curves that touch cross near the point, and those of a thin lens are the same. Each round halves them.
  constexpr int kMostRounds = 64;
  constexpr std::size_t kFew = 4096;
  const std::size_t most = 8 * chords_.size() + kFew;
  for (int round = 0; round < kMostRounds && chords_.size() <= most && refine(job); ++round) {
  }
}

std::span<const OutlineChord> CurveChords::next() {
  const std::size_t begin = next_ == 0 ? 0 : ends_[next_ - 1];
  const std::size_t end = ends_[next_++];
  return std::span(chords_).subspan(begin, end - begin);
}

std::vector<OutlineSide> CurveChords::sides() const {
  std::vector<OutlineSide> out;
  out.reserve(chords_.size());
  for (std::size_t piece = 0; piece < starts_.size(); ++piece) {
    Vec2 at = starts_[piece];
    for (std::size_t i = piece == 0 ? 0 : ends_[piece - 1]; i < ends_[piece]; ++i) {
      const auto [from, to] = std::minmax(at, chords_[i].to, lexicographically_less);
      out.push_back({.from = from, .to = to, .center = chords_[i].center});
      at = chords_[i].to;
    }
  }
  return out;
}

void CurveChords::split_at_ends(std::vector<Arc>& arcs, JobControl& job) const {
  const std::vector<OutlineSide> all = sides();
  const double least = least_height(all);
  std::vector<OutlineSide> chords;
  std::vector<std::size_t> arc_of;
  for (std::size_t k = 0; k < arcs.size(); ++k)
    for (std::size_t i = arcs[k].piece == 0 ? 0 : ends_[arcs[k].piece - 1]; i < ends_[arcs[k].piece]; ++i) {
      chords.push_back(all[i]);
      arc_of.push_back(k);
    }
  std::vector<Vec2> points = starts_;
  for (const std::size_t end : ends_) points.push_back(chords_[end - 1].to);
  std::ranges::sort(points, lexicographically_less);
  const auto repeats = std::ranges::unique(points);
  points.erase(repeats.begin(), repeats.end());

  const BoxTree<std::uint32_t> tree = tree_of(chords);
  std::vector<std::size_t> found;  // arcs near a point
  for (std::size_t k = 0; k < points.size(); ++k) {
    constexpr std::size_t kOften = 4096;
    if (k % kOften == 0) job.checkpoint();
    const Vec2 p = points[k];
    found.clear();
    tree.visit_where([p](const Box2& box, double) { return box.contains(p); },
                     [&](std::uint32_t i) {
                       if (is_on_circle(p, chords[i], least)) found.push_back(arc_of[i]);
                     });
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    for (const std::size_t arc : found) {
      const double parameter = parameter_on(arcs[arc].whole.arc, p);
      if (parameter < 1.0) arcs[arc].cuts.emplace_back(parameter, p);
    }
  }
  for (Arc& arc : arcs) {
    std::ranges::sort(arc.cuts, {}, &std::pair<double, Vec2>::first);
    Vec2 before = arc.whole.from();
    std::erase_if(arc.cuts, [&](const auto& cut) {
      if (distance(cut.second, before) <= least || distance(cut.second, arc.whole.to()) <= least) return true;
      before = cut.second;
      return false;
    });
    arc.is_shared = !arc.cuts.empty();
    arc.parts = parts_between(arc.whole, arc.cuts);
  }
}

void CurveChords::unite_shared_parts(std::vector<Arc>& arcs, double least) {
  struct Part {
    Piece forwards;  // from its lexicographically smaller end
    Arc* arc;
    std::size_t number;
  };
  std::vector<Part> parts;
  for (Arc& arc : arcs)
    for (std::size_t i = 0; i < arc.parts.size(); ++i) {
      const Piece& part = arc.parts[i];
      if (part.from() == part.to()) continue;
      const bool is_forwards = lexicographically_less(part.from(), part.to());
      parts.push_back({is_forwards ? part : reversed(part), &arc, i});
    }
  const auto place = [](const Part& part) {
    const auto& [from, to, second, third] = part.forwards.points;
    return std::tuple(from.x, from.y, to.x, to.y);
  };
  std::ranges::sort(parts, {}, [&](const Part& part) {
    const EllipticArc& arc = part.forwards.arc;
    return std::tuple(place(part), arc.center.x, arc.center.y);
  });
  for (std::size_t begin = 0, i = 0; i < parts.size(); ++i) {
    if (place(parts[i]) != place(parts[begin])) begin = i;
    const Vec2 middle = parts[i].forwards.at(0.5);
    for (std::size_t k = begin; k < i; ++k) {
      if (distance(parts[k].forwards.at(0.5), middle) > least) continue;
      parts[i].forwards = parts[k].forwards;
      Piece& part = parts[i].arc->parts[parts[i].number];
      part = part.from() == parts[k].forwards.from() ? parts[k].forwards : reversed(parts[k].forwards);
      parts[i].arc->is_shared = true;
      break;
    }
  }
}

void CurveChords::replace_chords_of(std::span<const Arc> arcs, double tolerance) {
  if (std::ranges::none_of(arcs, &Arc::is_shared)) return;
  std::vector<OutlineChord> out;
  std::size_t begin = 0;
  auto arc = arcs.begin();
  for (std::size_t piece = 0; piece < ends_.size(); ++piece) {
    const std::size_t end = ends_[piece];
    const bool is_arc = arc != arcs.end() && arc->piece == piece;
    if (is_arc && arc->is_shared)
      for (const Piece& part : arc->parts) add_chords_of(part, tolerance, out);
    else
      out.insert(out.end(), chords_.begin() + std::ptrdiff_t(begin), chords_.begin() + std::ptrdiff_t(end));
    if (is_arc) ++arc;
    begin = end;
    ends_[piece] = out.size();
  }
  chords_ = std::move(out);
}

bool CurveChords::refine(JobControl& job) {
  if (std::ranges::none_of(chords_, [](const OutlineChord& chord) { return chord.center.has_value(); })) return false;
  const std::vector<OutlineSide> all = sides();
  const double least = least_height(all);
  std::vector<bool> is_halved(all.size(), false);
  for_each_meeting(all, job, [&](std::uint32_t i, std::uint32_t j) {
    const OutlineSide& a = all[i];
    const OutlineSide& b = all[j];
    if ((!a.center && !b.center) || are_on_one_circle(a, b, least)) return true;
    const bool are_equal = a.from == b.from && a.to == b.to;
    const bool is_unclear = are_equal ? distance(middle_of(a), middle_of(b)) > least
                                      : cross_inside(a, b) && meeting_of(a, b, least) == Meeting::unclear;
    if (is_unclear || is_in_bow(b.from, a) || is_in_bow(b.to, a)) is_halved[i] = is_halved[i] || height_of(a) > least;
    if (is_unclear || is_in_bow(a.from, b) || is_in_bow(a.to, b)) is_halved[j] = is_halved[j] || height_of(b) > least;
    return true;
  });
  if (std::ranges::find(is_halved, true) == is_halved.end()) return false;
  std::vector<OutlineChord> finer;
  std::size_t piece = 0;
  for (std::size_t i = 0; i < chords_.size(); ++i) {
    for (; ends_[piece] == i; ++piece) ends_[piece] = finer.size();
    if (is_halved[i]) finer.push_back({middle_of(all[i]), chords_[i].center, chords_[i].is_arc});
    finer.push_back(chords_[i]);
  }
  for (; piece < ends_.size(); ++piece) ends_[piece] = finer.size();
  chords_ = std::move(finer);
  return true;
}

}  // namespace mes
