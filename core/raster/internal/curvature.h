// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature along a curve without the extremes that noise leaves. Private to core/raster.
//
// The circles of curvature along an arc of monotone curvature are nested (Tait 1896, Kneser 1912). So a medial axis has no
// end that is not the centre of curvature at an extreme of it, and a blunt end whose curvature goes up and down by the
// hundredth part has a twig for each time.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace mes {

struct CalmCurvature {
  std::vector<double> at{};      ///< the nodes
  std::vector<char> is_level{};  ///< of nodes: the curvature there and that at the next were pooled
  double factor = 1.0;           ///< of the stiffness against other changes of curvature
};

/// Curvature near to the given one with fewer extremes, monotone between them. A pair of neighbouring extremes goes
/// where flattening it moves the curve by less than `tolerance` of the length that it changes; those that move it least go
/// first. A closed curve keeps four extremes, an open one its ends. Between two that stay it is the monotone row nearest by
/// least squares (isotonic regression, by pooling adjacent violators; Ayer et al. 1955). Lengths are those from node to node,
/// of a closed curve also from the last to the first. O(n log n).
CalmCurvature calmed(std::span<const double> curvature, std::span<const double> lengths, bool is_closed,
                     const std::function<double(double)>& tolerance);

}  // namespace mes
