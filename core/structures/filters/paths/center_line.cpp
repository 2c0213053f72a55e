// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/paths/center_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/geometry/angle.h"
#include "core/base/sum.h"

namespace mes {
namespace {

Vec2 nearest_on_segment(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 along = b - a;
  const double size = dot(along, along);
  return size > 0.0 ? a + std::clamp(dot(p - a, along) / size, 0.0, 1.0) * along : a;
}

/// The axis by arc length.
class AxisByLength {
 public:
  explicit AxisByLength(const CenterLine& line) : line_(line) {
    Sum length;
    for (std::size_t i = 0; i < line.axis.size(); ++i) {
      if (i != 0) length.add(distance(line.axis[i - 1], line.axis[i]));
      lengths_.push_back(length.value());
    }
  }

  double length() const { return lengths_.back(); }
  struct Place {
    std::size_t piece = 0;
    Vec2 place{};
  };
  Place at(double along) const {
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, along);
    const auto piece = static_cast<std::size_t>(after - lengths_.begin()) - 1;
    const double whole = lengths_[piece + 1] - lengths_[piece];
    const double share = whole > 0.0 ? std::clamp((along - lengths_[piece]) / whole, 0.0, 1.0) : 0.0;
    return {piece, (1.0 - share) * line_.axis[piece] + share * line_.axis[piece + 1]};
  }
  double radius(const Place& at) const { return radius_at(line_.banks[at.piece][0], at.place); }
  double start_of(std::size_t piece) const { return lengths_[piece]; }

 private:
  const CenterLine& line_;
  std::vector<double> lengths_;
};

/// A point of the line that is being smoothed.
struct Bead {
  Vec2 center{};       // on the axis
  double along = 0.0;  // arc length of the axis there
  double reach = 0.0;  // how far it may move
  double part = 0.0;   // of the way along the axis from the bead before to the next
};

// Beads are at most an eighth of the radius apart, and no farther than the tolerance t; each moves by at most half of
// either t or the radius r. Let d be the distance to the next bead: its reach is at most (r + d) / 2, since radii change
// no faster than places. So it stays within (r + d) / 2 + d <= 11/16 r of this bead's centre, and so does the piece
// between them. The axis between two beads is within d / 2 of their chord, and the line within t / 2 of that.
// Where radii are very small, beads are the points of the axis itself and do not move.
class BeadWalk {
 public:
  BeadWalk(const CenterLine& line, const AxisByLength& axis, const SmoothingTolerance& tolerance)
      : line_(line), axis_(axis), tolerance_(tolerance) {}

  /// The last step of the usual size would lead beyond the end. One that is shorter than the others would bend the line
  /// as it is smoothed, so all steps are made shorter by the same factor where one is found.
  std::vector<Bead> beads() const {
    constexpr int kTries = 8;
    constexpr double kEqual = 1e-9;
    std::vector<Bead> usual = walk(1.0, std::nullopt);
    const std::size_t steps = usual.size() - 1;
    double factor = axis_.length() / usual.back().along;
    usual.back().along = axis_.length();
    for (int i = 0; i < kTries; ++i) {
      std::vector<Bead> even = walk(factor, steps);
      const double left = axis_.length() / even.back().along;
      factor = std::min(1.0, factor * left);
      if (std::abs(left - 1.0) > kEqual || !(even[steps - 1].along < axis_.length())) continue;
      even.back().along = axis_.length();
      return finished(std::move(even));
    }
    return finished(std::move(usual));
  }

 private:
  /// So many steps, or as many as lead to the end of the axis or beyond.
  std::vector<Bead> walk(double factor, std::optional<std::size_t> steps) const {
    constexpr double kFinest = 1e-6;
    const double whole = axis_.length();
    std::vector<Bead> out;
    bool was_free = line_.is_closed;
    double along = 0.0;
    while (steps ? out.size() < *steps : along < whole) {
      const AxisByLength::Place at = axis_.at(along);
      const double radius = axis_.radius(at);
      const double allowed = tolerance_.share > 0.0 ? tolerance_.share * radius : tolerance_.length;
      const double step = factor * std::min(0.125 * radius, allowed);
      const bool is_free = step >= kFinest * whole;
      out.push_back({at.place, along, is_free && was_free ? 0.5 * std::min(allowed, radius) : 0.0});
      was_free = is_free;
      along = is_free ? along + step : axis_.start_of(at.piece + 1);
    }
    out.push_back({line_.axis.back(), along, line_.is_closed && was_free ? out.front().reach : 0.0});
    return out;
  }
  /// The ends of an open line stay. Those of a closed line are one bead, which moves if the last step allows it.
  std::vector<Bead> finished(std::vector<Bead> beads) const {
    const std::size_t last = beads.size() - 1;
    beads.front().reach = beads.back().reach;
    for (std::size_t i = 0; i < last; ++i) {
      const double behind = i != 0 ? beads[i].along - beads[i - 1].along : beads[last].along - beads[last - 1].along;
      beads[i].part = behind / (behind + (beads[i + 1].along - beads[i].along));
    }
    return beads;
  }

