// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/figure_flow.h"

#include <algorithm>
#include <utility>

#include "app/model/record_settings.h"

namespace mes {

FigureFlow::FigureFlow(Uses uses, std::function<void()> wake) : uses_(std::move(uses)), desk_(std::move(wake)) {
  uses_.dialogs.figure.set_uses({.desk = desk_,
                                 .settings = uses_.settings.figure,
                                 .ask_file = [this] { ask_file(); },
                                 .texture = [this] { return texture(); },
                                 .closed =
                                     [this] {
                                       if (!desk_.is_saving()) desk_.end();
                                     }});
}

FigureFlow::~FigureFlow() {
  forget_texture();
}

void FigureFlow::bind(ActionBindings& actions) {
  actions.bind(ActionId::export_figure, {[this] { open(); }});
}

void FigureFlow::open() {
  if (desk_.is_saving()) {
    uses_.messages.problem("A figure is being written; the next one can be exported when that is done");
    return;
  }
  desk_.begin(subject());
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
                    .canvas_width = seen.camera.width() / scale};
  const LayerStack& layers = uses_.work.layers();
  out.shown.layers = layers.visible_layers();
  for (LayerIndex layer = 0; layer < layers.size(); ++layer) out.shown.styles.push_back(layers.style(layer));
  out.shown.background = uses_.board.picture().canvas();
  return out;
}

void FigureFlow::ask_file() {
  std::string name = std::filesystem::path(uses_.title()).stem().string();
  std::ranges::replace(name, '/', '-');
  const std::string& extension = uses_.settings.figure.extension;
  uses_.dialogs.browser.ask_save(uses_.folder(), name + extension,
                                 [this](const std::filesystem::path& file) {
                                   uses_.settings.last_folder = file.parent_path().string();
                                   desk_.save(file);
                                   uses_.dialogs.figure.close();
                                 },
                                 {.heading = "Export a figure", .extensions = {extension}});
}

void FigureFlow::take_results() {
  uses_.dialogs.figure.set_covered(uses_.dialogs.browser.is_open());
  if (!desk_.follow()) return;
  uses_.screen.clock.settle();
  const auto saved = desk_.take_saved();
  if (!saved) return;
  if (saved->outcome)
    uses_.messages.remark("Exported " + saved->file.string());
  else
    uses_.messages.problem(saved->outcome.error().message());
  if (!uses_.dialogs.figure.is_open()) desk_.end();
}

ImTextureID FigureFlow::texture() {
  const FigurePreview* const preview = desk_.preview();
  if (preview == nullptr) return nullptr;
  render::GlDevice& device = uses_.board.picture().device();
  if (!texture_ || textured_ != desk_.preview_number()) {
    forget_texture();
    texture_ = device.create_texture(preview->image.width, preview->image.height, preview->image.rgba, true);
    textured_ = desk_.preview_number();
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(device.name_of(*texture_)));
}

void FigureFlow::forget_texture() {
  if (texture_) uses_.board.picture().device().destroy_texture(*texture_);
  texture_.reset();
}

}  // namespace mes
