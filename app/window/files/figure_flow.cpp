// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/figure_flow.h"

#include <fmt/core.h>
#include <algorithm>
#include <new>
#include <utility>

#include "app/export/cell_export.h"
#include "app/export/geometry_export.h"
#include "app/insight/center_line_run.h"
#include "app/recording/frame_view.h"
#include "app/store/texts/center_line_text.h"
#include "core/base/assert.h"
#include "core/base/lower_case.h"
#include "core/io/files/atomic_file.h"

namespace mes {

FigureFlow::FigureFlow(Uses uses, Waker wake)
    : uses_(std::move(uses)),
      latest_(uses_.work.live_registry(), wake),
      writing_geometry_(wake),
      lesson_(std::move(wake)) {
  uses_.dialogs.figure.set_uses({.latest = latest_,
                                 .settings = uses_.settings.figure,
                                 .ask_file = [this] { ask_figure(); },
                                 .texture = [this] { return texture(); },
                                 .closed =
                                     [this] {
                                       if (!latest_.is_saving()) latest_.end();
                                     }});
}

FigureFlow::~FigureFlow() {
  forget_texture();
}

void FigureFlow::bind(ActionBindings& actions) {
  actions.bind(ActionId::export_figure, {[this] { open(); }});
  actions.bind(ActionId::export_center_lines, {[this] { ask_center_lines(); }});
  actions.bind(ActionId::export_cells, {[this] { ask_cells(); }});
}

void FigureFlow::open() {
  if (latest_.is_saving()) {
    uses_.messages.notice("A figure is being written; the next one can be exported when that is done");
    return;
  }
  latest_.begin(subject());
  uses_.dialogs.figure.open();
}

FigureSubject FigureFlow::subject() const {
  const ViewMotion& view = uses_.board.view();
  const auto window = uses_.screen.window->framebuffer_size();
  const double scale = uses_.screen.gui.drawing_scale();
  const FrameView seen =
      frame_view(view.camera(), part_between(view.insets(), window.width, window.height), scale, {});
  FigureSubject out{.data = data_of(uses_.work.document()),
                    .settings = uses_.work.computation().settings(),
                    .shown = {},
                    .image = uses_.work.layers().image(),
                    .maps = uses_.board.picture().scene().color_maps(),
                    .view = figure::page_of(seen.camera),
                    .canvas_width = seen.camera.width() / scale,
                    .legend_at = uses_.settings.legend_at,
                    .scale_bar_at = uses_.settings.marks.bar_at};
  out.session =
      uses_.work.session_for_picture(uses_.title(), uses_.board.view().free_box(), uses_.board.pane_views());
  const LayerStack& layers = uses_.work.layers();
  out.shown.descriptors = layers.descriptors();
  out.shown.layers = main_layers(layers.visible_layers());
  for (LayerIndex layer = 0; layer < layers.size(); ++layer) out.shown.styles.push_back(layers.style(layer));
  out.shown.background = uses_.board.picture().canvas();
  const Canvas& canvas = uses_.board.canvas();
  if (canvas.panes().is_empty()) return out;
  out.panes = uses_.work.pane_requests(std::make_shared<const SampleData>(out.data));
  for (std::size_t i = 0; i < out.panes.size() && uses_.work.panes().has_free_cameras(); ++i)
    out.pane_views.push_back(figure::page_of(
        frame_view(canvas.views().of(i).camera(), part_between(view.insets(), window.width, window.height), scale, {})
            .camera));
  return out;
}

std::string FigureFlow::document_name() const {
  std::string name = std::filesystem::path(uses_.title()).stem().string();
  std::ranges::replace(name, '/', '-');
  return name;
}

void FigureFlow::ask_file_for(const std::string& heading, const std::string& suffix,
                              const std::vector<std::string>& extensions,
                              std::function<void(const std::filesystem::path&)> write) {
  uses_.dialogs.browser.ask_save(uses_.folder(), document_name() + suffix + extensions.front(),
                                 [this, write = std::move(write)](const std::filesystem::path& file) {
                                   uses_.settings.last_folder = file.parent_path().string();
                                   write(file);
                                 },
                                 {.heading = heading, .extensions = extensions});
}

void FigureFlow::ask_figure() {
  ask_file_for("Export a figure", "", {uses_.settings.figure.extension}, [this](const std::filesystem::path& file) {
    latest_.save(file);
    uses_.dialogs.figure.close();
  });
}

void FigureFlow::write_aside(const std::filesystem::path& file, std::string_view contents, Compute compute) {
  writing_geometry_.begin([file, contents, registry = uses_.work.live_registry().share(),
                           data = data_of(uses_.work.document()),
                           compute = std::move(compute)](const std::stop_token& stop) -> WrittenGeometry {
    const auto failed = [&](Error error) { return WrittenGeometry{file, std::unexpected(std::move(error))}; };
    try {
      const auto made = compute(*registry, data, stop);
      if (!made) return failed(made.error());
      if (auto written = write_file_atomically(file, made->text); !written) return failed(written.error());
      return {file, made->remark, made->totals};
    } catch (const Cancelled&) {
      return failed({ErrorCode::cancelled, "the export was stopped"});
    } catch (const std::bad_alloc&) {
      return failed({ErrorCode::out_of_memory, fmt::format("memory is not enough for {}", contents)});
    }
  });
}

void FigureFlow::ask_geometry(std::vector<LayerIndex> layers, const LayerTextFormat& format) {
  if (layers.empty()) {
    uses_.messages.problem("No layer is shown whose geometry could be exported");
    return;
  }
  const auto lacks = [&](LayerIndex layer) { return !format.holds(uses_.work.layers().descriptor(layer)); };
  if (!std::ranges::all_of(layers, lacks)) std::erase_if(layers, lacks);
  if (auto good = check_layers(uses_.work.layers().descriptors(), format, layers); !good) {
    uses_.messages.problem(good.error().message());
    return;
  }
  const std::string layer =
      layers.size() == 1 ? "-" + std::string(uses_.work.layers().descriptor(layers.front()).id) : "";
  ask_file_for(fmt::format("Export geometry as {}", format.title), layer, {"." + std::string(format.extension)},
               [this, layers = std::move(layers), &format](const std::filesystem::path& file) {
                 write_geometry(file, layers, format);
               });
}

void FigureFlow::write_geometry(const std::filesystem::path& file, const std::vector<LayerIndex>& layers,
                                const LayerTextFormat& format) {
  for (const LayerIndex layer : layers)
    if (const LayerDescriptor& descriptor = uses_.work.layers().descriptor(layer); descriptor.is_removed) {
      uses_.messages.problem(fmt::format("The layer {} is not there any more", descriptor.name));
      return;
    }
  const auto compute = [layers = main_layers(layers), settings = uses_.work.computation().settings(), &format](
                           const Registry& registry, const SampleData& data,
                           const std::stop_token& stop) -> Expected<GeometryText> {
    auto text = compute_layer_text(registry, data, format,
                                   {.layers = layers, .settings = settings, .on_patch = {}, .stop = stop});
    if (!text) return std::unexpected(text.error());
    std::string remark = remark_about(*text, format);
    return GeometryText{std::move(text->text), std::move(remark)};
  };
  write_aside(file, "this geometry", compute);
}

void FigureFlow::ask_center_lines() {
  std::vector<std::string> extensions;
  for (const LineTextFormat& format : line_text_formats())
    if (!format.name.contains('-')) extensions.push_back("." + std::string(format.name));
  CenterLineWish wish = wish_of(uses_.work.computation().settings(), {});
  const std::vector<SampleSlot> selected = uses_.work.editor().selection().slots();
  if (selected.size() == 2) {
    const Document& document = uses_.work.document();
    wish.request.between = {{document.position(selected[0]), document.position(selected[1])}};
  }
  ask_file_for(!wish.request.between.empty() ? "Export the centre line between the ends near two samples"
                                             : "Export centre lines",
               "-center-lines", extensions,
               [this, wish](const std::filesystem::path& file) { write_center_lines(file, wish); });
}

void FigureFlow::write_center_lines(const std::filesystem::path& file, const CenterLineWish& wish) {
  const std::string extension = lower_case_extension(file);
  const LineTextFormat* const format = find_line_text_format(std::string_view(extension).substr(1));
  MES_ASSERT(format != nullptr);  // the dialog returns names with the extensions that it was given
  const auto compute = [format, wish](const Registry& registry, const SampleData& data,
                                      const std::stop_token& stop) -> Expected<GeometryText> {
    JobControl job(stop);
    CenterLineWish full = wish;
    if (full.request.between.empty()) full.request.between = center_line_ends(data.annotations);
    const auto found = CenterLineFinder(registry).find(data, full, job);
    if (!found) return std::unexpected(found.error());
    const double unit = data.map ? data.map->written_size() : 1.0;
    std::vector<TextLine> lines;
    for (const CenterLine& line : found->lines) lines.push_back(text_line_of(line, data.map, unit));
    auto text = format->write(lines);
    if (!text) return std::unexpected(text.error());
    CenterLineTotals totals;
    totals.add(*found, unit);
    return GeometryText{std::move(text->text), {}, totals.text(data.map, text->off_earth)};
  };
  write_aside(file, "these lines", compute);
}

void FigureFlow::ask_cells() {
  std::vector<std::string> extensions;
  for (const std::string_view format : cell_formats()) extensions.push_back("." + std::string(format));
  ask_file_for("Export Voronoi cells", "-cells", extensions,
               [this](const std::filesystem::path& file) { write_cells(file); });
}

void FigureFlow::write_cells(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  const auto format = std::ranges::find(cell_formats(), std::string_view(extension).substr(1));
  MES_ASSERT(format != cell_formats().end());  // as above
  const auto compute = [format = *format](const Registry& registry, const SampleData& data,
                                          const std::stop_token& stop) -> Expected<GeometryText> {
    JobControl job(stop);
    auto text = compute_cell_text(registry, data, usual_region_of(data), format, job);
    if (!text) return std::unexpected(text.error());
    return GeometryText{std::move(text->text),
                        text->off_earth == 0 ? "" : "cells beyond the poles or around the Earth are left out"};
  };
  write_aside(file, "these cells", compute);
}

void FigureFlow::take_geometry() {
  const auto written = writing_geometry_.poll();
  if (!written) return;
  uses_.screen.clock.settle();
  if (!written->remark)
    uses_.messages.problem(written->remark.error().message());
  else if (written->remark->empty())
    uses_.messages.remark("Exported " + written->file.string() +
                          (written->totals.empty() ? std::string() : ": " + written->totals));
  else
    uses_.messages.notice("Exported " + written->file.string() + "; " + *written->remark);
}

void FigureFlow::ask_lesson() {
  if (lesson_.is_under_way()) {
    uses_.messages.notice("A lesson is being written; the next one can be exported when that is done");
    return;
  }
  ask_file_for("Export the lesson as .pdf, .html, .mp4 or .webm", "", lesson_extensions(),
               [this, session = std::make_shared<const Session>(uses_.session())](const std::filesystem::path& file) {
                 lesson_.begin(uses_.work.live_registry().share(), session, file);
               });
}

void FigureFlow::take_lesson() {
  const auto done = lesson_.take_done();
  if (!done) return;
  uses_.screen.clock.settle();
  std::string exported = "Exported " + done->file.string();
  for (const std::string& remark : done->remarks) exported += "; " + remark;
  if (done->outcome && done->remarks.empty())
    uses_.messages.remark(exported);
  else if (done->outcome)
    uses_.messages.notice(exported);
  else if (done->outcome.error().code == ErrorCode::cancelled)
    uses_.messages.remark("The export of the lesson was cancelled");
  else
    uses_.messages.problem(done->outcome.error().message());
}

void FigureFlow::take_results() {
  take_geometry();
  take_lesson();
  uses_.dialogs.figure.set_covered(uses_.dialogs.browser.is_open());
  if (!latest_.follow()) return;
  uses_.screen.clock.settle();
  const auto saved = latest_.take_saved();
  if (!saved) return;
  if (saved->outcome)
    uses_.messages.remark("Exported " + saved->file.string());
  else
    uses_.messages.problem(saved->outcome.error().message());
  if (!uses_.dialogs.figure.is_open()) latest_.end();
}

ImTextureID FigureFlow::texture() {
  const FigurePreview* const preview = latest_.preview();
  if (preview == nullptr) return nullptr;
  render::GlDevice& device = uses_.board.picture().device();
  if (!texture_ || textured_ != latest_.preview_number()) {
    forget_texture();
    texture_ = device.create_texture(preview->image.width, preview->image.height, preview->image.rgba, true);
    textured_ = latest_.preview_number();
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(device.name_of(*texture_)));
}

void FigureFlow::forget_texture() {
  if (texture_) uses_.board.picture().device().destroy_texture(*texture_);
  texture_.reset();
}

}  // namespace mes
