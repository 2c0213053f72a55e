// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and saving, and the questions that go with it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/app.h"

namespace mes {

namespace fs = std::filesystem;

void App::open_first(const WindowOptions& options) {
  if (const std::vector<fs::path> files = without_bundles(options.files); !files.empty()) {
    files_.open(files);
  } else if (!shapes_.empty()) {
    files_.open_shape(shapes_.front().file, shapes_.front().name);
  } else {
    fit_wanted_ = Fit::at_once;
  }
}

void App::with_saved_work(std::function<void()> then) {
  canvas_.cancel_gesture();
  if (files_.is_saving()) {
    after_save_ = [this, then = std::move(then)] { with_saved_work(then); };
    return;
  }
  if (!editor_.is_modified()) {
    then();
    return;
  }
  ask_unsaved_.ask(files_.title(), std::move(then));
}

void App::open_files(const std::vector<std::string>& files, const fs::path& picture) {
  std::vector<fs::path> paths = without_bundles(files);
  if (paths.empty()) {
    if (!picture.empty()) trace_picture(picture);
    return;
  }
  with_saved_work([this, paths = std::move(paths), picture] {
    files_.open(paths);
    traced_with_next_ = picture;
  });
}

void App::open_shape(const SampleShape& shape) {
  with_saved_work([this, shape] {
    traced_with_next_.clear();
    files_.open_shape(shape.file, shape.name);
  });
}

// Another document takes the place of this one: what belongs to this one alone goes (docs/decisions.md).
void App::leave_document() {
  computation_.animation().stop();
  evolution_.resume(evolution_.choice(), 0);
  computation_.set(for_another_document(computation_.settings()));
  layers_.set_image({});
}

void App::take_read_file() {
  const auto outcome = files_.poll();
  if (!outcome) return;
  const fs::path picture = std::exchange(traced_with_next_, {});
  frames_wanted_ = 3;
  if (outcome->error) {
    report(*outcome->error);
    const std::string text = outcome->file.string();
    if (!fs::exists(outcome->file)) std::erase(settings_.recent_files, text);
    return;
  }
  end_demo(true);
  leave_document();
  if (outcome->session) show_as_in(*outcome->session);
  if (!picture.empty()) trace_picture(picture);
  fit_wanted_ = had_first_file_ ? Fit::glide : Fit::at_once;
  // What is to be told at the start stays to be read.
  if (had_first_file_) messages_.clear_problem();
  memory_told_at_.reset();
  tell_of_memory();
  had_first_file_ = true;
  if (!outcome->is_shape)
    for (const fs::path& file : outcome->files) remember_file(settings_, file);
  if (outcome->left_out != 0) {
    const std::size_t opened = outcome->files.size();
    messages_.remark("Opened " + (opened == 1 ? "the first" : std::to_string(opened)) + " of " +
                     std::to_string(opened + outcome->left_out) + " files");
  }
  if (!outcome->warnings.empty()) {
    std::string text = outcome->warnings.front();
    if (outcome->warnings.size() > 1)
      text += " (and " + std::to_string(outcome->warnings.size() - 1) + " more remarks)";
    messages_.problem(text);
  }
}

// Whatever waits for the save goes on once everything is in a file; what has none is asked a name for then.
void App::save() {
  if (files_.file().empty()) {
    ask_save_as();
    return;
  }
  files_.save();
}

void App::take_saved() {
  const auto saved = files_.poll_saved();
  if (!saved) return;
  on_anything();
  if (saved->error) {
    report(*saved->error);
    after_save_ = {};
    return;
  }
  if (saved->conflict) {
    ask_conflict_.ask(*saved->conflict);
    return;
  }
  std::string names;
  for (const fs::path& file : saved->files) {
    names += (names.empty() ? "" : " and ") + file.string();
    remember_file(settings_, file);
  }
  say_saved(names);
}

void App::say_saved(const std::string& files) {
  messages_.clear_problem();
  messages_.remark("Saved " + files);
  if (!editor_.is_modified()) {
    keep_timeline();
    autosave_.note_saved();
  }
  const FileDesk::Unsaved rest = files_.unsaved();
  if (!rest.samples && !rest.balls) {
    if (const auto then = std::exchange(after_save_, {})) then();
    return;
  }
  if (after_save_) {
    ask_save_as();
    return;
  }
  const std::string what = rest.samples ? rest.balls ? "the samples and the balls" : "the samples" : "the balls";
  const bool has_file = !(rest.balls ? files_.ball_file() : files_.sample_file()).empty();
  messages_.problem(
      "Saved " + files_.title() + "; still unsaved: " + what +
      (has_file ? " (\"Save\" writes both files)"
                : std::string(" (\"Save as...\" with a name that ends in ") + (rest.balls ? ".wpoff)" : ".poff)")));
}

void App::ask_save_as() {
  std::string name = fs::path(files_.title()).stem().string();
  std::ranges::replace(name, '/', '-');
  const FileDesk::Unsaved rest = files_.unsaved();
  const bool balls_only = editor_.document().sample_count() == 0 && editor_.document().ball_count() != 0;
  const bool wants_balls = rest.balls && !rest.samples;
  const bool has_format = !files_.file().empty() && !files_.has_session_file();
  const char* const extension = !has_format ? ".json" : wants_balls || balls_only ? ".wpoff" : ".poff";
  browser_.ask_save(browse_folder(), name + extension);
}

fs::path App::browse_folder() const {
  std::error_code error;
  if (!files_.file().empty()) return files_.file().parent_path();
  if (!settings_.last_folder.empty() && fs::is_directory(settings_.last_folder, error)) return settings_.last_folder;
  return fs::current_path(error);
}

// What waits for the save waits for the answer too.
void App::draw_conflict() {
  switch (ask_conflict_.draw(gui_)) {
    case AskConflict::Answer::none: break;
    case AskConflict::Answer::cancel:
      ask_conflict_.close();
      after_save_ = {};
      break;
    case AskConflict::Answer::overwrite: files_.overwrite(ask_conflict_.take()); break;
    case AskConflict::Answer::save_as:
      ask_conflict_.close();
      ask_save_as();
      break;
  }
}

void App::draw_dialogs() {
  switch (ask_unsaved_.draw(gui_)) {
    case AskUnsaved::Answer::none: break;
    case AskUnsaved::Answer::cancel: ask_unsaved_.close(); break;
    case AskUnsaved::Answer::discard:
      if (const auto then = ask_unsaved_.take_then()) then();
      break;
    case AskUnsaved::Answer::save:
      after_save_ = ask_unsaved_.take_then();
      save();
      break;
  }
  switch (ask_recover_.draw(gui_)) {
    case AskRecover::Answer::none: break;
    case AskRecover::Answer::later: ask_recover_.close(); break;
    case AskRecover::Answer::discard: ask_recover_.take().remove(); break;
    case AskRecover::Answer::recover: with_saved_work([this] { recover(ask_recover_.take()); }); break;
  }
  draw_conflict();
  const bool was_saving = browser_.is_saving();
  if (const auto chosen = browser_.draw(gui_)) {
    settings_.last_folder = chosen->parent_path().string();
    if (const auto then = std::exchange(when_chosen_, {})) {
      then(*chosen);
    } else if (!was_saving) {
      if (const std::vector<fs::path> files = without_bundles({chosen->string()}); !files.empty()) {
        traced_with_next_.clear();
        files_.open(files);
      }
    } else {
      files_.save_as(*chosen);
    }
  }
  if (!browser_.is_open()) {
    if (!files_.is_saving() && !ask_conflict_.is_open()) after_save_ = {};
    when_chosen_ = {};
  }
}

void App::remember_settings() {
  const auto size = window_->size();
  const double units = window_->content_scale() / window_->pixel_ratio();
  settings_.window_width = static_cast<int>(std::lround(size.width / units));
  settings_.window_height = static_cast<int>(std::lround(size.height / units));
  // Nobody is left to be told when this fails.
  std::error_code error;
  const Settings now =
      fs::exists(settings_path_, error) ? load_settings(settings_path_).settings : settings_at_start_;
  static_cast<void>(save_settings(merged(settings_, settings_at_start_, now), settings_path_));
}

}  // namespace mes
