// SPDX-License-Identifier: GPL-3.0-or-later
// PostScript and encapsulated PostScript, through cairo: PostScript has no opacity, so cairo makes a picture of 300
// dots an inch of translucent parts, and vectors of all others.
#include <cairo-ps.h>

#include <string>
#include <vector>

#include "render/figure/internal/cairo_painter.h"
#include "render/figure/raster.h"
#include "render/figure/writers.h"

namespace mes::figure {
namespace {

cairo_status_t append_bytes(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// Removes the comment lines with the date of a file and the version of the library.
void remove_comments_that_vary(std::string& text) {
  for (const char* const name : {"%%CreationDate:", "%%Creator:"}) {
    const std::size_t at = text.find(name);
    if (at != std::string::npos) text.erase(at, text.find('\n', at) + 1 - at);
  }
}

std::size_t translucent_shapes(const FigureLayer& layer) {
  std::size_t count = 0;
  for (const Group& group : layer.groups)
    for (const Run& run : group.runs)
      if (group.opacity < 1.0 || run.opacity < 1.0) count += run.shapes.size();
  return count;
}

/// Layers that cairo would rasterize shape by shape, for minutes.
std::vector<std::string> layers_to_rasterize(const Figure& figure) {
  constexpr std::size_t kMostTranslucent = 1000;
  std::vector<std::string> out;
  for (const FigureLayer& layer : figure.layers)
    if (translucent_shapes(layer) > kMostTranslucent) out.push_back(layer.id);
  return out;
}

Expected<std::string> postscript(const Figure& figure, bool is_encapsulated) {
  if (const std::vector<std::string> layers = layers_to_rasterize(figure); !layers.empty()) {
    Figure reduced = figure;
    if (auto good = rasterize_layers(reduced, layers, kDotsPerInch); !good) return std::unexpected(good.error());
    return postscript(reduced, is_encapsulated);
  }
  std::string out;
  cairo_surface_t* const surface =
      cairo_ps_surface_create_for_stream(append_bytes, &out, figure.width, figure.height);
  cairo_ps_surface_set_eps(surface, is_encapsulated ? 1 : 0);
  cairo_surface_set_fallback_resolution(surface, kDotsPerInch, kDotsPerInch);
  cairo_t* const cairo = cairo_create(surface);
  CairoPainter(cairo, figure).paint();
  cairo_show_page(cairo);
  const cairo_status_t painted = cairo_status(cairo);
  cairo_destroy(cairo);
  cairo_surface_finish(surface);
  const cairo_status_t written = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  const cairo_status_t status = painted != CAIRO_STATUS_SUCCESS ? painted : written;
  if (status != CAIRO_STATUS_SUCCESS)
    return std::unexpected(Error{ErrorCode::out_of_memory,
                                 "the figure cannot be drawn: " + std::string(cairo_status_to_string(status))});
  remove_comments_that_vary(out);
  return out;
}

}  // namespace

Expected<std::string> ps_of(const Figure& figure) {
  return postscript(figure, false);
}

Expected<std::string> eps_of(const Figure& figure) {
  return postscript(figure, true);
}

}  // namespace mes::figure
