// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/command_palette.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr float kPaletteWidth = 620.0F;  // logical pixels
constexpr float kRow = 28.0F;
constexpr float kMostRows = 13.0F;
constexpr float kKindWidth = 92.0F;
constexpr float kPalettePadding = 10.0F;
constexpr float kPaletteEdge = 10.0F;  // between the palette and the lower edge of the window
constexpr float kFieldPadding = 7.0F;
constexpr float kFootLines = 3.0F;

float foot_height(const Gui& gui) {
  ImGui::PushFont(gui.small());
  const float line = ImGui::GetTextLineHeight();
  ImGui::PopFont();
  return kFootLines * line;
}

// Matching letters are bold and in the accent colour. A name that does not fit before `end` ends in dots.
void draw_action_name(const Gui& gui, const PaletteEntry& entry, const std::vector<std::size_t>& letters, ImVec2 at,
                      float end, ImU32 color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string& name = entry.name;
  const float dots = ImGui::CalcTextSize("\u2026").x;
  std::size_t from = 0;
  while (from < name.size()) {
    const bool is_match = std::ranges::binary_search(letters, from);
    // Continuation bytes belong to the letter before them.
    std::size_t to = from + 1;
    while (to < name.size() && ((static_cast<unsigned char>(name[to]) & 0xC0U) == 0x80U ||
                                std::ranges::binary_search(letters, to) == is_match))
      ++to;
    ImFont* const font = is_match ? gui.bold() : ImGui::GetFont();
    const ImU32 ink = is_match && entry.is_enabled ? gui.colors().accent : color;
    const std::string run = name.substr(from, to - from);
    const float width = font->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, run.c_str()).x;
    if (at.x + width > end && at.x + width + (to < name.size() ? dots : 0.0F) > end) {
      list.AddText(at, ink, elided(run, end - at.x).c_str());
      return;
    }
    list.AddText(font, ImGui::GetFontSize(), at, ink, run.c_str());
    at.x += width;
    from = to;
  }
}

}  // namespace

void CommandPalette::toggle() {
  is_open_ = !is_open_;
  if (!is_open_ || !source_) return;
  query_.clear();
  list_.set_query({});
  list_.set_entries(source_());
  field_.focus();
  is_accepted_ = false;
  follows_mark_ = true;
}

void CommandPalette::press(const KeyChord& chord) {
  constexpr int kPage = 10;
  const bool is_back = chord.modifiers.shift;
  switch (chord.symbol) {
    case key::down: list_.move(1); break;
    case key::up: list_.move(-1); break;
    case key::tab: list_.move(is_back ? -1 : 1); break;
    case key::page_down: list_.move(kPage); break;
    case key::page_up: list_.move(-kPage); break;
    case key::enter: is_accepted_ = true; return;
    default: return;
  }
  follows_mark_ = true;
}

void CommandPalette::draw_field(const Gui& gui) {
  ImGui::SetNextItemWidth(-1);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {10 * gui.unit(), kFieldPadding * gui.unit()});
  if (field_.draw("##query", "Some letters of a command, layer, bundle, parameter, heading...", query_))
    is_accepted_ = true;
  ImGui::PopStyleVar();
  if (query_ == list_.query()) return;
  list_.set_query(query_);
  follows_mark_ = true;
}

