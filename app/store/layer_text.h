// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of layers as text that other programs read.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/document/document.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/primitives.h"

namespace mes {

class Registry;

/// What is written.
struct LayerGeometry {
  const Registry& registry;
  std::span<const LayerIndex> layers;  ///< in drawing order
  const LayerMirror& mirror;           ///< holds them, and the layers that `LayerTextFormat::needs` adds
  const Document& document;
};

struct LayerText {
  std::string text;
  std::uint64_t left_out = 0;  ///< rays and lines, which the format cannot hold
  std::uint64_t off_earth =
      0;  ///< shapes of a map that reach beyond a pole or around the Earth, and are left out, too
};

/// A format. Numbers are in shortest round-trip form in all of them; segments of length zero are left out, as they are
/// from the counts of `compute`. Equal geometry gives equal bytes.
struct LayerTextFormat {
  std::string_view name;        ///< as on the command line
  std::string_view extension;   ///< of file names, without its dot
  std::string_view title;       ///< as in a menu
  std::string_view help;        ///< one line
  bool is_of_many = false;      ///< it holds several layers at once
  bool needs_curve = false;     ///< the layers `curve` and `curve-normals` have to be computed too
  std::string_view contents{};  ///< what a layer needs for it: "points"; empty: any layer
  bool (*holds)(const LayerDescriptor& layer) = nullptr;
  LayerText (*write)(const LayerGeometry& geometry) = nullptr;
};

/// In the order in which help and menus name them.
std::span<const LayerTextFormat> layer_text_formats();
/// Null for any other name.
const LayerTextFormat* find_layer_text_format(std::string_view name);

/// The columns that a primitive of this kind fills in CSV, with what they mean for it. Where a layer has several kinds, the
/// header names the columns of one of them, and the others fill the same places.
std::string_view csv_columns(PrimitiveKind kind);

/// Checks that the format holds these layers; `descriptors` are those of all layers. Error: `usage`, with the layer and a
/// format that holds it.
Expected<void> check_layers(std::span<const LayerDescriptor> descriptors, const LayerTextFormat& format,
                            std::span<const LayerIndex> layers);

}  // namespace mes