  const CenterLine& line_;
  const AxisByLength& axis_;
  const SmoothingTolerance& tolerance_;
};

/// The beads of a line as they are smoothed. Differences are half of what separates a bead from the point between its
/// neighbours, so a wave of k beads is multiplied by y = (1 - cos(2 pi / k)) / 2.
class BeadLine {
 public:
  BeadLine(const std::vector<Bead>& beads, bool is_closed, const std::array<std::optional<Vec2>, 2>& ends)
      : beads_(beads), is_closed_(is_closed) {
    for (const Bead& bead : beads) places_.push_back(bead.center);
    places_.front() = ends[0].value_or(places_.front());
    places_.back() = ends[1].value_or(places_.back());
  }

  const std::vector<Vec2>& places() const { return places_; }

  /// Multiplies each wave by (1 - y)^12 (1 + 12 y + 78 y^2), which is 1 up to a multiple of y^3, and moves beads back
  /// into their reach. Returns the largest move as a share of the reach.
  double smooth() {
    before_ = places_;
    take_differences(places_, first_);
    take_differences(first_, second_);
    for (std::size_t i = 0; i < places_.size(); ++i) places_[i] = places_[i] + 12.0 * first_[i] + 78.0 * second_[i];
    for (int step = 0; step < 12; ++step) {
      take_differences(places_, first_);
      for (std::size_t i = 0; i < places_.size(); ++i) places_[i] = places_[i] - first_[i];
    }
    return hold_back();
  }

 private:
  void take_differences(const std::vector<Vec2>& of, std::vector<Vec2>& out) const {
    const std::size_t last = of.size() - 1;
    out.resize(of.size());
    out[0] = is_closed_ ? difference(0, of[last - 1], of[0], of[1]) : Vec2{};
    for (std::size_t i = 1; i < last; ++i) out[i] = difference(i, of[i - 1], of[i], of[i + 1]);
    out[last] = out[0];
  }
  Vec2 difference(std::size_t bead, Vec2 left, Vec2 at, Vec2 right) const {
    const Bead& b = beads_[bead];
    if (b.reach == 0.0) return {};
    return 0.5 * (at - ((1.0 - b.part) * left + b.part * right));
  }
  double hold_back() {
    double out = 0.0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Bead& bead = beads_[i];
      if (bead.reach == 0.0) continue;
      const Vec2 away = places_[i] - bead.center;
      if (const double size = length(away); size > bead.reach) places_[i] = bead.center + (bead.reach / size) * away;
      out = std::max(out, distance(places_[i], before_[i]) / bead.reach);
    }
    return out;
  }

  const std::vector<Bead>& beads_;
  bool is_closed_;
  std::vector<Vec2> places_, before_, first_, second_;
};

}  // namespace

Vec2 foot_on(const Bank& bank, Vec2 place) {
  if (bank.center) {
    const Vec2 way = place - *bank.center;
    const double size = length(way);
    return size > 0.0 ? *bank.center + (distance(bank.sample, *bank.center) / size) * way : bank.sample;
  }
  const Vec2 a = nearest_on_segment(bank.sample, bank.neighbours[0], place);
  const Vec2 b = nearest_on_segment(bank.sample, bank.neighbours[1], place);
  return distance(a, place) <= distance(b, place) ? a : b;
}

double radius_at(const Bank& bank, Vec2 place) {
  return distance(bank.is_side ? foot_on(bank, place) : bank.sample, place);
}

void take_axis(CenterLine& line) {
  const AxisByLength axis(line);
  line.points.clear();
  for (std::size_t i = 0; i < line.axis.size(); ++i) line.points.push_back({line.axis[i], axis.start_of(i)});
}

double along_of(const CenterLine& line, std::size_t point) {
  return AxisByLength(line).start_of(point);
}

