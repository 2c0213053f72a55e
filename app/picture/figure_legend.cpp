// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/figure_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/picture/internal/legend_entries.h"

namespace mes {
namespace {

constexpr std::size_t kWritten = 1U << 30U;
constexpr double kMargin = 12.0 * figure::kPointsPerPixel;
std::vector<LegendEntry> legend_of(const figure::Drawing& drawing, LegendScope scope) {
  return entries_of(
      drawing.views, scope, [&](const render::LayerView& view) { return shown_map(drawing, view); },
      [&](LayerIndex layer, PrimitiveKind kind) { return !drawing.mirror.instances(layer, kind).empty(); });
}

/// The upper left corner of the legend, within the room.
Vec2 emptiest_corner(const figure::Figure& figure, const Box2& room, double width, double height, double margin) {
  const double left = room.low.x + margin;
  const double top = room.low.y + margin;
  const double right = room.high.x - margin - width;
  const double bottom = room.high.y - margin - height;
  Vec2 best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Vec2 corner : {Vec2{right, bottom}, Vec2{left, bottom}, Vec2{right, top}, Vec2{left, top}}) {
    const Box2 legend{corner, corner + Vec2{width, height}};
    // What is written there already counts as more than any geometry.
    const auto covers = [&](const figure::Box& box) {
      return box.corner.x < legend.high.x && legend.low.x < box.corner.x + box.width &&
             box.corner.y < legend.high.y && legend.low.y < box.corner.y + box.height;
    };
    const auto written = static_cast<std::size_t>(std::ranges::count_if(figure.legend.boxes, covers));
    const std::size_t hidden = figure::shapes_in(figure, legend) + kWritten * written;
    if (hidden < least) {
      least = hidden;
      best = corner;
    }
  }
  return best;
}

}  // namespace

bool has_legend(const figure::Drawing& drawing, LegendScope scope) {
  return !legend_of(drawing, scope).empty();
}

void add_legend(figure::Figure& figure, const figure::Drawing& drawing, LegendScope scope,
                const FigureLegendPlace& where, const PaperFonts& fonts) {
  const std::vector<LegendEntry> entries = legend_of(drawing, scope);
  if (entries.empty()) return;
  const auto pixels = [](double points) { return static_cast<int>(std::ceil(points / figure::kPointsPerPixel)); };
  const PictureLegend legend =
      layout_legend(entries, fonts, pixels(figure.width), pixels(figure.height), drawing.scale, drawing.background);
  const double scale = legend.scale * figure::kPointsPerPixel;
  const auto placed_corner = [&] {
    constexpr double kPixels = 1.0 / figure::kPointsPerPixel;
    return figure::kPointsPerPixel *
           corner_of(legend, *where.place, {kPixels * where.room.low, kPixels * where.room.high});
  };
  const Vec2 corner = where.place ? placed_corner()
                                  : emptiest_corner(figure, where.room, scale * legend.drawing.width,
                                                    scale * legend.drawing.height, kMargin * legend.scale);
  add_to(figure, fonts, legend.drawing, corner, legend.scale);
}

}  // namespace mes
