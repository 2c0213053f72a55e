// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/picture_overlay.h"

#include <algorithm>
#include <utility>

#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/scale_drawing.h"
#include "render/image/text.h"

namespace mes {
namespace {

/// The heights of the letters and of the band behind them, in pixels.
struct CaptionSize {
  double letters = 0.0;
  double band = 0.0;
};

CaptionSize caption_size(int width_px, int height_px, const render::Font& font, const std::string& text) {
  if (text.empty()) return {};
  double letters = std::max(11.0, 0.034 * height_px);
  const double room = 0.94 * width_px;
  const double width = render::text_width(font, letters, text);
  if (width > room) letters *= room / width;
  return {letters, 2.2 * letters};
}

void draw_caption(render::Image& image, const render::Font& font, const std::string& text, const CaptionSize& size,
                  const std::optional<Rgb>& background) {
  const bool on_dark = background && is_dark(*background);
  const Rgb paper = background.value_or(kWhiteCanvas);
  const Rgb ink = on_dark ? Rgb{0xF2, 0xF4, 0xF6} : Rgb{0x22, 0x26, 0x2B};
  const double height = image.height;
  render::fill_rectangle(image, 0, height - size.band, image.width, size.band, paper, 0.9);
  const double x = 0.5 * (image.width - render::text_width(font, size.letters, text));
  render::draw_text(image, font, size.letters, x, height - 0.85 * size.letters, ink, text);
}

}  // namespace

void PictureOverlay::paint(render::Image& image) const {
  if (is_empty()) return;
  const CaptionSize size = caption_size(image.width, image.height, fonts->bold, caption);
  if (!highlights.is_empty()) mes::paint(image, *fonts, highlights, {0.0, 0.0}, marks_scale);
  if (!annotations.is_empty()) mes::paint(image, *fonts, annotations, {0.0, 0.0}, marks_scale);
  if (!marks.is_empty()) mes::paint(image, *fonts, marks, {0.0, 0.0}, marks_scale);
  if (!title.is_empty()) mes::paint(image, *fonts, title, {0.0, 0.0}, marks_scale);
  mes::paint(image, *fonts, legend, marks_scale);
  if (!caption.empty()) draw_caption(image, fonts->bold, caption, size, background);
}

PictureOverlay picture_overlay_of(OverlayContent content, std::shared_ptr<const PaperFonts> fonts,
                                  const OverlayTarget& target, const InkMap* ink) {
  PictureOverlay out{.fonts = std::move(fonts),
                     .legend = {},
                     .highlights = {},
                     .annotations = {},
                     .marks = {},
                     .marks_scale = target.scale,
                     .title = std::move(content.title),
                     .caption = std::move(content.caption),
                     .background = target.background};
  if (!out.fonts) return out;
  const auto& [camera, scale, background] = target;
  const MeasureText measure = measure_with(*out.fonts, scale);
  std::vector<Box2> words;
  LegendSurroundings around{.place = content.legend_at};
  if (!content.annotations.is_empty()) {
    AnnotationDrawing drawn = layout_annotations(content.annotations, seen_plane(camera, scale), measure, background);
    out.highlights = std::move(drawn.highlights);
    out.annotations = std::move(drawn.drawing);
    if (ink != nullptr) words = std::move(drawn.words);
  }
  SeenPlane plane = seen_plane(camera, scale);
  plane.covered = caption_size(camera.width(), camera.height(), out.fonts->bold, out.caption).band / scale;
  plane.covered_above = out.title.height;
  plane.unit = std::move(content.unit);
  if (ink != nullptr) {
    around.words = words;
    around.hides = [&](const Box2& box) { return ink->parts_below({scale * box.low, scale * box.high}, camera); };
    content.marks =
        with_free_bar(content.marks, plane, measure, [&](const Box2& box) { return around.cost_of(box); });
  }
  if (!content.marks.is_empty()) out.marks = layout_scale_marks(content.marks, plane, measure, background);
  const MarksPlace marks = place_of_marks(content.marks, plane, measure);
  around.room = marks.room;
  around.bar = marks.longest_bar;
  out.legend = place_legend(content.legend, *out.fonts, scale, around, background);
  return out;
}

}  // namespace mes
