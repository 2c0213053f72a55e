// SPDX-License-Identifier: GPL-3.0-or-later
// What is read, dropped or recovered becomes the document of the window.
#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "app/playing/session_evolution.h"
#include "app/window/document_flow.h"
#include "core/io/bundle_file.h"
#include "imgui.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

/// Takes the pictures out. Of several the last is on top; the others would not be seen.
std::string take_picture(std::vector<std::string>& files) {
  const auto first = std::stable_partition(files.begin(), files.end(),
                                           [](const std::string& file) { return !is_picture_to_trace(file); });
  std::string picture = first == files.end() ? std::string() : files.back();
  files.erase(first, files.end());
  return picture;
}

}  // namespace

void DocumentFlow::open_first(std::vector<std::string> files) {
  const std::string picture = take_picture(files);
  if (const std::vector<fs::path> documents = without_bundles(files); !documents.empty()) {
    open_documents(documents);
    traced_with_next_ = picture;
    return;
  }
  if (!shapes_.empty())
    files_.open_shape(shapes_.front().file, shapes_.front().name);
  else
    uses_.board.fitter().want(ViewFitter::How::at_once);
  if (!picture.empty()) tracing_.open(picture);
}

void DocumentFlow::open_documents(const std::vector<fs::path>& files) {
  files_.open(files, degrees_wanted());
}

MapDegrees DocumentFlow::degrees_wanted() const {
  return uses_.settings.keep_degrees ? MapDegrees::kept : MapDegrees::projected;
}

// Not when what is open has been saved to a file of its own since, nor when it is as it is wanted: where the question about
// unsaved work was cancelled, the setting has changed and the map has not.
void DocumentFlow::read_map_again() {
  // What is being read comes first, and may be a map itself; `take_results` asks again when it has ended.
  reads_map_again_ = files_.is_reading();
  if (reads_map_again_ || map_files_.empty() || has_own_file() || map_degrees_ == degrees_wanted()) return;
  with_saved_work([this, files = map_files_] {
    if (has_own_file()) return;  // saved by the answer
    traced_with_next_.clear();
    open_documents(files);
  });
}

// A file of balls that was opened with the map is read again with it.
bool DocumentFlow::has_own_file() const {
  const fs::path& balls = files_.ball_file();
  const bool are_balls_of_map = balls.empty() || std::ranges::find(map_files_, balls) != map_files_.end();
  return files_.has_session_file() || !files_.sample_file().empty() || !are_balls_of_map;
}

void DocumentFlow::open(std::vector<std::string> files) {
  const std::string picture = take_picture(files);
  open_with_picture(files, picture);
}

void DocumentFlow::open_with_picture(const std::vector<std::string>& files, const fs::path& picture) {
  std::vector<fs::path> documents = without_bundles(files);
  if (documents.empty()) {
    if (!picture.empty()) tracing_.open(picture);
    return;
  }
  with_saved_work([this, documents = std::move(documents), picture] {
    open_documents(documents);
    traced_with_next_ = picture;
  });
}

void DocumentFlow::open_shape(const SampleShape& shape) {
  with_saved_work([this, shape] {
    traced_with_next_.clear();
    files_.open_shape(shape.file, shape.name);
  });
}

// A lesson that the program makes is presented beside the document that is open.
void DocumentFlow::open_lesson(const ShippedLesson& lesson) {
  if (lesson.file.empty()) {
    if (files_.is_reading() || files_.is_saving()) return;
    const auto session = demo_of(uses_.work.registry(), shapes_);
    if (!session) return report(session.error());
    uses_.demo.end(true);
    return uses_.lesson.start(*session);
  }
  with_saved_work([this, lesson] {
    traced_with_next_.clear();
    files_.open_shape(lesson.file, lesson.title);
    presents_next_ = true;
  });
}

std::vector<fs::path> DocumentFlow::without_bundles(const std::vector<std::string>& files) {
  std::vector<fs::path> rest;
  for (const std::string& file : files) {
    if (is_bundle_file(file))
      uses_.work.import_bundles(file);
    else
      rest.emplace_back(file);
  }
  return rest;
}

void DocumentFlow::ask_before_read_file() {
  if (!files_.would_lose_work()) {
    asks_about_read_ = false;
    return;
  }
  const bool is_in_question = uses_.dialogs.unsaved.is_open() || files_.is_saving() || after_save_;
  if (asks_about_read_) {
    if (is_in_question) return;
    if (!recovering_) uses_.messages.remark(files_.reading_name() + " was read, and not opened");
    files_.cancel_reading();
    return;
  }
  // One thing after the other.
  const bool is_busy = uses_.board.canvas().has_pointer() || ImGui::IsAnyItemActive();
  if (is_in_question || is_busy || !uses_.dialogs.open().empty()) return;
  asks_about_read_ = true;
  uses_.screen.clock.settle();
  with_saved_work([this] { files_.give_up_work(); },
                  fmt::format("{} has been read, and takes its place", files_.reading_name()));
}

