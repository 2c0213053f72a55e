// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/figure_desk.h"

#include <algorithm>
#include <new>

#include "app/export/computation.h"
#include "app/store/background_loader.h"
#include "core/draw/layer_descriptor.h"
#include "core/io/atomic_file.h"
#include "core/io/carried_session.h"
#include "render/figure/raster.h"

namespace mes {
namespace {

constexpr double kPointsPerMillimeter = figure::kPointsPerInch / figure::kMillimetersPerInch;

std::unexpected<Error> no_memory() {
  return std::unexpected(Error{ErrorCode::out_of_memory, "memory is not enough for this figure"});
}

std::optional<Rgb> paper_of(FigurePaper paper, const std::optional<Rgb>& canvas) {
  switch (paper) {
    case FigurePaper::white: return Rgb{255, 255, 255};
    case FigurePaper::canvas: return canvas;
    case FigurePaper::transparent: return std::nullopt;
  }
  return std::nullopt;
}

FigureRequest request_of(const FigureSubject& subject, const FigureSettings& settings,
                         const std::vector<std::string>& rasterized) {
  FigureRequest out{.shown = subject.shown, .part = Everything{}, .image = subject.image};
  if (settings.extent != FigureExtent::everything) out.part = subject.view;
  PageSize page{.width = kPointsPerMillimeter * settings.width_mm, .height = std::nullopt};
  if (settings.height_mm > 0.0) page.height = kPointsPerMillimeter * std::max(settings.height_mm, kLeastFigureSide);
  out.page = page;
  out.is_tight = settings.extent == FigureExtent::ink;
  out.legend = legend_scope(settings.with_legend, settings.with_key);
  out.legend_at = subject.legend_at;
  out.marks = settings.marks;
  out.marks.bar_at = subject.scale_bar_at;
  out.title = settings.title;
  out.with_annotations = settings.with_annotations;
  out.shown.background = paper_of(settings.paper, subject.shown.background);
  out.shown.scale =
      settings.as_on_screen ? page.width / (figure::kPointsPerPixel * subject.canvas_width) : settings.line_scale;
  const figure::Format* const format = figure::format_for(settings.extension);
  if (format != nullptr && format->has_images) out.rasterized = rasterized;
  out.dots_per_inch = settings.dots_per_inch;
  return out;
}

FigurePreview::Layer counted(const figure::FigureLayer& layer) {
  return {layer.id, layer.title, figure::shape_count(layer), layer.image.has_value()};
}

}  // namespace

/// Everything that a figure is made of, whatever its settings.
struct FigureDesk::Contents {
  FigureSubject subject;
  PlacedAnnotations annotations;
  LayerMirror mirror;
  Document document;
  Box2 bounds;
  std::optional<render::Image> traced;
  std::vector<std::string> remarks;
  std::optional<std::string> session;  // packed; none: it is too long
};

FigureDesk::FigureDesk(std::function<void()> wake)
    : computing_(wake), drawing_(wake), writing_(wake), saving_(std::move(wake)) {}

void FigureDesk::begin(FigureSubject subject) {
  end();
  is_open_ = true;
  computing_.begin([subject = std::move(subject)](const std::stop_token& stop) { return compute(subject, stop); });
}

void FigureDesk::end() {
  computing_.give_up();
  drawing_.give_up();
  writing_.give_up();
  is_open_ = false;
  contents_.reset();
  preview_.reset();
  figure_.reset();
  bytes_.reset();
  problem_.reset();
  save_to_.reset();
}

Expected<std::shared_ptr<const FigureDesk::Contents>> FigureDesk::compute(const FigureSubject& subject,
                                                                          const std::stop_token& stop) try {
  auto out = std::make_shared<Contents>();
  out->subject = subject;
  out->session = packed_session(subject.session);
  auto result = run_computation(subject.data, {.layers = subject.shown.layers,
                                               .settings = subject.settings,
                                               .on_patch = [&](const FramePatch& patch) { out->mirror.apply(patch); },
                                               .stop = stop});
  if (!result) return std::unexpected(result.error());
  out->bounds = result->document.bounding_box();
  out->annotations = place(result->document);
  out->document = std::move(result->document);
  const bool is_traced = std::ranges::find(subject.shown.layers, find_layer("image")) != subject.shown.layers.end();
  if (is_traced && !subject.image.file.empty()) {
    if (auto image = read_background(subject.image.file))
      out->traced = std::move(*image);
    else
      out->remarks.push_back("the picture to trace is left out: " + image.error().message());
  }
  return out;
} catch (const std::bad_alloc&) {
  return no_memory();
}

FigureDesk::Drawn FigureDesk::draw(const Contents& contents, const Wanted& wanted) try {
  const FigureSubject& subject = contents.subject;
  const FigureRequest request = request_of(subject, wanted.settings, wanted.rasterized);
  auto drawn = draw_figure(request, {.mirror = contents.mirror,
                                     .samples = subject.data.positions,
                                     .bounds = contents.bounds,
                                     .maps = subject.maps,
                                     .traced = contents.traced ? &*contents.traced : nullptr,
                                     .annotations = contents.annotations,
                                     .document = contents.document});
  if (!drawn) return {wanted, std::unexpected(drawn.error())};
  FigurePreview preview{.image = {},
                        .width = drawn->figure.width,
                        .height = drawn->figure.height,
                        .layers = {},
                        .shapes = figure::shape_count(drawn->figure),
                        .remarks = contents.remarks};
  preview.remarks.insert(preview.remarks.end(), drawn->remarks.begin(), drawn->remarks.end());
  const figure::Format* const format = figure::format_for(wanted.settings.extension);
  if (contents.traced && format != nullptr && !format->has_images) {
    preview.remarks.push_back("the picture to trace is left out: " + std::string(format->name) + " files hold none");
    for (figure::FigureLayer& layer : drawn->figure.layers) layer.image.reset();
  }
  for (const figure::FigureLayer& layer : drawn->figure.layers) preview.layers.push_back(counted(layer));
  if (wanted.settings.with_source && format != nullptr && format->carries_session) {
    if (contents.session)
      drawn->figure.session = *contents.session;
    else
      preview.remarks.emplace_back("the document is left out: it is too long for a figure");
  }
  auto image = figure::picture_of(drawn->figure, wanted.preview_px / std::max(preview.width, preview.height));
  if (!image) return {wanted, std::unexpected(image.error())};
  preview.image = std::move(*image);
  return {wanted, std::pair(std::make_shared<const figure::Figure>(std::move(drawn->figure)), std::move(preview))};
} catch (const std::bad_alloc&) {
  return {wanted, no_memory()};
}

void FigureDesk::want(const FigureSettings& settings, const std::vector<std::string>& rasterized, int preview_px) {
  Wanted wanted{settings, rasterized, std::max(preview_px, 16)};
  if (wanted == wanted_) return;
  wanted_ = std::move(wanted);
  bytes_.reset();
  writing_.give_up();
  if (contents_) {
    problem_.reset();
    begin_drawing();
  }
}

void FigureDesk::begin_drawing() {
  // One after the other: a slider that is dragged would begin more than a machine can draw.
  if (!is_open_ || !contents_ || drawing_.is_under_way()) return;
  drawing_.begin(
      [contents = contents_, wanted = wanted_](const std::stop_token&) { return draw(*contents, wanted); });
}

void FigureDesk::begin_writing() {
  const figure::Format* const format = figure::format_for(wanted_.settings.extension);
  if (format == nullptr) {
    fail({ErrorCode::usage, "figures have no format " + wanted_.settings.extension});
    return;
  }
  writing_.begin([figure = figure_, wanted = wanted_, format](const std::stop_token&) -> Written {
    try {
      return {wanted, format->write(*figure)};
    } catch (const std::bad_alloc&) {
      return {wanted, no_memory()};
    }
  });
}

void FigureDesk::fail(const Error& error) {
  problem_ = error;
  if (save_to_) saved_ = Saved{*std::exchange(save_to_, std::nullopt), std::unexpected(error)};
}

bool FigureDesk::take_contents() {
  auto contents = computing_.poll();
  if (!contents) return false;
  if (*contents) {
    contents_ = std::move(**contents);
    begin_drawing();
  } else {
    fail(contents->error());
  }
  return true;
}

bool FigureDesk::take_drawn() {
  auto drawn = drawing_.poll();
  if (!drawn) return false;
  if (drawn->wanted == wanted_ && !drawn->figure) {
    fail(drawn->figure.error());
    return true;
  }
  if (drawn->figure) {
    figure_ = std::move(drawn->figure->first);
    preview_ = std::move(drawn->figure->second);
    shown_ = drawn->wanted;
    ++preview_number_;
  }
  if (drawn->wanted == wanted_)
    begin_writing();
  else
    begin_drawing();
  return true;
}

bool FigureDesk::take_written() {
  auto written = writing_.poll();
  if (!written) return false;
  if (!written->bytes) {
    fail(written->bytes.error());
    return true;
  }
  bytes_ = std::make_shared<const std::string>(std::move(*written->bytes));
  if (save_to_) begin_saving();
  return true;
}

bool FigureDesk::follow() {
  bool has_changed = take_contents();
  has_changed = take_drawn() || has_changed;
  has_changed = take_written() || has_changed;
  if (auto saved = saving_.poll()) {
    saved_ = std::move(*saved);
    has_changed = true;
  }
  return has_changed || saved_;
}

void FigureDesk::save(const std::filesystem::path& file) {
  save_to_ = file;
  if (problem_)
    fail(Error(*problem_));
  else if (bytes_)
    begin_saving();
}

void FigureDesk::begin_saving() {
  saving_.begin([file = *std::exchange(save_to_, std::nullopt), bytes = bytes_](const std::stop_token&) -> Saved {
    return {file, write_file_atomically(file, *bytes)};
  });
}

}  // namespace mes
