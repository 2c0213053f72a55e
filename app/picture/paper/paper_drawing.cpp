// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/paper_drawing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <memory>
#include <numbers>
#include <utility>

#include "app/picture/paper/canvas_look.h"
#include "render/image/strokes.h"

namespace mes {
namespace {

constexpr PaperColors kOnLight{{0xff, 0xff, 0xff}, {0xd0, 0xd4, 0xd9}, {0x1f, 0x23, 0x28}, {0x5b, 0x64, 0x6e}};
constexpr PaperColors kOnDark{{0x24, 0x28, 0x2d}, {0x5a, 0x63, 0x6d}, {0xf2, 0xf4, 0xf6}, {0xb4, 0xbc, 0xc4}};

const render::Font& font_of(const PaperFonts& fonts, Face face) {
  return fonts.of(face == Face::bold, face == Face::italic);
}

/// Makes a text for the figure; `corner` is in points.
figure::Text figure_text(const PaperFonts& fonts, const PaperDrawing::Line& line, Vec2 corner, double scale) {
  const double points = scale * figure::kPointsPerPixel;
  const double width =
      render::text_width(font_of(fonts, line.face), scale * line.size, line.text) * figure::kPointsPerPixel;
  return {.start = corner + points * Vec2{line.x, line.top + kPaperAscent * line.size},
          .size = points * line.size,
          .width = width,
          .is_bold = line.face == Face::bold,
          .color = line.color,
          .text = line.text,
          .is_italic = line.face == Face::italic,
          .latex = line.latex,
          .continues = line.continues};
}

/// Collects the shapes of a layer of annotations in runs of one colour and width.
class Shapes {
 public:
  /// `points` per logical pixel; coordinates are rounded to `decimals`.
  Shapes(figure::FigureLayer& layer, Vec2 corner, double points, int decimals)
      : layer_(layer), corner_(corner), points_(points), steps_(std::pow(10.0, decimals)) {}

  void add(const PaperDrawing::Stroke& stroke) {
    figure::Run& run = run_of(stroke.color, false);
    for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i)
      run.shapes.push_back(
          {.kind = figure::ShapeKind::segment, .p = {at(stroke.points[i]), at(stroke.points[i + 1])}});
  }
  void add(const PaperDrawing::Arc& arc) {
    const Vec2 center = at(arc.center);
    const double radius = rounded(points_ * arc.radius);
    figure::Run& run = run_of(arc.color, false);
    if (arc.sweep >= 2.0 * std::numbers::pi) {
      run.shapes.push_back({.kind = figure::ShapeKind::circle, .p = {center}, .radius = radius});
      return;
    }
    const auto end = [&](double angle) { return rounded(center + radius * Vec2{std::cos(angle), std::sin(angle)}); };
    // Counter-clockwise on the page.
    run.shapes.push_back({.kind = figure::ShapeKind::arc,
                          .p = {end(arc.from + arc.sweep), end(arc.from), center},
                          .radius = radius,
                          .sweep = arc.sweep});
  }
  void add(const PaperDrawing::Triangle& triangle) {
    run_of(triangle.color, true)
        .shapes.push_back({.kind = figure::ShapeKind::triangle,
                           .p = {at(triangle.corners[0]), at(triangle.corners[1]), at(triangle.corners[2])}});
  }
  void add(const PaperDrawing::Dot& dot) {
    run_of(dot.color, true)
        .shapes.push_back(
            {.kind = figure::ShapeKind::disk, .p = {at({dot.x, dot.y})}, .radius = rounded(points_ * dot.radius)});
  }

