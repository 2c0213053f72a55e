// SPDX-License-Identifier: GPL-3.0-or-later
// The common input of all stages of the union pipeline: the balls in numbers of both kernels, and the split of work.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/structures/balls/internal/local_frame.h"
#include "core/structures/balls/internal/numbers/number_parts.h"
#include "core/structures/balls/internal/numbers/union_numbers.h"
#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// `Balls` is the kernel of the triangulation of the balls and of the dual complex, `Points` that of the v-points.
template <class Balls, class Points>
struct UnionBalls : NumberParts<typename Balls::FT, typename Points::FT> {
  using BallNumber = typename Balls::FT;
  using PointNumber = typename Points::FT;

  TableView<InputSlot, PipelineBall> input;
  std::size_t rows;  ///< of the family's table
  LocalFrame frame;
  Table<InputSlot, BallOf<BallNumber>> in_balls;
  Table<InputSlot, BallOf<PointNumber>> in_points;

  explicit UnionBalls(const PipelineInput& given)
      : input(given.balls),
        rows(given.rows),
        frame(given.frame),
        in_balls(given.balls.size()),
        in_points(given.balls.size()) {
    this->in_parts(input.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
      for (const InputSlot i : slots_between<InputSlot>(begin, end)) {
        in_balls[i] = ball_in<BallNumber>(input[i]);
        if constexpr (std::is_same_v<BallNumber, PointNumber>) {
          in_points[i] = in_balls[i];
        } else {
          in_points[i] = ball_in<PointNumber>(input[i]);
        }
      }
    });
  }

  std::size_t size() const { return input.size(); }
  Vec2 center(InputSlot ball) const { return input[ball].disk.center; }
  /// Signs that follow from a common sample are not computed: zero takes rationals longest to find.
  static constexpr bool kKnowsSamples = std::is_same_v<Balls, ExactKernel>;

  /// True if the three balls and the other one touch one sample.
  bool have_common_sample(const InputSlot (&three)[3], InputSlot other) const {
    return std::ranges::any_of(input[other].samples, [&](const TouchedSample& sample) {
      return std::ranges::all_of(three, [&](InputSlot ball) { return input[ball].find(sample.site) != nullptr; });
    });
  }
  /// An order that does not depend on that of the input.
  bool comes_before(InputSlot a, InputSlot b) const { return lexicographically_less(center(a), center(b)); }
};

}  // namespace mes
