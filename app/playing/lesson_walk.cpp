// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/lesson_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mes {

LessonWalk::LessonWalk(LiveRegistry registry, const Session& session)
    : registry_(std::move(registry)), session_(session), playback_(session.entries) {}

Expected<void> LessonWalk::begin() {
  now_ = start_of(session_);
  begun_with_ = registry_.share();
  layers_.emplace(std::move(now_.layers), [registry = begun_with_](std::string_view layer) {
    return registry->find_layer(layer) != kNoLayer;
  });
  replay_.emplace();
  position_ = 0;
  return replay_->begin(*session_.data);
}

Expected<void> LessonWalk::go_to(std::size_t position) {
  if (!replay_ || position < position_ || registry_.share() != begun_with_)
    if (auto begun = begin(); !begun) {
      replay_.reset();
      return begun;
    }
  auto done = playback_.perform(position_, position, *this);
  position_ = position;
  // The state after an invalid entry is unknown.
  if (!done) replay_.reset();
  return done;
}

Expected<LessonScene> LessonWalk::scene(std::size_t step) {
  const LessonStep& wanted = session_.lesson.steps[step];
  if (auto done = go_to(std::min(wanted.position, session_.entries.size())); !done)
    return std::unexpected(done.error());
  LessonScene out{.data = data_of(replay_->document()),
                  .layers = LayerStack(registry_.now().layers()),
                  .settings = wanted.settings.value_or(now_.settings),
                  .view = wanted.view.is_empty() ? now_.view : wanted.view};
  // Applies the layers of the step to those of the timeline: unnamed layers are hidden and keep their style.
  if (!layers_->configuration().layers.empty()) out.layers.set_configuration(layers_->configuration());
  if (!wanted.layers.layers.empty()) out.layers.set_configuration(wanted.layers);
  return out;
}

double seconds_of(const LessonStep& step) {
  constexpr double kLeast = 4.0;
  constexpr double kMost = 30.0;
  constexpr double kLettersASecond = 15.0;
  if (step.seconds > 0.0) return step.seconds;
  return std::clamp(std::ceil(static_cast<double>(step.caption.size()) / kLettersASecond), kLeast, kMost);
}

}  // namespace mes
