// SPDX-License-Identifier: GPL-3.0-or-later
// What everybody may know of a layer: the command line, the window, the manual page, the renderer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/slot.h"
#include "core/draw/layer_style.h"
#include "core/draw/primitives.h"

namespace mes {

enum class LayerGroup : std::uint8_t {
  samples,
  delaunay_voronoi,
  crust_axis,
  scale_axis,
  poles,
  union_a,
  union_p,
  union_b,
  diagnostics,
  experiments  ///< of the user; the program itself has none
};

/// In the order in which they are listed.
inline constexpr std::array kLayerGroups{
    LayerGroup::experiments, LayerGroup::samples,    LayerGroup::delaunay_voronoi, LayerGroup::crust_axis,
    LayerGroup::scale_axis,  LayerGroup::poles,      LayerGroup::union_a,          LayerGroup::union_p,
    LayerGroup::union_b,     LayerGroup::diagnostics};

/// Heading of the group in the layer panel, e.g. "Delaunay & Voronoi".
std::string_view title_of(LayerGroup group);

/// How the points of a layer are drawn.
enum class PointsAs : std::uint8_t {
  dots,
  numbers,  ///< of samples, beside them: from 0 since the data were opened, with letters as high as dots are wide
};

/// Layers of some kinds show data of a file. They can be written in file formats for such data.
enum class LayerData : std::uint8_t { other, samples, balls, curve, curve_normals };

struct LayerDescriptor {
  std::string id{};       ///< public name, kebab case
  std::string name{};     ///< as shown
  std::string tooltip{};  ///< one sentence, no full stop
  LayerGroup group = LayerGroup::samples;
  LayerData data = LayerData::other;
  std::string of_any_family{};  ///< what layers share that show the same of several families of balls; else empty
  bool in_paper = false;        ///< one of the 41 layers of the 2007 paper
  bool in_fit_box = true;       ///< counts for "fit to view"
  bool visible_at_start = false;
  std::string scalar{};                   ///< what the scalar of an instance means; empty = none
  bool scalars_are_names = false;         ///< they only tell elements apart, and depend on history
  PointsAs points_as = PointsAs::dots;    ///< numbers: it draws nothing else
  LayerStyle style{};                     ///< the default
  std::vector<PrimitiveKind> kinds{};     ///< what it may emit, in drawing order (first = bottom)
  std::vector<std::string> structures{};  ///< ids of the structures it reads
  std::vector<std::string> parameters{};  ///< ids of those that have a say in it
  bool follows_settings = false;          ///< number type or parameters have a say in it
  bool is_removed = false;                ///< no layer has this index any more
};

/// The position of a public id in a list of all layers, or kNoLayer; that of a layer that was removed does not count.
LayerIndex find_layer(std::span<const LayerDescriptor> layers, std::string_view id);
/// The position of the first that shows something of a file, or kNoLayer, likewise.
LayerIndex find_layer(std::span<const LayerDescriptor> layers, LayerData data);

}  // namespace mes
