// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/help.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "app/ui/icons.h"
#include "app/ui/widgets.h"

namespace mes {
namespace {

void key_cap(const Gui& gui, std::string_view text) {
  const float unit = gui.unit();
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + size.x + 10 * unit, at.y + size.y + 4 * unit);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, end, gui.colors().field, 4 * unit);
  list.AddRect(at, end, gui.colors().border, 4 * unit);
  list.AddText({at.x + 5 * unit, at.y + 2 * unit}, gui.colors().text, text.data(), text.data() + text.size());
  ImGui::Dummy({end.x - at.x, end.y - at.y});
}

void heading(const Gui& gui, std::string_view text) {
  ImGui::Dummy({0, 3 * gui.unit()});
  ImGui::PushFont(gui.bold());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
}

/// Actions whose keys differ only by a number are listed in one line.
struct Series {
  ActionId first;
  ActionId last;
  std::string_view keys;
  std::string_view name;
};
constexpr std::array<Series, 3> kSeries{
    {{ActionId::first_nudge, nth(ActionId::first_nudge, kNudges / 2 - 1), "Arrow keys", "Nudge by a pixel"},
     {nth(ActionId::first_nudge, kNudges / 2), ActionId::last_nudge, "Shift+arrow keys", "Nudge by ten pixels"},
     {ActionId::first_bundle, ActionId::last_bundle, "1 to 9", "Show a bundle"}}};

bool has_keys_of_table(const Keymap& keymap, const Series& series) {
  for (auto id = series.first; id <= series.last; id = nth(id, 1))
    if (!std::ranges::equal(keymap.keys_of(id), descriptor_of(id).keys)) return false;
  return true;
}

struct Line {
  std::vector<std::string_view> keys;
  std::string_view text;
};

std::vector<Line> lines_of(const Keymap& keymap, ActionGroup group) {
  std::vector<Line> out;
  for (const ActionDescriptor& action : action_descriptors()) {
    const std::vector<std::string>& keys = keymap.keys_of(action.id);
    if (action.group != group || keys.empty()) continue;
    const auto series = std::ranges::find_if(
        kSeries, [&](const Series& one) { return one.first <= action.id && action.id <= one.last; });
    if (series == kSeries.end() || !has_keys_of_table(keymap, *series))
      out.push_back({{keys.begin(), keys.end()}, action.name});
    else if (series->first == action.id)
      out.push_back({{series->keys}, series->name});
  }
  return out;
}

void draw_group(const Gui& gui, const Keymap& keymap, ActionGroup group) {
  const float unit = gui.unit();
  const std::vector<Line> lines = lines_of(keymap, group);
  heading(gui, title_of(group));
  float text_at = 0.0F;
  for (const Line& line : lines) {
    float width = 0.0F;
    for (const std::string_view key : line.keys)
      width += ImGui::CalcTextSize(key.data(), key.data() + key.size()).x + 14 * unit;
    text_at = std::max(text_at, width + 8 * unit);
  }
  const float start = ImGui::GetCursorPosX();
  for (const Line& line : lines) {
    for (const std::string_view key : line.keys) {
      key_cap(gui, key);
      ImGui::SameLine(0, 4 * unit);
    }
    ImGui::SetCursorPos({start + text_at, ImGui::GetCursorPosY() + 2 * unit});
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(line.text.data(), line.text.data() + line.text.size());
    ImGui::PopTextWrapPos();
  }
}

void draw_gesture(const Gui& gui, const GestureDescriptor& gesture) {
  const float unit = gui.unit();
  key_cap(gui, gesture.input);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - 3 * unit);
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().text_quiet);
  ImGui::TextWrapped("%.*s", static_cast<int>(gesture.meaning.size()), gesture.meaning.data());
  ImGui::PopStyleColor();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 3 * unit);
}

/// Draws the groups in reading order, in columns of about the same height.
void draw_columns(const Gui& gui, const Keymap& keymap, float width) {
  constexpr std::array<ActionGroup, 6> kOrder{ActionGroup::file, ActionGroup::tools,   ActionGroup::edit,
                                              ActionGroup::view, ActionGroup::compute, ActionGroup::help};
  constexpr float kColumnWidth = 285.0F;  // logical pixels; in narrower columns lines would break
  const int columns = std::clamp(static_cast<int>(width / (kColumnWidth * gui.unit())), 1, 4);
  if (!ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) return;
  constexpr std::size_t kHeading = 2;
  constexpr std::size_t kGestureLines = 2;
  std::size_t left = kGestureLines * gesture_descriptors().size() + kHeading;
  for (const ActionGroup group : kOrder) left += lines_of(keymap, group).size() + kHeading;
  const std::size_t most = (left + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns);
  ImGui::TableNextColumn();
  std::size_t filled = 0;
  const auto next = [&](std::size_t lines) {
    // A group may exceed the column by less than it would otherwise leave empty.
    const bool is_better_below = filled + lines <= most || filled + lines - most < most - std::min(filled, most);
    if (filled > 0 && !is_better_below && ImGui::TableGetColumnIndex() + 1 < columns) {
      ImGui::TableNextColumn();
      filled = 0;
    }
    filled += lines;
  };
  for (const ActionGroup group : kOrder) {
    next(lines_of(keymap, group).size() + kHeading);
    draw_group(gui, keymap, group);
  }
  next(kHeading + kGestureLines);
  heading(gui, "With the mouse");
  for (const GestureDescriptor& gesture : gesture_descriptors()) {
    next(kGestureLines);
    draw_gesture(gui, gesture);
  }
  ImGui::EndTable();
}

void draw_foot(const Gui& gui, const std::string& keys_file) {
  if (keys_file.empty()) return;
  ImGui::Dummy({0, 8 * gui.unit()});
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().text_quiet);
  ImGui::TextWrapped(
      "Keys are set in %s. Help > Write or reread the file of keys creates it, with all commands. A command without "
      "a "
      "key is found by its name with Help > Find anything.",
      keys_file.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

bool HelpPage::is_cancelled_by(const KeyChord& chord) const {
  return Dialog::is_cancelled_by(chord) || keymap_->find(chord, false) == ActionId::help;
}

void HelpPage::draw(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(1240 * unit, screen.x - 24 * unit), std::min(680 * unit, screen.y - 24 * unit));
  ImGui::SetNextWindowPos({0.5F * (screen.x - size.x), 0.5F * (screen.y - size.y)});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {22 * unit, 16 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * unit, 3 * unit});
  if (Gui::begin_dialog("##help", is_open_, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove)) {
    ImGui::PushFont(gui.bold());
    ImGui::TextUnformatted("Keys and gestures");
    ImGui::PopFont();
    ImGui::SameLine(size.x - 48 * unit);
    if (icon_button("close", Icon::close, 24 * unit)) is_open_ = false;
    tooltip(gui, "Close (Esc)");
    ImGui::BeginChild("page");
    draw_columns(gui, *keymap_, ImGui::GetContentRegionAvail().x);
    draw_foot(gui, keys_file_);
    ImGui::EndChild();
    const bool beside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                        !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    if (beside) is_open_ = false;
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace mes
