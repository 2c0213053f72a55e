// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/empty_view_note.h"

#include <algorithm>
#include <string>

#include "app/layers/empty_view.h"
#include "app/ui/widgets/paragraph.h"

namespace mes {

bool EmptyViewNote::draw(ImVec2 middle, float width) const {
  const EngineStatus status = engine.status();
  if (status.busy || status.cancelled || picture.document_revision() != editor.document().revision()) return false;
  const auto shows = [this](LayerIndex layer) {
    // A failed layer has its own message, and an unfinished one may still show something.
    if (picture.state(layer) != NodeState::up_to_date) return true;
    return std::ranges::any_of(layers.descriptor(layer).kinds,
                               [&](PrimitiveKind kind) { return picture.scene().instances(layer, kind) != 0; });
  };
  const auto empty = empty_view(editor.document(), layers, shows);
  if (!empty) return false;
  const float unit = gui.unit();
  const float wrap = std::min(380 * unit, width - 40 * unit);
  ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {16 * unit, 12 * unit});
  ImGui::Begin("##empty-view", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  paragraph(empty->text, wrap - ImGui::GetCursorPosX());
  ImGui::Dummy({0, 3 * unit});
  const std::string label = label_of(empty->offer);
  const bool is_wanted = ImGui::Button(label.c_str());
  ImGui::End();
  ImGui::PopStyleVar();
  if (is_wanted) editor.change_layers(label, [&] { show_instead(empty->offer, layers); });
  return true;
}

}  // namespace mes
