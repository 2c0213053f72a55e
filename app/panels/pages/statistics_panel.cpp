// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/statistics_panel.h"

#include <fmt/core.h>

#include "app/layers/words/statistics_text.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"
#include "core/draw/variant.h"

namespace mes {
namespace {

std::string readable(std::string key) {
  for (char& c : key)
    if (c == '_' || c == '-') c = ' ';
  if (!key.empty() && key[0] >= 'a' && key[0] <= 'z') key[0] = static_cast<char>(key[0] - 'a' + 'A');
  return key;
}

ImU32 state_color(const ThemeColors& colors, NodeState state) {
  switch (state) {
    case NodeState::up_to_date: return colors.good;
    case NodeState::computing: return colors.accent;
    case NodeState::failed:
    case NodeState::blocked: return colors.warning;
    case NodeState::inactive: break;
  }
  return colors.text_faint;
}

std::string work_text(const NodeReport& node) {
  if (node.update_ms == 0.0 && !node.rebuilt && node.touched == 0) return {};
  const int decimals = node.update_ms < 10 ? 2 : 0;
  if (node.rebuilt) return fmt::format("{:.{}f} ms, rebuilt", node.update_ms, decimals);
  return fmt::format("{:.{}f} ms, {} changed", node.update_ms, decimals, node.touched);
}

std::string text_of_stat(const StatValue& value) {
  const auto* const number = std::get_if<std::int64_t>(&value);
  return number != nullptr && *number >= 0 ? grouped(static_cast<std::size_t>(*number)) : to_text(value);
}

/// Draws name and value on one line. A value that does not fit beside its name stands below it.
void draw_stat(const Gui& gui, const Stat& stat) {
  const float unit = gui.unit();
  const float right = ImGui::GetContentRegionMax().x;
  const std::string name = readable(stat.key);
  const std::string text = text_of_stat(stat.value);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  const float indent = 16 * unit;
  const float gap = 8 * unit;
  ImGui::Indent(indent);
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextDisabled("%s", name.c_str());
  if (ImGui::GetCursorStartPos().x + indent + ImGui::CalcTextSize(name.c_str()).x + gap + width <= right) {
    ImGui::SameLine(right - width);
    ImGui::TextUnformatted(text.c_str());
  } else {
    ImGui::Indent(indent);
    ImGui::TextUnformatted(text.c_str());
    ImGui::Unindent(indent);
  }
  ImGui::PopTextWrapPos();
  ImGui::Unindent(indent);
}

void draw_node(const Gui& gui, const NodeReport& node) {
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 5 * unit, at.y + 0.5F * ImGui::GetTextLineHeight()}, 4 * unit,
                                              state_color(gui.colors(), node.state));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 16 * unit);
  ImGui::PushFont(gui.bold());
  ImGui::TextUnformatted(readable(node.structure).c_str());
  ImGui::PopFont();
  const std::string work = work_text(node);
  ImGui::PushFont(gui.small());
  ImGui::SameLine(
      std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(work.c_str()).x));
  ImGui::TextDisabled("%s", work.c_str());
  ImGui::PopFont();
  if (!node.reason.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    paragraph(node.reason);
    ImGui::PopStyleColor();
  }
  if (!node.kernel.empty()) {
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 16 * unit);
    ImGui::PushFont(gui.small());
    ImGui::TextDisabled("%s", std::string(node.kernel).c_str());
    ImGui::PopFont();
    tooltip(
        gui,
        "Numbers of this computation. EPICK and EPECK are CGAL's kernels with exact decisions: coordinates that are "
        "constructed are rounded to doubles in the first, and exact in the second");
  }
  for (const Stat& stat : node.stats) draw_stat(gui, stat);
  ImGui::Dummy({0, 4 * unit});
}

}  // namespace

void StatisticsPanel::draw() const {
  const float unit = gui.unit();
  std::vector<NodeReport> nodes = picture.nodes();
  std::erase_if(nodes, [](const NodeReport& node) { return node.variant != kMainVariant; });
  nodes.push_back(times.report());
  if (ImGui::SmallButton("Copy")) ImGui::SetClipboardText(statistics_as_tsv(nodes).c_str());
  tooltip(gui, "Copy all numbers as lines with tabs, for a spreadsheet");
  ImGui::SameLine(0, 6 * unit);
  if (ImGui::SmallButton("Copy JSON")) ImGui::SetClipboardText(statistics_as_json(nodes).c_str());
  tooltip(gui, "Copy all numbers as JSON, for a program");
  ImGui::Dummy({1, 2 * unit});
  ImGui::BeginChild("nodes");
  for (const NodeReport& node : nodes) {
    if (node.state == NodeState::inactive) continue;
    ImGui::PushID(node.structure.c_str());
    draw_node(gui, node);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

}  // namespace mes
