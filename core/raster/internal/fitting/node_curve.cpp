// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/fitting/node_curve.h"

#include <algorithm>

namespace mes {

void NodeCurve::renew(std::span<const Vec2> nodes, std::size_t first, std::size_t moved) {
  const auto each = [&](std::size_t before, std::size_t after, std::size_t size, auto use) {
    const std::size_t all = moved + before + after;
    if (!is_closed_) {
      for (std::size_t k = first - std::min(first, before); k < std::min(first + moved + after, size); ++k) use(k);
    } else {
      std::size_t k = (first + size - before % size) % size;
      for (std::size_t i = 0; i < std::min(all, size); ++i, k = k + 1 < size ? k + 1 : 0) use(k);
    }
  };
  const std::size_t count = nodes.size();
  each(1, 0, chords_.size(), [&](std::size_t k) {
    Chord& chord = chords_[k];
    const Vec2 along = nodes[k + 1 < count ? k + 1 : 0] - nodes[k];
    chord.from = nodes[k];
    chord.size = size_of(along);
    chord.along = chord.size > 0.0 ? (1.0 / chord.size) * along : Vec2{};
  });
  each(1, 1, count, [&](std::size_t k) {
    if (!is_closed_ && (k == 0 || k + 1 == count)) return;
    const Chord& in = before(k);
    const Chord& on = chords_[k];
    // The curvature of the circle through the node and its neighbours.
    const double across = size_of(in.size * in.along + on.size * on.along);
    bends_[k] = across > 0.0 ? 2.0 * cross(in.along, on.along) / across : 0.0;
  });
  if (!is_closed_) {
    bends_.front() = bends_[1];
    bends_.back() = bends_[count - 2];
  }
  each(3, 3, chords_.size(), [&](std::size_t k) {
    Chord& chord = chords_[k];
    chord.bend = bends_[k];
    chord.next_bend = bends_[k + 1 < count ? k + 1 : 0];
    const double sine = std::clamp(0.25 * (chord.bend + chord.next_bend) * chord.size, -1.0, 1.0);
    constexpr double kMostBulge = 0.4;
    chord.bulge = std::clamp(sine / (1.0 + std::sqrt(1.0 - sine * sine)), -kMostBulge, kMostBulge);
  });
}

Vec2 NodeCurve::normal(std::size_t k) const {
  if (!is_closed_ && k == 0) return perpendicular(chords_.front().along);
  if (!is_closed_ && k == chords_.size()) return perpendicular(chords_.back().along);
  const Vec2 along = chords_[k].size * before(k).along + before(k).size * chords_[k].along;
  return (1.0 / std::max(size_of(along), 1e-12)) * perpendicular(along);
}

double length_of(std::span<const Vec2> nodes, bool is_closed) {
  double out = 0.0;
  for (std::size_t k = 1; k < nodes.size(); ++k) out += size_of(nodes[k] - nodes[k - 1]);
  return is_closed ? out + size_of(nodes.front() - nodes.back()) : out;
}

std::vector<Vec2> respaced(std::span<const Vec2> nodes, bool is_closed, std::size_t count) {
  const NodeCurve curve(nodes, is_closed);
  const std::vector<Chord>& chords = curve.chords();
  double all = 0.0;
  for (const Chord& chord : chords) all += chord.size;
  std::vector<Vec2> out;
  out.reserve(count);
  std::size_t k = 0;
  double passed = 0.0;
  const double intervals = static_cast<double>(is_closed ? count : count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = all * (static_cast<double>(i) / intervals);
    while (k + 1 < chords.size() && passed + chords[k].size < wanted) passed += chords[k++].size;
    const double t = chords[k].size > 0.0 ? std::clamp((wanted - passed) / chords[k].size, 0.0, 1.0) : 0.0;
    out.push_back(chords[k].at(t));
  }
  return out;
}

}  // namespace mes
