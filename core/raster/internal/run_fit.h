// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffest curve that a row of measured edges allows. Private to core/raster.
//
// A run is a closed contour, or what lies between two of its corners. The curve is given by nodes, and found by steps of
// Gauss and Newton: along the normals of the nodes move offsets u that minimise the squares of what is measured minus u,
// weighted by how much of a pixel's side an edge takes, plus the sixth power of a length, the stiffness, times the square of
// the change of curvature along the curve. Lines and circles cost nothing, so they stay where they are whatever the
// stiffness. What is left over is compared with noise: the mean over each window of 4, 8, 16 ... edges with what pixels can
// hide there. It begins with nodes some 16 pixels apart and twice that as the stiffness; where that does not fit, both are
// halved, down to a stiffness of one or two pixels. So long smooth stretches have few nodes, and only corners and narrow
// bends have many. After that the stiffness is doubled where it can be, with the same nodes, as long as what is left over
// could be noise. Where it is more, the stiffness stays as it was, and grows beside that place by no more than the way.
//
// The idea of testing residuals in all windows: Davies and Kovac, "Local extremes, runs, strings and multiresolution",
// 2001. The penalty: Moreton and Sequin, "Functional optimization for fair surface design", 1992.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/base/vec2.h"

namespace mes {

/// Where an edge crosses a row or column of pixel centres: the place along that line is measured.
struct Edge {
  Vec2 at{};
  bool is_along_y = false;  ///< of a column
  float variance = -1.0F;   ///< of its transition from value to value, square pixels; negative: not known
};

/// Edges that lie more nearly along their line of pixels say little, and what they say is uncertain.
inline constexpr double kLeastShare = 0.35;
/// Those that tell how blurred a picture is, and how much that matters to them, lie at most so.
inline constexpr double kLeastAcross = 0.5;
inline constexpr double kVarianceOfPixel = 1.0 / 12.0;  ///< of a square one, in square pixels

struct EdgeNoise {
  /// Pixels: how far a single edge may be off. What windows may be off by goes down with the pixel borders that the curve
  /// passes in them.
  double one = 0.45;
  /// The edge is the mean over what a pixel covers, and what the picture is blurred by, which is nearer to the centre of
  /// curvature than the edge itself: that is made good. Otherwise edges are taken for points.
  bool is_blurred = false;
  double least_stiffness = 2.0;  ///< pixels
};

struct Run {
  std::vector<Vec2> nodes{};        ///< of an open run both ends
  std::vector<std::size_t> at{};    ///< where the nodes are, in the finest distances, from the first
  std::size_t cells = 0;            ///< of the whole run, in the same
  std::vector<double> stiffness{};  ///< at the nodes, pixels
  std::vector<bool> is_held{};      ///< a larger stiffness was tried there, and did not fit
  bool is_closed = false;
  double farthest = 0.0;  ///< of all edges from the curve, pixels; not a number where the fit went wrong
};

/// The fit to edges in the order of the curve, from a curve near to it of nodes about a pixel apart. The finest distance of
/// its nodes is half the least stiffness, or three quarters of it along a curve of more than 512 pixels. Cost: O(edges +
/// nodes) a round, of which there are a few for each doubling of the stiffness; equations are solved only for nodes near to
/// a change. Throws `Cancelled` if there is a job.
Run fitted(std::span<const Vec2> start, bool is_closed, std::span<const Edge> edges, const EdgeNoise& noise,
           const JobControl* job = nullptr);

/// How much a piece of a cubic may turn. It leaves a circle by waves whose curvature is 0.003 times the fourth power of the
/// turn, relative to that of the circle; they should be less than what the edges leave of a circle with that circumference.
double most_turn(double length);

/// The same fit with nodes so near to each other that the curve turns by at most that between two of them, as far as there
/// are edges for them.
Run refined(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job = nullptr);

/// Fits again with as few extremes of curvature as the edges allow (core/raster/internal/curvature.h).
Run with_few_extremes(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job = nullptr);

/// The same curve with all nodes at the finest distance.
Run evened(const Run& run);

/// Where the edges are along a closed run, in nodes from 0 to their number. O(edges + nodes).
std::vector<double> places_along(const Run& run, std::span<const Edge> edges);

}  // namespace mes
