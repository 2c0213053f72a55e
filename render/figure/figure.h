// SPDX-License-Identifier: GPL-3.0-or-later
// A figure: what the screen shows, as shapes on a page.
//
// It is the list that every writer of a vector format gets. Lengths are in points of 1/72 inch; the origin is the
// upper left corner of the page, y grows downwards. Coordinates and radii are multiples of one power of ten
// (`Figure::decimals`), which is finer than any output resolves.
//
// What it guarantees:
//  1. Layers, groups, runs and shapes are in drawing order, the first below.
//  2. Each shape stands for one primitive of its layer; a primitive that cannot be seen on the page has none, one that
//     is cut by it may have two. Only shapes of a run that is opaque are reordered, and only segments.
//  3. Lines, rays and segments end at most a stroke's width beyond the page; what is drawn is cut at its edge by the
//     writer. No coordinate of a shape is farther from the page than some diagonals of it.
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
#include "core/base/vec2.h"
#include "render/image.h"
#include "render/text.h"

namespace mes::figure {

inline constexpr double kPointsPerInch = 72.0;
inline constexpr double kMillimetersPerInch = 25.4;
/// A logical pixel is 1/96 inch, as in CSS.
inline constexpr double kPointsPerPixel = 0.75;

enum class ShapeKind : std::uint8_t {
  disk,      ///< filled: centre p[0], `radius`
  triangle,  ///< filled: corners p[0..2], all triangles turn the same way
  rim,       ///< filled, part of a huge disk: a Bezier curve p[0..3], then straight on to p[4] and p[5], and back
  circle,    ///< stroked: centre p[0], `radius`
  segment,   ///< stroked: p[0] to p[1]
  arc,       ///< stroked: from p[0] to p[1], centre p[2], `radius`; counter-clockwise as seen, by `sweep`
  curve,     ///< stroked, part of a huge circle: a Bezier curve p[0..3]
};

struct Shape {
  ShapeKind kind = ShapeKind::segment;
  std::array<Vec2, 6> p{};
  double radius = 0.0;
  double sweep = 0.0;  ///< radians, in (0, 2 pi)
};

constexpr bool is_filled(ShapeKind kind) {
  return kind == ShapeKind::disk || kind == ShapeKind::triangle || kind == ShapeKind::rim;
}

/// How dashes repeat along a stroke: `on` and `off` in turn, beginning `offset` into them. No dashes: all zero.
struct Dashes {
  double on = 0.0;
  double off = 0.0;
  double offset = 0.0;
  friend bool operator==(const Dashes&, const Dashes&) = default;
};

/// Shapes that look alike, each painted on its own.
struct Run {
  Rgb color;
  double opacity = 1.0;   ///< of each shape
  bool is_filled = true;  ///< else it is stroked, with round caps and joins
  Dashes dashes;          ///< with flat caps
  std::vector<Shape> shapes;
};

/// What is painted together, and then laid on the page with one opacity.
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

/// The em square of the program's fonts, which formats count in, against the height of their letters from ascent to
/// descent, which layouts count in (render/text.h).
inline constexpr double kEmOfSize = 2816.0 / 3408.0;

/// Letters of one look on one line.
struct Text {
  Vec2 start;          ///< of the baseline
  double size = 0.0;   ///< from the ascent of the font to its descent
  double width = 0.0;  ///< as the layout measured it
  bool is_bold = false;
  Rgb color{};
  std::string text{};  ///< UTF-8
  bool is_italic = false;
  /// What TeX typesets instead of this text and of those after it that continue it; empty: each text by itself.
  std::string latex{};
  bool continues = false;  ///< belongs to the text before
  double opacity = 1.0;
};

/// The fonts of texts.
struct Fonts {
  render::Font plain;
  render::Font bold;
  render::Font italic;
  /// What is both bold and italic is in italic.
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
  std::optional<PagePart> clip{};  ///< what of the layer is seen; none: what is on the page
};

/// What lies above all layers and explains them.
struct Legend {
  std::vector<Box> boxes;
  std::vector<Run> runs;    ///< above the boxes: disks
  std::vector<Text> texts;  ///< above both
  bool is_empty() const { return boxes.empty() && runs.empty() && texts.empty(); }
};

struct Figure {
  double width = 0.0;
  double height = 0.0;
  int decimals = 3;                 ///< of coordinates
  std::optional<Rgb> background{};  ///< none: the page itself
  std::vector<FigureLayer> layers{};
  Legend legend{};
  std::shared_ptr<const Fonts> fonts{};  ///< that files and pictures have texts in; none: Helvetica, by name
  std::string session{};                 ///< that files carry, compressed (core/base/carried_session.h); empty: none
};

/// Puts layers and legend of a figure on a page, as a part of it: above what is there, cut where its own page ends.
/// `id` goes before the ids of its layers, `title` before their titles. The page takes its fonts if it has none, and
/// coordinates as fine as it has; the corner is rounded to these.
void place(Figure& page, Figure part, Vec2 corner, const std::string& id, const std::string& title);

/// Shapes of one layer, or of all.
std::size_t shape_count(const FigureLayer& layer);
std::size_t shape_count(const Figure& figure);

}  // namespace mes::figure
