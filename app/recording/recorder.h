// SPDX-License-Identifier: GPL-3.0-or-later
// Decides when a frame is due: whenever the display differs from the last frame and its picture is complete.
//
// Guarantees:
//  1. No frame shows a half-computed picture: a state counts as complete when the engine had no work left for it and
//     all its results were taken.
//  2. While a change waits for its frame, input must be held back: each change gets a frame of its own. A cancelled
//     computation holds nothing back and gives no frame.
//  3. A moving view gets a frame only at rest, and a control in use only after its release; the former is an option.
//
// Smallest use, each turn of the window's loop:
//     recorder.note_complete(is_idle ? now : nullopt);   // before results are taken
//     if (recorder.is_due(now, rest)) { capture(); recorder.note_captured(now); }
//     if (!recorder.holds_input(now, rest)) deliver_events();
//
// Cost: some comparisons. Threads: none.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/layers/legend_scope.h"
#include "app/panes/pane_list.h"
#include "app/settings/scale_marks.h"
#include "core/document/settings/computation_settings.h"
#include "core/document/timeline/timeline.h"
#include "core/draw/layer_descriptor.h"
#include "render/camera.h"

namespace mes {

/// The changeable state on which the picture depends.
struct ShownState {
  std::uint64_t document = 0;  ///< revision, like the next two
  std::uint64_t selection = 0;
  std::uint64_t layers = 0;
  LayerIndex solo = kNoLayer;
  std::uint64_t panes = 0;       ///< revision of the panes beside the main one
  PaneEvolution evolution{};     ///< the evolution whose states panes show; the default if no pane does
  bool has_differences = false;  ///< differences of the panes are marked
  ComputationSettings settings{};
  render::Camera view{};
  std::vector<render::Camera> pane_views{};  ///< for panes beside the main one that have their own camera
  LegendScope legend = LegendScope::none;
  std::optional<PaperPlace> legend_at{};  ///< nothing: the lower right corner
  ScaleMarks marks{};
  bool annotations = true;  ///< annotations are shown
  std::string caption{};
  friend bool operator==(const ShownState&, const ShownState&) = default;
};

/// The things that are at rest, not under the user's hand.
struct AtRest {
  bool view = true;      ///< neither panned nor gliding
  bool controls = true;  ///< no slider, colour or field of a panel is in use
};

enum class Change : std::uint8_t { none, view, texts, selection, layers, panes, settings, document };

class Recorder {
 public:
  Recorder(const ShownState& start, bool each_motion) : captured_(start), each_motion_(each_motion) {}

  /// The state whose results are complete once the available patches have been taken; nothing: still computing.
  void note_complete(const std::optional<ShownState>& state) { complete_ = state; }
  void note_captured(const ShownState& state) { captured_ = state; }

  /// The most important difference from the last frame.
  Change change(const ShownState& now) const;
  bool is_due(const ShownState& now, const AtRest& rest) const;
  /// True if a change has no frame yet, and will get one if nothing else happens.
  bool holds_input(const ShownState& now, const AtRest& rest, bool is_cancelled) const;

 private:
  bool wants_frame(const ShownState& now, const AtRest& rest) const;

  ShownState captured_;
  std::optional<ShownState> complete_{};
  bool each_motion_ = false;
};

/// The name of a change in a manifest; a change of the document has the name of its last entry on the timeline.
std::string name_of(Change change, const TimelineLog& timeline);

}  // namespace mes