 private:
  double rounded(double x) const { return std::round(steps_ * x) / steps_; }
  Vec2 rounded(Vec2 p) const { return {rounded(p.x), rounded(p.y)}; }
  Vec2 at(Vec2 p) const { return rounded(corner_ + points_ * p); }
  figure::Run& run_of(Rgb color, bool is_filled) {
    std::vector<figure::Run>& runs = layer_.groups.back().runs;
    if (runs.empty() || runs.back().color != color || runs.back().is_filled != is_filled)
      runs.push_back({.color = color, .opacity = 1.0, .is_filled = is_filled, .dashes = {}, .shapes = {}});
    return runs.back();
  }
  figure::FigureLayer& layer_;
  Vec2 corner_;
  double points_;
  double steps_;
};

struct PixelBox {
  glm::dvec2 from{0.0};
  glm::dvec2 to{0.0};
  const PaperDrawing::Box* box = nullptr;
};

/// Rounds to whole pixels, so that edges are sharp and thin lines look alike. If the box lies within the previous
/// one, the frame left of that is at least a pixel wide.
PixelBox in_pixels(const PaperDrawing::Box& box, const glm::dmat3& place_of, const PixelBox& below) {
  const glm::dvec2 from(box.left, box.top);
  const glm::dvec2 to(box.left + box.width, box.top + box.height);
  const auto rounded = [&place_of](glm::dvec2 p) { return glm::round(glm::dvec2(place_of * glm::dvec3(p, 1.0))); };
  PixelBox out{rounded(from), rounded(to), &box};
  if (below.box != nullptr) {
    const glm::dvec2 outer_from(below.box->left, below.box->top);
    const glm::dvec2 outer_to(below.box->left + below.box->width, below.box->top + below.box->height);
    if (glm::all(glm::lessThan(outer_from, from)) && glm::all(glm::lessThan(to, outer_to))) {
      out.from = glm::max(out.from, below.from + 1.0);
      out.to = glm::min(out.to, below.to - 1.0);
    }
  }
  out.to = glm::max(out.to, out.from + 1.0);
  return out;
}

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
    out.lines.push_back({kPadding, y, kTextSize, Face::plain, colors.ink, line});
    out.width = std::max(out.width, 2.0 * kPadding + measure(line, kTextSize, Face::plain));
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
  return [&fonts, scale](const std::string& text, double size, Face face) {
    return render::text_width(font_of(fonts, face), scale * size, text) / scale;
  };
}

glm::dmat3 paper_placement(const glm::dvec2& corner, double scale) {
  return glm::dmat3(glm::dvec3(scale, 0.0, 0.0), glm::dvec3(0.0, scale, 0.0), glm::dvec3(corner, 1.0));
}

void paint(render::Image& image, const PaperFonts& fonts, const PaperDrawing& drawing, const glm::dvec2& corner,
           double scale) {
  const glm::dmat3 place_of = paper_placement(corner, scale);
  PixelBox below;
  for (const PaperDrawing::Box& box : drawing.boxes) {
    const PixelBox at = in_pixels(box, place_of, below);
    render::fill_rectangle(image, at.from.x, at.from.y, at.to.x - at.from.x, at.to.y - at.from.y, box.color,
                           box.opacity);
    below = at;
  }
  const auto at = [&](Vec2 p) {
    const glm::dvec3 out = place_of * glm::dvec3(p.x, p.y, 1.0);
    return Vec2{out.x, out.y};
  };
  const auto all_at = [&](std::span<const Vec2> points) {
    std::vector<Vec2> out;
    for (const Vec2 p : points) out.push_back(at(p));
    return out;
  };
  for (const PaperDrawing::Stroke& stroke : drawing.strokes)
    render::stroke_path(image, all_at(stroke.points), scale * stroke.width, stroke.color);
  for (const PaperDrawing::Arc& arc : drawing.arcs)
    render::stroke_arc(image, at(arc.center), scale * arc.radius, arc.from, arc.sweep, scale * arc.width, arc.color);
  for (const PaperDrawing::Triangle& triangle : drawing.triangles)
    render::fill_polygon(image, all_at(triangle.corners), triangle.color);
  for (const PaperDrawing::Dot& dot : drawing.dots) {
    const glm::dvec2 center(place_of * glm::dvec3(dot.x, dot.y, 1.0));
    render::fill_disk(image, center.x, center.y, scale * dot.radius, dot.color);
  }
  for (const PaperDrawing::Line& line : drawing.lines) {
    const glm::dvec2 from(place_of * glm::dvec3(line.x, line.top + kPaperAscent * line.size, 1.0));
    render::draw_text(image, font_of(fonts, line.face), scale * line.size, from.x, from.y, line.color, line.text);
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
  for (const PaperDrawing::Line& line : drawing.lines)
    figure.legend.texts.push_back(figure_text(fonts, line, corner, scale));
}

void add_layer(figure::Figure& figure, const PaperFonts& fonts, const PaperDrawing& drawing, Vec2 corner,
               double scale, figure::FigureLayer layer) {
  set_fonts(figure, fonts);
  layer.groups.emplace_back();
  Shapes shapes(layer, corner, scale * figure::kPointsPerPixel, figure.decimals);
  for (const PaperDrawing::Stroke& stroke : drawing.strokes) shapes.add(stroke);
  for (const PaperDrawing::Arc& arc : drawing.arcs) shapes.add(arc);
  for (const PaperDrawing::Triangle& triangle : drawing.triangles) shapes.add(triangle);
  for (const PaperDrawing::Dot& dot : drawing.dots) shapes.add(dot);
  for (const PaperDrawing::Line& line : drawing.lines) layer.texts.push_back(figure_text(fonts, line, corner, scale));
  figure.layers.push_back(std::move(layer));
}

}  // namespace mes
