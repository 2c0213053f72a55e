// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/latest_figure.h"

#include <algorithm>
#include <new>

#include "app/export/computation.h"
#include "app/export/pane_figure.h"
#include "app/picture/paper/pane_sheet.h"
#include "app/store/background_loader.h"
#include "core/io/files/atomic_file.h"
#include "core/io/session/session.h"
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

/// Width of the page's content: all panes in their rows, or the main one alone.
double canvas_width(const FigureSubject& subject, bool has_panes) {
  if (!has_panes) return subject.canvas_width;
  const std::size_t columns = usual_columns(subject.panes.size());
  return lay_out_panes_of(subject.canvas_width, 0.0, subject.panes.size(), columns, 1.0).extent().x;
}

bool shows_panes(const FigureSubject& subject, const FigureSettings& settings) {
  return settings.all_panes && !subject.panes.empty();
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
  out.legend_beside = true;
  out.marks = settings.marks;
  out.marks.bar_at = subject.scale_bar_at;
  out.title = settings.title;
  out.with_annotations = settings.with_annotations;
  out.shown.background = paper_of(settings.paper, subject.shown.background);
  if (settings.as_on_screen) {
    out.shown.scale = page.width / (figure::kPointsPerPixel * canvas_width(subject, shows_panes(subject, settings)));
  } else {
    out.shown.scale = scale_for_letters(settings.letters_pt);
    out.shown.least_line_px = settings.least_line_pt / (figure::kPointsPerPixel * out.shown.scale);
    for (LayerStyle& style : out.shown.styles) {
      style.line_width_px = std::max(style.line_width_px, out.shown.least_line_px);
      style.point_size_px = std::max(style.point_size_px, out.shown.least_line_px);
    }
    out.keeps_letters = true;
  }
  const figure::Format* const format = figure::format_for(settings.extension);
  if (format != nullptr && format->has_images) out.rasterized = rasterized;
  out.dots_per_inch = settings.dots_per_inch;
  return out;
}

/// Counts layers; the parts of one layer in several panes count as one.
std::vector<FigurePreview::Layer> counted(const figure::Figure& figure, std::span<const Pane> panes) {
  std::vector<FigurePreview::Layer> out;
  for (const figure::FigureLayer& layer : figure.layers) {
    if (layer.id == kPaneLabels) continue;  // belongs to no layer that could be a picture
    FigurePreview::Layer one{layer.id, layer.title, figure::shape_count(layer), layer.image.has_value()};
    for (const Pane& pane : panes) {
      const std::string id = id_prefix_of(pane);
      if (!one.id.starts_with(id)) continue;
      one.id.erase(0, id.size());
      one.title.erase(0, title_prefix_of(pane).size());
      break;
    }
    const auto known = std::ranges::find(out, one.id, &FigurePreview::Layer::id);
    if (known == out.end()) {
      out.push_back(std::move(one));
      continue;
    }
    known->shapes += one.shapes;
    known->is_picture = known->is_picture || one.is_picture;
  }
  return out;
}

void note_lines(FigurePreview& preview, const figure::Figure& figure) {
  for (const figure::FigureLayer& layer : figure.layers) {
    const auto has_lines = [](const figure::Group& group) {
      return std::ranges::any_of(group.runs,
                                 [](const figure::Run& run) { return !run.is_filled && !run.shapes.empty(); });
    };
    if (!std::ranges::any_of(layer.groups, has_lines)) continue;
    preview.finest = preview.widest == 0.0 ? layer.line_width : std::min(preview.finest, layer.line_width);
    preview.widest = std::max(preview.widest, layer.line_width);
  }
}

}  // namespace

/// Everything from which a figure is made, whatever its settings.
struct LatestFigure::Contents {
  std::shared_ptr<const Registry> registry;  // the registry of these layers
  FigureSubject subject;
  LayerMirror mirror;
  Comparison comparison;  // a single pane, or several with the marks of their differences
  ComputationResult result;
  std::vector<Box2> bounds;  // bounds of the documents of the panes
  std::optional<render::Image> traced;
  std::vector<std::string> remarks;
  std::optional<std::string> session;  // packed; nothing: it is too long

  /// The sources of a pane; they refer to this object.
  FigureSource source_of(std::size_t pane) const {
    const Document& document = comparison.document_of(comparison.panes[pane], result);
    return {.mirror = mirror,
            .bounds = bounds[pane],
            .maps = subject.maps,
            .traced = traced ? &*traced : nullptr,
            .annotations = place(document),
            .document = document};
  }
};

LatestFigure::LatestFigure(LiveRegistry registry, Waker wake)
    : registry_(std::move(registry)), computing_(wake), drawing_(wake), writing_(wake), saving_(std::move(wake)) {}

void LatestFigure::begin(FigureSubject subject) {
  end();
  is_open_ = true;
  has_panes_ = !subject.panes.empty();
  computing_.begin([registry = registry_.share(), subject = std::move(subject)](const std::stop_token& stop) {
    return compute(registry, subject, stop);
  });
}

