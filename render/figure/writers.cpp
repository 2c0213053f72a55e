// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/writers.h"

#include <algorithm>
#include <array>
#include <string>

namespace mes::figure {
namespace {

constexpr std::array kFormats{
    Format{.extension = ".svg", .name = "SVG", .write = svg_of, .carries_session = true},
    Format{.extension = ".pdf", .name = "PDF", .write = pdf_of, .carries_session = true},
    Format{.extension = ".ps", .name = "PostScript", .write = ps_of},
    Format{.extension = ".eps", .name = "Encapsulated PostScript", .write = eps_of},
    Format{.extension = ".ipe", .name = "Ipe", .write = ipe_of, .carries_session = true},
    Format{.extension = ".tex", .name = "TikZ", .write = tikz_of, .has_images = false},
};

}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

Expected<std::string> bytes_of(const Figure& figure, const Format& format, std::size_t most) {
  // No format has a shape in fewer bytes, so a figure that is far too large takes no memory.
  constexpr std::size_t kLeastOfAShape = 4;
  const auto refuse = [most] {
    return std::unexpected(Error{ErrorCode::usage,
                                 "the figure would have more than " + std::to_string(most / 1'000'000) +
                                     " MB: show fewer layers or a smaller part, or make pictures of layers",
                                 {},
                                 0,
                                 0});
  };
  if (shape_count(figure) > most / kLeastOfAShape) return refuse();
  auto out = format.write(figure);
  if (out && out->size() > most) return refuse();
  return out;
}

const Format* format_for(std::string_view extension) {
  const auto found = std::ranges::find(kFormats, extension, &Format::extension);
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace mes::figure
