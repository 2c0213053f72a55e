// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/writers.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

namespace mes::figure {
namespace {

constexpr std::array kFormats{
    Format{.extension = ".svg", .name = "SVG", .write = svg_of, .carries_session = true},
    Format{.extension = ".pdf", .name = "PDF", .write = pdf_of, .carries_session = true},
    Format{.extension = ".ps", .name = "PostScript", .write = ps_of, .grows = false},
    Format{.extension = ".eps", .name = "Encapsulated PostScript", .write = eps_of, .grows = false},
    Format{.extension = ".ipe", .name = "Ipe", .write = ipe_of, .carries_session = true},
    Format{.extension = ".tex", .name = "TikZ", .write = tikz_of, .has_images = false},
};

// Adjacent shapes, such as chains of segments, stay in one block.
constexpr std::size_t kShapesOfABlock = 512;
constexpr std::size_t kBlocks = 64;

/// The shapes of one block out of `every`, and their number; 0: no shapes.
std::pair<Figure, std::size_t> thinned(const Figure& figure, std::size_t every) {
  Figure out{.width = figure.width, .height = figure.height, .decimals = figure.decimals};
  std::size_t place = 0;
  std::size_t taken = 0;
  for (const FigureLayer& layer : figure.layers) {
    FigureLayer& thin = out.layers.emplace_back();
    thin.id = layer.id;
    thin.line_width = layer.line_width;
    for (const Group& group : layer.groups) {
      if (group.opacity < 1.0 && group.runs.size() > 1) continue;  // some formats make a picture of it
      Group& part = thin.groups.emplace_back(Group{.opacity = group.opacity});
      for (const Run& run : group.runs) {
        Run few{run.color, run.opacity, run.is_filled, run.dashes, {}};
        for (std::size_t i = 0; i < run.shapes.size();) {
          const std::size_t block = place / kShapesOfABlock;
          const std::size_t left = std::min((block + 1) * kShapesOfABlock - place, run.shapes.size() - i);
          const std::span<const Shape> shapes = std::span(run.shapes).subspan(i, left);
          if (every != 0 && block % every == 0) few.shapes.insert(few.shapes.end(), shapes.begin(), shapes.end());
          i += left;
          place += left;
        }
        taken += few.shapes.size();
        if (!few.shapes.empty()) part.runs.push_back(std::move(few));
      }
    }
  }
  return {std::move(out), taken};
}

}  // namespace

Expected<std::size_t> estimated_bytes(const Figure& figure, const Format& format) {
  const std::size_t every = std::max<std::size_t>(1, shape_count(figure) / (kShapesOfABlock * kBlocks));
  const auto [part, taken] = thinned(figure, every);
  const auto with = format.write(part);
  if (!with) return std::unexpected(with.error());
  const auto without = format.write(thinned(figure, 0).first);
  if (!without) return std::unexpected(without.error());
  return without->size() + every * (with->size() - std::min(with->size(), without->size()));
}

std::span<const Format> formats() {
  return kFormats;
}

Expected<std::string> bytes_of(const Figure& figure, const Format& format, std::size_t most) {
  // No format needs fewer bytes for a shape, so a figure that is far too large takes no memory.
  constexpr std::size_t kLeastOfAShape = 4;
  const auto refuse = [most] {
    return std::unexpected(Error{ErrorCode::usage,
                                 "the figure would have more than " + std::to_string(most / 1'000'000) +
                                     " MB: show fewer layers or a smaller part, or make pictures of layers",
                                 {},
                                 0,
                                 0});
  };
  const std::size_t shapes = shape_count(figure);
  if (shapes > most / kLeastOfAShape) return refuse();
  // Writing takes time, and memory for all of it; a figure near the limit is written.
  constexpr std::size_t kMostOfAShape = 400;
  if (format.grows && shapes > most / kMostOfAShape && shapes > kShapesOfABlock * kBlocks) {
    const auto estimated = estimated_bytes(figure, format);
    if (!estimated) return std::unexpected(estimated.error());
    if (*estimated > most + most / 4) return refuse();
  }
  auto out = format.write(figure);
  if (out && out->size() > most) return refuse();
  return out;
}

const Format* format_for(std::string_view extension) {
  const auto found = std::ranges::find(kFormats, extension, &Format::extension);
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace mes::figure
