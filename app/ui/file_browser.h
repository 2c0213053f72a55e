// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing a file to open, or a name to save under.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/dialog.h"
#include "app/ui/name_field.h"

namespace mes {

/// What a file is asked for when it is not the document.
struct FilePurpose {
  std::string heading{};
  std::vector<std::string> extensions{};  ///< lower case, with the dot; empty: of samples and balls
};

/// What it guarantees: it reads a folder once, when it is entered; a folder that cannot be read is told, not left
/// silently empty; saving over a file asks first, and a name without extension gets that of the name proposed.
///
/// Smallest use:
///     browser.ask_open(folder, [](const std::filesystem::path& file) { open(file); });
///     ... each frame: browser.draw(gui);
class FileBrowser final : public Dialog {
 public:
  using Then = std::function<void(const std::filesystem::path&)>;

  /// `then` gets the file, once it is chosen.
  void ask_open(const std::filesystem::path& folder, Then then, FilePurpose purpose = {});
  void ask_save(const std::filesystem::path& folder, const std::string& name, Then then, FilePurpose purpose = {});

  bool is_open() const override { return is_open_; }
  void cancel() override { is_open_ = false; }
  void draw(const Gui& gui) override;

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t size = 0;
  };
  void ask(const std::filesystem::path& folder, Then then, FilePurpose purpose);
  /// The chosen file, once.
  std::optional<std::filesystem::path> draw_choice(const Gui& gui);
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
  FilePurpose purpose_;
  Then then_;
  std::string trouble_;
  std::vector<Entry> entries_;
  std::filesystem::path overwrite_;  // waits for a yes
};

}  // namespace mes
