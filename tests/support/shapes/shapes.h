// SPDX-License-Identifier: GPL-3.0-or-later
// Sampled shapes with a known formula for the medial axis: the reference of the tests.
//
// Guarantees:
//  1. Samples run along each contour in order, outer contours counter-clockwise; `data.contours` lists them.
//  2. `graded` shapes are epsilon-samples: every curve point x has a sample within epsilon * lfs(x), jitter included.
//     Reason: neighbours are at most 2 ln(1 + epsilon) apart in the measure ds / lfs, and lfs is 1-Lipschitz.
//  3. Equal arguments give equal samples. Random numbers come from core/base/rng.h; sine and cosine from libm.
//
// Smallest use:
//     const TestShape shape = ellipse(2.0, 1.0, 400);
//     CHECK(axis.length == Approx(*shape.expected.axis_length).margin(shape.expected.axis_length_tolerance));
//
// Each function states its formula: elementary geometry of offset curves and conics. The tolerances are bounds c * h^2
// (h = spacing) on the difference between the discrete inner axis and the smooth one. Over epsilon 0.03 .. 0.5,
// offsets, jitters and seeds the largest observed error was 0.74 of its bound (an ellipse by equal parameters),
// elsewhere 0.55.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/commands.h"

namespace mes::test {

/// The expected results. Counts are those of the inner medial axis graph, with nodes nearer than `merge_distance`
/// merged.
struct Facts {
  std::size_t components = 1;
  std::size_t cycles = 0;
  std::optional<std::size_t> leaves;         ///< axis ends; a component of one point has no leaves
  std::optional<std::size_t> branch_points;  ///< nodes with three or more edges
  std::optional<double> axis_length;
  double axis_length_tolerance = 0.0;
  std::optional<double> min_radius;  ///< smallest inner ball
  std::optional<double> max_radius;  ///< largest inner ball
  double radius_tolerance = 0.0;
  /// Arcs sampled by doubles are cocircular only up to rounding, which leaves clusters of tiny edges at their centre.
  double merge_distance = 1e-9;
};

struct TestShape {
  std::string name;
  SampleData data;
  Facts expected;
  double epsilon = 0.0;  ///< the samples are an epsilon-sample for this value; 0 = not claimed
};

struct Sampling {
  double offset = 0.0;     ///< shifts all samples along the curve, in spacings; breaks mirror symmetry
  double jitter = 0.0;     ///< each sample moves along the curve by up to this many spacings, 0 .. 0.25
  std::uint64_t seed = 1;  ///< seed of the jitter
};

/// 1. Ellipse x^2/a^2 + y^2/b^2 = 1, a > b, at `n` equal parameter steps. With c^2 = a^2 - b^2 the axis is the
/// segment |x| <= c^2/a, whose ends are the centres of curvature (radius b^2/a) at (+-a, 0); the largest ball is b.
TestShape ellipse(double a, double b, std::size_t n, const Sampling& sampling = {});
/// The same as an epsilon-sample: lfs(t) = distance to the axis segment (the outer axis is empty: convex).
TestShape ellipse_graded(double a, double b, double epsilon, const Sampling& sampling = {});

/// 2. Points at distance R from the segment [-L, L] x {0}: the axis is that segment, with r = R = lfs everywhere.
TestShape stadium(double half_length, double radius, double epsilon, const Sampling& sampling = {});

/// 3. Annulus R1 < R2 with `n` samples on each circle at equal angles. By symmetry the axis is exactly the regular
///    n-gon of inradius (R1 + R2)/2: length n (R1 + R2) tan(pi/n), nodes at (R1 + R2)/(2 cos(pi/n)); the only tolerance
///    is for rounding.
TestShape annulus_aligned(double inner_radius, double outer_radius, std::size_t n);
/// The same region, each circle sampled by its own lfs: min(R1, (R2-R1)/2) inside, (R2-R1)/2 outside. The axis is the
/// circle of radius (R1 + R2)/2, r = (R2 - R1)/2.
TestShape annulus(double inner_radius, double outer_radius, double epsilon, const Sampling& sampling = {});

/// 4. Disk R2 about the origin with a hole R1 about (d, 0), d < R2 - R1. |x - c1| - R1 = R2 - |x| makes the axis the
/// ellipse with foci at both centres, semi-axes (R1+R2)/2 and sqrt((R1+R2)^2 - d^2)/2, r in (R2 - R1 -+ d)/2.
TestShape eccentric_hole(double hole_radius, double disk_radius, double distance, double epsilon,
                         const Sampling& sampling = {});

/// 5. Rectangle of half sides A > B, corners rounded with radius q < B. Axis: the segment |x| <= A - B with r = B and
/// four diagonals of length sqrt(2) (B - q) down to r = q; two branch points, four leaves. lfs >= q.
TestShape rounded_rectangle(double half_width, double half_height, double corner_radius, double epsilon,
                            const Sampling& sampling = {});

/// 6. Two equal ellipses side by side, `gap` apart: all counts double, two components. `n` samples each.
TestShape two_ellipses(double a, double b, double gap, std::size_t n, const Sampling& sampling = {});

/// 7. Disk R with `k` >= 2 holes of radius h, their centres at equal angles on the circle of radius d. k cycles, no
/// leaf. Smallest ball: between hole and rim, (R - d - h)/2, or between neighbours, d sin(pi/k) - h. Largest: the one
/// in the middle, d - h, or the k ones that touch the rim and two neighbours.
TestShape disk_with_holes(std::size_t k, double disk_radius, double hole_radius, double hole_distance, double epsilon,
                          const Sampling& sampling = {});

/// 8. Annulus R1 < R2 with an ellipse a > b (a < R1) in its hole: parity nests three deep; two components, one cycle.
TestShape island_in_hole(double a, double b, double inner_radius, double outer_radius, double epsilon,
                         const Sampling& sampling = {});

/// One of each of the above in several proportions, for exhaustive loops. `epsilon` in (0, 0.5].
std::vector<TestShape> oracle_shapes(double epsilon, const Sampling& sampling = {});

}  // namespace mes::test
