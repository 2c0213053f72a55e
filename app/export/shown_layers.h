// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a picture or figure, with their look and the area they cover.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/color.h"
#include "core/base/geometry/box2.h"
#include "core/document/settings/layer_configuration.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/layer_style.h"
#include "render/scene.h"

namespace mes {

/// Margin between the area of "fit" and the edge of a picture, as a share of its shorter side.
inline constexpr double kFitMargin = 0.05;

struct ShownLayers {
  std::span<const LayerDescriptor> descriptors;  ///< all existing layers, by index
  std::vector<VariantLayer> layers{};            ///< bottom first
  std::vector<LayerStyle> styles{};              ///< styles of all layers of one variant, by index
  std::optional<Rgb> background{};               ///< nothing: transparent
  double scale = 1.0;                            ///< factor for line widths and point sizes
  double least_line_px = 0.0;                    ///< density makes no line and no dot finer, in logical pixels
};

/// The `scale` of a page on which the letters of legend, scale bar and axes have this size in points.
double scale_for_letters(double points);

/// The layers of one variant with their styles, in the form of sessions.
LayerConfiguration configuration_of(const ShownLayers& shown);

/// The layers with their styles on its background, as the window draws them: finer where samples are dense
/// (`thinned`). `spacing_px`: spacing of the samples in logical pixels of the picture; 0: unchanged styles, as in
/// legends.
std::vector<render::LayerView> views_of(const ShownLayers& shown, double spacing_px);

/// The area that "fit" shows: the samples, and the shown layers that count for it. The latter may extend the box
/// beyond the samples by at most a tenth of their extent: the balls of a good sample stay within that, and one huge
/// ball at a hole of the curve must not shrink everything else to a dot.
Box2 fit_box(std::span<const LayerDescriptor> descriptors, const Box2& samples, const LayerMirror& mirror,
             std::span<const VariantLayer> layers);

}  // namespace mes
