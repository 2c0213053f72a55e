// SPDX-License-Identifier: GPL-3.0-or-later
// The title of a picture, in a band at its upper edge. The drawing is fitted into the area below.
//
// Smallest use:
//     const PictureTitle title = layout_title("Crust of $\\varepsilon$-samples", 800.0, 600.0, measure, kWhiteCanvas);
//     paint(image, fonts, title.drawing, {0.0, 0.0}, 1.0);
//
// Cost: microseconds. Threads: any.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/picture/paper/paper_drawing.h"
#include "render/camera.h"
#include "render/figure/figure_of.h"

namespace mes {

/// Lengths are in logical pixels, from the upper left corner of the picture.
struct PictureTitle {
  PaperDrawing drawing;     ///< as wide as the picture, and as high as the band; empty without text
  std::string complaint{};  ///< about text that is not understood, one line; empty if all is
};

/// Lays out centred text, in the syntax of `rich_text`. Letters become smaller if the text would be wider than the
/// picture, or higher than a third of it.
PictureTitle layout_title(std::string_view words, double width, double height, const MeasureText& measure,
                          const std::optional<Rgb>& background);

/// The edges of a picture that fitted contents avoid, in pixels.
struct EdgeRoom {
  int above = 0;
  int below = 0;
  int left = 0;
  int right = 0;
};
/// A camera that shows the box in the rest of the picture, with a margin that is this share of the shorter side
/// there; at the edges it shows more of the plane.
render::Camera camera_within(const EdgeRoom& edges, int width, int height, const Box2& box, double margin);

/// The room that axes take at the edges, for a picture with `scale` pixels per logical pixel.
EdgeRoom room_of_axes(double scale);

/// Strips at the edges of a page, in points.
struct PageEdges {
  double above = 0.0;
  double below = 0.0;
  double right = 0.0;
};
/// The page with these strips around it, which show more of the plane.
figure::Page with_edges(figure::Page page, const PageEdges& edges);

}  // namespace mes
