// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/lesson_editor.h"

#include <algorithm>
#include <cmath>

namespace mes {
namespace {

constexpr std::size_t kMostBefore = 100;

/// The beginning of a UTF-8 text, at most this many bytes, without cutting a letter.
std::string beginning_of(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (bytes > 0 && goes_on(text[bytes])) --bytes;
  return text.substr(0, bytes);
}

}  // namespace

void LessonEditor::follow() {
  if (generation_ == editor_.timeline().generation()) return;
  generation_ = editor_.timeline().generation();
  before_.clear();
  chosen_.reset();
}

std::optional<std::size_t> LessonEditor::chosen() {
  follow();
  if (chosen_ && *chosen_ >= lesson().steps.size()) chosen_.reset();
  return chosen_;
}

bool LessonEditor::can_mark() const {
  return !editor_.in_gesture() && !is_full();
}

LessonStep LessonEditor::moment() {
  LessonStep out{.position = editor_.settle()};
  Look look = look_();
  // Layers that a step does not name are hidden; a step that names none shows the layers of the timeline.
  const auto is_hidden = [](const auto& layer) { return !layer.visible; };
  if (!std::ranges::all_of(look.layers.layers, is_hidden)) std::erase_if(look.layers.layers, is_hidden);
  out.layers = std::move(look.layers);
  out.settings = look.settings;
  out.view = look.view;
  return out;
}

void LessonEditor::change(Lesson next) {
  follow();
  if (next == lesson()) return;
  before_.push_back(lesson());
  if (before_.size() > kMostBefore) before_.erase(before_.begin());
  editor_.set_lesson(std::move(next));
}

void LessonEditor::type(Lesson next) {
  follow();
  if (next == lesson()) return;
  if (typed_ != lesson()) {
    change(std::move(next));
  } else if (!before_.empty() && before_.back() == next) {
    take_back();
  } else {
    editor_.set_lesson(std::move(next));
  }
  typed_ = lesson();
}

void LessonEditor::mark() {
  const std::optional<std::size_t> after = chosen();
  Lesson next = lesson();
  const std::size_t at = after ? *after + 1 : next.steps.size();
  next.steps.insert(next.steps.begin() + static_cast<std::ptrdiff_t>(at), moment());
  change(std::move(next));
  chosen_ = at;
}

void LessonEditor::mark_again() {
  const auto step = chosen();
  if (!step || editor_.in_gesture()) return;
  Lesson next = lesson();
  LessonStep now = moment();
  now.caption = next.steps[*step].caption;
  now.seconds = next.steps[*step].seconds;
  next.steps[*step] = std::move(now);
  change(std::move(next));
}

void LessonEditor::type_title(const std::string& title) {
  Lesson next = lesson();
  next.title = beginning_of(title, kLongestLessonTitle);
  type(std::move(next));
}

void LessonEditor::set_caption(const std::string& caption) {
  end_typing();
  type_caption(caption);
  end_typing();
}

void LessonEditor::type_caption(const std::string& caption) {
  const auto step = chosen();
  if (!step) return;
  Lesson next = lesson();
  next.steps[*step].caption = beginning_of(caption, kLongestLessonCaption);
  type(std::move(next));
}

void LessonEditor::set_seconds(double seconds) {
  const auto step = chosen();
  if (!step || !std::isfinite(seconds)) return;
  Lesson next = lesson();
  next.steps[*step].seconds = std::clamp(seconds, 0.0, kLongestLessonStep);
  change(std::move(next));
}

void LessonEditor::remove() {
  const auto step = chosen();
  if (!step) return;
  Lesson next = lesson();
  next.steps.erase(next.steps.begin() + static_cast<std::ptrdiff_t>(*step));
  // Chooses the next step, or else the previous one.
  chosen_ = std::min(*step, next.steps.size() - 1);
  if (next.steps.empty()) chosen_.reset();
  change(std::move(next));
}

bool LessonEditor::can_move(int places) {
  const auto step = chosen();
  if (!step) return false;
  const auto to = static_cast<std::ptrdiff_t>(*step) + places;
  return to >= 0 && to < static_cast<std::ptrdiff_t>(lesson().steps.size());
}

void LessonEditor::move(int places) {
  if (!can_move(places)) return;
  Lesson next = lesson();
  const auto from = next.steps.begin() + static_cast<std::ptrdiff_t>(*chosen_);
  if (places > 0)
    std::rotate(from, from + 1, from + places + 1);
  else
    std::rotate(from + places, from, from + 1);
  chosen_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(*chosen_) + places);
  change(std::move(next));
}

bool LessonEditor::can_take_back() {
  follow();
  return !before_.empty();
}

void LessonEditor::take_back() {
  if (!can_take_back()) return;
  editor_.set_lesson(std::move(before_.back()));
  before_.pop_back();
}

}  // namespace mes
