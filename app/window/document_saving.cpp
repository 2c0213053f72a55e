// SPDX-License-Identifier: GPL-3.0-or-later
// The document of the window goes to its files.
#include <algorithm>
#include <utility>

#include "app/window/document_flow.h"

namespace mes {

namespace fs = std::filesystem;

// Whatever waits for the save goes on once everything is in a file; what has none is asked a name for then.
void DocumentFlow::save() {
  uses_.lesson.end();
  if (files_.file().empty())
    ask_save_as();
  else
    files_.save();
}

void DocumentFlow::ask_save_as() {
  uses_.lesson.end();
  std::string name = fs::path(files_.title()).stem().string();
  std::ranges::replace(name, '/', '-');
  const FileDesk::Unsaved rest = files_.unsaved();
  const Document& document = uses_.work.document();
  const bool balls_only = document.sample_count() == 0 && document.ball_count() != 0;
  const bool wants_balls = rest.balls && !rest.samples;
  const bool wants_session = (rest.annotations || rest.lesson) && !rest.samples && !rest.balls;
  const bool has_format = !files_.file().empty() && !files_.has_session_file() && !wants_session;
  const char* const extension = !has_format ? ".json" : wants_balls || balls_only ? ".wpoff" : ".poff";
  uses_.dialogs.browser.ask_save(browse_folder(), name + extension,
                                 remembering([this](const fs::path& file) { files_.save_as(file); }));
}

void DocumentFlow::take_saved() {
  const auto saved = files_.poll_saved();
  if (!saved) return;
  uses_.screen.clock.settle();
  if (saved->error) {
    report(*saved->error);
    after_save_ = {};
    return;
  }
  if (saved->conflict) {
    ask_about(*saved->conflict);
    return;
  }
  std::string names;
  for (const fs::path& file : saved->files) {
    names += (names.empty() ? "" : " and ") + file.string();
    remember_file(uses_.settings, file);
  }
  say_saved(names);
}

// What waits for the save waits for the answer too.
void DocumentFlow::ask_about(const FileConflict& conflict) {
  uses_.dialogs.conflict.ask(conflict, {.overwrite = [this](const FileConflict& of) { files_.overwrite(of); },
                                        .save_as = [this] { ask_save_as(); },
                                        .cancel = [this] { after_save_ = {}; }});
}

void DocumentFlow::say_saved(const std::string& files) {
  uses_.messages.clear_problem();
  uses_.messages.remark("Saved " + files);
  if (!uses_.work.editor().is_modified()) {
    keep();
    keeper_.note_saved();
  }
  const FileDesk::Unsaved rest = files_.unsaved();
  if (!rest.any()) {
    if (const auto then = std::exchange(after_save_, {})) then();
  } else if (after_save_) {
    ask_save_as();
  } else {
    say_still_unsaved(rest);
  }
}

void DocumentFlow::say_still_unsaved(const FileDesk::Unsaved& rest) {
  if (rest.annotations || rest.lesson) {
    const std::string what = !rest.lesson        ? "the annotations"
                             : !rest.annotations ? "the lesson"
                                                 : "the annotations and the lesson";
    uses_.messages.problem("Saved " + files_.title() + "; still unsaved: " + what +
                           " (\"Save as...\" with a name that ends in .json)");
    return;
  }
  const std::string what = rest.samples ? rest.balls ? "the samples and the balls" : "the samples" : "the balls";
  const bool has_file = !(rest.balls ? files_.ball_file() : files_.sample_file()).empty();
  const std::string way =
      has_file ? " (\"Save\" writes both files)"
               : std::string(" (\"Save as...\" with a name that ends in ") + (rest.balls ? ".wpoff)" : ".poff)");
  uses_.messages.problem("Saved " + files_.title() + "; still unsaved: " + what + way);
}

}  // namespace mes
