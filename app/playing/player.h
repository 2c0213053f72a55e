// SPDX-License-Identifier: GPL-3.0-or-later
// A session's timeline, played: one complete picture after each thing that happened.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/layers/layer_stack.h"
#include "app/playing/playback.h"
#include "core/document/layer_fold.h"
#include "core/engine/engine.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

/// What it guarantees: after `apply` and `complete` of the steps in order, document, layers, settings and view are
/// those of that moment, and the patches handed on make the whole picture; the same session gives the same pictures
/// in every run. What is drawn first within a layer depends on the steps before, so each step is to be completed also
/// where no caller looks at it. The cost of a step grows with what its entries change, not with what came before.
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
  /// The registry has to outlive it.
  Player(const Registry& registry, const Session& session, OnPatch on_patch);

  const std::vector<PlayStep>& steps() const { return playback_.steps(); }
  /// Error: an entry makes no sense; nothing after it can be played.
  Expected<void> apply(const PlayStep& step);
  /// Waits for the picture. What failed to be computed, one line; empty: nothing.
  std::string complete();

  const Document& document() const { return replay_.document(); }
  const History& history() const { return replay_.history(); }
  const LayerStack& layers() const { return layers_; }
  const ComputationSettings& settings() const { return settings_; }
  /// What is to be seen; empty: everything.
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
  std::vector<std::shared_ptr<const DocumentDelta>> deltas_;  // of the steps since the last picture
  DocumentReplay replay_;
  bool has_begun_ = false;
};

}  // namespace mes
