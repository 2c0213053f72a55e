// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/experiments_panel.h"

#include <fmt/core.h>

#include <algorithm>

#include <string>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

/// Counts the contents: "1 structure, 2 layers".
std::string contents_in_words(const ExperimentContents& contents) {
  std::string out;
  const auto add = [&out](std::size_t count, const char* one) {
    if (count == 0) return;
    if (!out.empty()) out += ", ";
    out += counted(count, one);
  };
  add(contents.structures.size(), "structure");
  add(contents.layers.size(), "layer");
  add(contents.parameters.size(), "parameter");
  add(contents.evolutions.size(), "evolution");
  add(contents.shapes.size(), "shape");
  add(contents.formats.size(), "format");
  return out.empty() ? "nothing" : out;
}

std::string state_in_words(const ExperimentList::Entry& entry) {
  switch (entry.state) {
    case ExperimentList::State::waiting: return "Waiting for its turn";
    case ExperimentList::State::preparing: return "Being compiled";
    case ExperimentList::State::added:
      return fmt::format("Adds {} ({:.1f} s)", contents_in_words(entry.contents), entry.seconds);
    case ExperimentList::State::failed: break;
  }
  return entry.contents.is_empty() ? "Adds nothing" : "The previous version stays in use";
}

std::string place_of(const CompilerMessage& message) {
  const std::string name = std::filesystem::path(message.file).filename().string();
  return message.line == 0 ? name : fmt::format("{}:{}", name, message.line);
}

}  // namespace

void ExperimentsPanel::draw_more() const {
  if (ImGui::SmallButton("Add...")) ask_file();
  tooltip(gui, "Compile and load a C++ source, or load a shared library; saving the source loads its new version");
  const float unit = gui.unit();
  const auto menu = [&](const char* label, const char* popup, bool is_empty, const char* explanation,
                        auto draw_items) {
    ImGui::SameLine(0, 6 * unit);
    ImGui::BeginDisabled(is_empty);
    if (ImGui::SmallButton(label)) ImGui::OpenPopup(popup);
    ImGui::EndDisabled();
    tooltip(gui, explanation);
    if (!begin_popup(gui, popup)) return;
    draw_items();
    ImGui::EndPopup();
  };
  menu("Examples", "examples", examples.empty(), "Load one of the experiments that come with the program", [this] {
    for (const std::filesystem::path& file : examples)
      if (ImGui::MenuItem(file.stem().c_str())) add(file);
  });
  menu("Recent", "recent", recent.empty(), "Load an experiment that was loaded before", [this] {
    for (const std::string& file : recent) {
      if (ImGui::MenuItem(std::filesystem::path(file).filename().c_str())) add(file);
      tooltip(gui, file);
    }
  });
  menu("...", "compiler", false, "The compiler of experiments", [&] {
    ImGui::TextUnformatted("Compiler");
    ImGui::SetNextItemWidth(200 * unit);
    ImGui::InputTextWithHint("##compiler", "$CXX, g++ or clang++", &compiler);
    tooltip(gui, "A program and its first arguments, as in \"clang++-16 -O3\"");
  });
}

void ExperimentsPanel::draw_message(const CompilerMessage& message) const {
  constexpr float kMostLines = 4.0F;
  const std::string label = fmt::format("{}: {}", place_of(message), message.text);
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string shown = elided(label, kMostLines * width);
  const ImVec2 at = ImGui::GetCursorPos();
  const ImVec2 size = ImGui::CalcTextSize(broken_lines(shown, width).c_str());
  if (ImGui::Selectable("##message", false, 0, {width, size.y})) edit(message.file, message.line);
  tooltip(gui, label + "\n\nClick to open the file and to copy its name and line");
  const ImVec2 below = ImGui::GetCursorPos();
  ImGui::SetCursorPos(at);
  if (message.is_error) ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
  paragraph(shown);
  if (message.is_error) ImGui::PopStyleColor();
  ImGui::SetCursorPos(below);
}

void ExperimentsPanel::draw_entry(std::size_t index) const {
  const ExperimentList::Entry& entry = list.entries()[index];
  const float unit = gui.unit();
  ImGui::PushID(static_cast<int>(index));
  ImGui::PushFont(gui.bold());
  ImGui::TextUnformatted(entry.file.filename().c_str());
  ImGui::PopFont();
  tooltip(gui, entry.file.string());
  const std::filesystem::path file = entry.file;
  ImGui::PushFont(gui.small());
  ImGui::TextDisabled("%s", state_in_words(entry).c_str());
  const bool is_explained = std::ranges::any_of(entry.messages, &CompilerMessage::is_error);
  if (entry.state == ExperimentList::State::failed && !is_explained) {
    ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    paragraph(entry.problem);
    ImGui::PopStyleColor();
  }
  for (std::size_t i = 0; i < entry.messages.size(); ++i) {
    const CompilerMessage& message = entry.messages[i];
    ImGui::PushID(static_cast<int>(i));
    draw_message(message);
    ImGui::PopID();
  }
  bool is_removed = false;
  if (ImGui::SmallButton("Edit")) edit(file, 0);
  tooltip(gui, "Open the source in the editor of the desktop, or the one that VISUAL names");
  ImGui::SameLine(0, 6 * unit);
  if (ImGui::SmallButton("Reload")) list.reload(index);
  tooltip(gui, "Compile and load it again, even if it has not changed");
  ImGui::SameLine(0, 6 * unit);
  if (ImGui::SmallButton("Remove")) is_removed = true;
  tooltip(gui, "Remove what it adds; layers shown now return with it");
  ImGui::PopFont();
  ImGui::Dummy({1, 4 * unit});
  ImGui::PopID();
  if (is_removed) list.remove(index);
}

void ExperimentsPanel::draw() const {
  draw_more();
  ImGui::Separator();
  ImGui::BeginChild("experiments");
  if (list.entries().empty()) {
    quiet_paragraph(
        "Your own structures, layers, evolutions and shapes, as C++ sources. \"mesecina new structure NAME\" writes "
        "one to start from.");
  }
  for (std::size_t i = 0; i < list.entries().size(); ++i) draw_entry(i);
  ImGui::EndChild();
}

}  // namespace mes
