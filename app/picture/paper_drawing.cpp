// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper_drawing.h"

#include <algorithm>
#include <glm/common.hpp>
#include <memory>
#include <utility>

#include "app/picture/canvas_look.h"

namespace mes {
namespace {

constexpr PaperColors kOnLight{{0xff, 0xff, 0xff}, {0xd0, 0xd4, 0xd9}, {0x1f, 0x23, 0x28}, {0x5b, 0x64, 0x6e}};
constexpr PaperColors kOnDark{{0x24, 0x28, 0x2d}, {0x5a, 0x63, 0x6d}, {0xf2, 0xf4, 0xf6}, {0xb4, 0xbc, 0xc4}};

// From the top of a line to its baseline.
constexpr double kAscent = 0.8;

}  // namespace

PaperColors paper_colors(const std::optional<Rgb>& background) {
  return background && is_dark(*background) ? kOnDark : kOnLight;
}

PaperDrawing layout_words(std::span<const std::string> lines, const MeasureText& measure,
                          const std::optional<Rgb>& background) {
  constexpr double kTextSize = 13.0;
  constexpr double kLineHeight = 17.0;
  constexpr double kPadding = 7.0;
  PaperDrawing out;
  if (lines.empty()) return out;
  const PaperColors colors = paper_colors(background);
  double y = kPadding;
  for (const std::string& line : lines) {
    out.lines.push_back({kPadding, y, kTextSize, false, colors.ink, line});
    out.width = std::max(out.width, 2.0 * kPadding + measure(line, kTextSize, false));
    y += kLineHeight;
  }
  out.height = y + kPadding - 2.0;
  out.boxes = {{0.0, 0.0, out.width, out.height, colors.frame},
               {1.0, 1.0, out.width - 2.0, out.height - 2.0, colors.paper}};
  return out;
}

Expected<PaperFonts> PaperFonts::read(const std::filesystem::path& assets) {
  auto plain = render::Font::read(assets / "fonts" / "Inter-Regular.otf");
  if (!plain) return std::unexpected(plain.error());
  auto bold = render::Font::read(assets / "fonts" / "Inter-SemiBold.otf");
  if (!bold) return std::unexpected(bold.error());
  auto italic = render::Font::read(assets / "fonts" / "Inter-Italic.otf");
  if (!italic) return std::unexpected(italic.error());
  return PaperFonts{{std::move(*plain), std::move(*bold), std::move(*italic)}};
}

MeasureText measure_with(const PaperFonts& fonts, double scale) {
  return [&fonts, scale](const std::string& text, double size, bool is_bold) {
    return render::text_width(fonts.of(is_bold, false), scale * size, text) / scale;
  };
}

glm::dmat3 paper_placement(const glm::dvec2& corner, double scale) {
  return glm::dmat3(glm::dvec3(scale, 0.0, 0.0), glm::dvec3(0.0, scale, 0.0), glm::dvec3(corner, 1.0));
}

void paint(render::Image& image, const PaperFonts& fonts, const PaperDrawing& drawing, const glm::dvec2& corner,
           double scale) {
  const glm::dmat3 place_of = paper_placement(corner, scale);
  // On whole pixels, so that edges are sharp and thin lines look alike.
  for (const PaperDrawing::Box& box : drawing.boxes) {
    const glm::dvec2 from = glm::round(glm::dvec2(place_of * glm::dvec3(box.left, box.top, 1.0)));
    const glm::dvec3 end(box.left + box.width, box.top + box.height, 1.0);
    const glm::dvec2 size = glm::max(glm::round(glm::dvec2(place_of * end)) - from, glm::dvec2(1.0));
    render::fill_rectangle(image, from.x, from.y, size.x, size.y, box.color, box.opacity);
  }
  for (const PaperDrawing::Dot& dot : drawing.dots) {
    const glm::dvec2 center(place_of * glm::dvec3(dot.x, dot.y, 1.0));
    render::fill_disk(image, center.x, center.y, scale * dot.radius, dot.color);
  }
  for (const PaperDrawing::Line& line : drawing.lines) {
    const glm::dvec2 from(place_of * glm::dvec3(line.x, line.top + kAscent * line.size, 1.0));
    render::draw_text(image, fonts.of(line.is_bold, false), scale * line.size, from.x, from.y, line.color, line.text);
  }
}

void set_fonts(figure::Figure& figure, const PaperFonts& fonts) {
  figure.fonts = std::make_shared<const figure::Fonts>(fonts);
}

void add_to(figure::Figure& figure, const PaperFonts& fonts, const PaperDrawing& drawing, Vec2 corner, double scale) {
  const double points = scale * figure::kPointsPerPixel;
  set_fonts(figure, fonts);
  for (const PaperDrawing::Box& box : drawing.boxes)
    figure.legend.boxes.push_back(
        {corner + points * Vec2{box.left, box.top}, points * box.width, points * box.height, box.color, box.opacity});
  for (const PaperDrawing::Dot& dot : drawing.dots) {
    figure::Run run{.color = dot.color, .opacity = 1.0, .is_filled = true, .dashes = {}, .shapes = {}};
    run.shapes.push_back({.kind = figure::ShapeKind::disk,
                          .p = {corner + points * Vec2{dot.x, dot.y}},
                          .radius = points * dot.radius,
                          .sweep = 0.0});
    figure.legend.runs.push_back(std::move(run));
  }
  for (const PaperDrawing::Line& line : drawing.lines) {
    const double width =
        render::text_width(fonts.of(line.is_bold, false), scale * line.size, line.text) * figure::kPointsPerPixel;
    figure.legend.texts.push_back({corner + points * Vec2{line.x, line.top + kAscent * line.size}, points * line.size,
                                   width, line.is_bold, line.color, line.text});
  }
}

}  // namespace mes
