// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing a file to open, or a name to save under.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/gui.h"
#include "app/ui/name_field.h"

namespace mes {

/// What it guarantees: it reads a folder once, when it is entered; a folder that cannot be read is told, not left
/// silently empty; saving over a file asks first, and a name without extension gets that of the name proposed.
///
/// Smallest use:
///     browser.ask_open(folder);
///     ... each frame: if (auto file = browser.draw(gui)) open(*file);
class FileBrowser {
 public:
  /// `heading`: what for, when it is not for the document.
  void ask_open(const std::filesystem::path& folder, std::string heading = {});
  void ask_save(const std::filesystem::path& folder, const std::string& name, std::string heading = {});
  /// For files of other kinds: `then` gets the chosen one, instead of whoever draws the dialog.
  void ask_for(const std::string& title, std::vector<std::string> extensions, const std::filesystem::path& folder,
               std::function<void(const std::filesystem::path&)> then);
  void close() { is_open_ = false; }
  bool is_open() const { return is_open_; }
  bool is_saving() const { return is_saving_; }
  /// Draws the dialog while it is open. The chosen file, once.
  std::optional<std::filesystem::path> draw(const Gui& gui);
  const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t size = 0;
  };
  void ask(const std::filesystem::path& folder);
  bool is_listed(const std::string& name) const;
  void enter(const std::filesystem::path& folder);
  void draw_path(const Gui& gui);
  void draw_entries(const Gui& gui, float height);
  bool draw_overwrite_question(const Gui& gui);
  /// What the name field says, as a path; enters it when it is a folder.
  std::optional<std::filesystem::path> accept();

  bool is_open_ = false;
  bool is_saving_ = false;
  bool all_files_ = false;
  bool accepted_ = false;
  std::filesystem::path folder_;
  std::string name_;
  NameField field_;
  std::string extension_;  // of the name proposed
  std::string heading_;
  std::vector<std::string> extensions_;  // lower case, with the dot; empty: of samples and balls
  std::function<void(const std::filesystem::path&)> then_;
  std::string trouble_;
  std::vector<Entry> entries_;
  std::filesystem::path overwrite_;  // waits for a yes
};

}  // namespace mes
