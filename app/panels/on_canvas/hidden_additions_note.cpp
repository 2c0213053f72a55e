// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/hidden_additions_note.h"

#include <fmt/core.h>
#include <algorithm>

#include "app/editing/selection.h"
#include "app/layers/ball_families.h"
#include "app/layers/empty_view.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"

namespace mes {
namespace {

std::string words_of(AddedKind kind, std::size_t count) {
  switch (kind) {
    case AddedKind::samples: return counted(count, 0) + " added; the layer Points is hidden";
    case AddedKind::balls: return counted(0, count) + " added; the layers of your own balls are hidden";
    case AddedKind::annotations: break;
  }
  return counted(count, "annotation") + " added; annotations are hidden";
}

std::string show_label_of(AddedKind kind) {
  switch (kind) {
    case AddedKind::samples: return label_of(ShowInstead::samples);
    case AddedKind::balls: return "Show my own balls";
    case AddedKind::annotations: break;
  }
  return "Show annotations";
}

}  // namespace

std::size_t HiddenAdditionsNote::count(AddedKind kind) const {
  return kind == AddedKind::annotations && shows_annotations ? 0 : hidden.count(kind);
}

void HiddenAdditionsNote::show(AddedKind kind) const {
  if (kind == AddedKind::annotations) {
    show_annotations = true;
    return;
  }
  editor.change_layers(show_label_of(kind), [&] {
    if (kind == AddedKind::samples) return show_instead(ShowInstead::samples, layers);
    for (const std::string_view id : kOwnBallLayers)
      if (const LayerIndex layer = layers.find(id); layer != kNoLayer) layers.set_visible(layer, true);
  });
}

void HiddenAdditionsNote::draw_row(AddedKind kind) const {
  const float unit = gui.unit();
  ImGui::PushID(static_cast<int>(kind));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words_of(kind, count(kind)).c_str());
  ImGui::SameLine(0, 10 * unit);
  if (ImGui::Button(show_label_of(kind).c_str())) show(kind);
  ImGui::SameLine(0, 6 * unit);
  if (icon_button("close", Icon::close, ImGui::GetFrameHeight())) hidden.dismiss(kind);
  tooltip(gui, "Close until such elements have been shown");
  ImGui::PopID();
}

bool HiddenAdditionsNote::close() const {
  bool out = false;
  for (const AddedKind kind : kAddedKinds) {
    if (count(kind) == 0) continue;
    hidden.dismiss(kind);
    out = true;
  }
  return out;
}

void HiddenAdditionsNote::draw(ImVec2 top) const {
  if (std::ranges::all_of(kAddedKinds, [this](AddedKind kind) { return count(kind) == 0; })) return;
  const float unit = gui.unit();
  ImGui::SetNextWindowPos(top, ImGuiCond_Always, {0.5F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 6 * unit});
  ImGui::Begin("##hidden-additions", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  for (const AddedKind kind : kAddedKinds)
    if (count(kind) != 0) draw_row(kind);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace mes
