// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the stiffest curve that a row of measured edges allows. Private to core/raster.
//
// A run is a closed contour, or the part between two of its corners. The curve is given by nodes and found by
// Gauss-Newton steps: nodes move along their normals by offsets u that minimise the sum of squares of (measured
// distance minus u), weighted by the edge's share of a pixel's side, plus a penalty. The penalty is the sixth power of
// a length, the stiffness, times the square of the change of curvature along the curve. Lines and circles have no
// penalty, so they stay whatever the stiffness. The residuals are compared with noise: the mean over each window of 4,
// 8, 16 ... edges with the error that pixels can hide there. The fit begins with nodes about 16 pixels apart and twice
// that as the stiffness; where this does not fit, both are halved, down to a stiffness of one or two pixels. So long
// smooth stretches have few nodes, and only corners and narrow bends have many. Then, with the same nodes, the
// stiffness is doubled wherever the residuals could still be noise. Elsewhere it stays, and from there it grows along
// the curve by at most the distance.
//
// The idea of testing residuals in all windows: Davies and Kovac, "Local extremes, runs, strings and multiresolution",
// 2001. The penalty: Moreton and Sequin, "Functional optimization for fair surface design", 1992.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"

namespace mes {

/// The crossing of an edge with a row or column of pixel centres; its position along that line is measured.
struct Edge {
  Vec2 at{};
  bool is_along_y = false;  ///< the line is a column
  float variance = -1.0F;   ///< variance of its transition from value to value, square pixels; negative: unknown
};

/// Edges nearly parallel to their line of pixels tell little, and that is uncertain; edges below this share are
/// ignored.
inline constexpr double kLeastShare = 0.35;
/// Edges above this share serve to estimate the blur of the picture; its effect on others is limited by it.
inline constexpr double kLeastAcross = 0.5;
inline constexpr double kVarianceOfPixel = 1.0 / 12.0;  ///< for a square pixel, in square pixels

struct EdgeNoise {
  /// Largest error of a single edge, in pixels. The error of a window decreases with the number of pixel borders that
  /// the curve crosses in it.
  double one = 0.45;
  /// Measured edges are means over the area of a pixel and the blur of the picture, which lie nearer to the centre of
  /// curvature than the edge itself; if true, the fit corrects this. Otherwise edges count as points.
  bool is_blurred = false;
  double least_stiffness = 2.0;  ///< pixels
};

struct Run {
  std::vector<Vec2> nodes{};        ///< for an open run including both ends
  std::vector<std::size_t> at{};    ///< positions of the nodes, in units of the finest distance, from the first
  std::size_t cells = 0;            ///< length of the whole run in the same unit
  std::vector<double> stiffness{};  ///< at the nodes, pixels
  std::vector<bool> is_held{};      ///< a larger stiffness was tried there and did not fit
  bool is_closed = false;
  double farthest = 0.0;  ///< largest distance of an edge from the curve, pixels; NaN if the fit failed
};

/// Fits a curve to edges in the order of the curve, starting from a nearby curve of nodes about a pixel apart. The
/// finest node distance is half the least stiffness, or three quarters of it for a curve longer than 512 pixels. Cost:
/// O(edges + nodes) for each round, of which there are a few for each doubling of the stiffness; equations are solved
/// only for nodes near a change. Throws `Cancelled` if there is a job.
Run fitted(std::span<const Vec2> start, bool is_closed, std::span<const Edge> edges, const EdgeNoise& noise,
           const JobControl* job = nullptr);

/// Largest turn of a cubic piece. It deviates from a circle by waves whose curvature is 0.003 times the fourth power of
/// the turn, relative to that of the circle; they should be smaller than the residuals on a circle with that
/// circumference.
double most_turn(double length);

/// Refits with denser nodes, between which the curve turns by at most that angle, as far as there are enough edges.
Run refined(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job = nullptr);

/// Fits again with as few extremes of curvature as the edges allow (core/raster/internal/fitting/curvature.h).
Run with_few_extremes(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job = nullptr);

/// The same curve with all nodes at the finest distance.
Run evened(const Run& run);

/// Positions of the edges along a closed run, in nodes from 0 to their number. O(edges + nodes).
std::vector<double> places_along(const Run& run, std::span<const Edge> edges);

}  // namespace mes
