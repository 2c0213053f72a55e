// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of layers: what `mesecina render` writes into a vector format.
#pragma once

#include <span>
#include <string>

#include "app/cli/picture_request.h"
#include "core/base/box2.h"
#include "core/base/error.h"
#include "core/draw/layer_mirror.h"
#include "render/colormap.h"
#include "render/image.h"

namespace mes::cli {

/// What a figure is made of.
struct FigureSource {
  const LayerMirror& mirror;
  const std::vector<Vec2>& samples;
  const Box2& bounds;  ///< of the document
  std::span<const render::ColorMap> maps;
  const render::Image* traced = nullptr;  ///< null: none
  bool with_legend = true;
};

/// The bytes of the file. Error: as of the writers, and `usage` for a page that cannot hold the figure.
Expected<std::string> draw_figure(const PictureRequest& request, const FigureSource& source);

}  // namespace mes::cli
