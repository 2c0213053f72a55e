// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the geometry of layers as text for other programs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/primitives.h"

namespace mes {

class Document;
class Registry;

/// The geometry to write.
struct LayerGeometry {
  const Registry& registry;
  std::span<const LayerIndex> layers;  ///< in drawing order
  const LayerMirror& mirror;           ///< holds these layers and those that `LayerTextFormat::needs_curve` adds
  const Document& document;
};

struct LayerText {
  std::string text;
  std::uint64_t left_out = 0;      ///< rays and lines, which the format cannot hold
  std::uint64_t without_area = 0;  ///< lines that a format of areas leaves out, because they branch or have free ends
  std::uint64_t off_earth = 0;     ///< shapes of a map that reach beyond a pole or around the Earth; also left out
};

/// A format. All formats write numbers in shortest round-trip form and leave out segments of length zero, as the
/// counts of `compute` do. Equal geometry gives equal bytes.
struct LayerTextFormat {
  std::string_view name;        ///< its name on the command line
  std::string_view extension;   ///< extension of file names, without its dot
  std::string_view title;       ///< its name in menus
  std::string_view help;        ///< one line
  bool is_of_many = false;      ///< holds several layers at once
  bool needs_curve = false;     ///< needs the layers `curve` and `curve-normals` to be computed too
  std::string_view contents{};  ///< required content of a layer, such as "points"; empty: any layer
  bool (*holds)(const LayerDescriptor& layer) = nullptr;
  /// Error: as for `MapConversion::of` (core/io/systems/map_conversion.h).
  Expected<LayerText> (*write)(const LayerGeometry& geometry) = nullptr;
};

/// The formats in the order of help and menus.
std::span<const LayerTextFormat> layer_text_formats();
/// The format of this name, or null.
const LayerTextFormat* find_layer_text_format(std::string_view name);

/// The names of the CSV columns that a primitive of this kind fills. If a layer has several kinds, the header names
/// the columns of one of them, and the others fill the same columns.
std::string_view csv_columns(PrimitiveKind kind);

/// Checks that the format can hold these layers; `descriptors` are those of all layers. Error: `usage`, with the
/// layer and a format that can hold it.
Expected<void> check_layers(std::span<const LayerDescriptor> descriptors, const LayerTextFormat& format,
                            std::span<const LayerIndex> layers);

}  // namespace mes
