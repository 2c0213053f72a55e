// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/scale_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/picture/paper/internal/small_text.h"
#include "core/document/document.h"
#include "core/io/text/round_numbers.h"

namespace mes {
namespace {

constexpr double kTick = 5.0;
constexpr double kMargin = kUsualMarginPx;
constexpr double kLabelsApart = 10.0;
constexpr double kEnd = 8.0;  // height of the ends of a bar
constexpr double kBarShare = 0.25;
// The least distance of ticks.
constexpr double kLeastStep = 56.0;

/// A position along an axis, from the first end of the edge, and the number there.
struct Tick {
  double at = 0.0;
  std::string label;
};

std::vector<Tick> ticks_along(double center, double length, double units_per_pixel) {
  const double half = 0.5 * length * units_per_pixel;
  const double largest = std::abs(center) + half;
  const double step = grid_step(units_per_pixel);
  // With smaller steps neighbouring numbers are equal, or their lines are not at these numbers.
  constexpr double kDoublesInStep = 64.0;
  if (!std::isfinite(largest) || step < kDoublesInStep * std::numeric_limits<double>::epsilon() * largest) return {};
  std::vector<Tick> out;
  const double first = std::ceil((center - half) / step);
  for (double i = first; i * step <= center + half; i += 1.0)
    out.push_back({(i * step - (center - half)) / units_per_pixel, number_text(i * step, step)});
  return out;
}

class ScaleLayout {
 public:
  ScaleLayout(const SeenPlane& plane, const MeasureText& measure, const std::optional<Rgb>& background)
      : plane_(plane), measure_(measure), colors_(paper_colors(background)), paper_(background) {
    drawing_.width = plane.width;
    drawing_.height = plane.height;
  }

  void grid() {
    constexpr double kFaint = 0.22;
    const double bottom = plane_.height - plane_.covered;
    for (const Tick& tick : ticks_along(plane_.center.y, plane_.height, plane_.units_per_pixel))
      if (const double y = plane_.height - tick.at; y <= bottom)
        drawing_.boxes.push_back({0.0, y - 0.5, plane_.width, 1.0, colors_.quiet, kFaint});
    for (const Tick& tick : ticks_along(plane_.center.x, plane_.width, plane_.units_per_pixel))
      drawing_.boxes.push_back({tick.at - 0.5, 0.0, 1.0, bottom, colors_.quiet, kFaint});
  }

  void axes() {
    const double bottom = plane_.height - plane_.covered;
    line(0.0, bottom - 1.0, plane_.width, 1.0);
    line(0.0, 0.0, 1.0, bottom);
    // Lays out the left edge first, because the bar needs to know its room; y grows upwards there.
    for (const Tick& tick : ticks_along(plane_.center.y, plane_.height, plane_.units_per_pixel)) {
      const double y = plane_.height - tick.at;
      if (y > bottom) continue;
      line(0.0, y - 0.5, kTick, 1.0);
      const double width = measure_(tick.label, kSmallTextSize, Face::plain);
      if (y - 0.5 * kSmallLineHeight < 0.0 || y + 0.5 * kSmallLineHeight > bottom - kAxisRoom) continue;
      number(kTick + 4.0, y - 0.5 * kSmallLineHeight, width, tick.label);
      left_room_ = std::max(left_room_, kTick + 4.0 + width);
    }
    double taken = 0.0;
    for (const Tick& tick : ticks_along(plane_.center.x, plane_.width, plane_.units_per_pixel)) {
      line(tick.at - 0.5, bottom - kTick, 1.0, kTick);
      const double width = measure_(tick.label, kSmallTextSize, Face::plain);
      const double left = tick.at - 0.5 * width;
      if (left < taken + kLabelsApart || left + width > plane_.width - 2.0) continue;
      number(left, bottom - kTick - 2.0 - kSmallLineHeight, width, tick.label);
      taken = left + width;
    }
    bottom_room_ = kAxisRoom;
  }

  void bar(const std::optional<PaperPlace>& place) {
    const double most = kBarShare * plane_.width * plane_.units_per_pixel;
    if (!(most > 0.0) || !std::isfinite(most)) return;
    const double units = round_number_up_to(most);
    const double length = units / plane_.units_per_pixel;
    const std::string label = number_text(units, units) + (plane_.unit.empty() ? "" : " " + plane_.unit);
    const double width = measure_(label, kSmallTextSize, Face::plain);
    const Vec2 size{std::max(length, width), kEnd + kSmallLineHeight};
    const Vec2 at = bar_corner(place, length, size);
    bar_box_ = Box2{at, at + size};
    const double left = at.x + 0.5 * (size.x - length);
    const double foot = at.y + size.y;
    constexpr double kBeside = 6.0;
    constexpr double kAbove = 4.0;
    const Vec2 most_size{std::max(kBarShare * plane_.width, size.x), size.y};
    const Vec2 most_at = place ? placed(*place, most_size, room()) : at;
    longest_bar_ = Box2{at - Vec2{kBeside, kAbove}, at + size + Vec2{kBeside, kAbove}};
    longest_bar_->add(Box2{most_at - Vec2{kBeside, kAbove}, most_at + most_size + Vec2{kBeside, kAbove}});
    box(at.x - kBeside, at.y - kAbove, size.x + 2.0 * kBeside, size.y + 2.0 * kAbove, paper());
    constexpr double kThick = 2.0;
    box(left, foot - kThick, length, kThick, colors_.ink);
    box(left, foot - kEnd, kThick, kEnd, colors_.ink);
    box(left + length - kThick, foot - kEnd, kThick, kEnd, colors_.ink);
    drawing_.lines.push_back({at.x + 0.5 * (size.x - width), at.y, kSmallTextSize, Face::plain, colors_.ink, label});
  }

