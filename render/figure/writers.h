// SPDX-License-Identifier: GPL-3.0-or-later
// The vector formats, one writer a file: from a figure to the bytes of a file.
//
// What all of them guarantee:
//  1. Layers, groups, runs and shapes keep their order, colours, opacities and widths; what lies beyond the page is cut
//     at its edge.
//  2. Each layer of the figure is a group, layer or scope with its id and title, where the format has such things.
//  3. The same figure gives the same bytes, in every locale: no time, no name of a machine.
//
// Cost: some hundred nanoseconds a shape. Threads: any. Error: `out_of_memory`, or a `usage` error for a page that the
// format cannot have.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "render/figure/figure.h"

namespace mes::figure {

/// Scalable Vector Graphics 1.1: layers are groups, and layers to Inkscape. Shapes of an opaque run that are not
/// circles or disks share one path.
Expected<std::string> svg_of(const Figure& figure);

/// The same as an element within HTML, where ids have to differ from those of other figures: they begin with `prefix`,
/// which consists of letters, digits and hyphens. It carries no session.
Expected<std::string> svg_element_of(const Figure& figure, std::string_view prefix);

/// PDF 1.5: layers are optional content groups, which viewers switch on and off. Text is in the fonts of the figure, of
/// which the file carries the letters that occur; without them it is in Helvetica, by name.
Expected<std::string> pdf_of(const Figure& figure);

/// PostScript of level 3 and its encapsulated form. Where something is translucent, a picture of 300 dots an inch takes
/// its place.
Expected<std::string> ps_of(const Figure& figure);
Expected<std::string> eps_of(const Figure& figure);

/// Ipe 7: a layer a layer. A flat layer of several colours is a picture of 300 dots an inch.
Expected<std::string> ipe_of(const Figure& figure);

/// A TikZ picture, a scope a layer: a LaTeX document by itself, and the picture alone where another document reads it by
/// \\input. Without the picture to trace.
Expected<std::string> tikz_of(const Figure& figure);

struct Format {
  std::string_view extension;  ///< of file names, with its dot
  std::string_view name;
  Expected<std::string> (*write)(const Figure& figure);
  bool has_images = true;        ///< else the picture to trace is left out
  bool carries_session = false;  ///< that of the figure
  bool grows = true;             ///< with each shape; else a picture may take their place
};

/// Bytes of the largest file that is written.
inline constexpr std::size_t kMostFigureBytes = 2'000'000'000;

/// About how many bytes the file will have, from blocks of shapes here and there: a tenth more or less. Of a format that
/// `grows`; too few where a group becomes a picture. As the writer of some 30,000 shapes.
Expected<std::size_t> estimated_bytes(const Figure& figure, const Format& format);

/// The bytes of the file. Error: as the writer; `usage` for more than `most` bytes, of which far too many are not written
/// first.
Expected<std::string> bytes_of(const Figure& figure, const Format& format, std::size_t most = kMostFigureBytes);

/// In the order in which help and manual name them.
std::span<const Format> formats();

/// The format of a file name's extension, in lower case; null for any other.
const Format* format_for(std::string_view extension);

}  // namespace mes::figure
