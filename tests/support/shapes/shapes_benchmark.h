// SPDX-License-Identifier: GPL-3.0-or-later
// Large seeded inputs for benchmarks and random edit scripts.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes::test {

/// The smooth closed curve r(t) = 200 (1 + 0.3 cos 5t + 0.05 cos 37t) at `n` equal steps of t, each jittered by up to a
/// quarter step; in curve order. All crust degrees are 2 from n = 1000 on.
std::vector<Vec2> benchmark_curve(std::size_t n, std::uint64_t seed = 1);

/// The same with flaws: every sample leaves the curve by up to 5 % of a step, and one in a hundred by one to three
/// steps, which is a corner sharper than the sampling can follow. Some samples have odd crust degree.
std::vector<Vec2> rough_curve(std::size_t n, std::uint64_t seed = 1);

/// The same curve under noise of up to one step in each coordinate: many odd samples, all along the curve.
std::vector<Vec2> noisy_curve(std::size_t n, std::uint64_t seed = 1);

/// A curve of three petals, with radii from 70 to 130, at equal angles; `noise` is the width of the noise.
std::vector<Vec2> noisy_trefoil(std::size_t n, double noise, std::uint64_t seed);

/// Uniform in the square [0, 400)^2: no curve at all, odd samples everywhere.
std::vector<Vec2> uniform_square(std::size_t n, std::uint64_t seed = 1);

/// A closed outline drawn by hand, sometimes fast and sometimes slowly: `n` samples, some close together and some far
/// apart, in curve order, on a grid with this spacing.
std::vector<Vec2> drawn_by_hand(std::size_t n, std::uint64_t seed = 1, double grid = 1.0);

/// `n` draws from about n / 4 points of a coarse integer grid, with many duplicates and many collinear and cocircular
/// quadruples.
std::vector<Vec2> duplicate_heavy(std::size_t n, std::uint64_t seed = 1);

}  // namespace mes::test
