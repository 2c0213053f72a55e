// SPDX-License-Identifier: GPL-3.0-or-later
// A curve through nodes, with circular arcs between them. Private to core/raster.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

inline double size_of(Vec2 v) {
  return std::sqrt(dot(v, v));  // pixel coordinates neither overflow nor underflow
}

/// The parabola between two nodes that is nearest to the circle with their mean curvature.
struct Chord {
  Vec2 from{};
  Vec2 along{};  // unit vector
  double size = 0.0;
  double bulge = 0.0;  // tangent of a quarter of the turn, to the left
  double bend = 0.0;   // curvature at both ends
  double next_bend = 0.0;

  /// Distance of the curve to the left of the chord.
  double beside(double t) const { return -2.0 * t * (1.0 - t) * size * bulge; }
  Vec2 at(double t) const { return from + (t * size) * along + beside(t) * perpendicular(along); }
};

/// All chords, with the curvature of the circle through each node and its neighbours.
class NodeCurve {
 public:
  NodeCurve() = default;
  NodeCurve(std::span<const Vec2> nodes, bool is_closed) { reset(nodes, is_closed); }

  void reset(std::span<const Vec2> nodes, bool is_closed) {
    is_closed_ = is_closed;
    chords_.resize(is_closed ? nodes.size() : nodes.size() - 1);
    bends_.resize(nodes.size());
    renew(nodes, 0, nodes.size());
  }

  /// Updates the curve after `moved` successive nodes have moved, cyclically if it is closed.
  void renew(std::span<const Vec2> nodes, std::size_t first, std::size_t moved);

  const std::vector<Chord>& chords() const { return chords_; }
  double curvature(std::size_t k) const { return bends_[k]; }
  /// The normal of the circle through the node and its neighbours; at both ends of an open curve that of the chord.
  Vec2 normal(std::size_t k) const;

 private:
  const Chord& before(std::size_t k) const { return chords_[k > 0 ? k - 1 : chords_.size() - 1]; }

  bool is_closed_ = false;
  std::vector<Chord> chords_;
  std::vector<double> bends_;  // curvature at the nodes, to the left
};

double length_of(std::span<const Vec2> nodes, bool is_closed);

/// Resamples the curve to `count` equally spaced nodes.
std::vector<Vec2> respaced(std::span<const Vec2> nodes, bool is_closed, std::size_t count);

}  // namespace mes
