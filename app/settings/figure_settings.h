// SPDX-License-Identifier: GPL-3.0-or-later
// The options of a figure. Plain data, remembered from one start to the next.
#pragma once

#include <cstdint>
#include <string>

#include "app/settings/scale_marks.h"

namespace mes {

/// The part of the plane that a figure shows.
enum class FigureExtent : std::uint8_t {
  view,        ///< the view of the window between its panels
  everything,  ///< samples, balls and the layers that count for "fit", with a margin
  ink,         ///< the view, cut to the drawing
};

enum class FigurePaper : std::uint8_t { white, canvas, transparent };

inline constexpr double kLeastFigureSide = 1.0;  ///< millimetres
inline constexpr double kMostFigureSide = 5080.0;
inline constexpr double kLeastLettersPt = 4.0;
inline constexpr double kMostLettersPt = 36.0;
inline constexpr double kMostLeastLinePt = 4.0;
inline constexpr double kLeastDotsPerInch = 10.0;
inline constexpr double kMostDotsPerInch = 2400.0;

struct FigureSettings {
  std::string extension = ".pdf";  ///< extension of the format
  double width_mm = 84.0;
  double height_mm = 0.0;  ///< 0: follows from the width
  bool in_inches = false;  ///< unit of the displayed sizes
  FigureExtent extent = FigureExtent::view;
  FigurePaper paper = FigurePaper::white;
  bool as_on_screen = false;  ///< lines, points and letters have the same proportion to the page as to the canvas
  /// Otherwise: the size of the letters in points; lines and points keep their proportion to it.
  double letters_pt = 7.5;
  double least_line_pt = 0.5;  ///< no line is finer then
  bool with_legend = true;
  bool with_key = false;  ///< key of all layers
  ScaleMarks marks{};
  std::string title{};  ///< above the drawing, in the syntax of annotations; only for this run of the program
  bool with_annotations = true;
  bool all_panes = true;          ///< if the window shows several
  bool with_differences = false;  ///< marks elements that only some of the panes have
  bool with_source = true;        ///< the file carries the document, if the format can
  double dots_per_inch = 300.0;   ///< for layers that become pictures
  friend bool operator==(const FigureSettings&, const FigureSettings&) = default;
};

}  // namespace mes