void DocumentFlow::take_read_file() {
  const auto outcome = files_.poll();
  if (!outcome) {
    if (files_.is_reading()) return;
    // After a reading that was given up, too.
    traced_with_next_.clear();
    presents_next_ = false;
    if (std::exchange(recovering_, std::nullopt)) say_left_work_waits();
    return;
  }
  const fs::path picture = std::exchange(traced_with_next_, {});
  const bool presents = std::exchange(presents_next_, false);
  std::optional<LeftWork> recovered = std::exchange(recovering_, std::nullopt);
  uses_.screen.clock.settle();
  if (outcome->error) {
    report(*outcome->error);
    if (recovered) say_left_work_waits();
    if (!fs::exists(outcome->file)) std::erase(uses_.settings.recent_files, outcome->file.string());
    return;
  }
  if (outcome->is_recovered && recovered) return take_recovered(*outcome, *std::move(recovered));
  uses_.demo.end(true);
  leave_document();
  if (outcome->degrees) {
    map_files_ = outcome->files;
    map_degrees_ = *outcome->degrees;
  }
  if (outcome->session) show_as_in(*outcome->session);
  if (!picture.empty()) uses_.board.traced().trace(picture);
  uses_.board.fitter().want(had_first_file_ ? ViewFitter::How::glide : ViewFitter::How::at_once);
  // Messages from the start stay on screen.
  if (had_first_file_) uses_.messages.clear();
  uses_.board.note_new_document();
  had_first_file_ = true;
  say_opened(*outcome);
  if (!outcome->remark.empty()) uses_.messages.remark(outcome->remark);
  if (recovered) say_left_work_waits();
  if (!when_presentable().holds()) return;
  if (presents)
    uses_.lesson.start(session_now());
  else if (outcome->warnings.empty())
    uses_.messages.remark("It holds a lesson: Help > Lessons > Present the lesson shows its steps");
}

void DocumentFlow::say_opened(const FileDesk::Outcome& outcome) {
  if (!outcome.is_shape && !outcome.is_made)
    for (const fs::path& file : outcome.files) remember_file(uses_.settings, file);
  if (outcome.left_out != 0) {
    const std::size_t opened = outcome.files.size();
    uses_.messages.remark(fmt::format("Opened {} of {} files: a document has one set of samples, and one of balls",
                                      opened == 1 ? "the first" : std::to_string(opened), opened + outcome.left_out));
  }
  std::vector<std::string> warnings = outcome.warnings;
  if (!warnings.empty() && outcome.degrees == MapDegrees::projected && outcome.files.size() == 1)
    warnings.front() += fmt::format(" (File > {} leaves them)", descriptor_of(ActionId::keep_degrees).name);
  uses_.messages.problems(warnings);
}

Session DocumentFlow::session_now() const {
  const Timeline& timeline = uses_.work.editor().timeline();
  return {.title = files_.title(),
          .data = timeline.data(),
          .entries = timeline.entries(),
          .layers = uses_.work.layers().configuration(),
          .settings = uses_.work.computation().settings(),
          .evolution = uses_.work.evolution_now(),
          .view = uses_.board.view().free_box(),
          .lesson = timeline.lesson(),
          .panes = uses_.work.panes_now(),
          .pane_views = uses_.board.pane_views()};
}

void DocumentFlow::show_as_in(const Session& session) {
  LayerStack& layers = uses_.work.layers();
  Editor& editor = uses_.work.editor();
  layers.forget_missing();
  if (!session.layers.layers.empty()) layers.set_configuration(session.layers);
  uses_.work.take_family_of_layers();
  uses_.work.computation().set(session.settings);
  uses_.work.evolution().resume(choice_of(uses_.work.registry(), session.evolution), session.evolution.step);
  uses_.work.panes().set(session.panes);
  uses_.work.panes().resolve(uses_.work.registry());
  uses_.work.panes().set_free_cameras(!session.pane_views.empty());
  uses_.board.see_in_panes(session.pane_views);
  if (!session.view.is_empty()) uses_.board.fitter().set_target(session.view);
  editor.take_layers_as_noted();
  if (files_.has_session_file()) editor.set_saved_layers(layers.configuration());
  keeper_.take_as_noted(session.view);
}

void DocumentFlow::offer_left_work() {
  auto found = keeper_.take_left_work();
  if (!found || !offers_left_work_) return;
  if (!found->message.empty()) uses_.messages.problem(found->message);
  AskRecover& question = uses_.dialogs.recover;
  question.offer(std::move(found->works), [this, &question] {
    with_saved_work([this, &question] {
      if (auto work = question.take()) recover(*std::move(work));
    });
  });
  uses_.screen.clock.settle();
}

void DocumentFlow::say_left_work_waits() {
  uses_.messages.remark("The work that was left is offered again at the next start");
}

// The end of a demo marks the document as saved, so it comes before recovered work is the document.
void DocumentFlow::recover(LeftWork work) {
  uses_.demo.end(true);
  if (files_.is_reading())
    uses_.messages.problem(files_.reading_name() + " is not opened: work that was left is recovered");
  traced_with_next_.clear();
  recovering_.emplace(std::move(work));
  uses_.dialogs.recover.set_waits(true);
  files_.recover(recovering_->shared_session());
}

void DocumentFlow::take_recovered(const FileDesk::Outcome& outcome, LeftWork work) {
  uses_.messages.remark("Recovered " + files_.title() + "; no file holds it yet");
  leave_document();
  uses_.board.note_new_document();
  show_as_in(*outcome.session);
  uses_.board.fitter().want(ViewFitter::How::at_once);
  had_first_file_ = true;
  keep();
  recovered_.push_back(std::move(work));
}

void DocumentFlow::remove_recovered() {
  if (recovered_.empty() || uses_.lesson.is_running()) return;
  if (uses_.work.editor().is_modified() && !keeper_.holds_all()) return;
  for (LeftWork& work : recovered_) work.remove();
  recovered_.clear();
}

}  // namespace mes
