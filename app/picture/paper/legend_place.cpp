// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/legend_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mes {
namespace {

constexpr double kBarApart = 6.0;  // least distance from the scale bar

bool boxes_overlap(const Box2& a, const Box2& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool is_within(const Box2& box, const Box2& room) {
  return room.low.x <= box.low.x && box.high.x <= room.high.x && room.low.y <= box.low.y && box.high.y <= room.high.y;
}

/// Candidate positions for a box of one size.
class LegendPlaces {
 public:
  LegendPlaces(const LegendSurroundings& around, Vec2 size, double margin)
      : around_(around), size_(size), margin_(margin) {}

  /// The given position, or one next to the scale bar there, or else the best corner.
  std::optional<Vec2> best() const {
    if (around_.place)
      if (const auto there = nearest_free(placed(*around_.place, size_, around_.room))) return there;
    if (!around_.strip.is_empty())
      if (const auto there = nearest_free(corners().front())) return there;
    std::optional<Vec2> out;
    std::pair<std::size_t, std::size_t> least;
    for (const Vec2 corner : corners()) {
      const auto here = nearest_free(corner);
      if (!here) continue;
      const auto cost = around_.cost_of(box_at(*here));
      if (out && cost >= least) continue;
      out = here;
      least = cost;
    }
    return out;
  }

 private:
  Box2 box_at(Vec2 corner) const { return {corner, corner + size_}; }

  std::array<Vec2, 4> corners() const {
    const Box2& room = around_.room;
    const Vec2 low = room.low + Vec2{margin_, margin_};
    const Vec2 high = room.high - size_ - Vec2{margin_, margin_};
    // A box larger than the room shows its beginning.
    const double left = std::max(room.low.x, std::min(low.x, room.high.x - size_.x));
    const double top = std::max(room.low.y, std::min(low.y, room.high.y - size_.y));
    const double right = std::max(room.low.x, high.x);
    const double bottom = std::max(room.low.y, high.y);
    return {Vec2{right, bottom}, Vec2{left, bottom}, Vec2{right, top}, Vec2{left, top}};
  }

  /// Without a scale bar every position is free.
  bool is_free(Vec2 corner) const {
    const Box2 box = box_at(corner);
    return !around_.bar || (!boxes_overlap(box, *around_.bar) && is_within(box, around_.room));
  }

  std::optional<Vec2> nearest_free(Vec2 corner) const {
    if (is_free(corner)) return corner;
    const Box2& bar = *around_.bar;
    std::optional<Vec2> out;
    for (const Vec2 past : {Vec2{corner.x, bar.low.y - kBarApart - size_.y}, Vec2{corner.x, bar.high.y + kBarApart},
                            Vec2{bar.low.x - kBarApart - size_.x, corner.y}, Vec2{bar.high.x + kBarApart, corner.y}})
      if (is_free(past) && (!out || distance(past, corner) < distance(*out, corner))) out = past;
    return out;
  }

  const LegendSurroundings& around_;
  Vec2 size_;
  double margin_;
};

}  // namespace

std::pair<std::size_t, std::size_t> LegendSurroundings::cost_of(const Box2& box) const {
  const auto covered =
      std::ranges::count_if(words, [&](const Box2& text) { return !text.is_empty() && boxes_overlap(text, box); });
  return {static_cast<std::size_t>(covered), hides ? hides(box) : 0};
}

PlacedLegend place_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double shrink,
                          const LegendSurroundings& around, const std::optional<Rgb>& background) {
  if (entries.empty()) return {};
  const double margin = shrink * kUsualMarginPx;
  const auto with = [&](PaperDrawing drawing) -> std::optional<PlacedLegend> {
    PlacedLegend out{.drawing = std::move(drawing), .shrink = shrink};
    const auto corner = LegendPlaces(around, out.size(), margin).best();
    if (!corner) return std::nullopt;
    out.corner = *corner;
    out.from_below = around.room.high.y - out.corner.y;
    out.hides = around.cost_of({out.corner, out.corner + out.size()});
    return out;
  };
  const auto at_most = [&](double height) {
    return with(layout_legend(entries, measure, height / shrink, background));
  };
  if (around.strip.below > 0.0) {
    const double bar = around.bar ? around.bar->width() + kBarApart : 0.0;
    const double width = around.room.width() - 2.0 * margin - bar;
    if (auto wide = with(layout_wide_legend(entries, measure, width / shrink, background))) return std::move(*wide);
  }
  if (auto whole = at_most(around.room.height() - 2.0 * margin)) {
    const Vec2 size = whole->size();
    if (size.x * size.y > around.most_of_room * around.room.width() * around.room.height())
      return {.lacks_room = true};
    return std::move(*whole);
  }
  // Only a scale bar can leave no free position.
  const double above = around.bar->low.y - around.room.low.y;
  const double beneath = around.room.high.y - around.bar->high.y;
  if (auto part = at_most(std::max(above, beneath) - kBarApart - margin)) return std::move(*part);
  if (auto first = at_most(0.0)) return std::move(*first);
  return {.lacks_room = true};
}

PlacedLegend place_legend(std::span<const LegendEntry> entries, const PaperFonts& fonts, double scale,
                          const LegendSurroundings& around, const std::optional<Rgb>& background) {
  constexpr double kShare = 0.3;
  constexpr double kLeast = 0.7;
  const double shrink =
      around.keeps_letters ? 1.0 : std::clamp(kShare * around.room.high.x / kLegendWidth, kLeast, 1.0);
  return place_legend(entries, measure_with(fonts, scale * shrink), shrink, around, background);
}

LegendStrip strip_for_legend(const std::function<LegendTrial(const LegendStrip&)>& lay_out) {
  constexpr std::size_t kLessHidden = 4;
  constexpr double kMostOfSide = 0.6;  // share of the side of the picture
  const LegendTrial bare = lay_out({});
  const PlacedLegend& corner = bare.legend;
  if (corner.drawing.is_empty() || corner.hides == std::pair<std::size_t, std::size_t>()) return {};
  const auto is_better = [&](const PlacedLegend& legend) {
    if (legend.hides.first != corner.hides.first) return legend.hides.first < corner.hides.first;
    return legend.hides.second < corner.hides.second && kLessHidden * legend.hides.second <= corner.hides.second;
  };
  const double margins = 2.0 * corner.shrink * kUsualMarginPx;
  LegendStrip out;
  double least = 0.0;
  const auto try_strip = [&](const LegendStrip& strip) {
    const LegendTrial trial = lay_out(strip);
    if (strip.below > kMostOfSide * trial.height || strip.right > kMostOfSide * trial.width) return;
    if (!is_better(trial.legend) || (!out.is_empty() && trial.units_per_pixel >= least)) return;
    out = strip;
    least = trial.units_per_pixel;
  };
  // The strip below has the legend in columns, whose layout depends on the width only, above the scale bar if both do
  // not fit beside each other. A picture that grows by a strip has one that is high enough at first.
  constexpr double kHighEnough = 8.0;
  LegendTrial below = lay_out({.below = margins});
  if (below.height > bare.height) below = lay_out({.below = kHighEnough * bare.height});
  try_strip({.below = below.legend.from_below + 0.5 * margins});
  try_strip({.right = corner.size().x + margins});
  return out;
}

void paint(render::Image& image, const PaperFonts& fonts, const PlacedLegend& legend, double scale) {
  if (legend.drawing.is_empty()) return;
  paint(image, fonts, legend.drawing, {std::round(scale * legend.corner.x), std::round(scale * legend.corner.y)},
        scale * legend.shrink);
}

}  // namespace mes
