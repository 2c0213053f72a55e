// SPDX-License-Identifier: GPL-3.0-or-later
// A layer's geometry as text that other programs read.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/layer_mirror.h"

namespace mes::cli {

/// One header line, then one primitive a line, numbers in shortest round-trip form; a layer that may emit several
/// kinds has a first column `kind`. Segments of length zero are left out, as they are from the counts of `compute`.
std::string csv_of(const LayerMirror& mirror, LayerIndex layer, const LayerDescriptor& descriptor);

/// The points of a layer; or, for a layer of segments, their distinct ends in order of appearance, with the chains
/// that the segments form as `# loop` lines. Error: `usage` for layers that have neither.
Expected<std::string> poff_of(const LayerMirror& mirror, LayerIndex layer, const LayerDescriptor& descriptor);

/// The disks of a layer, or its circles, as WPOFF. Error: `usage` for layers that have neither.
Expected<std::string> wpoff_of(const LayerMirror& mirror, LayerIndex layer, const LayerDescriptor& descriptor);

}  // namespace mes::cli
