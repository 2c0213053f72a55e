// SPDX-License-Identifier: GPL-3.0-or-later
// For each ball, the least factor such that growing all balls by it puts the ball inside another one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/jobs/job_control.h"

namespace mes {

/// The date of ball i is the least of |c_i - c_j| / (r_j - r_i) over all balls j with r_j > r_i, and at least 1;
/// infinite for the largest balls. It equals, bit for bit, the least of the same doubles over all pairs.
///
/// Blocks of neighbouring balls search a tree of boxes together, and boxes that can improve no ball of the block are
/// skipped at once. Let B be the largest of the least quotients that a block's balls have so far. With a vector u no
/// longer than 1 / B, no ball j of a box improves anything if r_j - r_i <= u * (c_j - c_i) for all i of the block.
/// Radii on both sides are bounded by planes, above the balls of the box and below those of the block, so this compares
/// a few numbers: along an axis, and from the curve to it, radii change evenly, and a plane is near to them where the
/// largest radius is not. For a leaf and a box of the last level, the balls themselves are compared in the direction of
/// u, and the remaining ones in pairs that the processor handles at once.
///
/// Cost: building O(n log n); searching for all balls O(n log n) typically, O(n^2) at worst.
/// Threads: building borrows other cores; searches may run in parallel.
class CoverSearch {
 public:
  /// The date of a ball that no other one ever holds.
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t kNone = 0xffffffffU;
  /// For each ball a few others that may swallow it early; kNone where there are fewer.
  using Hints = std::array<std::uint32_t, 3>;

  /// Balls are finite, and counted from 0. There is one entry of hints per ball, or none at all.
  CoverSearch(std::span<const Disk> balls, std::span<const Hints> hints);

  /// Number of parts into which the searches are divided, independent of each other.
  std::size_t part_count() const;
  /// Finds the dates of the balls of a part and writes them to their indices in `dates`. Throws `Cancelled`.
  void search(std::size_t part, std::span<double> dates, JobControl& job) const;

 private:
  struct Bound;
  struct Lanes;
  struct Direction;
  struct Guesses;
  struct Ball {
    Vec2 center{};
    double radius = 0.0;
    std::uint32_t number = 0;  ///< index in the input
  };
  /// The balls from index `first` on, up to `last`.
  struct alignas(64) Node {
    Box2 box{};
    Vec2 middle{};
    Vec2 half{};                     ///< no point of the box is farther from the middle
    double most = 0.0, least = 0.0;  ///< radii
    /// Radii are between `low` and `high` + `slope` * (centre - middle), rounding included.
    double low = 0.0, high = 0.0;
    Vec2 slope{};
    std::uint32_t first = 0, last = 0;
    std::uint32_t child = 0;  ///< first of its two children; 0 if it has none
  };

  void measure(Node& node) const;
  void fit_planes(Node& node) const;
  void split(std::vector<Node>& nodes, std::uint32_t at, std::uint32_t down_to);
  void find_blocks(std::uint32_t at);
  static bool is_apart(const Node& asked, const Bound& bound, const Node& node);
  static Direction towards(const Node& asked, const Bound& bound, const Node& node);
  static bool is_below(const Node& asked, const Node& node, const Direction& direction);
  void begin(Lanes& lanes, const Node& leaf, const Guesses& guesses) const;
  double date_of(const Ball& ball, const Ball& by) const;
  void take(Lanes& lanes, std::size_t lane, std::uint32_t by) const;
  bool look_at(Lanes& lanes, std::uint32_t by) const;
  void look_into(Lanes& lanes, const Node& leaf) const;
  void search_block(const Node& block, Guesses& guesses, std::span<double> dates) const;

  std::vector<Ball> balls_;              ///< in the order of the tree
  std::vector<double> x_, y_, radius_;   ///< the same, with some behind that swallow nothing
  std::vector<std::uint32_t> place_of_;  ///< index in the tree, by index in the input
  std::span<const Hints> hints_;
  std::vector<Node> tree_;
  std::vector<std::uint32_t> blocks_;  ///< their nodes
};

}  // namespace mes
