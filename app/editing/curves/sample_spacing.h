// SPDX-License-Identifier: GPL-3.0-or-later
// The spacing of samples, and styles for pictures in which samples are closer than pixels.
//
// Smallest use, the same in the window, in snapshots, in pictures of `render`, figures and films:
//     const double spacing = typical_spacing(document);
//     view.style = thinned(view.style, descriptor, spacing / units_per_logical_pixel);
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/document/document.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

/// The median distance of two hundred samples, or of all distinct positions if there are fewer, to the nearest other
/// position, in units of the document; 0 for fewer than two positions. It depends only on the positions in input
/// order, not on the history of the document, and changes as little from step to step as the samples move. O(n log n)
/// for n samples: some tens of milliseconds per million if they are spread evenly, and hundreds in clusters.
double typical_spacing(const Document& document);

/// The spacing of a document that is being edited. With up to `kAlwaysMeasured` samples it is always up to date. With
/// more, it is measured again if their number has changed by a tenth, or the magnitude of coordinates has; otherwise
/// only when it is requested a second time after a change: not in each picture of a drag.
class FollowedSpacing {
 public:
  static constexpr std::size_t kAlwaysMeasured = 20'000;

  /// `origin` must change when another document replaces the previous one. O(1) if nothing is measured.
  double of(const Document& document, std::uint64_t origin = 0);

 private:
  std::uint64_t digest_ = 0;      // digest of samples at the last measurement, like the rest
  std::uint64_t changed_to_ = 0;  // digest at the last request without measurement
  std::uint64_t origin_ = 0;
  std::size_t count_ = 0;
  int magnitude_ = 0;
  double spacing_ = 0.0;
};

/// False for own balls and pictures, whose density does not depend on the samples, and for letters, which keep their
/// size.
bool is_made_of_samples(const LayerDescriptor& descriptor);

/// The style with thinner points and lines if samples are closer than two pixels: the closer, the thinner, down to a
/// fifth. Layers of dots with their default size are also kept apart: the dots are as wide as 0.7 times the spacing at
/// most, if that is more than 1.5 pixels for samples, and 2.5 for others such as v-points. Larger dots, which mark single
/// places, keep their size. Layers not made of samples stay as they are, and so do styles that opt out.
/// `spacing_px`: logical pixels; 0: unknown.
LayerStyle thinned(LayerStyle style, const LayerDescriptor& descriptor, double spacing_px);

}  // namespace mes
