// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/writers.h"

#include <algorithm>
#include <array>

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

const Format* format_for(std::string_view extension) {
  const auto found = std::ranges::find(kFormats, extension, &Format::extension);
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace mes::figure
