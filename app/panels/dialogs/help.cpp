// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/help.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/widgets/even_columns.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

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
  bool is_gesture = false;
};

struct Group {
  std::string_view title;
  std::vector<Line> lines;
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

std::vector<Group> groups_of(const Keymap& keymap) {
  std::vector<Group> out;
  for (const ActionGroup group : {ActionGroup::file, ActionGroup::tools, ActionGroup::edit, ActionGroup::view,
                                  ActionGroup::compute, ActionGroup::help})
    out.push_back({title_of(group), lines_of(keymap, group)});
  Group& gestures = out.emplace_back(Group{"With the mouse", {}});
  for (const GestureDescriptor& gesture : gesture_descriptors())
    gestures.lines.push_back({{gesture.input}, gesture.meaning, true});
  std::erase_if(out, [](const Group& group) { return group.lines.empty(); });
  return out;
}

/// Sizes on the sheet, in screen coordinates.
class SheetSizes {
 public:
  SheetSizes(const Gui& gui, float column) : unit_(gui.unit()), column_(column) {}

  float width_of(std::string_view key) const {
    return ImGui::CalcTextSize(key.data(), key.data() + key.size()).x + 10 * unit_;
  }
  float keys_of(const Line& line) const {
    float out = 0.0F;
    for (const std::string_view key : line.keys) out += width_of(key) + 4 * unit_;
    return out;
  }
  /// Where the texts of a group begin.
  float text_at(const Group& group) const {
    float out = 0.0F;
    for (const Line& line : group.lines) out = std::max(out, keys_of(line) + 8 * unit_);
    return out;
  }
  float cap() const { return ImGui::GetTextLineHeight() + 4 * unit_; }
  float gap() const { return 3 * unit_; }
  float heading() const { return ImGui::GetTextLineHeight() + 9 * unit_; }
  float height_of(const Line& line, float text_at) const {
    const float wrap = std::max(1.0F, column_ - (line.is_gesture ? 0.0F : text_at));
    const float text = ImGui::CalcTextSize(broken_lines(line.text, wrap).c_str()).y + 2 * unit_;
    return gap() + (line.is_gesture ? cap() + text : std::max(cap(), text));
  }
  float column() const { return column_; }

 private:
  float unit_;
  float column_;
};

void draw_part(const Gui& gui, const Group& group, const ColumnPart& part, const SheetSizes& sizes, ImVec2& at) {
  const float unit = gui.unit();
  ImGui::SetCursorScreenPos({at.x, at.y + 6 * unit});
  ImGui::PushFont(gui.bold());
  const std::string title = std::string(group.title) + (part.first == 0 ? "" : ", continued");
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  at.y += sizes.heading();
  const float text_at = sizes.text_at(group);
  for (std::size_t i = part.first; i < part.end; ++i) {
    const Line& line = group.lines[i];
    ImVec2 cap = at;
    for (const std::string_view key : line.keys) {
      ImGui::SetCursorScreenPos(cap);
      key_cap(gui, key);
      cap.x += sizes.width_of(key) + 4 * unit;
    }
    const ImVec2 text = line.is_gesture ? ImVec2(at.x, at.y + sizes.cap()) : ImVec2(at.x + text_at, at.y + 2 * unit);
    ImGui::SetCursorScreenPos(text);
    if (line.is_gesture) ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().text_quiet);
    paragraph(line.text, at.x + sizes.column() - text.x);
    if (line.is_gesture) ImGui::PopStyleColor();
    at.y += sizes.height_of(line, text_at);
  }
}

/// Draws the groups in reading order, in columns of about the same height.
void draw_columns(const Gui& gui, const Keymap& keymap, float width) {
  const float unit = gui.unit();
  const float gap = 18 * unit;
  constexpr float kColumnWidth = 285.0F;  // logical pixels; in narrower columns lines would break
  const auto columns = static_cast<std::size_t>(std::clamp(static_cast<int>(width / (kColumnWidth * unit)), 1, 4));
  const float column = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  const SheetSizes sizes(gui, column);
  const std::vector<Group> groups = groups_of(keymap);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  float bottom = corner.y;
  std::size_t number = 0;
  std::vector<std::vector<float>> heights;
  for (const Group& group : groups) {
    std::vector<float>& lines = heights.emplace_back();
    for (const Line& line : group.lines) lines.push_back(sizes.height_of(line, sizes.text_at(group)));
  }
  for (const std::vector<ColumnPart>& parts : even_columns(heights, sizes.heading(), columns)) {
    ImVec2 at(corner.x + static_cast<float>(number++) * (column + gap), corner.y);
    for (const ColumnPart& part : parts) draw_part(gui, groups[part.group], part, sizes, at);
    bottom = std::max(bottom, at.y);
  }
  ImGui::SetCursorScreenPos({corner.x, bottom});
}

void draw_foot(const Gui& gui, const std::string& keys_file) {
  if (keys_file.empty()) return;
  ImGui::Dummy({0, 8 * gui.unit()});
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().text_quiet);
  paragraph(
      fmt::format("Keys are set in {}. Help > Write or reread the file of keys creates it, with all commands. A "
                  "command without a key is found by its name with Help > Find anything.",
                  keys_file));
  ImGui::PopStyleColor();
}

}  // namespace

bool HelpPage::is_cancelled_by(const KeyChord& chord) const {
  return Dialog::is_cancelled_by(chord) || chord.symbol == key::enter ||
         keymap_->find(chord, false) == ActionId::help;
}

void HelpPage::draw(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float edge = 24 * unit;
  // As high as the page was in the last frame.
  const ImVec2 size(std::min(1240 * unit, screen.x - edge), std::min(height_ * unit, screen.y - edge));
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
    const float page = ImGui::GetCursorPosY();
    ImGui::EndChild();
    height_ = (ImGui::GetItemRectMin().y - ImGui::GetWindowPos().y + page + 16 * unit) / unit;
    const bool beside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                        !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    if (beside) is_open_ = false;
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace mes
