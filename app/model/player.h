// SPDX-License-Identifier: GPL-3.0-or-later
// A session's timeline, played: one complete picture after each thing that happened.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/model/layer_stack.h"
#include "core/document/layer_fold.h"
#include "core/engine/engine.h"
#include "core/io/session.h"

namespace mes {

/// What follows each other without a picture of its own between, and the picture after it.
struct PlayStep {
  std::size_t first_entry = 0;
  std::size_t end_entry = 0;  ///< one past the last
  std::string_view what;      ///< of the entry that made the picture: "edit", "undo", "layers", ...
  double seconds = 0.0;       ///< how long it stays in a video; 0: as long as any
};

/// Everything before the first thing that was done is the first step, then each entry that can be seen is one.
std::vector<PlayStep> steps_of(const TimelineLog& entries);

/// What it guarantees: after `apply` and `complete` of the steps in order, document, layers, settings and view are
/// those of that moment, and the patches handed on make the whole picture; the same session gives the same pictures
/// in every run. What is drawn first within a layer depends on the steps before, so each step is to be completed also
/// where no caller looks at it. The cost of a step grows with what its entries change, not with what came before.
///
/// Smallest use:
///     Player player(session, [&](const FramePatch& patch) { scene.apply(patch); });
///     for (const PlayStep& step : player.steps()) {
///       player.apply(step);
///       player.complete();
///       draw(player.layers(), player.view());
///     }
///
/// Threads: one; the engine has its own.
class Player {
 public:
  using OnPatch = std::function<void(const FramePatch&)>;
  Player(const Session& session, OnPatch on_patch);

  const std::vector<PlayStep>& steps() const { return steps_; }
  /// Error: an entry makes no sense; nothing after it can be played.
  Expected<void> apply(const PlayStep& step);
  /// Waits for the picture. What failed to be computed, one line; empty: nothing.
  std::string complete();

  const Document& document() const { return replay_.document(); }
  const LayerStack& layers() const { return layers_; }
  const ComputationSettings& settings() const { return settings_; }
  /// What is to be seen; empty: everything.
  const Box2& view() const { return view_; }
  const std::string& caption() const { return caption_; }

 private:
  Expected<void> apply(const TimelineEntry& entry);

  Session session_;
  std::vector<PlayStep> steps_;
  OnPatch on_patch_;
  LayerStack layers_;
  LayerFold layer_fold_;
  ComputationSettings settings_;
  Box2 view_;
  std::string caption_;
  Engine engine_;
  std::vector<std::shared_ptr<const DocumentDelta>> deltas_;  // of the steps since the last picture
  DocumentReplay replay_;
  bool has_begun_ = false;
};

}  // namespace mes
