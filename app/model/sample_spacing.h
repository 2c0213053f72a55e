// SPDX-License-Identifier: GPL-3.0-or-later
// How close samples stand, and styles for pictures in which they stand closer than pixels.
#pragma once

#include "app/model/place_index.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

/// The median distance of some two hundred samples to their nearest neighbours elsewhere, in units of the document; 0
/// for fewer than two places. Cost: some milliseconds, however many samples there are.
double typical_spacing(const Document& document, const SampleIndex& index);

/// False for own balls and pictures: samples say nothing about how close they stand. False for letters, which keep
/// their size.
bool is_made_of_samples(const LayerDescriptor& descriptor);

/// The style with points and lines that are thinner the closer samples stand below two pixels, down to a fifth; layers
/// that are not made of samples stay as they are, and so do styles that say so. `spacing_px`: logical pixels; 0: not known.
LayerStyle thinned(LayerStyle style, const LayerDescriptor& descriptor, double spacing_px);

}  // namespace mes
