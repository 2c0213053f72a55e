// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/legend.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/internal/legend_entries.h"
#include "app/picture/paper/internal/small_text.h"
#include "core/io/text/round_numbers.h"

namespace mes {
namespace {

constexpr double kWidth = kLegendWidth;
constexpr double kPadding = 12.0;
constexpr double kBar = 12.0;
constexpr double kTickLength = 4.0;
constexpr double kEntryGap = 12.0;  // gap between entries
constexpr double kRow = 19.0;       // height of an entry in a key
constexpr double kSample = 15.0;
constexpr double kBesideSample = 9.0;
constexpr double kDashGap = 2.0;
constexpr int kBarSteps = 108;
constexpr std::size_t kMostSwatches = 12;

/// Blends `above` onto `below`.
Rgb mixed(Rgb below, Rgb above, double opacity) {
  const auto channel = [opacity](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + opacity * (b - a)));
  };
  return {channel(below.r, above.r), channel(below.g, above.g), channel(below.b, above.b)};
}

/// Breaks the text at spaces into lines of at most this width.
std::vector<std::string> wrapped(const std::string& text, double width, const MeasureText& measure) {
  std::vector<std::string> lines(1);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    std::string& line = lines.back();
    if (line.empty())
      line = word;
    else if (measure(line + ' ' + word, kSmallTextSize, Face::plain) <= width)
      line += ' ' + word;
    else
      lines.push_back(word);
    begin = end + 1;
  }
  return lines;
}

/// Places entries below each other.
class LegendLayout {
 public:
  LegendLayout(const MeasureText& measure, const std::optional<Rgb>& background)
      : measure_(&measure), colors_(paper_colors(background)), background_(background) {}

  double y() const { return y_; }
  PaperDrawing& drawing() { return drawing_; }

  void text(const std::string& line, bool is_bold, Rgb color) {
    drawing_.lines.push_back({kPadding, y_, kSmallTextSize, is_bold ? Face::bold : Face::plain, color, line});
    y_ += is_bold ? kSmallLineHeight + 2.0 : kSmallLineHeight;
  }

  void entry(const LegendEntry& entry) {
    const bool is_row = entry.map == nullptr;
    if (y_ > kPadding && !(is_row && after_row_)) y_ += kEntryGap;
    after_row_ = is_row;
    if (is_row) return row(entry);
    text(entry.title, true, colors_.ink);
    for (const std::string& line : wrapped(entry.scalar, kWidth - 2.0 * kPadding, *measure_))
      text(line, false, colors_.quiet);
    y_ += 3.0;
    if (entry.map->is_categorical)
      swatches(entry);
    else
      bar(entry);
  }

 private:
  // Draws a sample of the layer, with its name beside it.
  void row(const LegendEntry& entry) {
    sample(entry.sample, {kPadding, y_ + 0.5 * (kRow - kSample), kSample, kSample, {}});
    for (const std::string& line :
         wrapped(entry.title, kWidth - 2.0 * kPadding - kSample - kBesideSample, *measure_)) {
      drawing_.lines.push_back({kPadding + kSample + kBesideSample, y_ + 0.5 * (kRow - kSmallLineHeight) + 1.0,
                                kSmallTextSize, Face::plain, colors_.ink, line});
      y_ += kRow;
    }
  }

  void sample(const LayerSample& sample, const PaperDrawing::Box& place) {
    const LayerStyle style = drawn_on(sample.style, background_);
    const Rgb color = mixed(colors_.paper, style.color, style.opacity);
    const Vec2 middle{place.left + 0.5 * place.width, place.top + 0.5 * place.height};
    const double thick = std::clamp(style.line_width_px, 0.5, 5.0);
    if (sample.is_text) {
      const double size = std::clamp(style.point_size_px, 6.0, kSmallTextSize);
      const std::string number = "7";
      const double width = (*measure_)(number, size, Face::plain);
      drawing_.lines.push_back({middle.x - 0.5 * width, middle.y - 0.5 * size, size, Face::plain, color, number});
      return;
    }
    switch (sample.kind) {
      case PrimitiveKind::point:
        drawing_.dots.push_back(
            {middle.x, middle.y, 0.5 * std::clamp(style.point_size_px, 2.0, place.height), color});
        return;
      case PrimitiveKind::disk: drawing_.dots.push_back({middle.x, middle.y, 0.5 * place.height, color}); return;
      case PrimitiveKind::circle:
        drawing_.dots.push_back({middle.x, middle.y, 0.5 * place.height, color});
        drawing_.dots.push_back({middle.x, middle.y, 0.5 * place.height - thick, colors_.paper});
        return;
      case PrimitiveKind::triangle:
        drawing_.boxes.push_back({place.left, place.top, place.width, place.height, color});
        return;
      case PrimitiveKind::segment:
      case PrimitiveKind::ray:
      case PrimitiveKind::line:
      case PrimitiveKind::arc:
      case PrimitiveKind::parabola: break;
    }
    const int dashes = style.dashed ? 3 : 1;
    const double step = (place.width + (dashes > 1 ? kDashGap : 0.0)) / dashes;
    for (int i = 0; i < dashes; ++i)
      drawing_.boxes.push_back(
          {place.left + i * step, middle.y - 0.5 * thick, dashes > 1 ? step - kDashGap : step, thick, color});
  }

