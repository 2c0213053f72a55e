// SPDX-License-Identifier: GPL-3.0-or-later
// Panes side by side on one sheet: their positions, the labels below them, and the lines around them.
//
// Smallest use:
//     const PaneGrid grid = lay_out(labels.size(), 1600.0, 1200.0, proportions, scale);
//     const PaneSheet sheet{.width = 1600, .height = 1200, .scale = scale, .grid = grid, .labels = labels};
//     const render::Image image = sheet.with(pictures, fonts);
//
// Cost: O(pixels). Threads: any.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/panes/pane_list.h"
#include "app/picture/paper/paper_drawing.h"
#include "core/base/color.h"
#include "core/base/geometry/vec2.h"
#include "render/image/image.h"

namespace mes {

/// The letter of a pane, from "a" to "z".
std::string pane_letter(std::size_t pane);
/// The label of a pane: "(a) precision exact".
std::string pane_label(std::size_t pane, const std::string& words);

/// The positions of panes on a page; all have the same size. Lengths are in the unit of the page.
struct PaneGrid {
  std::size_t columns = 1;
  std::size_t rows = 1;
  double pane_width = 0.0;
  double pane_height = 0.0;
  double gap = 0.0;   ///< between neighbours
  double band = 0.0;  ///< height below each pane, for its label
  /// The upper left corner of a pane.
  Vec2 corner(std::size_t pane) const;
  /// The lower right corner of all panes.
  Vec2 extent() const;
  /// Multiplies all lengths by a factor.
  PaneGrid scaled(double factor) const;
};

/// Chooses the columns with which a box of the given proportions (height by width) is drawn largest; `unit` is the
/// length of a logical pixel. Sides of panes may come out too small, or negative.
PaneGrid lay_out(std::size_t panes, double width, double height, double proportions, double unit);
/// A grid of panes of a given size.
PaneGrid lay_out_panes_of(double pane_width, double pane_height, std::size_t panes, std::size_t columns, double unit);
/// Number of columns if the height of the page follows from the panes: rows of up to three, or a square.
std::size_t usual_columns(std::size_t panes);

/// Width of the line around a pane, in logical pixels.
inline constexpr double kPaneFrame = 0.75;

/// The labels below the panes and a line around each pane, on a page in logical pixels.
PaperDrawing layout_pane_labels(std::span<const std::string> labels, const PaneGrid& grid, const MeasureText& measure,
                                const std::optional<Rgb>& background);

/// True if a legend of the first pane explains all panes: they show the same layers in the same styles.
bool are_alike(std::span<const ShownPanes::Layers> panes);

/// A sheet in pixels.
struct PaneSheet {
  int width = 0;
  int height = 0;
  int band = 0;                     ///< height above the panes, for a title
  double scale = 1.0;               ///< pixels per logical pixel
  std::optional<Rgb> background{};  ///< nothing: transparent
  PaneGrid grid{};                  ///< in pixels
  std::vector<std::string> labels{};
  PaperDrawing title{};  ///< drawn in the band

  int pane_width() const { return static_cast<int>(grid.pane_width); }
  int pane_height() const { return static_cast<int>(grid.pane_height); }
  /// The sheet with these pictures of `pane_width` x `pane_height`, the labels and the title.
  render::Image with(std::span<const render::Image> panes, const PaperFonts& fonts) const;
};

}  // namespace mes
