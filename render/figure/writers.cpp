// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/writers.h"

#include <algorithm>
#include <array>

namespace mes::figure {
namespace {

constexpr std::array kFormats{
    Format{".svg", "SVG", svg_of},        Format{".pdf", "PDF", pdf_of},
    Format{".ps", "PostScript", ps_of},   Format{".eps", "Encapsulated PostScript", eps_of},
    Format{".ipe", "Ipe", ipe_of, false}, Format{".tex", "TikZ", tikz_of, false},
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
