// SPDX-License-Identifier: GPL-3.0-or-later
// What a saved picture shows beside the drawing: the legend, and a caption below it.
//
// An overlay is plain data, so pictures can be finished on other threads.
//
// Smallest use:
//     const PictureOverlay overlay =
//         picture_overlay_of(legend_of(scene, views), caption, fonts, {width, height, scale, background});
//     overlay.paint(image);
//
// Cost: some microseconds to make, some milliseconds to paint. Threads: const calls may run at the same time.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/picture/legend.h"
#include "core/base/color.h"
#include "render/image.h"

namespace mes {

struct PictureOverlay {
  std::shared_ptr<const LegendFonts> fonts;
  PictureLegend legend;
  std::string caption;
  std::optional<Rgb> background;  ///< none: transparent

  bool is_empty() const { return !fonts || (legend.drawing.boxes.empty() && caption.empty()); }
  void paint(render::Image& image) const;
};

/// The picture that an overlay is made for.
struct OverlayTarget {
  int width = 0;
  int height = 0;
  double scale = 1.0;  ///< pixels per logical pixel
  std::optional<Rgb> background;
};

/// Without fonts the overlay is empty.
PictureOverlay picture_overlay_of(std::span<const LegendEntry> entries, std::string caption,
                                  std::shared_ptr<const LegendFonts> fonts, const OverlayTarget& target);

}  // namespace mes