  void bar(const LegendEntry& entry) {
    const double width = kWidth - 2.0 * kPadding;
    for (int i = 0; i < kBarSteps; ++i) {
      const double left = width * i / kBarSteps;
      const Rgb color = entry.map->at((i + 0.5) / kBarSteps);
      // Each box extends to the end of the bar and is covered by the next, so edges within a pixel show no seam.
      drawing_.boxes.push_back({kPadding + left, y_, width - left, kBar, color});
    }
    y_ += kBar;
    std::vector<LegendTick> ticks = legend_ticks(entry.range);
    if (ticks.empty()) {
      text("no number is finite", false, colors_.quiet);
      return;
    }
    // Places the ends first, then the ticks between them for which there is room.
    if (ticks.size() > 1) std::rotate(ticks.begin() + 1, ticks.end() - 1, ticks.end());
    std::vector<std::pair<double, double>> taken;
    for (const LegendTick& tick : ticks) {
      const double x = kPadding + tick.at * width;
      drawing_.boxes.push_back({std::min(x, kPadding + width - 1.0), y_, 1.0, kTickLength, colors_.quiet});
      const double size = (*measure_)(tick.label, kSmallTextSize, Face::plain);
      const double left = std::clamp(x - 0.5 * size, kPadding, std::max(kPadding, kPadding + width - size));
      constexpr double kApart = 8.0;
      const bool is_free = std::ranges::none_of(taken, [&](const auto& other) {
        return left < other.second + kApart && other.first < left + size + kApart;
      });
      if (!is_free) continue;
      taken.emplace_back(left, left + size);
      drawing_.lines.push_back({left, y_ + kTickLength + 1.0, kSmallTextSize, Face::plain, colors_.ink, tick.label});
    }
    y_ += kTickLength + 1.0 + kSmallLineHeight;
  }

  // Draws the whole numbers of the range with their colours, side by side as far as there is room.
  void swatches(const LegendEntry& entry) {
    const double low = std::ceil(entry.range.low - 0.5);
    const double high = std::floor(entry.range.high + 0.5);
    if (!(low <= high)) {
      text("no number is finite", false, colors_.quiet);
      return;
    }
    double x = kPadding;
    std::size_t shown = 0;
    for (double value = low; value <= high; value += 1.0) {
      const bool is_left_out = shown == kMostSwatches;
      const std::string label = is_left_out ? "..." : shortest_text(value, 9);
      const double size = (is_left_out ? 0.0 : kBar + 4.0) + (*measure_)(label, kSmallTextSize, Face::plain);
      if (x > kPadding && x + size > kWidth - kPadding) {
        x = kPadding;
        y_ += kSmallLineHeight + 2.0;
      }
      if (!is_left_out) {
        const std::optional<Rgb> color = entry.map->color_of(value, entry.range);
        drawing_.boxes.push_back({x, y_ + 2.0, kBar, kBar, *color});
      }
      drawing_.lines.push_back(
          {x + (is_left_out ? 0.0 : kBar + 4.0), y_, kSmallTextSize, Face::plain, colors_.ink, label});
      x += size + 12.0;
      if (is_left_out) break;
      ++shown;
    }
    y_ += kSmallLineHeight;
  }

  const MeasureText* measure_;
  PaperColors colors_;
  std::optional<Rgb> background_;
  bool after_row_ = false;  // the last entry was a row of a sample and a name
  PaperDrawing drawing_;
  double y_ = kPadding;
};

/// The width that entries laid out below each other take, with the padding.
double width_of(std::span<const LegendEntry> entries, const PaperDrawing& drawing, const MeasureText& measure) {
  // Programs that display figures may substitute a wider font.
  constexpr double kWiderFont = 1.1;
  if (std::ranges::any_of(entries, [](const LegendEntry& entry) { return entry.map != nullptr; })) return kWidth;
  double right = 0.0;
  for (const PaperDrawing::Line& line : drawing.lines)
    right = std::max(right, line.x + measure(line.text, line.size, line.face));
  return kWiderFont * right + kPadding;
}

void add_frame(PaperDrawing& drawing, const std::optional<Rgb>& background) {
  const PaperColors colors = paper_colors(background);
  drawing.boxes.insert(drawing.boxes.begin(), {{0.0, 0.0, drawing.width, drawing.height, colors.frame},
                                               {1.0, 1.0, drawing.width - 2.0, drawing.height - 2.0, colors.paper}});
}

