// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels.h"

#include <algorithm>

#include "app/panels/canvas_legend.h"
#include "app/panels/empty_hint.h"
#include "app/panels/evolution_strip.h"
#include "app/panels/problem_note.h"

namespace mes {
namespace {

constexpr float kMostOfBundles = 0.35F;   // of the height that bundles and layers share
constexpr float kLeastOfBundles = 62.0F;  // logical pixels: the head and a row
constexpr float kLeastOfLayers = 190.0F;
constexpr float kColumnWidth = 286.0F;
constexpr float kMargin = 10.0F;

}  // namespace

Panels::Panels(const Uses& uses)
    : uses_(uses),
      menu_bar_{uses.screen.gui,
                uses.actions,
                uses.settings,
                uses.work.editor(),
                uses.work.layers(),
                uses.work.evolution(),
                uses.documents.shapes(),
                [&flow = uses.documents](const std::string& file) { flow.open({file}); },
                [&flow = uses.documents](const SampleShape& shape) { flow.open_shape(shape); }},
      status_bar_{uses.screen.gui,
                  uses.work.editor(),
                  uses.board.canvas(),
                  uses.board.picture(),
                  uses.work.computation(),
                  uses.messages,
                  {uses.screen.gui, uses.actions, uses.work.engine(), uses.documents.files(), uses.recording.desk()},
                  {uses.screen.gui, uses.actions, uses.work.document(), uses.work.computation().settings(),
                   uses.board.picture(), uses.board.canvas()}},
      toolbar_{uses.screen.gui,
               uses.actions,
               uses.board.canvas(),
               uses.settings,
               {uses.screen.gui, uses.actions, uses.recording.desk(), uses.board.picture(), uses.settings.record}},
      bundles_panel_({uses.screen.gui, uses.actions, uses.work.bundles(), uses.work.editor(), uses.messages,
                      uses.settings.show_bundles,
                      [&flow = uses.documents](std::size_t bundle) { flow.ask_export(bundle); }}),
      layers_panel_(uses.screen.gui, uses.work.layers(), uses.board.picture(),
                    {uses.screen.gui, uses.actions, uses.work.layers(), uses.board.picture(), uses.board.canvas()}),
      details_panel_(uses.screen.gui, uses.settings.details,
                     {uses.screen.gui, uses.board.picture(), uses.screen.times},
                     {uses.screen.gui, uses.work.computation()}, {uses.screen.gui, uses.messages}) {}

void Panels::bind(ActionBindings& actions) {
  bind_shown(actions);
  bind_look(actions);
}

void Panels::bind_shown(ActionBindings& actions) {
  Settings& settings = uses_.settings;
  const auto bind_toggle = [&](ActionId id, bool& value) {
    actions.bind(id, {[&value] { value = !value; }, {}, [&value] { return value; }});
  };
  bind_toggle(ActionId::toggle_evolution, settings.show_evolution);
  bind_toggle(ActionId::toggle_panels, are_shown_);
  bind_toggle(ActionId::toggle_layers, settings.show_layers);
  bind_toggle(ActionId::toggle_legend, settings.show_legend);
  const auto bind_page = [&](ActionId id, DetailsPage page) {
    actions.bind(id, {[&settings, page] { settings.details = settings.details == page ? DetailsPage::none : page; },
                      {},
                      [&settings, page] { return settings.details == page; }});
  };
  bind_page(ActionId::toggle_statistics, DetailsPage::statistics);
  bind_page(ActionId::toggle_parameters, DetailsPage::parameters);
  bind_page(ActionId::toggle_log, DetailsPage::log);
  actions.bind(ActionId::save_bundle, {[this, &settings] {
                 are_shown_ = true;
                 settings.show_layers = true;
                 bundles_panel_.ask_name();
               }});
}

void Panels::bind_look(ActionBindings& actions) {
  Settings& settings = uses_.settings;
  actions.bind(ActionId::projector_mode, {[&settings] { settings.for_projector = !settings.for_projector; },
                                          {},
                                          [&settings] { return settings.for_projector; }});
  actions.bind(ActionId::toggle_theme,
               {[&settings] { settings.theme = settings.theme == Theme::dark ? Theme::light : Theme::dark; },
                {},
                [&settings] { return settings.theme == Theme::dark; }});
}

Panels::Room Panels::draw() {
  Sides sides = are_shown_ ? draw_around() : Sides{};
  draw_over(sides);
  const ImVec2 legend = uses_.settings.show_legend ? draw_legend(sides) : ImVec2{};
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float unit = uses_.screen.gui.unit();
  const float width = screen.x - sides.left - sides.right;
  const ImVec2 middle(sides.left + 0.5F * width, sides.top + 0.5F * (screen.y - sides.top - sides.bottom));
  const Gui& gui = uses_.screen.gui;
  EmptyHint{gui, uses_.work.document(), uses_.documents.files(), uses_.board.picture(), uses_.board.canvas()}.draw(
      middle);
  uses_.demo.draw(gui, {middle.x, screen.y - sides.bottom}, width);
  ProblemNote{gui, uses_.messages}.draw({sides.left + 8 * unit, sides.top + 10 * unit}, width - 16 * unit);
  const double ratio = uses_.screen.window->pixel_ratio();
  const auto in_pixels = [ratio](float length) { return static_cast<double>(length) * ratio; };
  return {{in_pixels(sides.left), in_pixels(sides.top), in_pixels(sides.right), in_pixels(sides.bottom)},
          {in_pixels(legend.x), in_pixels(legend.y)}};
}

// Above, below, on the right and on the left.
Panels::Sides Panels::draw_around() {
  const float unit = uses_.screen.gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  Sides out;
  out.top = menu_bar_.draw();
  out.bottom = status_bar_.height();
  status_bar_.draw({{0, screen.y - out.bottom}, {screen.x, out.bottom}});
  const float height = screen.y - out.top - out.bottom;
  out.right = draw_column(out.top, height);
  const float margin = kMargin * unit;
  out.left = margin + toolbar_.draw({margin, out.top + margin}, height - 2 * margin);
  return out;
}

// Bundles, layers and details; its width.
float Panels::draw_column(float top, float height) {
  const float unit = uses_.screen.gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(kColumnWidth * unit, 0.45F * screen.x);
  const float left = screen.x - width;
  const bool has_layers = uses_.settings.show_layers;
  const bool has_details = uses_.settings.details != DetailsPage::none;
  const float upper = !has_layers ? 0.0F : has_details ? 0.6F * height : height;
  if (has_layers) {
    // In a low window the layers need the room, and bundles have their keys and their menu.
    const float most = std::min(kMostOfBundles * upper, upper - kLeastOfLayers * unit);
    const float bundles = most < kLeastOfBundles * unit ? 0.0F : bundles_panel_.height(most);
    if (bundles > 0.0F) bundles_panel_.draw({{left, top}, {width, bundles}});
    layers_panel_.draw({{left, top + bundles}, {width, upper - bundles}});
  }
  if (has_details) details_panel_.draw({{left, top + upper}, {width, height - upper}});
  return has_layers || has_details ? width : 0.0F;
}

// The strip of evolutions, which takes room, and what was clicked, which takes none.
void Panels::draw_over(Sides& sides) {
  const Gui& gui = uses_.screen.gui;
  const float margin = kMargin * gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = screen.x - sides.left - sides.right - 2 * margin;
  const auto corner = [&] { return ImVec2(sides.left + margin, screen.y - sides.bottom - margin); };
  if (are_shown_ && uses_.settings.show_evolution)
    sides.bottom += margin + EvolutionStrip{gui, uses_.actions, uses_.work.evolution()}.draw(corner(), width);
  uses_.board.provenance().draw(gui, uses_.board.canvas(), uses_.work.document().revision(), corner(),
                                {width, 0.6F * (screen.y - sides.top - sides.bottom)});
}

// Its size with its margin.
ImVec2 Panels::draw_legend(const Sides& sides) {
  const Gui& gui = uses_.screen.gui;
  const float margin = kMargin * gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size = CanvasLegend{gui, uses_.board.picture(), uses_.work.layers()}.draw(
      {screen.x - sides.right - margin, screen.y - sides.bottom - margin},
      screen.y - sides.top - sides.bottom - 2 * margin);
  return size.x > 0.0F ? ImVec2(size.x + margin, size.y + margin) : ImVec2();
}

}  // namespace mes
