// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/dialogs/file_browser.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/lower_case.h"
#include "core/io/carried_session.h"
#include "core/io/format_spec.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

/// The extensions of files that can be opened, each once.
std::vector<std::string_view> known_extensions(const std::optional<LiveRegistry>& registry) {
  std::vector<std::string_view> out{".txt", ".bnd"};
  const auto add = [&out](std::string_view extension) {
    if (std::ranges::find(out, extension) == out.end()) out.push_back(extension);
  };
  if (registry)
    for (const auto& format : registry->now().formats().all())
      if (format->descriptor.can_read) std::ranges::for_each(format->descriptor.extensions, add);
  std::ranges::for_each(kCarrierExtensions, add);
  return out;
}

bool is_known(const std::optional<LiveRegistry>& registry, const std::string& name) {
  const std::vector<std::string_view> known = known_extensions(registry);
  return std::ranges::find(known, lower_case_extension(name)) != known.end();
}

std::vector<std::string> known_patterns(const std::optional<LiveRegistry>& registry) {
  std::vector<std::string> out;
  for (const std::string_view extension : known_extensions(registry)) out.push_back(fmt::format("*{}", extension));
  return out;
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
constexpr const char* kDesktopTitle = "##desktop-dialog";

}  // namespace

FileBrowser::FileBrowser() = default;
FileBrowser::~FileBrowser() = default;

void FileBrowser::use_desktop(const std::string& window, std::function<void()> wake, std::function<void()> settle) {
  settle_ = std::move(settle);
  if (may_have_desktop_dialog()) desktop_ = std::make_unique<Desktop>(window, std::move(wake));
}

void FileBrowser::cancel() {
  is_open_ = false;
  if (desktop_) desktop_->asking.give_up();
}

std::string FileBrowser::heading() const {
  const char* const usual =
      is_saving_ ? "Save as" : "Open a session, samples, balls, bundles, or a picture with its source";
  return purpose_.heading.empty() ? usual : purpose_.heading;
}

// If the desktop was not asked, or has failed, the own dialog is shown.
void FileBrowser::ask_desktop_first() {
  if (!desktop_) return;
  DesktopQuestion question{.is_saving = is_saving_,
                           .heading = heading(),
                           .folder = files_.folder(),
                           .name = is_saving_ ? name_ : std::string(),
                           .window = desktop_->window};
  if (!is_saving_) {
    std::vector<std::string> patterns;
    for (const std::string& extension : purpose_.extensions) patterns.push_back('*' + extension);
    if (patterns.empty()) patterns = known_patterns(registry_);
    question.filters = {{"What can be opened", std::move(patterns)}, {"All files", {"*"}}};
  }
  try {
    desktop_->asking.begin(
        [question = std::move(question)](const std::stop_token& stop) { return ask_desktop(question, stop); });
  } catch (const std::system_error&) {
    desktop_.reset();
  }
}

// Returns the chosen file if it can be used as it is; otherwise the own dialog continues from there.
std::optional<fs::path> FileBrowser::take_desktop_answer() {
  if (!is_desktop_asked()) return std::nullopt;
  const std::optional<DesktopAnswer> answer = desktop_->asking.poll();
  if (!answer) return std::nullopt;
  settle_();
  switch (answer->kind) {
    case DesktopAnswer::Kind::cancelled: is_open_ = false; return std::nullopt;
    case DesktopAnswer::Kind::unavailable: desktop_.reset(); return std::nullopt;
    case DesktopAnswer::Kind::chosen: break;
  }
  std::error_code error;
  const bool is_folder = fs::is_directory(answer->file, error);
  if (!is_folder) enter(answer->file.parent_path());
  name_ = is_folder ? answer->file.string() : answer->file.filename().string();
  // The user has confirmed overwriting only for the name as it was chosen.
  const bool is_agreed = is_saving_ && !is_folder && has_fitting_extension(answer->file);
  std::optional<fs::path> out = is_agreed ? std::optional(answer->file) : accept();
  followed_name_ = name_;
  return out;
}