/// Entries below each other, without a frame.
PaperDrawing column_of(std::span<const LegendEntry> entries, const MeasureText& measure,
                       const std::optional<Rgb>& background) {
  LegendLayout layout(measure, background);
  for (const LegendEntry& entry : entries) layout.entry(entry);
  PaperDrawing out = std::move(layout.drawing());
  out.width = width_of(entries, out, measure);
  out.height = layout.y() + kPadding - 4.0;
  return out;
}

/// Adds a column without points, arcs and triangles, which legends do not have.
void add_column(PaperDrawing& drawing, PaperDrawing column) {
  for (PaperDrawing::Box& box : column.boxes) box.left += drawing.width;
  for (PaperDrawing::Dot& dot : column.dots) dot.x += drawing.width;
  for (PaperDrawing::Line& line : column.lines) line.x += drawing.width;
  drawing.boxes.insert(drawing.boxes.end(), column.boxes.begin(), column.boxes.end());
  drawing.dots.insert(drawing.dots.end(), column.dots.begin(), column.dots.end());
  drawing.lines.insert(drawing.lines.end(), column.lines.begin(), column.lines.end());
  drawing.width += column.width;
  drawing.height = std::max(drawing.height, column.height);
}

}  // namespace

std::vector<LegendEntry> legend_of(std::span<const LayerDescriptor> descriptors, const render::Scene& scene,
                                   std::span<const render::LayerView> views, LegendScope scope) {
  return entries_of(
      descriptors, views, scope,
      [&](const render::LayerView& view) { return scene.shown_map(view.layer, view.style); },
      [&](VariantLayer layer, PrimitiveKind kind) { return scene.instances(layer, kind) > 0; });
}

std::vector<LegendEntry> legend_of(const figure::Drawing& drawing, LegendScope scope) {
  return entries_of(
      drawing.layers, drawing.views, scope, [&](const render::LayerView& view) { return shown_map(drawing, view); },
      [&](VariantLayer layer, PrimitiveKind kind) { return !drawing.mirror.instances(layer, kind).empty(); });
}

std::vector<LegendTick> legend_ticks(const render::ScalarRange& range) {
  if (range.is_empty() || !std::isfinite(range.low) || !std::isfinite(range.high)) return {};
  constexpr int kAlone = 6;
  if (range.low == range.high) return {{0.5, shortest_text(range.low, kAlone)}};
  const double width = range.high - range.low;
  // The ends need not be round; they are written to a hundredth of the width.
  const double fine = 0.005 * range.high - 0.005 * range.low;
  std::vector<LegendTick> out{{0.0, number_text(range.low, fine)}};
  if (std::isfinite(width)) {
    const double step = round_number_from(width / 5.0);
    const double first = std::ceil(range.low / step);
    constexpr int kMostTicks = 12;
    constexpr double kNearEnd = 0.02;
    for (int i = 0; i < kMostTicks; ++i) {
      const double value = (first + i) * step;
      const double at = render::place_in(value, range);
      if (!(value < range.high)) break;
      if (value > range.low && at > kNearEnd && at < 1.0 - kNearEnd) out.push_back({at, number_text(value, step)});
    }
  }
  out.push_back({1.0, number_text(range.high, fine)});
  return out;
}

PaperDrawing layout_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double room,
                           const std::optional<Rgb>& background) {
  if (entries.empty()) return {};
  const PaperColors colors = paper_colors(background);
  LegendLayout layout(measure, background);
  std::size_t shown = 0;
  for (const LegendEntry& entry : entries) {
    LegendLayout with = layout;
    with.entry(entry);
    const double rest = shown + 1 < entries.size() ? kEntryGap + kSmallLineHeight : 0.0;
    if (shown > 0 && with.y() + rest + kPadding > room) break;
    layout = std::move(with);
    ++shown;
  }
  if (shown < entries.size()) layout.text(fmt::format("and {} more", entries.size() - shown), false, colors.quiet);
  PaperDrawing out = std::move(layout.drawing());
  out.width = width_of(entries.first(shown), out, measure);
  out.height = layout.y() + kPadding - 4.0;
  add_frame(out, background);
  return out;
}

PaperDrawing layout_wide_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double width,
                                const std::optional<Rgb>& background) {
  if (entries.empty()) return {};
  PaperDrawing out;
  for (std::size_t each = 1; each <= entries.size(); ++each) {
    out = {};
    for (std::size_t begin = 0; begin < entries.size(); begin += each)
      add_column(out, column_of(entries.subspan(begin, std::min(each, entries.size() - begin)), measure, background));
    if (out.width <= width) break;
  }
  add_frame(out, background);
  return out;
}

}  // namespace mes
