// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of a lesson show: the timeline of its session, replayed up to each of them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "app/layers/layer_stack.h"
#include "app/playing/playback.h"
#include "core/document/layer_fold.h"
#include "core/graph/live_registry.h"
#include "core/io/session/session.h"

namespace mes {

/// A step of a lesson, complete: what it does not say itself is as the timeline has it.
struct LessonScene {
  SampleData data;
  LayerStack layers;
  ComputationSettings settings{};
  Box2 view{};  ///< empty: everything
};

/// What it guarantees: a scene depends on the session, the registry and the step alone, not on the scenes that were asked for before.
/// Cost: a step is reached from the one before it by what its entries change, and one that lies before that by a replay
/// from the beginning; each scene copies the samples. Threads: none.
///
/// Smallest use:
///     LessonWalk walk(registry, session);
///     for (std::size_t i = 0; i < session.lesson.steps.size(); ++i) show(walk.scene(i));
class LessonWalk : private Stage {
 public:
  /// The session has to outlive it.
  LessonWalk(LiveRegistry registry, const Session& session);

  /// Error: an entry makes no sense, and is named.
  Expected<LessonScene> scene(std::size_t step);

 private:
  Expected<void> go_to(std::size_t position);
  Expected<void> begin();
  Expected<void> change_document(const TimelineEntry& entry) override { return replay_->apply(entry); }
  void change_layers(const LayersChanged& change) override { layers_->apply(change); }
  void change_settings(const ComputationSettings& settings) override { now_.settings = settings; }
  void look_at(const Box2& box) override { now_.view = box; }

  LiveRegistry registry_;
  std::shared_ptr<const Registry> begun_with_;  // whose layers are in `layers_`
  const Session& session_;
  Playback playback_;
  PlayStart now_;  // its layers are in `layers_`
  std::optional<LayerFold> layers_;
  std::optional<DocumentReplay> replay_;  // none: not begun
  std::size_t position_ = 0;
};

/// How long a step stays in a video: what it says, or else as long as its words need to be read.
double seconds_of(const LessonStep& step);

}  // namespace mes
