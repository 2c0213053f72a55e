// SPDX-License-Identifier: GPL-3.0-or-later
// Plays the timeline of a session: one complete picture after each action.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/layers/layer_stack.h"
#include "app/playing/playback.h"
#include "core/document/timeline/layer_fold.h"
#include "core/engine/engine.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

/// Guarantees: after `apply` and `complete` of the steps in order, document, layers, settings and view are those of
/// that moment, and the patches make up the whole picture; the same session gives the same pictures in every run. The
/// drawing order within a layer depends on earlier steps, so each step must be completed even if nobody looks at it.
/// The cost of a step depends on the changes in its entries, not on earlier ones.
///
/// Smallest use:
///     Player player(registry, session, [&](const FramePatch& patch) { scene.apply(patch); });
///     for (const PlayStep& step : player.steps()) {
///       player.apply(step);
///       player.complete();
///       draw(player.layers(), player.view());
///     }
///
/// Threads: one; the engine has its own.
class Player : private Stage {
 public:
  using OnPatch = std::function<void(const FramePatch&)>;
  /// The registry must outlive it.
  Player(const Registry& registry, const Session& session, OnPatch on_patch);

  const std::vector<PlayStep>& steps() const { return playback_.steps(); }
  /// Error: an entry is invalid; nothing after it can be played.
  Expected<void> apply(const PlayStep& step);
  /// Waits for the picture. Returns what could not be computed, in one line; empty: everything was.
  std::string complete();

  const Document& document() const { return replay_.document(); }
  const History& history() const { return replay_.history(); }
  const LayerStack& layers() const { return layers_; }
  const ComputationSettings& settings() const { return settings_; }
  /// The visible area; empty: everything.
  const Box2& view() const { return view_; }
  const std::string& caption() const { return playback_.caption(); }

 private:
  Expected<void> change_document(const TimelineEntry& entry) override;
  void change_layers(const LayersChanged& change) override;
  void change_settings(const ComputationSettings& settings) override { settings_ = settings; }
  void look_at(const Box2& box) override { view_ = box; }

  std::shared_ptr<const SampleData> data_;
  Playback playback_;
  OnPatch on_patch_;
  LayerStack layers_;
  LayerFold layer_fold_;
  ComputationSettings settings_;
  Box2 view_;
  Engine engine_;
  std::vector<std::shared_ptr<const DocumentDelta>> deltas_;  // changes since the last picture
  DocumentReplay replay_;
  bool has_begun_ = false;
};

}  // namespace mes
