// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/layers/bundles_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr const char* kBundleDragKind = "mesecina-bundle";
constexpr std::size_t kDigits = 9;
constexpr float kRowHeight = 24.0F;

void menu_item(const Gui& gui, const ActionBindings& actions, ActionId id) {
  const ActionDescriptor& action = descriptor_of(id);
  const std::string name(action.name);
  const std::string key = actions.keymap().key_of(id);
  if (ImGui::MenuItem(name.c_str(), key.c_str(), false, actions.is_enabled(id))) actions.run(id);
  tooltip(gui, std::string(action.tooltip));
}

// Opens the next popup beside the panel, whether a key or a click asked for it.
void place_beside_panel(const Gui& gui) {
  const ImVec2 panel = ImGui::GetWindowPos();
  const float gap = 8 * gui.unit();
  ImGui::SetNextWindowPos({panel.x - gap, panel.y + gap}, ImGuiCond_Appearing, {1.0F, 0.0F});
}

bool begin_roomy_popup(const Gui& gui, const char* id) {
  const float unit = gui.unit();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * unit, 7 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * unit, 10 * unit});
  const bool is_open = begin_popup(gui, id);
  if (!is_open) ImGui::PopStyleVar(2);
  return is_open;
}

void close_on_escape() {
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
}

void end_roomy_popup() {
  ImGui::EndPopup();
  ImGui::PopStyleVar(2);
}

/// Draws a name field and a button with a verb. Returns true when the user confirms.
bool draw_name_field(const Gui& gui, NameField& field, std::string& name, const char* verb) {
  const float unit = gui.unit();
  ImGui::SetNextItemWidth(200 * unit);
  if (ImGui::IsWindowAppearing()) field.focus();
  const bool entered = field.draw("##name", "Name", name);
  ImGui::SameLine();
  const bool is_good = checked_bundle_name(name).has_value();
  ImGui::BeginDisabled(!is_good);
  const bool pressed = default_button(gui, verb, {90 * unit, 0}, true);
  ImGui::EndDisabled();
  close_on_escape();
  return is_good && (entered || pressed);
}

}  // namespace

void BundlesPanel::tell(const Expected<void>& done) const {
  if (!done)
    uses_.messages.problem(done.error().message());
  else if (const std::string what = uses_.bundles.undo_offer(); !what.empty())
    uses_.messages.remark(what);
  if (const std::string message = uses_.bundles.take_message(); !message.empty()) uses_.messages.problem(message);
}

void BundlesPanel::draw_head() {
  const float unit = uses_.gui.unit();
  if (ImGui::Button("Save as...")) asks_name_ = true;
  tooltip(uses_.gui, uses_.actions.tooltip_of(ActionId::save_bundle));
  ImGui::SameLine(0, 4 * unit);
  if (ImGui::Button("More...")) ImGui::OpenPopup("bundles-menu");
  tooltip(uses_.gui, "Import, export and restore bundles");
  draw_menu();
  draw_save_popup();
}

void BundlesPanel::draw_menu() {
  if (!begin_roomy_popup(uses_.gui, "bundles-menu")) return;
  menu_item(uses_.gui, uses_.actions, ActionId::import_bundles);
  menu_item(uses_.gui, uses_.actions, ActionId::export_bundles);
  ImGui::Separator();
  if (ImGui::MenuItem("Add the starting set")) tell(uses_.bundles.add_starting_set());
  tooltip(uses_.gui, "Append the bundles that come with the program and are missing");
  menu_item(uses_.gui, uses_.actions, ActionId::undo_bundles);
  close_on_escape();
  end_roomy_popup();
}

void BundlesPanel::draw_save_popup() {
  if (std::exchange(asks_name_, false)) {
    name_.clear();
    ImGui::OpenPopup("save-bundle");
  }
  place_beside_panel(uses_.gui);
  if (!begin_roomy_popup(uses_.gui, "save-bundle")) return;
  ImGui::TextUnformatted("Save the layers as they are under a name");
  const auto checked = checked_bundle_name(name_);
  const bool is_taken = checked && uses_.bundles.has(*checked);
  const bool is_meant = draw_name_field(uses_.gui, field_, name_, is_taken ? "Overwrite" : "Save");
  ImGui::PushStyleColor(ImGuiCol_Text, uses_.gui.colors().warning);
  ImGui::TextUnformatted(is_taken ? "A bundle of this name exists" : " ");
  ImGui::PopStyleColor();
  if (is_meant) {
    tell(uses_.bundles.save(name_));
    ImGui::CloseCurrentPopup();
  }
  end_roomy_popup();
}

