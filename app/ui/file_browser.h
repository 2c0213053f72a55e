// SPDX-License-Identifier: GPL-3.0-or-later
// A dialog that chooses a file to open, or a name to save under.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/model/file_list.h"
#include "app/ui/dialog.h"
#include "app/ui/name_field.h"

namespace mes {

/// What a file is asked for when it is not the document.
struct FilePurpose {
  std::string heading{};
  std::vector<std::string> extensions{};  ///< lower case, with the dot; empty: of samples and balls
};

/// What it guarantees:
///  1. A folder is read once, when it is entered. An error is reported, not shown as an empty folder, until something
///     else is chosen.
///  2. Overwriting a file needs a confirmation.
///  3. A name without an extension gets that of the proposed name.
///  4. The keyboard does everything: arrows and Page keys mark a file, letters jump to one, Enter opens what is marked,
///     Alt+Up shows the folder above.
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
  void press(const KeyChord& chord) override;

 private:
  void ask(const std::filesystem::path& folder, Then then, FilePurpose purpose);
  /// The chosen file, once.
  std::optional<std::filesystem::path> draw_choice(const Gui& gui);
  void list_wanted();
  void enter(const std::filesystem::path& folder);
  /// The mark was moved: its name is the one that is meant.
  void take_marked_name();
  void follow_name();
  void draw_path(const Gui& gui);
  void draw_entries(const Gui& gui, float height);
  bool draw_overwrite_question(const Gui& gui);
  /// Returns the content of the name field as a path; enters it if it is a folder.
  std::optional<std::filesystem::path> accept();

  bool is_open_ = false;
  bool is_saving_ = false;
  bool all_files_ = false;
  bool accepted_ = false;
  FileList files_;
  std::string name_;
  std::string followed_name_;  // as the mark was last set by it, or it by the mark
  bool shows_mark_ = false;    // scrolls to it in the next frame
  NameField field_;
  std::string extension_;  // of the proposed name
  FilePurpose purpose_;
  Then then_;
  std::string trouble_;
  std::filesystem::path overwrite_;  // waits for the confirmation
  bool replaces_ = false;            // which of its two answers Enter gives
};

}  // namespace mes
