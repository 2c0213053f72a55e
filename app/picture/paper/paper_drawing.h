// SPDX-License-Identifier: GPL-3.0-or-later
// Explanatory drawings on pictures: legends, axes, scale bars, annotations.
//
// The window paints them on itself, `paint` on a picture in memory, and `add_to` on the page of a figure, so all three
// look alike.
//
// Cost: some hundred shapes. Threads: any, with a picture or a figure of its own.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/color.h"
#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "render/figure/figure.h"
#include "render/image/image.h"
#include "render/image/text.h"

namespace mes {

enum class Face : std::uint8_t { plain, bold, italic };

/// Lengths are in logical pixels, from the upper left corner of the drawing, y down.
struct PaperDrawing {
  struct Box {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
    Rgb color;
    double opacity = 1.0;
  };
  struct Line {
    double x = 0.0;
    double top = 0.0;
    double size = 0.0;
    Face face = Face::plain;
    Rgb color;
    std::string text;
    std::string latex{};     ///< TeX for this line and those that continue it; empty: the text
    bool continues = false;  ///< continues the previous line in another look
  };
  struct Dot {
    double x = 0.0;
    double y = 0.0;
    double radius = 0.0;
    Rgb color;
  };
  struct Stroke {
    std::vector<Vec2> points;
    double width = 1.0;
    Rgb color;
  };
  struct Arc {
    Vec2 center;
    double radius = 0.0;
    double from = 0.0;   ///< radians from the x axis, clockwise as seen
    double sweep = 0.0;  ///< angle from there, in (0, 2 pi]
    double width = 1.0;
    Rgb color;
  };
  struct Triangle {
    std::array<Vec2, 3> corners;
    Rgb color;
  };
  double width = 0.0;
  double height = 0.0;
  // Each list is drawn above the previous ones.
  std::vector<Box> boxes;
  std::vector<Stroke> strokes{};
  std::vector<Arc> arcs{};
  std::vector<Triangle> triangles{};
  std::vector<Dot> dots{};
  std::vector<Line> lines;
  bool is_empty() const {
    return boxes.empty() && strokes.empty() && arcs.empty() && triangles.empty() && dots.empty() && lines.empty();
  }
};

/// Distance from the top of a line to its baseline, as a share of its size.
inline constexpr double kPaperAscent = 0.8;

/// The text of legends, scale bars and axes; logical pixels.
inline constexpr double kSmallTextSize = 13.0;

/// The colours of explanatory drawings.
struct PaperColors {
  Rgb paper;
  Rgb frame;
  Rgb ink;
  Rgb quiet;
};
/// Light colours for a dark background; nothing: transparent.
PaperColors paper_colors(const std::optional<Rgb>& background);

/// Returns the width of a text in logical pixels, at a size in logical pixels.
using MeasureText = std::function<double(const std::string& text, double size, Face face)>;

/// A note of some lines, as large as they need; empty without lines.
PaperDrawing layout_words(std::span<const std::string> lines, const MeasureText& measure,
                          const std::optional<Rgb>& background);

struct PaperFonts : figure::Fonts {
  /// Reads the fonts that come with the program.
  static Expected<PaperFonts> read(const std::filesystem::path& assets);
};

/// Measures with `scale` pixels per logical pixel; the fonts must outlive the result.
MeasureText measure_with(const PaperFonts& fonts, double scale);

/// The map from coordinates of a drawing to pixels: `scale` pixels per logical pixel, with the upper left corner at
/// `corner`.
glm::dmat3 paper_placement(const glm::dvec2& corner, double scale);

/// `corner` is in pixels, `scale` in pixels per logical pixel.
void paint(render::Image& image, const PaperFonts& fonts, const PaperDrawing& drawing, const glm::dvec2& corner,
           double scale);

/// Sets the texts of the figure in these fonts.
void set_fonts(figure::Figure& figure, const PaperFonts& fonts);

/// Adds boxes, dots and text to the legend of the figure, which lies above the layers, and sets the fonts. `corner`
/// is in points on the page, `scale` in units of 1/96 inch per logical pixel.
void add_to(figure::Figure& figure, const PaperFonts& fonts, const PaperDrawing& drawing, Vec2 corner, double scale);

/// Adds all but boxes as a layer of the figure, above the existing ones.
void add_layer(figure::Figure& figure, const PaperFonts& fonts, const PaperDrawing& drawing, Vec2 corner,
               double scale, figure::FigureLayer layer);

}  // namespace mes