Vec2 join_at(CenterLine& line, double along) {
  const auto after = std::ranges::lower_bound(line.points, along, {}, &CenterLine::Point::along);
  if (after == line.points.end()) return line.points.back().place;
  if (after->along == along || after == line.points.begin()) return after->place;
  const CenterLine::Point& before = *(after - 1);
  const double share = (along - before.along) / (after->along - before.along);
  const Vec2 place = (1.0 - share) * before.place + share * after->place;
  line.points.insert(after, {place, along});
  return place;
}

// A filter that is maximally flat at long and at short waves (Herrmann 1971), so that circles keep their radius. After
// all rounds waves of 26 beads and more have kept 98 % of their height or more, waves of half that length 42 %, and those
// of a third nothing. Rounds end early when they move nothing: those that follow would move less.
void smooth(CenterLine& line, const SmoothingTolerance& tolerance, const std::array<std::optional<Vec2>, 2>& ends) {
  constexpr int kRounds = 20;
  constexpr double kStill = 0x1p-24;  // of the reach
  if (!(tolerance.length > 0.0) && !(tolerance.share > 0.0)) return;
  const AxisByLength axis(line);
  const std::vector<Bead> beads = BeadWalk(line, axis, tolerance).beads();
  BeadLine moved(beads, line.is_closed, ends);
  for (int round = 0; round < kRounds && moved.smooth() > kStill; ++round) {
  }
  line.points.clear();
  for (std::size_t i = 0; i < beads.size(); ++i) line.points.push_back({moved.places()[i], beads[i].along});
}

double length_of(const CenterLine& line) {
  Sum out;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    out.add(distance(line.points[i - 1].place, line.points[i].place));
  return out.value();
}

std::vector<Station> stations_of(const CenterLine& line, double spacing) {
  const AxisByLength axis(line);
  std::vector<Station> out;
  double from = 0.0;  // arc length of the line at the piece
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const CenterLine::Point& a = line.points[i - 1];
    const CenterLine::Point& b = line.points[i];
    const double piece = distance(a.place, b.place);
    const double to = from + piece;
    const bool is_last = i + 1 == line.points.size() && !line.is_closed;
    for (;;) {
      const double along = static_cast<double>(out.size()) * spacing;
      if (!(along < to || (is_last && along <= to)) || !(piece > 0.0)) break;
      const double share = std::clamp((along - from) / piece, 0.0, 1.0);
      Station& station = out.emplace_back();
      station.along = along;
      station.place = a.place + share * (b.place - a.place);
      const AxisByLength::Place at = axis.at(a.along + share * (b.along - a.along));
      station.axis = at.place;
      station.left = foot_on(line.banks[at.piece][0], at.place);
      station.right = foot_on(line.banks[at.piece][1], at.place);
      station.width = distance(station.left, at.place) + distance(station.right, at.place);
      const Vec2 way = b.place - a.place;
      station.direction = angle_of(way) * 180.0 / std::numbers::pi;
      if (station.direction < 0.0) station.direction += 360.0;
      if (!(station.direction < 360.0)) station.direction = 0.0;
    }
    from = to;
  }
  return out;
}

std::vector<double> radii_of(const CenterLine& line) {
  const AxisByLength axis(line);
  std::vector<double> out;
  out.reserve(line.points.size());
  for (const CenterLine::Point& point : line.points) {
    const auto& [left, right] = line.banks[axis.at(point.along).piece];
    out.push_back(std::min(distance(foot_on(left, point.place), point.place),
                           distance(foot_on(right, point.place), point.place)));
  }
  return out;
}

Widths widths_of(const CenterLine& line) {
  Widths out{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  Sum length;
  for (std::size_t i = 0; i + 1 < line.axis.size(); ++i) length.add(distance(line.axis[i], line.axis[i + 1]));
  Sum mean;
  const auto width_at = [](const std::array<Bank, 2>& banks, Vec2 at) {
    return distance(foot_on(banks[0], at), at) + distance(foot_on(banks[1], at), at);
  };
  for (std::size_t i = 0; i + 1 < line.axis.size(); ++i) {
    const double a = width_at(line.banks[i], line.axis[i]);
    const double b = width_at(line.banks[i], line.axis[i + 1]);
    // Products of two lengths may overflow.
    const double share = distance(line.axis[i], line.axis[i + 1]) / length.value();
    out.least = std::min({out.least, a, b});
    out.largest = std::max({out.largest, a, b});
    mean.add(share * (0.5 * a + 0.5 * b));
  }
  out.mean = std::clamp(mean.value(), out.least, out.largest);
  return out;
}

}  // namespace mes
