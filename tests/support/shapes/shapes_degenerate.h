// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs on which careless geometry fails: too few points, collinear and cocircular ones, duplicates, extreme numbers.
//
// Facts that are not set cannot be derived; a test should then only require that nothing breaks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes::test {

struct DegenerateInput {
  std::string name;
  std::vector<Vec2> positions;
  std::size_t distinct = 0;                ///< number of different positions
  std::optional<std::size_t> crust_edges;  ///< edges of the one-step crust, ties (alpha + beta = 90 degrees) counted
  std::optional<std::size_t> odd_samples;  ///< samples of odd crust degree
};

/// k x k integers, in rows. Every edge has alpha = beta = 45 degrees: a tie, so all 2k(k-1) unit edges are crust.
/// Border samples other than corners have degree 3: 4(k-2) odd ones. `k` >= 2.
DegenerateInput integer_lattice(std::size_t k);

/// The 36 integer points of x^2 + y^2 = 65^2, counter-clockwise. The crust is the hull; all inner balls are equal, of
/// radius 65 about the origin, and the axis is the origin.
DegenerateInput lattice_circle();

/// Consistent crusts of degree 2 throughout whose inner balls nevertheless meet outside the samples: `number` 1..3.
/// Too sparse for the theorem; the program must not call them certified. Found by random search among lattice points.
DegenerateInput foreign_crossing(int number);

/// The whole corpus, including the inputs above.
std::vector<DegenerateInput> degenerate_inputs();

}  // namespace mes::test
