// SPDX-License-Identifier: GPL-3.0-or-later
// How a figure is to be made. Plain data, remembered from one start to the next.
#pragma once

#include <cstdint>
#include <string>

#include "app/model/scale_marks.h"

namespace mes {

/// What of the plane a figure shows.
enum class FigureExtent : std::uint8_t {
  view,        ///< what the window shows between its panels
  everything,  ///< samples, balls and the layers that count for "fit", with a margin
  ink,         ///< the view, cut to what is drawn
};

enum class FigurePaper : std::uint8_t { white, canvas, transparent };

inline constexpr double kLeastFigureSide = 1.0;  ///< millimetres
inline constexpr double kMostFigureSide = 5080.0;
inline constexpr double kLeastDotsPerInch = 10.0;
inline constexpr double kMostDotsPerInch = 2400.0;

struct FigureSettings {
  std::string extension = ".pdf";  ///< of the format
  double width_mm = 84.0;
  double height_mm = 0.0;  ///< 0: what the width asks for
  bool in_inches = false;  ///< how sizes are shown
  FigureExtent extent = FigureExtent::view;
  FigurePaper paper = FigurePaper::white;
  bool as_on_screen = true;  ///< lines and points are to the page as they are to the canvas
  double line_scale = 1.0;   ///< otherwise: factor for their widths, whose pixels are 1/96 inch; [0.1, 10]
  bool with_legend = true;
  bool with_key = false;  ///< of all layers
  ScaleMarks marks{};
  std::string title{};  ///< above the drawing, as annotations are written; of this run of the program alone
  bool with_annotations = true;
  bool all_panes = true;          ///< where the window shows several
  bool with_differences = false;  ///< marked: what only some of the panes have
  bool with_source = true;        ///< the file carries the document, where the format can
  double dots_per_inch = 300.0;   ///< of layers that become pictures
  friend bool operator==(const FigureSettings&, const FigureSettings&) = default;
};

}  // namespace mes
