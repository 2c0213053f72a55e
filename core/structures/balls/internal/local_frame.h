// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates in which the pipelines compute: near the data, in units of their size. Results then depend neither on the
// position of the data nor on the unit of length.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"
#include "core/base/power_of_two.h"

namespace mes {

/// document = origin + 2^exponent * local. Conversion into the frame is exact for the numbers it was made for.
struct LocalFrame {
  Vec2 origin{};
  int exponent = 0;

  Vec2 to_local(Vec2 p) const { return {to_local_length(p.x - origin.x), to_local_length(p.y - origin.y)}; }
  double to_local_length(double length) const { return times_power_of_two(length, -exponent); }
  Vec2 to_document(Vec2 p) const { return origin + vector_to_document(p); }
  Vec2 vector_to_document(Vec2 v) const { return {to_document_length(v.x), to_document_length(v.y)}; }
  double to_document_length(double length) const { return times_power_of_two(length, exponent); }
};

/// Length of a vector in a frame. Its square leaves the range of doubles only if it is small, so this needs less care
/// than `length`.
inline double local_length(Vec2 v) {
  const double square = dot(v, v);
  return square > 0x1p-900 ? std::sqrt(square) : length(v);
}

/// Collects the numbers that a frame has to hold.
class FrameExtent {
 public:
  /// A position that must stay exact.
  void add_position(Vec2 p) {
    positions_.add(p);
    note_magnitude(p.x);
    note_magnitude(p.y);
  }
  /// A length that must stay exact.
  void add_length(double length) {
    longest_ = std::max(longest_, std::abs(length));
    note_magnitude(length);
  }
  /// A computed object, such as a circumcircle: it may be rounded, but must not overflow.
  void add_derived(const Disk& disk) {
    derived_.add(disk.center);
    longest_ = std::max(longest_, disk.radius);
  }
  void add(const FrameExtent& other) {
    positions_.add(other.positions_);
    derived_.add(other.derived_);
    longest_ = std::max(longest_, other.longest_);
    smallest_ = std::min(smallest_, other.smallest_);
  }
  LocalFrame frame() const {
    LocalFrame out;
    if (positions_.is_empty()) return out;
    out.origin = {origin_within(positions_.low.x, positions_.high.x),
                  origin_within(positions_.low.y, positions_.high.y)};
    // Halved, because distances of doubles need not be doubles.
    double half = 0.5 * longest_;
    for (const Box2& box : {positions_, derived_}) {
      if (box.is_empty()) continue;
      for (const Vec2 corner : {box.low, box.high})
        half = std::max(
            {half, std::abs(0.5 * corner.x - 0.5 * out.origin.x), std::abs(0.5 * corner.y - 0.5 * out.origin.y)});
    }
    if (!(half > 0.0)) return out;
    // No bit of a number may fall below the range of doubles, but keeping the largest within it takes precedence.
    const int size = std::ilogb(half) + 2;
    const int most = std::ilogb(smallest_) - std::numeric_limits<double>::min_exponent + 1;
    out.exponent = std::max(std::min(size, most), size - kLargestLocal);
    return out;
  }

 private:
  static constexpr int kLargestLocal = 200;

  // If numbers have one sign and none is more than twice as large as another, their differences are exact (Sterbenz).
  // Otherwise the data are not far from zero compared with their size.
  static double origin_within(double low, double high) {
    const bool is_far = (low > 0.0 && 0.5 * high <= low) || (high < 0.0 && 0.5 * low >= high);
    return is_far ? std::midpoint(low, high) : 0.0;
  }
  void note_magnitude(double x) {
    if (x != 0.0) smallest_ = std::min(smallest_, std::abs(x));
  }
  Box2 positions_;
  Box2 derived_;
  double longest_ = 0.0;
  double smallest_ = std::numeric_limits<double>::max();
};

}  // namespace mes
