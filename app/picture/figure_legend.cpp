// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/figure_legend.h"

#include <array>
#include <cmath>
#include <limits>

#include "app/picture/internal/legend_entries.h"

namespace mes {
namespace {

constexpr double kMargin = 12.0 * figure::kPointsPerPixel;
// From the top of a line to its baseline.
constexpr double kAscent = 0.8;
// Sizes of lines are from the ascender to the descender of Inter, 3408 units, where fonts count its em of 2816.
constexpr double kEm = 2816.0 / 3408.0;

std::vector<LegendEntry> legend_of(const figure::Drawing& drawing) {
  return entries_of(drawing.views, [&](const render::LayerView& view) { return shown_map(drawing, view); });
}

/// The upper left corner of the legend.
Vec2 emptiest_corner(const figure::Figure& figure, double width, double height, double margin) {
  const double right = figure.width - margin - width;
  const double bottom = figure.height - margin - height;
  Vec2 best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Vec2 corner : {Vec2{right, bottom}, Vec2{margin, bottom}, Vec2{right, margin}, Vec2{margin, margin}}) {
    const std::size_t hidden = figure::shapes_in(figure, {corner, corner + Vec2{width, height}});
    if (hidden < least) {
      least = hidden;
      best = corner;
    }
  }
  return best;
}

}  // namespace

bool has_legend(const figure::Drawing& drawing) {
  return !legend_of(drawing).empty();
}

void add_legend(figure::Figure& figure, const figure::Drawing& drawing, const LegendFonts& fonts) {
  const std::vector<LegendEntry> entries = legend_of(drawing);
  if (entries.empty()) return;
  const auto pixels = [](double points) { return static_cast<int>(std::ceil(points / figure::kPointsPerPixel)); };
  const PictureLegend legend =
      layout_legend(entries, fonts, pixels(figure.width), pixels(figure.height), drawing.scale, drawing.background);
  const double scale = legend.scale * figure::kPointsPerPixel;
  const Vec2 corner =
      emptiest_corner(figure, scale * legend.drawing.width, scale * legend.drawing.height, kMargin * legend.scale);
  for (const LegendDrawing::Box& box : legend.drawing.boxes)
    figure.legend.boxes.push_back(
        {corner + scale * Vec2{box.left, box.top}, scale * box.width, scale * box.height, box.color, box.opacity});
  for (const LegendDrawing::Line& line : legend.drawing.lines) {
    const double width =
        render::text_width(line.is_bold ? fonts.bold : fonts.plain, legend.scale * line.size, line.text) *
        figure::kPointsPerPixel;
    figure.legend.texts.push_back({corner + scale * Vec2{line.x, line.top + kAscent * line.size}, scale * line.size,
                                   width, line.is_bold, line.color, line.text});
  }
}

}  // namespace mes
