// SPDX-License-Identifier: GPL-3.0-or-later
// A dialog that chooses a file to open, or a name to save under: the desktop's, or this program's own.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/system/background_job.h"
#include "app/system/desktop_dialog.h"
#include "app/ui/dialogs/dialog.h"
#include "app/ui/dialogs/file_list.h"
#include "app/ui/dialogs/name_field.h"
#include "core/graph/live_registry.h"

namespace mes {

/// The purpose of a file that is not the document.
struct FilePurpose {
  std::string heading{};
  std::vector<std::string> extensions{};  ///< lower case, with the dot; empty: those of documents that can be opened
  std::string trouble{};                  ///< why the question is repeated
};

/// Guarantees:
///  1. A folder is read once, when it is entered. An error is reported, not shown as an empty folder, until something
///     else is chosen.
///  2. Overwriting a file needs a confirmation.
///  3. A name without an extension gets that of the proposed name. So does a name whose extension is none of the
///     purpose's: "x.txt" is saved as "x.txt.pdf".
///  4. The keyboard is sufficient: arrows and Page keys mark a file, letters jump to one, Enter opens the marked one,
///     Alt+Up shows the parent folder.
///  5. After `use_desktop` the desktop's dialog is shown instead, if there is one; when it fails for the first time,
///     the own dialog replaces it for good. No frame waits for it.
///
/// Smallest use:
///     browser.ask_open(folder, [](const std::filesystem::path& file) { open(file); });
///     ... each frame: browser.draw(gui);
class FileBrowser final : public Dialog {
 public:
  using Then = std::function<void(const std::filesystem::path&)>;

  FileBrowser();
  ~FileBrowser() override;
  /// Lists files of the formats of this registry. It lists none before this call.
  void use_formats(LiveRegistry registry) { registry_ = std::move(registry); }
  /// `window`: the parent window, as in DesktopQuestion. `wake` is called from another thread when an answer has
  /// arrived, `settle` when it was taken and other dialogs must be drawn.
  void use_desktop(const std::string& window, std::function<void()> wake, std::function<void()> settle);

  /// `then` receives the file once it is chosen.
  void ask_open(const std::filesystem::path& folder, Then then, FilePurpose purpose = {});
  void ask_save(const std::filesystem::path& folder, const std::string& name, Then then, FilePurpose purpose = {});

  bool is_open() const override { return is_open_; }
  void cancel() override;
  void draw(const Gui& gui) override;
  void press(const KeyChord& chord) override;

 private:
  struct Desktop {
    Desktop(std::string above, std::function<void()> wake) : window(std::move(above)), asking(std::move(wake)) {}
    std::string window;
    BackgroundJob<DesktopAnswer> asking;  // with a waker of its own: a dialog that is open is not work
  };
  void ask(const std::filesystem::path& folder, Then then, FilePurpose purpose);
  void ask_desktop_first();
  bool is_desktop_asked() const { return desktop_ && desktop_->asking.is_under_way(); }
  std::optional<std::filesystem::path> take_desktop_answer();
  void draw_desktop_note(const Gui& gui);
  std::string heading() const;
  /// Returns the chosen file, once.
  std::optional<std::filesystem::path> draw_choice(const Gui& gui);
  void list_wanted();
  void enter(const std::filesystem::path& folder);
  /// Uses the name of the row to which the mark was moved.
  void take_marked_name();
  void follow_name();
  void draw_path(const Gui& gui);
  void draw_entries(const Gui& gui, float height);
  std::string overwrite_text() const;
  bool draw_overwrite_question(const Gui& gui);
  /// True if the name can be saved as it is; otherwise it gets the extension of the proposed name.
  bool has_fitting_extension(const std::filesystem::path& file) const;
  /// The endings that the file to be saved may have, or the name that it gets for the one typed.
  std::string about_name() const;
  /// Returns the content of the name field as a path; enters it if it is a folder.
  std::optional<std::filesystem::path> accept();

  std::unique_ptr<Desktop> desktop_;  // null: the own dialog is shown
  std::function<void()> settle_;
  std::optional<LiveRegistry> registry_;
  bool is_open_ = false;
  bool is_saving_ = false;
  bool all_files_ = false;
  bool accepted_ = false;
  FileList files_;
  std::string name_;
  std::string followed_name_;  // name at the last synchronisation with the mark
  bool shows_mark_ = false;    // scrolls to the mark in the next frame
  NameField field_;
  std::string extension_;  // extension of the proposed name
  FilePurpose purpose_;
  Then then_;
  std::string trouble_;
  std::filesystem::path overwrite_;  // waits for the confirmation
  bool replaces_ = false;            // the answer that Enter gives to the question
};

}  // namespace mes
