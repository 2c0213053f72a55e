// SPDX-License-Identifier: GPL-3.0-or-later
// The explanations on a saved picture: annotations, the legend, scale bar and axes, and a caption below it.
//
// An overlay is plain data, so pictures can be finished on other threads.
//
// Smallest use:
//     const PictureOverlay overlay =
//         picture_overlay_of({legend_of(layers, scene, views), caption}, fonts, {camera, scale, background});
//     overlay.paint(image);
//
// Cost: some microseconds to make, some milliseconds to paint. Threads: const calls may run at the same time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/annotations/annotation_drawing.h"
#include "app/picture/ink_map.h"
#include "app/picture/paper/legend_place.h"
#include "app/settings/scale_marks.h"
#include "core/base/color.h"
#include "render/camera.h"
#include "render/image/image.h"

namespace mes {

struct PictureOverlay {
  std::shared_ptr<const PaperFonts> fonts;
  PlacedLegend legend;
  PaperDrawing highlights;  ///< highlights of annotations, below the others
  PaperDrawing annotations;
  PaperDrawing marks;  ///< scale bar, axes and grid
  double marks_scale = 1.0;
  PaperDrawing title{};
  std::string caption;
  std::optional<Rgb> background;  ///< nothing: transparent

  bool is_empty() const {
    return !fonts || (legend.drawing.is_empty() && highlights.is_empty() && annotations.is_empty() &&
                      marks.is_empty() && title.is_empty() && caption.empty());
  }
  void paint(render::Image& image) const;
};

/// The picture that an overlay is made for.
struct OverlayTarget {
  render::Camera camera;
  double scale = 1.0;  ///< pixels per logical pixel
  std::optional<Rgb> background;
};

/// The requested content.
struct OverlayContent {
  std::vector<LegendEntry> legend;
  std::string caption;
  ScaleMarks marks{};
  PlacedAnnotations annotations{};
  PaperDrawing title{};                   ///< made by `layout_title`
  std::optional<PaperPlace> legend_at{};  ///< nothing: the lower right corner, or a free one
  std::string unit{};                     ///< of lengths, as `unit_of_lengths` gives it
};

/// Without fonts the overlay is empty. Legend and scale bar without a given position avoid what is drawn, if `ink` says
/// where that is; without it they do not depend on the drawing, as in a sequence of pictures.
PictureOverlay picture_overlay_of(OverlayContent content, std::shared_ptr<const PaperFonts> fonts,
                                  const OverlayTarget& target, const InkMap* ink = nullptr);

}  // namespace mes
