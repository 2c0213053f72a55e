// SPDX-License-Identifier: GPL-3.0-or-later
// What is painted on a picture of the drawing alone: the legend, and a caption below.
//
// It is plain data once made, so that pictures can be finished on other threads.
//
// Smallest use:
//     const PictureOverlay overlay = picture_overlay_of(legend_of(scene, views), caption, fonts, {width, height,
//     scale, background}); overlay.paint(image);
//
// Cost: to make some microseconds, to paint some milliseconds. Threads: const is safe.
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

/// The picture that it is for.
struct OverlayTarget {
  int width = 0;
  int height = 0;
  double scale = 1.0;  ///< pixels to a logical one
  std::optional<Rgb> background;
};

/// Without fonts it is empty.
PictureOverlay picture_overlay_of(std::span<const LegendEntry> entries, std::string caption,
                                  std::shared_ptr<const LegendFonts> fonts, const OverlayTarget& target);

}  // namespace mes
