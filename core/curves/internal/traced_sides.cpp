// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/traced_sides.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mes {
namespace {

/// Parameter change along a few grid steps.
double slack_of(const FlatSide& side) {
  const double size = length(as_vec(side.to) - as_vec(side.from));
  return std::min(2.0 * kOnSide / size, 0.25) * (side.end - side.begin);
}

struct Crossing {
  double one = 0.0;
  double other = 0.0;
};

/// Newton's method from two parameters; returns nothing if it moves farther than `most` or does not converge.
std::optional<Crossing> crossing_near(const Piece& a, const Piece& b, Crossing at, Crossing most) {
  const Crossing first = at;
  Vec2 gap = a.at(at.one) - b.at(at.other);
  for (int i = 0; i < 30; ++i) {
    const Vec2 along_a = a.derivative(at.one);
    const Vec2 along_b = b.derivative(at.other);
    const double area = cross(along_a, along_b);
    if (area == 0.0) return std::nullopt;
    const Crossing step{cross(gap, along_b) / area, cross(gap, along_a) / area};
    at = {at.one - step.one, at.other - step.other};
    if (!(std::abs(at.one - first.one) <= most.one) || !(std::abs(at.other - first.other) <= most.other))
      return std::nullopt;
    if (at.one < 0.0 || at.one > 1.0 || at.other < 0.0 || at.other > 1.0) {
      // Rounding may move a crossing beyond the end of a piece.
      constexpr double kRounding = 1e-9;
      if (at.one < -kRounding || at.one > 1.0 + kRounding || at.other < -kRounding || at.other > 1.0 + kRounding)
        return std::nullopt;
      at = {std::clamp(at.one, 0.0, 1.0), std::clamp(at.other, 0.0, 1.0)};
    }
    gap = a.at(at.one) - b.at(at.other);
    constexpr double kArrived = 1e-14;
    if (std::abs(step.one) <= kArrived && std::abs(step.other) <= kArrived) return at;
  }
  // Rounding may prevent the last step from vanishing.
  const double size = length(a.at(at.one)) + length(b.at(at.other));
  return length(gap) <= 1e-12 * size ? std::optional(at) : std::nullopt;
}

/// Largest distance between a crossing of curves and that of their polygons: a few sides.
double reach_of(const TracedRun& run) {
  return 3.0 * run.step;
}

bool is_at_end(double parameter) {
  return parameter == 0.0 || parameter == 1.0;
}

/// Moves a parameter close to an end onto that end.
void snap(double& parameter, double slack) {
  if (parameter <= slack) parameter = 0.0;
  if (parameter >= 1.0 - slack) parameter = 1.0;
}

Piece backwards(Piece piece) {
  const std::size_t last = piece.kind == PieceKind::cubic ? 3 : piece.kind == PieceKind::quadratic ? 2 : 1;
  std::reverse(piece.points.begin(), piece.points.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  piece.arc.start += piece.arc.sweep;
  piece.arc.sweep = -piece.arc.sweep;
  return piece;
}

}  // namespace

SideTracer::Corner SideTracer::corner_at(ClipperPoint place) const {
  Corner out{place, subject_.sides_at(place), {}};
  if (region_ != nullptr) out.region = region_->sides_at(place);
  return out;
}

/// The run that continues the previous one if possible, else the nearest run.
TracedRun SideTracer::run_between(const Corner& from, const Corner& to, const TracedRun* before) const {
  TracedRun best;
  double best_distance = 0.0;
  for (const FlatCurves* curves : {&subject_, region_}) {
    if (curves == nullptr || best.of != nullptr) continue;
    const std::vector<SideAt>& begins = curves == &subject_ ? from.subject : from.region;
    const std::vector<SideAt>& ends = curves == &subject_ ? to.subject : to.region;
    for (const SideAt& begin : begins)
      for (const SideAt& end : ends) {
        if (begin.side != end.side || begin.parameter == end.parameter) continue;
        const FlatSide& side = curves->side(begin.side);
        TracedRun run{curves, side.piece, begin.parameter, end.parameter, side.end - side.begin};
        const double slack = slack_of(side);
        snap(run.begin, slack);
        snap(run.end, slack);
        const bool goes_on = before != nullptr && before->of == curves && before->piece == side.piece &&
                             before->is_backwards() == run.is_backwards() &&
                             std::abs(before->end - run.begin) <= slack;
        const double distance = goes_on ? -1.0 : begin.distance + end.distance;
        if (best.of != nullptr && distance >= best_distance) continue;
        best = run;
        best_distance = distance;
      }
  }
  best.to = subject_.place_of(to.place);
  return best;
}

std::vector<TracedRun> SideTracer::runs_along(const std::vector<Corner>& corners, bool is_closed) const {
  std::vector<TracedRun> all;
  const std::size_t sides = is_closed ? corners.size() : corners.size() - 1;
  for (std::size_t i = 0; i < sides; ++i)
    all.push_back(run_between(corners[i], corners[(i + 1) % corners.size()], all.empty() ? nullptr : &all.back()));
  const auto goes_on = [](const TracedRun& before, const TracedRun& run) {
    if (before.of == nullptr || before.of != run.of || before.piece != run.piece) return false;
    constexpr double kSame = 1e-6;
    return before.is_backwards() == run.is_backwards() && !is_at_end(run.begin) &&
           std::abs(before.end - run.begin) <= kSame;
  };
  if (is_closed) {
    std::size_t first = 0;
    while (first < all.size() && goes_on(all[(first + all.size() - 1) % all.size()], all[first])) ++first;
    if (first < all.size()) std::ranges::rotate(all, all.begin() + static_cast<std::ptrdiff_t>(first));
  }
  std::vector<TracedRun> out;
  for (const TracedRun& run : all) {
    if (!out.empty() && goes_on(out.back(), run)) {
      out.back().end = run.end;
      out.back().step = std::max(out.back().step, run.step);
      out.back().to = run.to;
    } else {
      out.push_back(run);
    }
  }
  return out;
}

/// Finds the point where one run becomes the next: the end of a piece, or the crossing of two pieces.
void SideTracer::meet(TracedRun& one, TracedRun& next) const {
  if (one.of != nullptr && is_at_end(one.end)) {
    one.to = one.of->piece(one.piece).at(one.end);
  } else if (next.of != nullptr && is_at_end(next.begin)) {
    one.to = next.of->piece(next.piece).at(next.begin);
  } else if (one.of != nullptr && next.of != nullptr && (one.of != next.of || one.piece != next.piece)) {
    const Piece& a = one.of->piece(one.piece);
    const Piece& b = next.of->piece(next.piece);
    const Crossing most{reach_of(one), reach_of(next)};
    if (const auto found = crossing_near(a, b, {one.end, next.begin}, most)) {
      const bool keeps_one = (found->one < one.begin) == one.is_backwards() && found->one != one.begin;
      const bool keeps_next = (next.end < found->other) == next.is_backwards() && found->other != next.end;
      if (keeps_one && keeps_next) {
        one.end = found->one;
        next.begin = found->other;
      }
    }
    one.to = a.at(one.end);
  } else if (one.of != nullptr) {
    one.to = one.of->piece(one.piece).at(one.end);
  } else if (next.of != nullptr) {
    one.to = next.of->piece(next.piece).at(next.begin);
  }
}

TracedPath SideTracer::closed(const GridPath& path) const {
  std::vector<Corner> corners;
  for (const ClipperPoint p : path) corners.push_back(corner_at(p));
  TracedPath out;
  out.runs = runs_along(corners, true);
  for (std::size_t i = 0; i < out.runs.size(); ++i) meet(out.runs[i], out.runs[(i + 1) % out.runs.size()]);
  if (!out.runs.empty()) out.start = out.runs.back().to;
  return out;
}

Vec2 SideTracer::end_at_region(TracedRun& run, bool at_its_end, ClipperPoint place, double reach) const {
  if (run.of == nullptr) return subject_.place_of(place);
  double& parameter = at_its_end ? run.end : run.begin;
  const Piece& piece = run.of->piece(run.piece);
  if (is_at_end(parameter) || region_ == nullptr) return piece.at(parameter);
  std::optional<Crossing> best;
  const auto away = [&](const Crossing& crossing) { return std::abs(crossing.one - parameter); };
  for (const SideAt& side : region_->sides_at(place, reach)) {
    const FlatSide& its = region_->side(side.side);
    const Crossing most{reach_of(run), 3.0 * (its.end - its.begin)};
    const auto found = crossing_near(piece, region_->piece(its.piece), {parameter, side.parameter}, most);
    if (found && (!best || away(*found) < away(*best))) best = found;
  }
  if (best && best->one != (at_its_end ? run.begin : run.end)) parameter = best->one;
  return piece.at(parameter);
}

TracedPath SideTracer::open(const GridPath& path, double reach) const {
  std::vector<Corner> corners;
  for (const ClipperPoint p : path) corners.push_back({p, subject_.sides_at(p), {}});
  TracedPath out;
  if (corners.size() < 2) return out;
  out.runs = runs_along(corners, false);
  for (std::size_t i = 0; i + 1 < out.runs.size(); ++i) meet(out.runs[i], out.runs[i + 1]);
  out.start = end_at_region(out.runs.front(), false, path.front(), reach);
  out.runs.back().to = end_at_region(out.runs.back(), true, path.back(), reach);
  return out;
}

std::optional<std::uint32_t> whole_curve(const TracedPath& path, const FlatCurves& subject) {
  std::vector<std::uint32_t> pieces;
  for (const TracedRun& run : path.runs) {
    if (run.of != &subject || !run.is_whole()) return std::nullopt;
    pieces.push_back(run.piece);
  }
  std::ranges::sort(pieces);
  if (!subject.is_first(pieces.front()) || !subject.is_last(pieces.back())) return std::nullopt;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i] != pieces[0] + i || (i > 0 && subject.is_first(pieces[i]))) return std::nullopt;
  return subject.curve_of(pieces.front());
}

PlaneCurve curve_of(const TracedPath& path, bool closes) {
  PlaneCurve out(path.start);
  for (const TracedRun& run : path.runs) {
    if (run.to == out.end() && (run.of == nullptr || run.begin == run.end)) continue;
    if (run.of == nullptr || run.begin == run.end) {
      out.line_to(run.to);
      continue;
    }
    const Piece& whole = run.of->piece(run.piece);
    Piece piece = run.is_whole() ? whole : whole.part(std::min(run.begin, run.end), std::max(run.begin, run.end));
    if (run.is_backwards()) piece = backwards(piece);
    piece.points[piece.kind == PieceKind::cubic ? 3 : piece.kind == PieceKind::quadratic ? 2 : 1] = run.to;
    out.add(piece);
  }
  if (closes) out.close();
  return out;
}

}  // namespace mes
