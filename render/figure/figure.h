// SPDX-License-Identifier: GPL-3.0-or-later
// A figure: the screen content as shapes on a page.
//
// It is the input of every writer of a vector format. Lengths are in points of 1/72 inch; the origin is the upper left
// corner of the page, y grows downwards. Coordinates and radii are multiples of one power of ten (`Figure::decimals`),
// finer than any output resolves.
//
// Guarantees:
//  1. Layers, groups, runs and shapes are in drawing order, bottom first.
//  2. Each shape stands for one primitive of its layer; a primitive that is invisible on the page has no shape, one
//     that is cut by it may have several. Only segments and parabolas of opaque runs are reordered.
//  3. Lines, rays and segments end at most a stroke's width beyond the page; the writer cuts them at its edge. No
//     coordinate of a shape is farther from the page than some diagonals of it.
//
// Cost: plain data; copies share the fonts. Threads: const use from several.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/color.h"
#include "core/base/geometry/vec2.h"
#include "render/image/image.h"
#include "render/image/text.h"

namespace mes::figure {

inline constexpr double kPointsPerInch = 72.0;
inline constexpr double kMillimetersPerInch = 25.4;
/// A logical pixel is 1/96 inch, as in CSS.
inline constexpr double kPointsPerPixel = 0.75;

enum class ShapeKind : std::uint8_t {
  disk,      ///< filled: centre p[0], `radius`
  triangle,  ///< filled: corners p[0..2], all triangles turn the same way
  rim,       ///< filled, part of a huge disk: a Bezier curve p[0..3], then straight to p[4], p[5], and back
  circle,    ///< stroked: centre p[0], `radius`
  segment,   ///< stroked: p[0] to p[1]
  parabola,  ///< stroked, an arc of one: a quadratic Bezier curve from p[0] to p[1] with the control point p[2]
  arc,       ///< stroked: from p[0] to p[1], centre p[2], `radius`; counter-clockwise as seen, by `sweep`
  curve,     ///< stroked, part of a huge circle: a Bezier curve p[0..3]
};

struct Shape {
  ShapeKind kind = ShapeKind::segment;
  std::array<Vec2, 6> p{};
  double radius = 0.0;
  double sweep = 0.0;  ///< radians, in (0, 2 pi)
};

/// True for the kinds that writers join into chains: from p[0] to p[1].
constexpr bool is_chained(ShapeKind kind) {
  return kind == ShapeKind::segment || kind == ShapeKind::parabola;
}

constexpr bool is_filled(ShapeKind kind) {
  return kind == ShapeKind::disk || kind == ShapeKind::triangle || kind == ShapeKind::rim;
}

/// Dash pattern along a stroke: `on` and `off` alternate, beginning `offset` into them. No dashes: all zero.
struct Dashes {
  double on = 0.0;
  double off = 0.0;
  double offset = 0.0;
  friend bool operator==(const Dashes&, const Dashes&) = default;
};

/// Shapes with the same look, each painted separately.
struct Run {
  Rgb color;
  double opacity = 1.0;   ///< opacity of each shape
  bool is_filled = true;  ///< else it is stroked, with round caps and joins
  Dashes dashes;          ///< dashes have flat caps
  std::vector<Shape> shapes;
};

/// Runs that are painted together and then blended onto the page with one opacity.
struct Group {
  double opacity = 1.0;
  std::vector<Run> runs{};
};

/// A picture with its corners along the axes.
struct PlacedImage {
  render::Image image;
  Vec2 corner;  ///< upper left
  double width = 0.0;
  double height = 0.0;
  double opacity = 1.0;
};

/// A rectangle without outline.
struct Box {
  Vec2 corner;  ///< upper left
  double width = 0.0;
  double height = 0.0;
  Rgb color;
  double opacity = 1.0;
};

/// The em square of the program's fonts, the unit of formats, divided by the height of their letters from ascent to
/// descent, the unit of layouts (render/image/text.h).
inline constexpr double kEmOfSize = 2816.0 / 3408.0;

/// Letters of one look on one line.
struct Text {
  Vec2 start;          ///< start of the baseline
  double size = 0.0;   ///< from the ascent of the font to its descent
  double width = 0.0;  ///< as measured by the layout
  bool is_bold = false;
  Rgb color{};
  std::string text{};  ///< UTF-8
  bool is_italic = false;
  /// TeX source for this text and all later ones that continue it; empty: each text by itself.
  std::string latex{};
  bool continues = false;  ///< belongs to the text before
  double opacity = 1.0;
};

/// The fonts of texts.
struct Fonts {
  render::Font plain;
  render::Font bold;
  render::Font italic;
  /// Text that is both bold and italic uses the italic font.
  const render::Font& of(bool is_bold, bool is_italic) const { return is_italic ? italic : is_bold ? bold : plain; }
};

/// A part of the page.
struct PagePart {
  Vec2 corner;  ///< upper left
  double width = 0.0;
  double height = 0.0;
};

struct FigureLayer {
  std::string id;  ///< public name, kebab case
  std::string title;
  double line_width = 1.0;
  std::optional<PlacedImage> image{};  ///< below the groups
  std::vector<Group> groups{};
  std::vector<Text> texts{};       ///< above the groups
  std::optional<PagePart> clip{};  ///< visible part of the layer; none: the page
};

/// Explanations above all layers.
struct Legend {
  std::vector<Box> boxes;
  std::vector<Run> runs;    ///< above the boxes: disks
  std::vector<Text> texts;  ///< above both
  bool is_empty() const { return boxes.empty() && runs.empty() && texts.empty(); }
};

struct Figure {
  double width = 0.0;
  double height = 0.0;
  int decimals = 3;                 ///< decimals of coordinates
  std::optional<Rgb> background{};  ///< none: the page itself
  std::vector<FigureLayer> layers{};
  Legend legend{};
  std::shared_ptr<const Fonts> fonts{};  ///< fonts for texts in files and pictures; none: Helvetica, by name
  std::string session{};                 ///< session in files, compressed (core/base/carried_session.h); empty: none
};

/// Places layers and legend of a figure on a page, above its content and cut at the figure's own page. Prefixes the ids
/// of its layers with `id`, and their titles with `title`. The page adopts its fonts if it has none, and its
/// coordinates if they are finer; the corner is rounded to these.
void place(Figure& page, Figure part, Vec2 corner, const std::string& id, const std::string& title);

/// Number of shapes in one layer, or in all.
std::size_t shape_count(const FigureLayer& layer);
std::size_t shape_count(const Figure& figure);

}  // namespace mes::figure