void BundlesPanel::draw_context_menu(std::size_t index) {
  const float unit = uses_.gui.unit();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * unit, 7 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * unit, 10 * unit});
  if (begin_context_popup(uses_.gui, "menu")) {
    if (ImGui::MenuItem("Rename...")) asks_rename_ = index;
    if (ImGui::BeginMenu("Overwrite")) {
      ImGui::TextDisabled("With the layers as they are now?");
      if (ImGui::MenuItem("Yes, overwrite")) tell(uses_.bundles.save(uses_.bundles.bundles()[index].name));
      ImGui::EndMenu();
    }
    if (ImGui::MenuItem("Export...")) uses_.export_one(index);
    ImGui::Separator();
    if (ImGui::MenuItem("Delete")) tell(uses_.bundles.remove(index));
    close_on_escape();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

void BundlesPanel::draw_rename_popup() {
  const auto bundles = uses_.bundles.bundles();
  if (asks_rename_ && *asks_rename_ < bundles.size()) {
    renamed_ = *asks_rename_;
    name_ = bundles[renamed_].name;
    ImGui::OpenPopup("rename-bundle");
  }
  asks_rename_.reset();
  place_beside_panel(uses_.gui);
  if (!begin_roomy_popup(uses_.gui, "rename-bundle")) return;
  ImGui::TextUnformatted("Rename the bundle");
  if (renamed_ < bundles.size() && draw_name_field(uses_.gui, field_, name_, "Rename")) {
    tell(uses_.bundles.rename(renamed_, name_));
    ImGui::CloseCurrentPopup();
  }
  end_roomy_popup();
}

void BundlesPanel::draw_row(std::size_t index) {
  const float unit = uses_.gui.unit();
  const float height = kRowHeight * unit;
  const std::string name = uses_.bundles.bundles()[index].name;
  const std::string description = uses_.bundles.bundles()[index].description;
  const bool is_current = uses_.bundles.current() == index;
  const bool is_changed = is_current && uses_.bundles.is_changed();
  ImGui::PushID(static_cast<int>(index));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + ImGui::GetContentRegionAvail().x, at.y + height);
  const bool clicked = hit_area("row", {end.x - at.x, height});
  const bool hovered = ImGui::IsItemHovered();
  std::string explanation = name;
  if (index < kDigits) explanation += fmt::format(" ({})", index + 1);
  if (!description.empty()) explanation += "\n" + description;
  if (is_changed) explanation += "\n\nThe layers have changed since; click to restore them as saved";
  tooltip(uses_.gui, explanation + "\n\nDrag to reorder, right click for more");
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(kBundleDragKind, &index, sizeof index);
    ImGui::TextUnformatted(name.c_str());
    ImGui::EndDragDropSource();
  }
  std::optional<std::size_t> dropped;
  if (ImGui::BeginDragDropTarget()) {
    const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(
        kBundleDragKind, ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
    if (payload != nullptr) {
      const std::size_t from = *static_cast<const std::size_t*>(payload->Data);
      const float y = from < index ? end.y : at.y;
      list.AddLine({at.x, y}, {end.x, y}, uses_.gui.colors().accent, 2 * unit);
      if (payload->IsDelivery() && from < uses_.bundles.bundles().size()) dropped = from;
    }
    ImGui::EndDragDropTarget();
  }

  if (is_current || hovered)
    list.AddRectFilled(at, end, is_current ? uses_.gui.colors().accent_soft : uses_.gui.colors().accent_faint,
                       4 * unit);
  const float text_y = at.y + 0.5F * (height - ImGui::GetFontSize());
  if (index < kDigits)
    list.AddText({at.x + 5 * unit, text_y}, is_current ? uses_.gui.colors().accent : uses_.gui.colors().text_quiet,
                 std::to_string(index + 1).c_str());
  list.PushClipRect(at, {end.x - 14 * unit, end.y}, true);
  list.AddText({at.x + 22 * unit, text_y}, is_current ? uses_.gui.colors().accent : uses_.gui.colors().text,
               name.c_str());
  list.PopClipRect();
  if (is_changed) list.AddCircleFilled({end.x - 8 * unit, at.y + 0.5F * height}, 3 * unit, uses_.gui.colors().accent);
  if (is_current && shown_current_ != index) ImGui::SetScrollHereY();
  // The list is changed last, because the rows drawn so far show the old one.
  if (clicked) uses_.choose(index);
  if (dropped) tell(uses_.bundles.move(*dropped, index));
  draw_context_menu(index);
  ImGui::PopID();
}

void BundlesPanel::draw_rows(float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  if (ImGui::BeginChild("rows", {0, height})) {
    for (std::size_t index = 0; index < uses_.bundles.bundles().size(); ++index) draw_row(index);
    shown_current_ = uses_.bundles.current();
    if (uses_.bundles.bundles().empty()) ImGui::TextDisabled("None yet: a bundle keeps the layers as they are");
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void BundlesPanel::draw_undo_line() const {
  ImGui::PushFont(uses_.gui.small());
  const std::string offer = uses_.bundles.undo_offer();
  const ImGuiStyle& style = ImGui::GetStyle();
  // A long name must not push the button out of the panel.
  const float button = ImGui::CalcTextSize("Undo").x + 2 * style.FramePadding.x + style.ItemSpacing.x;
  const float width = std::min(ImGui::CalcTextSize(offer.c_str()).x, ImGui::GetContentRegionAvail().x - button);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec4 clip(at.x, at.y, at.x + width, at.y + ImGui::GetFontSize());
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, uses_.gui.colors().text_quiet,
                                      offer.c_str(), nullptr, 0.0F, &clip);
  ImGui::Dummy({std::max(1.0F, width), ImGui::GetFontSize()});
  tooltip(uses_.gui, offer);
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button, 0U);
  ImGui::PushStyleColor(ImGuiCol_Text, uses_.gui.colors().accent);
  const bool clicked = ImGui::SmallButton("Undo");
  ImGui::PopStyleColor(2);
  ImGui::PopFont();
  tooltip(uses_.gui, std::string(descriptor_of(ActionId::undo_bundles).tooltip));
  if (clicked) tell(uses_.bundles.undo());
}

void BundlesPanel::draw() {
  draw_head();
  const bool offers_undo = !uses_.bundles.undo_offer().empty();
  const float line = offers_undo ? kRowHeight * uses_.gui.unit() : 0.0F;
  draw_rows(std::max(1.0F, ImGui::GetContentRegionAvail().y - line));
  if (offers_undo) draw_undo_line();
  draw_rename_popup();
}

}  // namespace mes
