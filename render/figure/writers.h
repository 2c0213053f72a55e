// SPDX-License-Identifier: GPL-3.0-or-later
// The vector formats, with one writer for each: from a figure to the bytes of a file.
//
// What all of them guarantee:
//  1. Layers, groups, runs and shapes keep their order, colours, opacities and widths; parts beyond the page are cut at
//     its edge.
//  2. Each layer of the figure is a group, layer or scope with its id and title, if the format has these.
//  3. The same figure gives the same bytes, in every locale: they contain no time and no name of a machine.
//
// Cost: some hundred nanoseconds a shape. Threads: any. Error: `out_of_memory`, or `usage` for a page that the format
// does not allow.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "render/figure/figure.h"

namespace mes::figure {

/// Scalable Vector Graphics 1.1: layers are groups, and Inkscape shows them as layers. Shapes of an opaque run other
/// than circles and disks share one path.
Expected<std::string> svg_of(const Figure& figure);

/// The same as an element within HTML, where ids must differ from those of other figures: they begin with `prefix`,
/// which consists of letters, digits and hyphens. Carries no session.
Expected<std::string> svg_element_of(const Figure& figure, std::string_view prefix);

/// PDF 1.5: layers are optional content groups, which viewers switch on and off. Text uses the fonts of the figure, and
/// the file embeds the letters that occur; without fonts it uses Helvetica, by name.
Expected<std::string> pdf_of(const Figure& figure);

/// PostScript of level 3 and its encapsulated form. Translucent parts become a picture of 300 dots an inch.
Expected<std::string> ps_of(const Figure& figure);
Expected<std::string> eps_of(const Figure& figure);

/// Ipe 7: one Ipe layer for each layer. A flat layer of several colours is a picture of 300 dots an inch.
Expected<std::string> ipe_of(const Figure& figure);

/// A TikZ picture, with a scope for each layer: a LaTeX document by itself, and only the picture if another document
/// reads it by \\input. Omits the picture to trace.
Expected<std::string> tikz_of(const Figure& figure);

struct Format {
  std::string_view extension;  ///< file name extension, with the dot
  std::string_view name;
  Expected<std::string> (*write)(const Figure& figure);
  bool has_images = true;        ///< whether it shows the picture to trace
  bool carries_session = false;  ///< whether it carries the figure's session
  bool grows = true;             ///< the file grows with each shape; else a picture may replace the shapes
};

/// Size limit of a file, in bytes.
inline constexpr std::size_t kMostFigureBytes = 2'000'000'000;

/// Approximate size of the file in bytes, from a sample of blocks of shapes: about a tenth more or less. Only for a
/// format that `grows`; too small if a group becomes a picture. Costs as much as writing about 30,000 shapes.
Expected<std::size_t> estimated_bytes(const Figure& figure, const Format& format);

/// The bytes of the file. Error: as the writer; `usage` for more than `most` bytes; figures far beyond that are refused
/// before writing.
Expected<std::string> bytes_of(const Figure& figure, const Format& format, std::size_t most = kMostFigureBytes);

/// All formats, in the order of the help and the manual.
std::span<const Format> formats();

/// The format of a file name's extension, in lower case; null for any other.
const Format* format_for(std::string_view extension);

}  // namespace mes::figure