void LatestFigure::end() {
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

Expected<std::shared_ptr<const LatestFigure::Contents>> LatestFigure::compute(
    std::shared_ptr<const Registry> registry, const FigureSubject& subject, const std::stop_token& stop) try {
  auto out = std::make_shared<Contents>();
  out->registry = registry;
  out->subject = subject;
  out->session = packed_session(subject.session);
  std::vector<PaneRequest> panes = subject.panes;
  if (panes.empty())
    panes.push_back({{}, subject.shown, subject.settings, std::make_shared<const SampleData>(subject.data)});
  out->comparison = compare(*registry, std::move(panes));
  Comparison& comparison = out->comparison;
  auto result = run_computation(*registry, *comparison.data,
                                {.layers = comparison.demand,
                                 .settings = comparison.settings,
                                 .on_patch = [&](const FramePatch& patch) { out->mirror.apply(patch); },
                                 .variants = comparison.variants,
                                 .stop = stop});
  if (!result) return std::unexpected(result.error());
  out->result = std::move(*result);
  for (const Pane& pane : comparison.panes)
    out->bounds.push_back(comparison.document_of(pane, out->result).bounding_box());
  if (!subject.panes.empty()) {
    share_color_ranges(comparison, out->mirror);
    Box2 all;
    for (const Box2& box : out->bounds)
      if (!box.is_empty()) all.add(box);
    out->mirror.apply(
        mark_differences(comparison, out->mirror, all.is_empty() ? 0.0 : std::max(all.width(), all.height())));
  }
  const bool is_traced = std::ranges::find(subject.shown.layers, find_layer(subject.shown.descriptors, "image")) !=
                         subject.shown.layers.end();
  if (is_traced && !subject.image.file.empty()) {
    if (auto image = read_background(subject.image))
      out->traced = std::move(*image);
    else
      out->remarks.push_back("the picture underneath is left out: " + image.error().message());
  }
  return out;
} catch (const std::bad_alloc&) {
  return no_memory();
}

Expected<DrawnFigure> LatestFigure::draw_figure_of(const Contents& contents, const Wanted& wanted) {
  const FigureSettings& settings = wanted.settings;
  const FigureRequest request = request_of(contents.subject, settings, wanted.rasterized);
  if (!shows_panes(contents.subject, settings)) return draw_figure(request, contents.source_of(0));
  Comparison comparison = contents.comparison;
  std::vector<FigureSource> sources;
  for (std::size_t i = 0; i < comparison.panes.size(); ++i) {
    if (!settings.with_differences) comparison.panes[i].marks.clear();
    sources.push_back(contents.source_of(i));
  }
  std::optional<FreeCameras> cameras;
  if (!contents.subject.pane_views.empty()) cameras = FreeCameras{contents.subject.pane_views};
  return draw_pane_figure(request, comparison, sources, cameras);
}

LatestFigure::Drawn LatestFigure::draw(const Contents& contents, const Wanted& wanted) try {
  auto drawn = draw_figure_of(contents, wanted);
  if (!drawn) return {wanted, std::unexpected(drawn.error())};
  FigurePreview preview{.image = {},
                        .width = drawn->figure.width,
                        .height = drawn->figure.height,
                        .layers = {},
                        .shapes = figure::shape_count(drawn->figure),
                        .finest = 0.0,
                        .widest = 0.0,
                        .remarks = contents.remarks};
  preview.remarks.insert(preview.remarks.end(), drawn->remarks.begin(), drawn->remarks.end());
  const figure::Format* const format = figure::format_for(wanted.settings.extension);
  if (contents.traced && format != nullptr && !format->has_images) {
    preview.remarks.push_back("the picture underneath is left out: " + std::string(format->name) +
                              " files hold none");
    for (figure::FigureLayer& layer : drawn->figure.layers) layer.image.reset();
  }
  preview.layers = counted(drawn->figure, contents.comparison.panes);
  note_lines(preview, drawn->figure);
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

void LatestFigure::want(const FigureSettings& settings, const std::vector<std::string>& rasterized, int preview_px) {
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

void LatestFigure::begin_drawing() {
  // One drawing at a time: dragging a slider would begin more of them than a machine can draw.
  if (!is_open_ || !contents_ || drawing_.is_under_way()) return;
  drawing_.begin(
      [contents = contents_, wanted = wanted_](const std::stop_token&) { return draw(*contents, wanted); });
}

void LatestFigure::begin_writing() {
  const figure::Format* const format = figure::format_for(wanted_.settings.extension);
  if (format == nullptr) {
    fail({ErrorCode::usage, "figures have no format " + wanted_.settings.extension});
    return;
  }
  writing_.begin([figure = figure_, wanted = wanted_, format](const std::stop_token&) -> Written {
    try {
      return {wanted, figure::bytes_of(*figure, *format)};
    } catch (const std::bad_alloc&) {
      return {wanted, no_memory()};
    }
  });
}

void LatestFigure::fail(const Error& error) {
  problem_ = error;
  if (save_to_) saved_ = Saved{*std::exchange(save_to_, std::nullopt), std::unexpected(error)};
}

bool LatestFigure::take_contents() {
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

bool LatestFigure::take_drawn() {
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

bool LatestFigure::take_written() {
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

bool LatestFigure::follow() {
  bool has_changed = take_contents();
  has_changed = take_drawn() || has_changed;
  has_changed = take_written() || has_changed;
  if (auto saved = saving_.poll()) {
    saved_ = std::move(*saved);
    has_changed = true;
  }
  return has_changed || saved_;
}

void LatestFigure::save(const std::filesystem::path& file) {
  save_to_ = file;
  if (problem_)
    fail(Error(*problem_));
  else if (bytes_)
    begin_saving();
}

void LatestFigure::begin_saving() {
  saving_.begin([file = *std::exchange(save_to_, std::nullopt), bytes = bytes_](const std::stop_token&) -> Saved {
    return {file, write_file_atomically(file, *bytes)};
  });
}

}  // namespace mes
