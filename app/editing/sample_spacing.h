// SPDX-License-Identifier: GPL-3.0-or-later
// How close samples stand, and styles for pictures in which they stand closer than pixels.
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

/// The median distance of two hundred samples, or the places of all if there are fewer, to the nearest other place, in
/// units of the document; 0 for fewer than two places. It depends on the places in the order of input alone, not on how
/// the document came to them, and changes as little from step to step as the samples move. O(n log n) for n samples: some
/// tens of milliseconds a million where they are spread evenly, and hundreds in clusters.
double typical_spacing(const Document& document);

/// The spacing of a document that is edited. Of up to `kAlwaysMeasured` samples it is that of the document as it is. Of
/// more it is measured anew where their number changed by a tenth, or the magnitude of coordinates, and else when it is
/// asked for a second time after a change: not in each picture of a drag.
class FollowedSpacing {
 public:
  static constexpr std::size_t kAlwaysMeasured = 20'000;

  /// `origin` changes where another document took the place of the one before. O(1) where nothing is measured.
  double of(const Document& document, std::uint64_t origin = 0);

 private:
  std::uint64_t digest_ = 0;      // of the samples when it was measured, as the rest
  std::uint64_t changed_to_ = 0;  // when it was last asked for and not measured
  std::uint64_t origin_ = 0;
  std::size_t count_ = 0;
  int magnitude_ = 0;
  double spacing_ = 0.0;
};

/// False for own balls and pictures: samples say nothing about how close they stand. False for letters, which keep
/// their size.
bool is_made_of_samples(const LayerDescriptor& descriptor);

/// The style with points and lines that are thinner the closer samples stand below two pixels, down to a fifth. Dots of
/// samples that have their default size are kept apart as well: they are no wider than 0.7 times the spacing, if that
/// is more than 1.5 pixels. Layers that are not made of samples stay as they are, and so do styles that say so.
/// `spacing_px`: logical pixels; 0: not known.
LayerStyle thinned(LayerStyle style, const LayerDescriptor& descriptor, double spacing_px);

}  // namespace mes
