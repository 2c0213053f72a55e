// SPDX-License-Identifier: GPL-3.0-or-later
// What a figure costs, from the layers to the bytes of the file, against a loop that hands the same strokes and disks to
// cairo.
#include <benchmark/benchmark.h>
#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <numbers>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/draw/layer_mirror.h"
#include "render/figure/figure_of.h"
#include "render/figure/writers.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/builtin_layers.h"

namespace mes::bench {
namespace {

constexpr double kWidth = 450.0;  // points: some two columns of a journal
constexpr double kHeight = 300.0;
constexpr std::size_t kSegments = 100000;
constexpr std::size_t kDisks = 10000;
constexpr double kOpacity = 0.6;
constexpr double kLineWidth = 0.75;  // points: a logical pixel

/// Short strokes in one layer, disks in the next.
struct Strokes {
  std::vector<double> segments;
  std::vector<double> disks;

  Strokes() {
    Rng rng(12);
    for (std::size_t i = 0; i < kSegments; ++i) {
      const double x = rng.uniform(0.0, kWidth);
      const double y = rng.uniform(0.0, kHeight);
      segments.insert(segments.end(), {x, y, x + rng.uniform(-5.0, 5.0), y + rng.uniform(-5.0, 5.0), 0.0});
    }
    for (std::size_t i = 0; i < kDisks; ++i)
      disks.insert(disks.end(), {rng.uniform(0.0, kWidth), rng.uniform(0.0, kHeight), rng.uniform(1.0, 10.0), 0.0});
  }

  LayerMirror mirror() const {
    FramePatch patch;
    patch.layers.resize(2);
    patch.layer_count = 2;
    const auto fill = [](KindPatch& kind, const std::vector<double>& data, PrimitiveKind of) {
      kind.reset = true;
      kind.count = static_cast<std::uint32_t>(data.size() / stride_of(of));
      kind.data = data;
    };
    patch.layers[1].layer = 1;
    fill(patch.layers[0][PrimitiveKind::disk], disks, PrimitiveKind::disk);
    fill(patch.layers[1][PrimitiveKind::segment], segments, PrimitiveKind::segment);
    LayerMirror out;
    out.apply(patch);
    return out;
  }
};

std::size_t ours(const LayerMirror& mirror, Expected<std::string> (*write)(const figure::Figure&)) {
  const LayerStyle style{.color = {40, 90, 160}, .opacity = kOpacity};
  const std::vector<render::LayerView> views{{.layer = 0, .style = style}, {.layer = 1, .style = style}};
  const figure::Page page{
      .center = {0.5 * kWidth, 0.5 * kHeight}, .units_per_point = 1.0, .width = kWidth, .height = kHeight};
  const auto bytes = write(figure_of({.mirror = mirror, .layers = layer_descriptors(), .views = views}, page));
  return bytes ? bytes->size() : 0;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// The least that puts the same on a page.
std::size_t minimal(const Strokes& strokes, cairo_surface_t* (*create)(cairo_write_func_t, void*, double, double)) {
  std::string bytes;
  cairo_surface_t* surface = create(append, &bytes, kWidth, kHeight);
  cairo_t* page = cairo_create(surface);
  cairo_set_source_rgba(page, 40 / 255.0, 90 / 255.0, 160 / 255.0, kOpacity);
  cairo_set_line_width(page, kLineWidth);
  cairo_set_line_cap(page, CAIRO_LINE_CAP_ROUND);
  for (std::size_t i = 0; i < strokes.disks.size(); i += stride_of(PrimitiveKind::disk)) {
    const double* disk = &strokes.disks[i];
    cairo_arc(page, disk[0], kHeight - disk[1], disk[2], 0.0, 2.0 * std::numbers::pi);
    cairo_fill(page);
  }
  for (std::size_t i = 0; i < strokes.segments.size(); i += stride_of(PrimitiveKind::segment)) {
    const double* segment = &strokes.segments[i];
    cairo_move_to(page, segment[0], kHeight - segment[1]);
    cairo_line_to(page, segment[2], kHeight - segment[3]);
    cairo_stroke(page);
  }
  cairo_destroy(page);
  cairo_surface_finish(surface);
  cairo_surface_destroy(surface);
  return bytes.size();
}

void figure(benchmark::State& state, RatioTable& table, const std::string& name,
            Expected<std::string> (*write)(const figure::Figure&),
            cairo_surface_t* (*create)(cairo_write_func_t, void*, double, double)) {
  const Strokes strokes;
  const LayerMirror mirror = strokes.mirror();
  std::vector<double> our_times, raw_times;
  std::size_t our_bytes = 0;
  std::size_t raw_bytes = 0;
  for (auto _ : state) {
    double start = now_us();
    our_bytes = ours(mirror, write);
    our_times.push_back(now_us() - start);
    start = now_us();
    raw_bytes = minimal(strokes, create);
    raw_times.push_back(now_us() - start);
  }
  if (our_bytes == 0) state.SkipWithError("nothing was written");
  const std::size_t count = kSegments + kDisks;
  table.add({name + " of segments and disks", count, median(our_times), median(raw_times), 1.3,
             "a minimal loop that calls cairo"});
  table.add({name + ", bytes", count, static_cast<double>(our_bytes), static_cast<double>(raw_bytes), 1.0,
             "those of the loop"});
}

}  // namespace

void register_figures(RatioTable& table) {
  struct Row {
    const char* name;
    Expected<std::string> (*write)(const figure::Figure&);
    cairo_surface_t* (*create)(cairo_write_func_t, void*, double, double);
  };
  for (const Row& row : {Row{"SVG", figure::svg_of, cairo_svg_surface_create_for_stream},
                         Row{"PDF", figure::pdf_of, cairo_pdf_surface_create_for_stream}})
    benchmark::RegisterBenchmark(
        ("figure/" + std::string(row.name)).c_str(),
        [&table, row](benchmark::State& state) { figure(state, table, row.name, row.write, row.create); })
        ->Iterations(5)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
