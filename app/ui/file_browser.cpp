// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/file_browser.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/ui/theme.h"
#include "core/base/lower_case.h"
#include "core/io/format.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

bool is_known(const std::string& name) {
  const std::string extension = lower_case_extension(name);
  for (const FormatDescriptor& format : format_descriptors())
    if (format.can_read && std::ranges::count(format.extensions, extension) > 0) return true;
  return extension == ".txt" || extension == ".bnd";
}

std::string size_text(std::uintmax_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (bytes < 1000) return fmt::format("{} B", bytes);
  if (bytes < 1'000'000) return fmt::format("{:.1f} kB", value / 1e3);
  return fmt::format("{:.1f} MB", value / 1e6);
}

fs::path home() {
  const char* value = std::getenv("HOME");
  return value != nullptr && value[0] == '/' ? fs::path(value) : fs::path("/");
}

constexpr const char* kTitle = "##file-browser";

}  // namespace

void FileBrowser::ask(const fs::path& folder, Then then, FilePurpose purpose) {
  is_open_ = true;
  field_.focus();
  accepted_ = false;
  trouble_.clear();
  overwrite_.clear();
  purpose_ = std::move(purpose);
  then_ = std::move(then);
  std::error_code error;
  enter(!folder.empty() && fs::is_directory(folder, error) ? folder : fs::current_path(error));
}

void FileBrowser::ask_open(const fs::path& folder, Then then, FilePurpose purpose) {
  is_saving_ = false;
  name_.clear();
  ask(folder, std::move(then), std::move(purpose));
}

void FileBrowser::ask_save(const fs::path& folder, const std::string& name, Then then, FilePurpose purpose) {
  is_saving_ = true;
  name_ = name;
  extension_ = fs::path(name).extension().string();
  ask(folder, std::move(then), std::move(purpose));
}

bool FileBrowser::is_listed(const std::string& name) const {
  if (all_files_) return true;
  const std::vector<std::string>& wanted = purpose_.extensions;
  return wanted.empty() ? is_known(name) : std::ranges::count(wanted, lower_case_extension(name)) > 0;
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(folder, error);
  if (error) target = folder;
  fs::directory_iterator iterator(target, error);
  if (error) {
    trouble_ = target.string() + ": " + error.message();
    return;
  }
  trouble_.clear();
  folder_ = target;
  entries_.clear();
  for (; !error && iterator != fs::directory_iterator(); iterator.increment(error)) {
    Entry entry{iterator->path().filename().string(), false, 0};
    if (entry.name.starts_with(".")) continue;
    std::error_code ignored;  // a broken link is an entry without size
    entry.is_folder = iterator->is_directory(ignored);
    if (!entry.is_folder) entry.size = iterator->file_size(ignored);
    if (ignored) entry.size = 0;
    entries_.push_back(std::move(entry));
  }
  std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
  });
}

std::optional<fs::path> FileBrowser::accept() {
  if (name_.empty()) return std::nullopt;
  fs::path chosen = name_.starts_with("~/") ? home() / name_.substr(2) : fs::path(name_);
  if (chosen.is_relative()) chosen = folder_ / chosen;
  std::error_code error;
  if (fs::is_directory(chosen, error)) {
    enter(chosen);
    if (trouble_.empty()) name_.clear();
    return std::nullopt;
  }
  if (!is_saving_) {
    if (fs::exists(chosen, error)) return chosen;
    trouble_ = "No such file: " + chosen.string();
    return std::nullopt;
  }
  if (chosen.extension().empty()) chosen += extension_;
  if (!fs::is_directory(chosen.parent_path(), error)) {
    trouble_ = "No such folder: " + chosen.parent_path().string();
    return std::nullopt;
  }
  if (!fs::exists(chosen, error)) return chosen;
  overwrite_ = chosen;
  return std::nullopt;
}

void FileBrowser::draw_path(const Gui& gui) {
  const float unit = gui.unit();
  if (ImGui::SmallButton("Home")) enter(home());
  ImGui::SameLine(0, 10 * unit);
  fs::path so_far;
  fs::path target;
  int id = 0;
  for (const fs::path& part : folder_) {
    so_far /= part;
    if (id > 0) ImGui::SameLine(0, 2 * unit);
    const std::string label = part == "/" ? "/" : part.string();
    // A long path continues on the next line.
    if (id > 0 &&
        ImGui::GetCursorPosX() + ImGui::CalcTextSize(label.c_str()).x + 20 * unit > ImGui::GetContentRegionMax().x)
      ImGui::NewLine();
    ImGui::PushID(id++);
    if (ImGui::SmallButton(label.c_str())) target = so_far;
    ImGui::PopID();
  }
  if (!target.empty()) enter(target);
}

