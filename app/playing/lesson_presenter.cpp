// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/lesson_presenter.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace mes {
namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr double kLongestPlay = 3.0;     // seconds
constexpr double kShortestEdit = 0.025;  // seconds; shorter edits are shown several per picture
constexpr double kLongestEdit = 0.35;

}  // namespace

Expected<void> LessonPresenter::start(std::shared_ptr<const Session> session, std::size_t step) {
  end();
  if (session->lesson.steps.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "the lesson has no steps", session->title});
  const Session& lesson = *session;
  Editor::Aside aside = uses_.editor.put_aside();
  run_.emplace(Run{.session = std::move(session),
                   .walk = LessonWalk(uses_.registry, lesson),
                   .aside = std::move(aside),
                   .layers_before = uses_.layers.configuration(),
                   .settings_before = uses_.settings()});
  auto done = replay_to(0);
  if (done) done = show(std::min(step, step_count() - 1));
  if (!done) end();
  return done;
}

void LessonPresenter::end() {
  if (!run_) return;
  Run run = std::move(*run_);
  run_.reset();
  uses_.layers.set_configuration(run.layers_before);
  uses_.set_settings(run.settings_before);
  uses_.editor.take_up(std::move(run.aside));
}

const std::string& LessonPresenter::title() const {
  return lesson().title.empty() ? run_->session->title : lesson().title;
}

Expected<void> LessonPresenter::go_on() {
  if (is_playing() && !is_edited()) return bring_document_to(std::exchange(run_->play_end, 0));
  return run_->step + 1 < step_count() ? go_to(run_->step + 1) : Expected<void>();
}

Expected<void> LessonPresenter::go_back() {
  return run_->step > 0 ? go_to(run_->step - 1) : Expected<void>();
}

Expected<void> LessonPresenter::go_to(std::size_t step) {
  return show(std::min(step, step_count() - 1));
}

bool LessonPresenter::is_edited() const {
  return run_->has_own || uses_.editor.document().revision() != run_->revision;
}

Expected<void> LessonPresenter::restore() {
  run_->has_own = false;
  if (auto done = undo_edits(); !done) return done;
  return show(run_->step);
}

// Makes the scene first, which shows whether the entries are valid.
Expected<void> LessonPresenter::show(std::size_t step) {
  auto scene = run_->walk.scene(step);
  if (!scene) return std::unexpected(scene.error());
  const std::size_t position = std::min(lesson().steps[step].position, run_->session->entries.size());
  const bool is_next = step == run_->step + 1;
  run_->play_end = 0;
  run_->step = step;
  run_->has_own = run_->has_own || (keeps_edits_ && is_edited());
  if (!run_->has_own)
    if (auto done = undo_edits(); !done) return done;
  // Undoing may change layers, so those of the step are set afterwards.
  show_around(*scene);
  if (run_->has_own) return {};
  if (is_next && plays_edits_ && position > run_->position) {
    begin_playing(position);
    return {};
  }
  return bring_document_to(position);
}

void LessonPresenter::show_around(const LessonScene& scene) {
  uses_.layers.set_configuration(scene.layers.configuration());
  uses_.set_settings(scene.settings);
  uses_.look_at(scene.view);
  uses_.editor.take_layers_as_noted();
}

Expected<void> LessonPresenter::undo_edits() {
  Editor& editor = uses_.editor;
  editor.cancel_gesture();
  while (editor.document().revision() != run_->revision && editor.can_undo()) editor.undo();
  return editor.document().revision() == run_->revision ? Expected<void>() : replay_to(run_->position);
}

Expected<void> LessonPresenter::bring_document_to(std::size_t position) {
  if (position < run_->position) return replay_to(position);
  return perform_edits(position, kAll);
}

Expected<void> LessonPresenter::replay_to(std::size_t position) {
  const Session& session = *run_->session;
  DocumentReplay replay(uses_.editor.document());
  TimelineLog entries;
  bool in_gesture = false;
  auto done = replay.begin(*session.data);
  for (std::size_t i = 0; done && i < position; ++i) {
    const TimelineEntry entry = session.entries[i];
    done = replay.apply(entry);
    entries.push_back(entry);
    if (std::holds_alternative<GestureBegun>(entry)) in_gesture = true;
    if (std::holds_alternative<GestureEnded>(entry)) in_gesture = false;
  }
  if (!done) return done;
  if (in_gesture) entries.push_back(GestureEnded{});
  uses_.editor.restore(std::move(replay), session.data, std::move(entries));
  run_->position = position;
  note_shown();
  return {};
}

void LessonPresenter::begin_playing(std::size_t end) {
  std::size_t edits = 0;
  for (std::size_t i = run_->position; i < end; ++i) edits += changes_document(run_->session->entries[i]) ? 1U : 0U;
  if (edits == 0) {
    run_->position = end;
    return;
  }
  const double each = kLongestPlay / static_cast<double>(edits);
  run_->seconds_each = std::clamp(each, kShortestEdit, kLongestEdit);
  run_->edits_at_once = std::max<std::size_t>(1, static_cast<std::size_t>(kShortestEdit / each));
  run_->play_end = end;
  run_->not_before = 0.0;
}

std::optional<double> LessonPresenter::next_due(double now) const {
  return is_playing() ? std::optional(run_->not_before - now) : std::nullopt;
}

bool LessonPresenter::advance(double now, bool may_step) {
  if (!is_playing() || !may_step || now < run_->not_before) return false;
  // An edit by hand interrupts the playback; the remaining edits are made when the lesson continues.
  if (is_edited()) {
    run_->play_end = 0;
    return false;
  }
  const std::size_t end = run_->play_end;
  const auto done = perform_edits(end, run_->edits_at_once);
  run_->not_before = now + run_->seconds_each;
  if (!done || run_->position == end) run_->play_end = 0;
  return true;
}

// Omits gestures, so that none is open when the user edits by hand; a replay then finds the results of undo and redo.
Expected<void> LessonPresenter::perform_edits(std::size_t end, std::size_t most) {
  Editor& editor = uses_.editor;
  if (run_->position < end && !has_numbers_of_lesson())
    if (auto done = replay_to(run_->position); !done) return done;
  for (std::size_t edits = 0; run_->position < end && edits < most; ++edits) {
    const TimelineEntry entry = run_->session->entries[run_->position];
    const auto* const edit = std::get_if<TimelineEdit>(&entry);
    if (edit != nullptr && edit->replaces) editor.undo_edit();
    const bool is_done = edit == nullptr ? !changes_document(entry) : editor.perform(*edit).has_value();
    if (!is_done) {
      if (auto done = replay_to(run_->position + 1); !done) return done;
      continue;
    }
    ++run_->position;
    if (edit == nullptr) --edits;
  }
  note_shown();
  return {};
}

// Samples inserted by hand have used up ids, even if they were removed again.
bool LessonPresenter::has_numbers_of_lesson() const {
  const Document& document = uses_.editor.document();
  return document.next_id() == run_->next_sample && document.next_ball_id() == run_->next_ball;
}

void LessonPresenter::note_shown() {
  const Document& document = uses_.editor.document();
  run_->revision = document.revision();
  run_->next_sample = document.next_id();
  run_->next_ball = document.next_ball_id();
  uses_.editor.take_layers_as_noted();
  uses_.editor.mark_saved();
}

}  // namespace mes
