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
std::vector<Bead> beads_of(const CenterLine& line, const AxisByLength& axis, const SmoothingTolerance& tolerance) {
  constexpr double kFinest = 1e-6;
  const double whole = axis.length();
  std::vector<Bead> out;
  bool was_free = line.is_closed;
  for (double along = 0.0;;) {
    const AxisByLength::Place at = axis.at(along);
    const double radius = axis.radius(at);
    const double allowed = tolerance.share > 0.0 ? tolerance.share * radius : tolerance.length;
    const double step = std::min(0.125 * radius, allowed);
    const bool is_free = step >= kFinest * whole;
    out.push_back({at.place, along, is_free && was_free ? 0.5 * std::min(allowed, radius) : 0.0});
    was_free = is_free;
    along = is_free ? along + step : axis.start_of(at.piece + 1);
    if (!(along < whole)) break;
  }
  // The ends of an open line stay. Those of a closed line are one bead, which moves if the last step allows it.
  out.push_back({line.axis.back(), whole, line.is_closed && was_free ? out.front().reach : 0.0});
  out.front().reach = out.back().reach;
  for (std::size_t i = 0; i + 1 < out.size(); ++i) {
    const double behind = i != 0 ? out[i].along - out[i - 1].along : whole - out[out.size() - 2].along;
    out[i].part = behind / (behind + (out[i + 1].along - out[i].along));
  }
  return out;
}

/// One pass over all beads: each moves by a share of the way to the point between its neighbours.
void move_beads(const std::vector<Bead>& beads, bool is_closed, double share, std::vector<Vec2>& places) {
  const std::size_t n = beads.size();
  const std::vector<Vec2> before = places;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Bead& bead = beads[i];
    if (bead.reach == 0.0) continue;
    const std::size_t last = i != 0 ? i - 1 : (is_closed ? n - 2 : 0);
    const Vec2 between = (1.0 - bead.part) * before[last] + bead.part * before[i + 1];
    Vec2 move = before[i] + share * (between - before[i]) - bead.center;
    if (std::abs(move.x) + std::abs(move.y) > bead.reach)
      if (const double size = length(move); size > bead.reach) move = (bead.reach / size) * move;
    places[i] = bead.center + move;
  }
  if (is_closed) places.back() = places.front();
}

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

// Taubin's smoothing: steps forwards and slightly larger ones back, which keep waves of 26 beads and more and do not
// shrink bends. Waves of half that length are left with a third of their height, and shorter ones with nothing.
void smooth(CenterLine& line, const SmoothingTolerance& tolerance, const std::array<std::optional<Vec2>, 2>& ends) {
  constexpr int kPasses = 500;
  constexpr double kForwards = 0.5;
  constexpr double kBackwards = -0.5076;
  if (!(tolerance.length > 0.0) && !(tolerance.share > 0.0)) return;
  const AxisByLength axis(line);
  const std::vector<Bead> beads = beads_of(line, axis, tolerance);
  std::vector<Vec2> places;
  for (const Bead& bead : beads) places.push_back(bead.center);
  places.front() = ends[0].value_or(places.front());
  places.back() = ends[1].value_or(places.back());
  for (int pass = 0; pass < kPasses; ++pass) {
    move_beads(beads, line.is_closed, kForwards, places);
    move_beads(beads, line.is_closed, kBackwards, places);
  }
  line.points.clear();
  for (std::size_t i = 0; i < beads.size(); ++i) line.points.push_back({places[i], beads[i].along});
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