bool CommandPalette::draw_row(const Gui& gui, std::size_t row) {
  const float unit = gui.unit();
  const ThemeColors& colors = gui.colors();
  const PaletteHit& hit = list_.hits()[row];
  const PaletteEntry& entry = list_.entries()[hit.entry];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = kRow * unit;
  ImGui::PushID(static_cast<int>(row));
  const bool is_clicked = hit_area("row", {width, height});
  ImGui::PopID();
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (ImGui::IsItemHovered() && (moved.x != 0.0F || moved.y != 0.0F)) list_.mark(row);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (row == list_.marked()) list.AddRectFilled(at, {at.x + width, at.y + height}, colors.accent_soft, 4 * unit);
  const float text_y = at.y + 0.5F * (height - ImGui::GetFontSize());
  const ImU32 color = entry.is_enabled ? colors.text : colors.text_faint;
  ImGui::PushFont(gui.small());
  list.AddText({at.x + 8 * unit, at.y + 0.5F * (height - ImGui::GetFontSize())}, colors.text_quiet,
               entry.kind.c_str());
  ImGui::PopFont();
  float end = at.x + width - 8 * unit;
  if (!entry.key.empty()) {
    const ImVec2 size = ImGui::CalcTextSize(entry.key.c_str());
    const ImVec2 cap(end - size.x - 10 * unit, text_y - 2 * unit);
    list.AddRectFilled(cap, {end, cap.y + size.y + 4 * unit}, colors.field, 4 * unit);
    list.AddRect(cap, {end, cap.y + size.y + 4 * unit}, colors.border, 4 * unit);
    list.AddText({cap.x + 5 * unit, text_y}, colors.text_quiet, entry.key.c_str());
    end = cap.x - 10 * unit;
  }
  if (entry.is_checked) {
    const ImVec2 middle(end - 6 * unit, at.y + 0.5F * height);
    const float r = 4 * unit;
    list.AddLine({middle.x - r, middle.y}, {middle.x - 0.3F * r, middle.y + 0.7F * r}, colors.accent, 2 * unit);
    list.AddLine({middle.x - 0.3F * r, middle.y + 0.7F * r}, {middle.x + r, middle.y - 0.8F * r}, colors.accent,
                 2 * unit);
    end -= 20 * unit;
  }
  const float name_at = at.x + kKindWidth * unit;
  const float name_end =
      name_at + gui.bold()->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0.0F, entry.name.c_str()).x;
  // The name needs the room first.
  ImGui::PushFont(gui.small());
  const float place = ImGui::CalcTextSize(entry.place.c_str()).x;
  if (!entry.place.empty() && name_end + 12 * unit + place <= end) {
    end -= place;
    list.AddText({end, at.y + 0.5F * (height - ImGui::GetFontSize())}, colors.text_quiet, entry.place.c_str());
    end -= 12 * unit;
  }
  ImGui::PopFont();
  draw_action_name(gui, entry, hit.letters, {name_at, text_y}, end, color);
  return is_clicked;
}

std::optional<std::size_t> CommandPalette::draw_rows(const Gui& gui, float height) {
  const float unit = gui.unit();
  std::optional<std::size_t> clicked;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("rows", {0, height});
  const float row_height = kRow * unit;
  if (std::exchange(follows_mark_, false)) {
    const float top = static_cast<float>(list_.marked()) * row_height;
    const float shown = ImGui::GetWindowHeight();
    if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
    if (top + row_height > ImGui::GetScrollY() + shown) ImGui::SetScrollY(top + row_height - shown);
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(list_.hits().size()), row_height);
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      if (draw_row(gui, static_cast<std::size_t>(row))) clicked = static_cast<std::size_t>(row);
  if (list_.hits().empty()) {
    ImGui::SetCursorPos({kKindWidth * unit, 6 * unit});
    ImGui::TextDisabled("No name matches these letters");
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  return clicked;
}

// Describes the action of the marked row.
void CommandPalette::draw_foot(const Gui& gui) const {
  std::string text = " ";
  if (list_.marked() < list_.hits().size()) {
    const PaletteEntry& entry = list_.entries()[list_.hits()[list_.marked()].entry];
    text = entry.is_enabled ? entry.explanation : "Not possible now: " + entry.missing + ". " + entry.explanation;
    if (!entry.place.empty()) text = entry.place + ": " + text;
  }
  ImGui::BeginChild("foot", {0, foot_height(gui)});
  ImGui::PushFont(gui.small());
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().text_quiet);
  paragraph(text.substr(0, text.find('\n')));
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::EndChild();
}

void CommandPalette::draw(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(kPaletteWidth * unit, screen.x - 24 * unit);
  const float top = 0.1F * screen.y;
  // Field and foot have their room first.
  const float field = ImGui::GetFontSize() + 2 * (kFieldPadding + kPalettePadding) * unit;
  const float gaps = 2 * ImGui::GetStyle().ItemSpacing.y;
  const float room = screen.y - top - kPaletteEdge * unit - field - gaps - foot_height(gui);
  const float rows = kRow * unit * std::clamp(std::floor(room / (kRow * unit)), 1.0F, kMostRows);
  ImGui::SetNextWindowPos({0.5F * (screen.x - width), top});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPalettePadding * unit, kPalettePadding * unit});
  std::function<void()> chosen;
  if (Gui::begin_dialog("##palette", is_open_, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove)) {
    draw_field(gui);
    const std::optional<std::size_t> clicked = draw_rows(gui, rows);
    draw_foot(gui);
    const bool is_accepted = std::exchange(is_accepted_, false);
    if (clicked) list_.mark(*clicked);
    if (clicked || is_accepted) chosen = list_.take(list_.marked());
    const bool beside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                        !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    if (chosen || beside) is_open_ = false;
    if (!is_open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  if (chosen) chosen();
}

}  // namespace mes