void FileBrowser::draw_entries(const Gui& gui, float height) {
  const float unit = gui.unit();
  fs::path target;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, gui.colors().raised);
  const bool shown =
      ImGui::BeginTable("entries", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersOuter, {0, height});
  ImGui::PopStyleColor();
  if (!shown) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, 80 * unit);
  for (const Entry& entry : entries_) {
    if (!entry.is_folder && !is_listed(entry.name)) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(entry.name.c_str());
    const std::string label = entry.is_folder ? entry.name + "/" : entry.name;
    if (entry.is_folder) ImGui::PushFont(gui.bold());
    const ImGuiSelectableFlags flags = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
    if (ImGui::Selectable(label.c_str(), !entry.is_folder && entry.name == name_, flags)) {
      const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      if (!entry.is_folder) name_ = entry.name;
      if (entry.is_folder)
        target = folder_ / entry.name;
      else if (twice)
        accepted_ = true;
    }
    if (entry.is_folder) ImGui::PopFont();
    ImGui::TableNextColumn();
    if (!entry.is_folder) ImGui::TextDisabled("%s", size_text(entry.size).c_str());
    ImGui::PopID();
  }
  ImGui::EndTable();
  if (!target.empty()) enter(target);
}

bool FileBrowser::draw_overwrite_question(const Gui& gui) {
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
  ImGui::TextWrapped("%s exists already.", overwrite_.filename().c_str());
  ImGui::PopStyleColor();
  const bool yes = ImGui::Button("Replace it");
  ImGui::SameLine(0, 8 * gui.unit());
  if (ImGui::Button("Choose another name")) overwrite_.clear();
  return yes;
}

void FileBrowser::draw(const Gui& gui) {
  if (const auto chosen = draw_choice(gui))
    if (const Then then = std::exchange(then_, {})) then(*chosen);
}

std::optional<fs::path> FileBrowser::draw_choice(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(640 * unit, screen.x - 24 * unit), std::min(520 * unit, screen.y - 24 * unit));
  ImGui::SetNextWindowPos({0.5F * (screen.x - size.x), 0.45F * (screen.y - size.y)});
  ImGui::SetNextWindowSize(size);
  std::optional<fs::path> out;
  if (!Gui::begin_dialog(kTitle, is_open_, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove)) return out;
  ImGui::PushFont(gui.bold());
  const char* const usual = is_saving_ ? "Save as" : "Open a session, samples, balls or bundles";
  ImGui::TextUnformatted(purpose_.heading.empty() ? usual : purpose_.heading.c_str());
  ImGui::PopFont();
  draw_path(gui);
  const float foot = (trouble_.empty() ? 0.0F : ImGui::GetTextLineHeightWithSpacing()) +
                     2 * ImGui::GetFrameHeightWithSpacing() + 6 * unit;
  draw_entries(gui, ImGui::GetContentRegionAvail().y - foot);
  if (!trouble_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    ImGui::TextUnformatted(trouble_.c_str());
    ImGui::PopStyleColor();
  }
  if (overwrite_.empty()) {
    ImGui::SetNextItemWidth(-1);
    if (field_.draw("##name", is_saving_ ? "Name of the file" : "Name of a file, or a folder to look into", name_))
      accepted_ = true;
    if (!is_saving_) {
      ImGui::Checkbox("All files", &all_files_);
    } else {
      ImGui::AlignTextToFramePadding();
      ImGui::TextDisabled("%s", purpose_.heading.empty() ? ".json everything   .poff samples   .wpoff balls" : "");
    }
    ImGui::SameLine();
    const char* verb = is_saving_ ? "Save" : "Open";
    const float buttons = 2 * 90 * unit + 8 * unit;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - buttons);
    if (ImGui::Button("Cancel", {90 * unit, 0})) is_open_ = false;
    ImGui::SameLine(0, 8 * unit);
    ImGui::BeginDisabled(name_.empty());
    if (ImGui::Button(verb, {90 * unit, 0})) accepted_ = true;
    ImGui::EndDisabled();
    if (accepted_) out = accept();
    accepted_ = false;
  } else if (draw_overwrite_question(gui)) {
    out = overwrite_;
  }
  if (out) is_open_ = false;
  ImGui::EndPopup();
  return out;
}

}  // namespace mes
