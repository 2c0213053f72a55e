// SPDX-License-Identifier: GPL-3.0-or-later
// A dialog that chooses a file to open, or a name to save under.
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

/// What it guarantees:
///  1. A folder is read once, when it is entered. An error is reported, not shown as an empty folder.
///  2. Overwriting a file needs a confirmation.
///  3. A name without an extension gets that of the proposed name.
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
  /// Returns the content of the name field as a path; enters it if it is a folder.
  std::optional<std::filesystem::path> accept();

  bool is_open_ = false;
  bool is_saving_ = false;
  bool all_files_ = false;
  bool accepted_ = false;
  std::filesystem::path folder_;
  std::string name_;
  NameField field_;
  std::string extension_;  // of the proposed name
  FilePurpose purpose_;
  Then then_;
  std::string trouble_;
  std::vector<Entry> entries_;
  std::filesystem::path overwrite_;  // waits for the confirmation
};

}  // namespace mes
