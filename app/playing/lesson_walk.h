// SPDX-License-Identifier: GPL-3.0-or-later
// The displays of the steps of a lesson: the timeline of its session, replayed up to each of them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "app/layers/layer_stack.h"
#include "app/playing/playback.h"
#include "core/document/timeline/layer_fold.h"
#include "core/graph/live_registry.h"
#include "core/io/session/session.h"

namespace mes {

/// A complete step of a lesson: the timeline supplies everything that the step does not set.
struct LessonScene {
  SampleData data;
  LayerStack layers;
  ComputationSettings settings{};
  Box2 view{};  ///< empty: everything
};

/// Guarantees: a scene depends only on session, registry and step, not on earlier calls. Cost: moving to a later step
/// takes the changes in the entries between, moving to an earlier one a replay from the beginning; each scene copies
/// the samples. Threads: none.
///
/// Smallest use:
///     LessonWalk walk(registry, session);
///     for (std::size_t i = 0; i < session.lesson.steps.size(); ++i) show(walk.scene(i));
class LessonWalk : private Stage {
 public:
  /// The session must outlive it.
  LessonWalk(LiveRegistry registry, const Session& session);

  /// Error: an invalid entry, with its name.
  Expected<LessonScene> scene(std::size_t step);

 private:
  Expected<void> go_to(std::size_t position);
  Expected<void> begin();
  Expected<void> change_document(const TimelineEntry& entry) override { return replay_->apply(entry); }
  void change_layers(const LayersChanged& change) override { layers_->apply(change); }
  void change_settings(const ComputationSettings& settings) override { now_.settings = settings; }
  void look_at(const Box2& box) override { now_.view = box; }

  LiveRegistry registry_;
  std::shared_ptr<const Registry> begun_with_;  // the registry of the layers in `layers_`
  const Session& session_;
  Playback playback_;
  PlayStart now_;  // its layers are in `layers_`
  std::optional<LayerFold> layers_;
  std::optional<DocumentReplay> replay_;  // empty: not begun
  std::size_t position_ = 0;
};

/// The duration of a step in a video: the given one, or else the time needed to read its caption.
double seconds_of(const LessonStep& step);

}  // namespace mes
