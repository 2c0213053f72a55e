// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/log_panel.h"

#include <fmt/core.h>
#include <array>
#include <ctime>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

std::string clock_text(std::chrono::system_clock::time_point when) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(when);
  std::tm parts{};
  ::localtime_r(&seconds, &parts);
  std::array<char, 16> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%H:%M:%S", &parts);
  return {text.data(), length};
}

std::string line_of(const Messages::Entry& entry) {
  return entry.times == 1 ? entry.text : fmt::format("{} ({} times)", entry.text, entry.times);
}

}  // namespace

void LogPanel::draw() const {
  const float unit = gui.unit();
  const auto& entries = messages.entries();
  ImGui::BeginDisabled(entries.empty());
  if (ImGui::SmallButton("Copy")) {
    std::string text;
    for (const Messages::Entry& entry : entries)
      text += clock_text(entry.when) + (entry.is_problem ? "\tproblem\t" : "\tremark\t") + line_of(entry) + '\n';
    ImGui::SetClipboardText(text.c_str());
  }
  tooltip(gui, "Copy all lines");
  ImGui::SameLine(0, 6 * unit);
  if (ImGui::SmallButton("Clear")) messages.clear_log();
  tooltip(gui, "Remove all messages from this list");
  ImGui::EndDisabled();
  ImGui::BeginChild("lines");
  if (entries.empty()) ImGui::TextDisabled("No messages yet");
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    ImGui::PushFont(gui.small());
    ImGui::TextDisabled("%s", clock_text(entry->when).c_str());
    ImGui::PopFont();
    ImGui::SameLine(0, 6 * unit);
    if (entry->is_problem) ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    paragraph(line_of(*entry));
    if (entry->is_problem) ImGui::PopStyleColor();
  }
  ImGui::EndChild();
}

}  // namespace mes
