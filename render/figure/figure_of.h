// SPDX-License-Identifier: GPL-3.0-or-later
// Converts layers, as shown on screen, to a figure.
//
// The same views (layer and style, bottom first) give a picture by `Scene` and a figure by `figure_of`; render/look.h
// defines the meaning of a style for both.
//
// Smallest use:
//     const Page page = page_of(camera);
//     const Figure figure = figure_of({.mirror = mirror, .layers = registry.layers(), .views = views, .maps = maps}, page);
//     const std::string bytes = svg_of(figure);
//
// Cost: O(n log n) for n primitives, about a microsecond each. Threads: any; nothing is kept.
#pragma once

#include <span>
#include <string>

#include "core/base/geometry/box2.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/layer_mirror.h"
#include "render/camera.h"
#include "render/figure/figure.h"
#include "render/instances/colormap.h"
#include "render/scene.h"

namespace mes::figure {

/// The part of the plane that a page shows.
struct Page {
  Vec2 center{};
  Vec2 center_low{};  ///< bits that `center` cannot represent, as in a camera
  double units_per_point = 1.0;
  double width = 0.0;  ///< in points
  double height = 0.0;
};

/// The camera's view on a page of the same proportions, `width` points wide.
Page page_of(const render::Camera& camera, double width);
/// The same at its natural size.
Page page_of(const render::Camera& camera);

/// A part of the page as a page of its own; `part` in points, y downwards.
Page part_of(const Page& page, const Box2& part);

/// The picture to trace and its layer.
struct Traced {
  VariantLayer layer = kNoLayer;
  const render::Image* image = nullptr;  ///< null: no picture
  render::PicturePlace place;
};

struct Drawing {
  const LayerMirror& mirror;
  std::span<const LayerDescriptor> layers;   ///< of all layers of one variant: ids, names, and presence of scalars
  std::span<const render::LayerView> views;  ///< bottom first; `every` is ignored
  std::span<const render::ColorMap> maps{};
  std::optional<Rgb> background{};
  double scale = 1.0;  ///< factor for line widths and point sizes, whose logical pixels are 0.75 points
  Traced traced{};
};

Figure figure_of(const Drawing& drawing, const Page& page);

/// The colour map of a layer, like `Scene::shown_map`.
render::ShownMap shown_map(const Drawing& drawing, const render::LayerView& view);

/// Bounds in points of shapes, images, texts and legend on the page, strokes included; empty if there are none.
Box2 ink_box(const Figure& figure);
/// The same for one layer, which may extend beyond the page.
Box2 ink_box(const FigureLayer& layer);
/// The same for the layer's image and shapes only.
Box2 ink_below_texts(const FigureLayer& layer);

}  // namespace mes::figure
