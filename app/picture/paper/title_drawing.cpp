// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/title_drawing.h"

#include <algorithm>
#include <cmath>

#include "app/picture/paper/rich_text.h"
#include "app/picture/paper/scale_drawing.h"

namespace mes {
namespace {

constexpr double kTitleLetters = 20.0;
constexpr double kTitleSpacing = 1.3;
constexpr double kAbove = 0.55;  // share of the height of letters, like the next two
constexpr double kBelow = 0.35;
constexpr double kBesideTitle = 0.5;
constexpr double kWidest = 0.94;  // share of the picture
constexpr double kHighest = 1.0 / 3.0;

double width_of(const RichText& text) {
  double out = 0.0;
  for (const RichLine& line : text.lines) out = std::max(out, line.width);
  return out;
}

/// Height in units of the letter size.
double lines_of(const RichText& text) {
  return 1.0 + kTitleSpacing * static_cast<double>(text.lines.size() - 1);
}

}  // namespace

PictureTitle layout_title(std::string_view words, double width, double height, const MeasureText& measure,
                          const std::optional<Rgb>& background) {
  if (words.find_first_not_of(" \t\r\n") == std::string_view::npos) return {};
  RichText text = rich_text(words, {}, kTitleLetters, measure);
  PictureTitle out{.drawing = {}, .complaint = text.complaint};
  if (text.lines.empty()) return out;
  const double widest = width_of(text) + 2.0 * kBesideTitle * kTitleLetters;
  const double band = (lines_of(text) + kAbove + kBelow) * kTitleLetters;
  const double smaller = std::min({1.0, kWidest * width / widest, kHighest * height / band});
  const double letters = smaller * kTitleLetters;
  if (smaller < 1.0) text = rich_text(words, {}, letters, measure);
  const PaperColors colors = paper_colors(background);
  PaperDrawing& drawing = out.drawing;
  drawing.width = width;
  drawing.height = (lines_of(text) + kAbove + kBelow) * letters;
  // A part of the drawing may lie in the band.
  const double paper = width_of(text) + 2.0 * kBesideTitle * letters;
  constexpr double kOpacity = 0.9;
  drawing.boxes.push_back({.left = 0.5 * (width - paper),
                           .top = 0.5 * kAbove * letters,
                           .width = paper,
                           .height = (lines_of(text) + 0.5 * kAbove + 0.5 * kBelow) * letters,
                           .color = background.value_or(colors.paper),
                           .opacity = kOpacity});
  double top = kAbove * letters;
  for (const RichLine& line : text.lines) {
    add_pieces(line, {0.5 * (width - line.width), top + kPaperAscent * letters}, colors.ink, drawing.lines);
    top += kTitleSpacing * letters;
  }
  return out;
}

render::Camera camera_within(const EdgeRoom& edges, int width, int height, const Box2& box, double margin) {
  render::Camera camera;
  camera.set_viewport(std::max(1, width - edges.left - edges.right), std::max(1, height - edges.above - edges.below));
  camera.fit(box, margin * std::min(camera.width(), camera.height()));
  camera.set_viewport(width, height);
  camera.pan({0.5 * (edges.left - edges.right), 0.5 * (edges.above - edges.below)});
  return camera;
}

EdgeRoom room_of_axes(double scale) {
  return {.below = static_cast<int>(std::ceil(scale * kAxisRoom)),
          .left = static_cast<int>(std::ceil(scale * kAxisRoomBeside))};
}

figure::Page with_edges(figure::Page page, const PageEdges& edges) {
  page.width += edges.right;
  page.height += edges.above + edges.below;
  // The low part of the number takes the shift, which is of the size of the page.
  page.center_low = page.center_low + 0.5 * page.units_per_point * Vec2{edges.right, edges.above - edges.below};
  return page;
}

}  // namespace mes
