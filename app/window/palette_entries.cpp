// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette_entries.h"

#include <fmt/core.h>
#include <algorithm>
#include <filesystem>

#include "app/actions/menus.h"
#include "app/layers/layer_topics.h"
#include "app/layers/words/parameter_words.h"
#include "app/layers/words/synonyms.h"
#include "app/panels/bars/interface_sizes.h"
#include "app/store/texts/layer_text.h"
#include "core/evolutions/evolution.h"

namespace mes {
namespace {

using Entries = std::vector<PaletteEntry>;

bool is_series(ActionId id) {
  return id >= ActionId::first_bundle && id <= ActionId::last_bundle;
}

// Some panels are in other menus, too.
constexpr std::string_view kPanelMenu = "View > Panels";

void add_actions(const Panels::Uses& uses, std::span<const SidePage> panels, Entries& out) {
  const ActionBindings& actions = uses.actions;
  for (const ActionDescriptor& action : action_descriptors()) {
    // Bundles are listed below by their own names; the palette itself is already open.
    if (!actions.is_bound(action.id) || is_series(action.id) || action.id == ActionId::command_palette) continue;
    const bool is_panel = std::ranges::count(panels, action.id, &SidePage::toggle) != 0;
    out.push_back({.kind = is_panel ? "Panel" : std::string(title_of(action.group)),
                   .name = action.name,
                   .key = actions.keymap().key_of(action.id),
                   .explanation = action.tooltip,
                   .more = action.public_id,
                   .words = synonyms_of(action.public_id),
                   .place = std::string(is_panel ? kPanelMenu : menu_of(action.id)),
                   .is_enabled = actions.is_enabled(action.id),
                   .missing = actions.missing(action.id),
                   .is_checked = actions.is_checked(action.id),
                   .run = [&actions, id = action.id] { actions.run(id); }});
  }
}

void add_bundles(const Panels::Uses& uses, Entries& out) {
  const WindowBundles& bundles = uses.work.bundles();
  for (std::size_t i = 0; i < bundles.bundles().size(); ++i) {
    const Bundle& bundle = bundles.bundles()[i];
    out.push_back({.kind = "Bundle",
                   .name = bundle.name,
                   .key = i < kNumberedBundles ? uses.actions.keymap().key_of(nth(ActionId::first_bundle, i)) : "",
                   .explanation = bundle.description,
                   .is_checked = bundles.current() == i,
                   .run = [&work = uses.work, i, name = bundle.name] {
                     if (i < work.bundles().bundles().size() && work.bundles().bundles()[i].name == name)
                       work.choose_bundle(i);
                   }});
  }
}

void add_lessons(const Panels::Uses& uses, Entries& out) {
  for (const ShippedLesson& lesson : uses.documents.lessons())
    out.push_back({.kind = "Lesson",
                   .name = lesson.title,
                   .explanation = "Open this lesson and present it",
                   .run = [&flow = uses.documents, lesson] { flow.open_lesson(lesson); }});
}

void add_layers(const Panels::Uses& uses, Entries& out) {
  // Layers of the family in use come before those that show the same for other families.
  constexpr double kLessThanFamily = -5.0;
  LayerStack& layers = uses.work.layers();
  const auto is_in_use = [&](FamilyKind family) {
    return uses.actions.is_checked(nth(ActionId::balls_inner, static_cast<std::size_t>(family)));
  };
  for (LayerIndex layer = 0; layer < layers.size(); ++layer) {
    const LayerDescriptor& descriptor = layers.descriptor(layer);
    if (descriptor.is_removed) continue;
    const auto family = family_of(descriptor);
    out.push_back({.kind = "Layer",
                   .name = std::string(descriptor.name),
                   .explanation = with_titles(descriptor.tooltip),
                   .more = std::string(descriptor.id) + ' ' + std::string(title_of(descriptor.group)),
                   .words = synonyms_of(descriptor.id),
                   .place = fmt::format("Layers > {}", layer_topics()[topic_place_of(descriptor).topic].title),
                   .handicap = family && !is_in_use(*family) ? kLessThanFamily : 0.0,
                   .is_checked = layers.is_visible(layer),
                   .run = [&layers, &messages = uses.messages, layer, show = uses.show_layer] {
                     layers.set_visible(layer, !layers.is_visible(layer));
                     if (!layers.is_visible(layer))
                       messages.remark(std::string(layers.descriptor(layer).name) + " is hidden now");
                     show(layer);
                   }});
  }
}

// The style of a layer is behind its swatch, which has no action of its own.
void add_styles(const Panels::Uses& uses, Entries& out) {
  out.push_back(
      {.kind = "Layers",
       .name = "Colours and widths of layers",
       .explanation = "Click the swatch in the row of a layer; viridis and cividis suit colour-blind readers",
       .words = "style styles colour color line thickness opacity dots map maps palette blind safe colorblind "
                "colourblind viridis cividis",
       .place = "Layers > swatch of a layer",
       .run = uses.show_swatches});
}

void add_parameters(const Panels::Uses& uses, Entries& out) {
  for (const Parameter& parameter : uses.work.computation().parameters()) {
    out.push_back({.kind = "Parameter",
                   .name = title_of(parameter),
                   .explanation = spoken_explanation(parameter),
                   .more = parameter.id,
                   .words = synonyms_of(parameter.id),
                   .place = "Parameters",
                   .run = [show = uses.show_parameter, name = title_of(parameter)] { show(name); }});
  }
}

void add_evolutions(const Panels::Uses& uses, Entries& out) {
  for (const auto& evolution : uses.work.evolution().evolutions()) {
    out.push_back({.kind = "Evolution",
                   .name = evolution->descriptor.name,
                   .explanation = with_titles(evolution->descriptor.tooltip),
                   .more = evolution->descriptor.id,
                   .words = synonyms_of(evolution->descriptor.id),
                   .is_checked = uses.work.evolution().choice().evolution == evolution,
                   .run = [&work = uses.work, &settings = uses.settings, evolution] {
                     settings.show_evolution = true;
                     work.evolution().choose(evolution);
                   }});
  }
}

void add_files(const Panels::Uses& uses, Entries& out) {
  for (const SampleShape& shape : uses.documents.shapes())
    out.push_back({.kind = "Shape",
                   .name = shape.name,
                   .explanation = shape.description,
                   .run = [&documents = uses.documents, &shape] { documents.open_shape(shape); }});
  for (const std::string& file : uses.settings.recent_files)
    out.push_back({.kind = "Recent file",
                   .name = std::filesystem::path(file).filename().string(),
                   .explanation = file,
                   .more = file,
                   .run = [&documents = uses.documents, file] { documents.open({file}); }});
}

void add_sizes(const Panels::Uses& uses, Entries& out) {
  for (const int percent : kInterfacePercents)
    out.push_back({.kind = "View",
                   .name = fmt::format("Interface size {} %", percent),
                   .explanation = "Draw the panels and their text at this size",
                   .words = "font text larger smaller scale zoom hidpi",
                   .place = "View > Interface size",
                   .is_checked = has_interface_size(uses.settings, percent),
                   .run = [&settings = uses.settings, percent] { settings.interface_scale = percent / 100.0; }});
}

void add_geometry(const Panels::Uses& uses, Entries& out) {
  for (const LayerTextFormat& format : layer_text_formats()) {
    if (!format.is_of_many) continue;
    out.push_back({.kind = "File",
                   .name = fmt::format("Export geometry: {}", format.title),
                   .explanation = fmt::format("All visible layers: {}", format.help),
                   .words = "save write gis map cad coordinates",
                   .place = "File > Export geometry",
                   .run = [&flow = uses.documents, &layers = uses.work.layers(), &format] {
                     flow.figures().ask_geometry(layers.visible_layers(), format);
                   }});
  }
}

void add_manual(const Panels::Uses& uses, Entries& out) {
  // Words to read come after things that can be done and have about the same name.
  constexpr double kLessThanCommands = -10.0;
  for (const ManualHeading& heading : uses.manual.headings())
    out.push_back({.kind = "Manual",
                   .name = heading.name,
                   .explanation = "Read this in the manual",
                   .more = heading.section,
                   .place = heading.section,
                   .handicap = kLessThanCommands,
                   .run = [&manual = uses.manual, section = heading.section, name = heading.name] {
                     manual.open_at(section, name);
                   }});
}

}  // namespace

std::vector<PaletteEntry> palette_entries(const Panels::Uses& uses, std::span<const SidePage> panels) {
  Entries out;
  add_actions(uses, panels, out);
  add_bundles(uses, out);
  add_lessons(uses, out);
  add_layers(uses, out);
  add_styles(uses, out);
  add_parameters(uses, out);
  add_evolutions(uses, out);
  add_sizes(uses, out);
  add_geometry(uses, out);
  add_files(uses, out);
  add_manual(uses, out);
  return out;
}

}  // namespace mes
