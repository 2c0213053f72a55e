// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of `mesecina render`, in pixels or vectors, for a single picture and for each of several panes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "app/cli/requests/picture.h"
#include "app/cli/requests/picture_request.h"
#include "app/cli/requests/requests.h"
#include "app/export/figure.h"
#include "app/export/shown_layers.h"
#include "app/picture/paper/legend_place.h"
#include "app/picture/paper/paper_drawing.h"
#include "app/picture/paper/title_drawing.h"
#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/draw/layer_mirror.h"
#include "render/camera.h"
#include "render/device/egl_context.h"
#include "render/device/gl_device.h"
#include "render/image/image.h"
#include "render/scene.h"

namespace mes::cli {

/// The area that must be visible, and the margin around it as a share of the shorter side.
struct Seen {
  Box2 box;
  double margin = 0.0;
};
Seen seen_by(const PictureRequest& picture, const Box2& samples, const LayerMirror& mirror);
/// A camera for the area within these edges. A box with a margin also avoids the axes.
render::Camera camera_for(const PictureSize& size, const Seen& seen, bool has_axes, double scale,
                          const EdgeRoom& taken = {});

/// The title of a picture in pixels, and the height of its band in pixels.
struct TitleBand {
  PaperDrawing drawing;
  int pixels = 0;
};
/// Makes the title, and reports the parts of it that are not understood.
TitleBand title_of(const RenderRequest& request, const PictureSize& size, const ShownLayers& shown);

/// The objects needed to draw a picture in pixels.
struct Canvas {
  render::EglContext context;
  render::GlDevice device;
  render::Scene scene{device};
  explicit Canvas(render::EglContext made) : context(std::move(made)) {}
};

/// The positions of the parts of a picture in pixels.
struct PictureLayout {
  render::Camera camera;
  TitleBand title{};
  LegendStrip strip{};
};
/// Leaves a strip free for the legend if the request permits and the legend hides the drawing otherwise.
PictureLayout layout_of(const PictureSize& size, const Seen& seen, TitleBand title, const Canvas& canvas,
                        const FigureSource& source, const FigureRequest& request);

/// Draws a picture in pixels; the request gives the layers, the marks above them, which are in no legend, and the
/// explanations. The title lies above everything.
Expected<render::Image> draw_pixels(Canvas& canvas, const PictureLayout& layout, const FigureSource& source,
                                    const FigureRequest& request);

/// The bytes of a PNG file that carries a session, if it is not empty.
Expected<std::string> encoded(const render::Image& image, std::string_view session);

/// The properties of a figure.
FigureRequest figure_request(const PictureRequest& picture, const RenderRequest& wanted);

/// The bytes of a figure in its format. Reports parts that were left out, and a large size.
Expected<std::string> written(const PictureRequest& picture, DrawnFigure drawn, bool is_traced, std::string session);

}  // namespace mes::cli