  /// The area within the axes, if they have been laid out.
  Box2 room() const {
    return {{left_room_, plane_.covered_above}, {plane_.width, plane_.height - plane_.covered - bottom_room_}};
  }
  const std::optional<Box2>& bar_box() const { return bar_box_; }
  const std::optional<Box2>& longest_bar() const { return longest_bar_; }
  PaperDrawing take() { return std::move(drawing_); }

 private:
  /// Without a given position, the margin is that of the line, not of its number.
  Vec2 bar_corner(const std::optional<PaperPlace>& place, double length, Vec2 size) const {
    if (place) return placed(*place, size, room());
    return {left_room_ + kMargin - 0.5 * (size.x - length), room().high.y - kMargin - size.y};
  }
  Rgb paper() const { return paper_.value_or(colors_.paper); }
  void box(double left, double top, double width, double height, Rgb color) {
    drawing_.boxes.push_back({left, top, width, height, color});
  }
  void line(double left, double top, double width, double height) { box(left, top, width, height, colors_.quiet); }
  void number(double left, double top, double width, const std::string& text) {
    box(left - 2.0, top + 1.0, width + 4.0, kSmallLineHeight - 2.0, paper());
    drawing_.lines.push_back({left, top + 1.0, kSmallTextSize, Face::plain, colors_.quiet, text});
  }

  const SeenPlane& plane_;
  const MeasureText& measure_;
  PaperColors colors_;
  std::optional<Rgb> paper_;
  PaperDrawing drawing_;
  double left_room_ = 0.0;
  double bottom_room_ = 0.0;
  std::optional<Box2> bar_box_;
  std::optional<Box2> longest_bar_;
};

ScaleLayout laid_out(const ScaleMarks& marks, const SeenPlane& plane, const MeasureText& measure,
                     const std::optional<Rgb>& background) {
  ScaleLayout layout(plane, measure, background);
  if (marks.grid) layout.grid();
  if (marks.axes) layout.axes();
  if (marks.bar) layout.bar(marks.bar_at);
  return layout;
}

}  // namespace

SeenPlane seen_plane(const render::Camera& camera, double scale) {
  return {.center = camera.center() + camera.center_low(),
          .units_per_pixel = camera.units_per_pixel() * scale,
          .width = camera.width() / scale,
          .height = camera.height() / scale};
}

SeenPlane seen_plane(const figure::Page& page, double scale) {
  const double points = scale * figure::kPointsPerPixel;
  return {.center = page.center + page.center_low,
          .units_per_pixel = page.units_per_point * points,
          .width = page.width / points,
          .height = page.height / points};
}

Box2 below(const SeenPlane& plane, const Box2& box) {
  const auto at = [&](Vec2 px) {
    return plane.center + plane.units_per_pixel * Vec2{px.x - 0.5 * plane.width, 0.5 * plane.height - px.y};
  };
  Box2 out;
  out.add(at(box.low));
  out.add(at(box.high));
  return out;
}

PaperDrawing layout_scale_marks(const ScaleMarks& marks, const SeenPlane& plane, const MeasureText& measure,
                                const std::optional<Rgb>& background) {
  return laid_out(marks, plane, measure, background).take();
}

MarksPlace place_of_marks(const ScaleMarks& marks, const SeenPlane& plane, const MeasureText& measure) {
  const ScaleLayout layout = laid_out(marks, plane, measure, std::nullopt);
  return {layout.bar_box(), layout.longest_bar(), layout.room()};
}

ScaleMarks with_free_bar(ScaleMarks marks, const SeenPlane& plane, const MeasureText& measure,
                         const std::function<std::pair<std::size_t, std::size_t>(const Box2&)>& hides) {
  if (!marks.bar || marks.bar_at) return marks;
  std::optional<PaperPlace> best;
  const auto cost_at = [&](const std::optional<PaperPlace>& place) {
    marks.bar_at = place;
    const MarksPlace placed = place_of_marks(marks, plane, measure);
    return placed.longest_bar ? hides(*placed.longest_bar) : std::pair<std::size_t, std::size_t>();
  };
  auto least = cost_at(best);
  for (const PaperCorner corner : {PaperCorner::bottom_right, PaperCorner::top_left, PaperCorner::top_right}) {
    const PaperPlace place{.corner = corner};
    const auto cost = cost_at(place);
    if (!(cost < least)) continue;
    least = cost;
    best = place;
  }
  marks.bar_at = best;
  return marks;
}

std::string unit_of_lengths(const Document& document) {
  return document.map() ? std::string(document.map()->plane_unit()) : std::string();
}

double grid_step(double units_per_pixel) {
  return round_number_from(kLeastStep * units_per_pixel);
}

// Each of the numbers 1, 2, 5, 10, ... is at most two and a half times the previous one.
double pixel_step(double units_per_pixel) {
  return round_number_from(0.4 * units_per_pixel);
}

}  // namespace mes
