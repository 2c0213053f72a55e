// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature along a curve without the extremes caused by noise. Private to core/raster.
//
// The circles of curvature along an arc of monotone curvature are nested (Tait 1896, Kneser 1912). So each end of the
// medial axis is the centre of curvature at an extreme of curvature, and a blunt end whose curvature goes up and down
// by one percent has a twig for each of these extremes.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace mes {

/// Curvature with few extremes, and how strictly a fit follows it.
struct CalmCurvature {
  std::vector<double> at{};      ///< at the nodes
  std::vector<char> is_level{};  ///< the curvatures at a node and at the next were pooled
  double factor = 1.0;           ///< multiplies the stiffness against other changes of curvature
};

/// Returns curvature near to the given one that has fewer extremes and is monotone between them. A pair of neighbouring
/// extremes is removed if flattening it moves the curve by less than `tolerance(length)` pixels, where `length` is the
/// length of the stretch that changes; pairs that move the curve least are removed first. A closed curve keeps four
/// extremes, an open one its ends. Between two extremes the result is the nearest monotone row by least squares
/// (isotonic regression, by pooling adjacent violators; Ayer et al. 1955). `lengths` go from node to node, and on a
/// closed curve also from the last node to the first. O(n log n).
CalmCurvature calmed(std::span<const double> curvature, std::span<const double> lengths, bool is_closed,
                     const std::function<double(double)>& tolerance);

}  // namespace mes
