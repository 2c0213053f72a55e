// SPDX-License-Identifier: GPL-3.0-or-later
// The description of a layer, shared by the command line, the window, the manual page and the renderer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/ids.h"
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
  experiments  ///< for experiments of the user; the program itself has none
};

/// The groups in listing order.
inline constexpr std::array kLayerGroups{
    LayerGroup::experiments, LayerGroup::samples,    LayerGroup::delaunay_voronoi, LayerGroup::crust_axis,
    LayerGroup::scale_axis,  LayerGroup::poles,      LayerGroup::union_a,          LayerGroup::union_p,
    LayerGroup::union_b,     LayerGroup::diagnostics};

/// Heading of the group in the layer panel, e.g. "Delaunay & Voronoi".
std::string_view title_of(LayerGroup group);

/// Style of the points of a layer.
enum class PointsAs : std::uint8_t {
  dots,
  numbers,  ///< indices next to the samples, from 0 since the data were opened; letters are as high as dots are wide
};

/// Layers of some kinds show data from a file. They can be exported to file formats for such data.
enum class LayerData : std::uint8_t { other, samples, balls, curve, curve_normals };

struct LayerDescriptor {
  std::string id{};       ///< public name, kebab case
  std::string name{};     ///< name in the interface
  std::string tooltip{};  ///< one sentence, no full stop
  LayerGroup group = LayerGroup::samples;
  LayerData data = LayerData::other;
  std::string
      of_any_family{};     ///< common name of layers that show the same for several families of balls; else empty
  bool in_paper = false;   ///< one of the 41 layers of the 2007 paper
  bool in_fit_box = true;  ///< included in "fit to view"
  bool visible_at_start = false;
  std::string scalar{};                   ///< meaning of an instance's scalar; empty = none
  bool scalars_are_names = false;         ///< scalars only tell elements apart, and depend on history
  PointsAs points_as = PointsAs::dots;    ///< `numbers`: the layer draws nothing else
  LayerStyle style{};                     ///< default style
  std::vector<PrimitiveKind> kinds{};     ///< kinds that it may emit, in drawing order (first = bottom)
  std::vector<std::string> structures{};  ///< ids of the structures it reads
  std::vector<std::string> parameters{};  ///< ids of the parameters that affect it
  bool follows_settings = false;          ///< number type or parameters affect it
  bool is_removed = false;                ///< no layer has this index any more
};

/// Position of a public id in a list of all layers, or kNoLayer; removed layers do not count.
LayerIndex find_layer(std::span<const LayerDescriptor> layers, std::string_view id);
/// Position of the first layer that shows such data of a file, or kNoLayer, likewise.
LayerIndex find_layer(std::span<const LayerDescriptor> layers, LayerData data);

}  // namespace mes
