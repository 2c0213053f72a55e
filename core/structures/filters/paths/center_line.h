// SPDX-License-Identifier: GPL-3.0-or-later
// A line along the axis of a shape: smoothed inside the balls of the axis, and measured across.
//
// A *bank* is a piece of the boundary: a side or a vertex of an outline, or a sample and its two neighbours along the
// curve, as the crust has them. The *foot* of a point on a bank is the nearest point of that piece of the boundary.
//
// Guarantees of `smoothed`, with the tolerance t at each point of the axis:
//  1. Each point of the line lies within t of the axis, and each point of the axis within t of the line.
//  2. Each piece of the line between two of its points lies in a ball about a point of the axis, at least a quarter of
//     the radius away from the circle. So the line stays in the union of the inner balls.
//  3. The ends of an open line stay where they are. If the caller gives them new places, 1 and 2 do not hold for the
//     first and the last piece.
//  4. The result depends on the axis as a set with balls: it is scaled, turned and moved with the samples, and denser
//     samples of the same shape change it as little as they change the axis.
//
// Smallest use:
//     CenterLine line = set.lines.front();  // of `center_lines_of`
//     smooth(line, {.share = 0.25});        // within a quarter of the half width
//     for (const Station& at : stations_of(line, 10.0)) use(at.place, at.width);
//
// Cost: O(points of the axis + points of the line); a line has about eight points per radius. Threads: any.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

struct Bank {
  Vec2 sample{};                     ///< or an end of a side
  std::array<Vec2, 2> neighbours{};  ///< the sample itself where the curve ends or branches; the other end of a side
  bool is_side = false;              ///< the ball touches the side, not a sample
  std::optional<Vec2> center{};      ///< the side stands for an arc of the circle through `sample` about this
};
Vec2 foot_on(const Bank& bank, Vec2 place);
/// Radius of the ball about a point of the axis next to the bank.
double radius_at(const Bank& bank, Vec2 place);

struct CenterLine {
  std::vector<Vec2> axis;  ///< from end to end, no point twice in a row; a closed line repeats the first at the end
  /// Left and right bank of each piece of the axis; all points of the piece have the same distance from both, as
  /// `radius_at` measures it, and no other bank is nearer.
  std::vector<std::array<Bank, 2>> banks;
  bool is_closed = false;
  std::vector<std::size_t> joints;  ///< points of the axis where another line may begin or end, ascending
  std::array<bool, 2> is_free{};    ///< whether the first and the last point are free ends of the axis
  std::size_t shape = 0;            ///< number of the shape, counted from 0, the one with the longest line first
  std::size_t rank = 0;             ///< number of the line in its shape

  /// A point of the line, and the arc length of the point of the axis that it stands for.
  struct Point {
    Vec2 place{};
    double along = 0.0;
  };
  std::vector<Point> points;  ///< the line; at first the axis itself
};

/// Makes the line the axis itself.
void take_axis(CenterLine& line);
/// Arc length of the axis at one of its points.
double along_of(const CenterLine& line, std::size_t point);
/// The point of the line that stands for this arc length of the axis; becomes one of its points. O(points).
Vec2 join_at(CenterLine& line, double along);

/// The largest distance by which smoothing may move: a length, or a part of the radius of the ball there if `share` is
/// positive. Without either the line stays the axis.
struct SmoothingTolerance {
  double length = 0.0;
  double share = 0.0;
};
inline constexpr SmoothingTolerance kUsualSmoothing{.length = 0.0, .share = 0.25};
/// Removes waves shorter than about three radii, or than thirteen tolerances where that is less, and keeps longer ones.
/// `ends`, where given, are new places of the ends of an open line, in the balls there.
void smooth(CenterLine& line, const SmoothingTolerance& tolerance,
            const std::array<std::optional<Vec2>, 2>& ends = {});

/// Length of the line.
double length_of(const CenterLine& line);

/// A place along a line.
struct Station {
  double along = 0.0;  ///< arc length of the line from its beginning
  Vec2 place{};
  Vec2 axis{};             ///< point of the axis that the place stands for
  double width = 0.0;      ///< sum of the distances from that point to its two feet
  Vec2 left{}, right{};    ///< the feet, as seen along the line
  double direction = 0.0;  ///< of the line, in degrees from the x axis, counter-clockwise, from 0 to below 360
};
/// Stations at all multiples of a positive spacing; the end of a closed line is its beginning. They ignore extensions.
std::vector<Station> stations_of(const CenterLine& line, double spacing);

/// For each point of the line the distance to the nearer of its feet: the largest radius of a disk about it inside the
/// shape. Where the line is smoothed or extended, other parts of the boundary may be nearer.
std::vector<double> radii_of(const CenterLine& line);

/// Least, mean and largest width along the axis.
struct Widths {
  double least = 0.0;
  double mean = 0.0;
  double largest = 0.0;
};
Widths widths_of(const CenterLine& line);

}  // namespace mes