// Shown below the desktop's dialog; offers a way out, e.g. if that lies behind other windows.
void FileBrowser::draw_desktop_note(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.45F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * unit, 16 * unit});
  if (Gui::begin_dialog(kDesktopTitle, is_open_ && is_desktop_asked(),
                        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::TextUnformatted("The file is chosen in the dialog of the desktop");
    ImGui::Dummy({1, 6 * unit});
    const bool is_confirmed = std::exchange(accepted_, false);
    if (default_button(gui, "Choose it here", {}, true) || is_confirmed) desktop_->asking.give_up();
    ImGui::SameLine(0, 8 * unit);
    if (ImGui::Button("Cancel")) cancel();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void FileBrowser::ask(const fs::path& folder, Then then, FilePurpose purpose) {
  is_open_ = true;
  field_.focus();
  accepted_ = false;
  trouble_.clear();
  overwrite_.clear();
  purpose_ = std::move(purpose);
  then_ = std::move(then);
  list_wanted();
  std::error_code error;
  enter(!folder.empty() && fs::is_directory(folder, error) ? folder : fs::current_path(error));
  if (trouble_.empty()) trouble_ = purpose_.trouble;
  followed_name_ = name_;
  ask_desktop_first();
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

void FileBrowser::list_wanted() {
  if (all_files_) return files_.set_filter({});
  files_.set_filter([wanted = purpose_.extensions, registry = registry_](const std::string& name) {
    return wanted.empty() ? is_known(registry, name) : std::ranges::count(wanted, lower_case_extension(name)) > 0;
  });
}

void FileBrowser::enter(const fs::path& folder) {
  if (const auto done = files_.enter(folder); !done)
    trouble_ = done.error().message();
  else
    trouble_.clear();
}

void FileBrowser::take_marked_name() {
  const FileList::Entry* const row = files_.marked_row();
  if (row == nullptr) return;
  // The name proposed for saving must survive the way through folders.
  if (!is_saving_ || !row->is_folder) name_ = row->name;
  field_.show_replaced();
  followed_name_ = name_;
  shows_mark_ = true;
  trouble_.clear();
}

// Typing jumps to the first row that begins with the text, and clears old errors.
void FileBrowser::follow_name() {
  if (name_ == followed_name_) return;
  followed_name_ = name_;
  trouble_.clear();
  if (is_saving_) return files_.unmark();
  files_.mark_by_name(name_);
  shows_mark_ = true;
}

void FileBrowser::press(const KeyChord& chord) {
  if (is_desktop_asked()) {
    accepted_ = accepted_ || chord.symbol == key::enter;
    return;
  }
  constexpr int kPage = 10;
  const char32_t symbol = chord.symbol;
  if (!overwrite_.empty()) {
    if (symbol == key::left || symbol == key::right || symbol == key::tab) replaces_ = !replaces_;
    if (symbol == key::enter) accepted_ = true;
    return;
  }
  // A field that has lost the keyboard to a click does not report Enter itself.
  if (symbol == key::enter) accepted_ = true;
  if (symbol == key::up && chord.modifiers.alt) return enter(files_.folder().parent_path());
  if (symbol == key::down) files_.move(1);
  if (symbol == key::up) files_.move(-1);
  if (symbol == key::page_down) files_.move(kPage);
  if (symbol == key::page_up) files_.move(-kPage);
  if (symbol == key::down || symbol == key::up || symbol == key::page_down || symbol == key::page_up)
    take_marked_name();
}

bool FileBrowser::has_fitting_extension(const fs::path& file) const {
  if (purpose_.extensions.empty()) return file.has_extension();
  return std::ranges::count(purpose_.extensions, lower_case_extension(file.filename().string())) > 0;
}

std::string FileBrowser::about_name() const {
  const fs::path name(name_);
  if (name.has_filename() && name.has_extension() && !has_fitting_extension(name))
    return "Saved as " + name.filename().string() + extension_;
  if (purpose_.heading.empty()) return ".json everything   .poff samples   .wpoff balls";
  if (purpose_.extensions.size() < 2) return {};
  std::string out;
  for (const std::string& extension : purpose_.extensions) out += (out.empty() ? "" : "   ") + extension;
  return out;
}

std::optional<fs::path> FileBrowser::accept() {
  const FileList::Entry* const row = files_.marked_row();
  // A marked folder is opened, even when saving a file.
  const std::string text = row != nullptr && row->is_folder ? row->name : name_;
  if (text.empty()) return std::nullopt;
  fs::path chosen = text.starts_with("~/") ? home() / text.substr(2) : fs::path(text);
  if (chosen.is_relative()) chosen = files_.folder() / chosen;
  std::error_code error;
  if (fs::is_directory(chosen, error)) {
    enter(chosen);
    if (trouble_.empty() && !is_saving_) name_.clear();
    followed_name_ = name_;
    return std::nullopt;
  }
  if (!is_saving_) {
    if (fs::exists(chosen, error)) return chosen;
    if (row != nullptr) return files_.folder() / row->name;
    trouble_ = "No such file: " + chosen.string();
    return std::nullopt;
  }
  if (!has_fitting_extension(chosen)) chosen += extension_;
  if (!fs::is_directory(chosen.parent_path(), error)) {
    trouble_ = "No such folder: " + chosen.parent_path().string();
    return std::nullopt;
  }
  if (!fs::exists(chosen, error)) return chosen;
  overwrite_ = chosen;
  replaces_ = false;
  return std::nullopt;
}

void FileBrowser::draw_path(const Gui& gui) {
  const float unit = gui.unit();
  if (ImGui::SmallButton("Home")) enter(home());
  ImGui::SameLine(0, 10 * unit);
  fs::path so_far;
  fs::path target;
  int id = 0;
  for (const fs::path& part : files_.folder()) {
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
  for (std::size_t i = 0; i < files_.rows().size(); ++i) {
    const FileList::Entry& entry = files_.rows()[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(entry.name.c_str());
    const std::string label = entry.is_folder ? entry.name + "/" : entry.name;
    if (entry.is_folder) ImGui::PushFont(gui.bold());
    const ImGuiSelectableFlags flags = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
    const bool is_marked = files_.marked() == i;
    if (ImGui::Selectable(label.c_str(), is_marked || (!entry.is_folder && entry.name == name_), flags)) {
      const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      files_.mark(i);
      take_marked_name();
      if (entry.is_folder)
        target = files_.folder() / entry.name;
      else if (twice)
        accepted_ = true;
    }
    if (is_marked && shows_mark_) ImGui::SetScrollHereY();
    if (entry.is_folder) ImGui::PopFont();
    ImGui::TableNextColumn();
    if (!entry.is_folder) ImGui::TextDisabled("%s", size_text(entry.size).c_str());
    ImGui::PopID();
  }
  shows_mark_ = false;
  ImGui::EndTable();
  if (!target.empty()) enter(target);
}

std::string FileBrowser::overwrite_text() const {
  return overwrite_.filename().string() + " exists already.";
}

bool FileBrowser::draw_overwrite_question(const Gui& gui) {
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
  paragraph(overwrite_text());
  ImGui::PopStyleColor();
  const bool is_confirmed = std::exchange(accepted_, false);
  const bool yes = default_button(gui, "Replace it", {}, replaces_) || (is_confirmed && replaces_);
  ImGui::SameLine(0, 8 * gui.unit());
  if (default_button(gui, "Choose another name", {}, !replaces_) || (is_confirmed && !replaces_)) overwrite_.clear();
  return yes;
}

void FileBrowser::draw(const Gui& gui) {
  std::optional<fs::path> chosen = take_desktop_answer();
  if (chosen) is_open_ = false;
  draw_desktop_note(gui);
  if (!chosen) chosen = draw_choice(gui);
  if (chosen)
    if (const Then then = std::exchange(then_, {})) then(*chosen);
}

std::optional<fs::path> FileBrowser::draw_choice(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(640 * unit, screen.x - 24 * unit), std::min(520 * unit, screen.y - 24 * unit));
  ImGui::SetNextWindowPos({0.5F * (screen.x - size.x), 0.45F * (screen.y - size.y)});
  ImGui::SetNextWindowSize(size);
  std::optional<fs::path> out;
  if (!Gui::begin_dialog(kTitle, is_open_ && !is_desktop_asked(),
                         ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove))
    return out;
  ImGui::PushFont(gui.bold());
  paragraph(heading());
  ImGui::PopFont();
  draw_path(gui);
  const auto height_of = [](const std::string& text) {
    if (text.empty()) return 0.0F;
    const std::string lines = broken_lines(text, ImGui::GetContentRegionAvail().x);
    return ImGui::CalcTextSize(lines.c_str()).y + ImGui::GetStyle().ItemSpacing.y;
  };
  const float row = ImGui::GetFrameHeightWithSpacing();
  const float foot =
      height_of(trouble_) + (overwrite_.empty() ? 2 * row : height_of(overwrite_text()) + row) + 6 * unit;
  draw_entries(gui, ImGui::GetContentRegionAvail().y - foot);
  if (!trouble_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    paragraph(trouble_);
    ImGui::PopStyleColor();
  }
  if (overwrite_.empty()) {
    ImGui::SetNextItemWidth(-1);
    if (field_.draw("##name", is_saving_ ? "Name of the file" : "Name of a file, or a folder to look into", name_))
      accepted_ = true;
    follow_name();
    const float buttons = 2 * 90 * unit + 8 * unit;
    if (!is_saving_) {
      if (checkbox("All files", &all_files_)) list_wanted();
    } else {
      ImGui::AlignTextToFramePadding();
      ImGui::TextDisabled("%s", elided(about_name(), ImGui::GetContentRegionAvail().x - buttons - 8 * unit).c_str());
    }
    ImGui::SameLine();
    const char* verb = is_saving_ ? "Save" : "Open";
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - buttons);
    if (ImGui::Button("Cancel", {90 * unit, 0})) is_open_ = false;
    ImGui::SameLine(0, 8 * unit);
    const bool is_folder = files_.marked_row() != nullptr && files_.marked_row()->is_folder;
    ImGui::BeginDisabled(name_.empty() && !is_folder);
    if (default_button(gui, is_folder ? "Look into" : verb, {90 * unit, 0}, true)) accepted_ = true;
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
