// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/pane_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/draw/variant.h"

namespace mes {
namespace {

constexpr double kPaneGap = 16.0;       // logical pixels
constexpr double kBand = 30.0;          // height of a label with its surroundings
constexpr double kLabelLetters = 16.0;  // height of its letters
constexpr double kSmallest = 8.0;       // height if there is less room

/// A picture of one colour, or a transparent one.
render::Image plain_image(int width, int height, const std::optional<Rgb>& color) {
  render::Image out{width, height, {}};
  out.rgba.resize(out.offset(0, height));
  if (!color) return out;
  const std::array<std::uint8_t, 4> pixel{color->r, color->g, color->b, 0xFF};
  for (std::size_t at = 0; at < out.rgba.size(); at += pixel.size())
    std::ranges::copy(pixel, out.rgba.begin() + static_cast<std::ptrdiff_t>(at));
  return out;
}

/// Overwrites the pixels from (x, y) on.
void paste(const render::Image& part, render::Image& image, int x, int y) {
  const auto row_bytes = static_cast<std::ptrdiff_t>(part.offset(part.width, 0));
  for (int row = 0; row < part.height; ++row) {
    const auto from = part.rgba.begin() + static_cast<std::ptrdiff_t>(part.offset(0, row));
    std::copy(from, from + row_bytes, image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(x, y + row)));
  }
}

}  // namespace

std::string pane_letter(std::size_t pane) {
  return std::string(1, static_cast<char>('a' + pane));
}

std::string pane_label(std::size_t pane, const std::string& words) {
  return '(' + pane_letter(pane) + ") " + words;
}

Vec2 PaneGrid::corner(std::size_t pane) const {
  return {static_cast<double>(pane % columns) * (pane_width + gap),
          static_cast<double>(pane / columns) * (pane_height + band + gap)};
}

Vec2 PaneGrid::extent() const {
  return corner(columns * rows - 1) + Vec2{pane_width, pane_height + band};
}

PaneGrid PaneGrid::scaled(double factor) const {
  return {columns, rows, factor * pane_width, factor * pane_height, factor * gap, factor * band};
}

PaneGrid lay_out(std::size_t panes, double width, double height, double proportions, double unit) {
  PaneGrid best;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t columns = 1; columns <= panes; ++columns) {
    PaneGrid grid = lay_out_panes_of(0.0, 0.0, panes, columns, unit);
    const auto share = [&](double side, std::size_t parts) {
      return (side - static_cast<double>(parts - 1) * grid.gap) / static_cast<double>(parts);
    };
    grid.pane_width = share(width, grid.columns);
    grid.pane_height = share(height, grid.rows) - grid.band;
    // The width of the box in a pane. Of equal widths, a grid without an empty position wins.
    const double size = std::min(grid.pane_width, grid.pane_height / std::max(proportions, 1e-6));
    if (size > largest) {
      largest = size;
      best = grid;
    }
  }
  return best;
}

PaneGrid lay_out_panes_of(double pane_width, double pane_height, std::size_t panes, std::size_t columns,
                          double unit) {
  return {.columns = columns,
          .rows = (panes + columns - 1) / columns,
          .pane_width = pane_width,
          .pane_height = pane_height,
          .gap = kPaneGap * unit,
          .band = kBand * unit};
}

std::size_t usual_columns(std::size_t panes) {
  constexpr std::size_t kInARow = 3;
  return panes <= kInARow ? panes : static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(panes))));
}

PaperDrawing layout_pane_labels(std::span<const std::string> labels, const PaneGrid& grid, const MeasureText& measure,
                                const std::optional<Rgb>& background) {
  const PaperColors colors = paper_colors(background);
  PaperDrawing out;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Vec2 corner = grid.corner(i);
    const Vec2 across{grid.pane_width, 0.0};
    const Vec2 down{0.0, grid.pane_height};
    out.strokes.push_back(
        {{corner, corner + across, corner + across + down, corner + down, corner}, kPaneFrame, colors.frame});
    const std::string& label = labels[i];
    const double natural = measure(label, kLabelLetters, Face::plain);
    const double size =
        natural > grid.pane_width ? std::max(kSmallest, kLabelLetters * grid.pane_width / natural) : kLabelLetters;
    const double width = measure(label, size, Face::plain);
    out.lines.push_back({.x = corner.x + 0.5 * (grid.pane_width - width),
                         .top = corner.y + grid.pane_height + 0.5 * (grid.band - size),
                         .size = size,
                         .face = Face::plain,
                         .color = colors.ink,
                         .text = label});
    out.width = std::max(out.width, corner.x + grid.pane_width);
    out.height = std::max(out.height, corner.y + grid.pane_height + grid.band);
  }
  return out;
}

bool are_alike(std::span<const ShownPanes::Layers> panes) {
  const auto is_same = [](const auto& a, const auto& b) {
    return a.first.layer == b.first.layer && a.second == b.second;
  };
  return std::ranges::all_of(
      panes, [&](const ShownPanes::Layers& pane) { return std::ranges::equal(pane, panes.front(), is_same); });
}

render::Image PaneSheet::with(std::span<const render::Image> panes, const PaperFonts& fonts) const {
  render::Image image = plain_image(width, height, background);
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const Vec2 corner = grid.corner(i);
    paste(panes[i], image, static_cast<int>(corner.x), band + static_cast<int>(corner.y));
  }
  paint(image, fonts, layout_pane_labels(labels, grid.scaled(1.0 / scale), measure_with(fonts, scale), background),
        {0.0, band}, scale);
  paint(image, fonts, title, {0.0, 0.0}, scale);
  return image;
}

}  // namespace mes
