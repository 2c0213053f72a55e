// SPDX-License-Identifier: GPL-3.0-or-later
// Decides when a frame is due: whenever what is shown differs from the last frame and its picture is complete.
//
// What it guarantees:
//  1. No frame of a half-computed picture: a state counts as complete when the engine had nothing to do for it and
//     all its results were taken.
//  2. While a change waits for its frame, input is to be held back: each change gets a frame of its own. A cancelled
//     computation holds nothing back and gives no frame.
//  3. A view in motion waits until it is at rest, and a control in use until it is let go; the former is an option.
//
// Smallest use, each turn of the window's loop:
//     recorder.note_complete(is_idle ? now : nullopt);   // before results are taken
//     if (recorder.is_due(now, rest)) { capture(); recorder.note_captured(now); }
//     if (!recorder.holds_input(now, rest)) deliver_events();
//
// Cost: comparisons. Threads: none.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/layers/legend_scope.h"
#include "app/model/pane_list.h"
#include "app/model/scale_marks.h"
#include "core/document/computation_settings.h"
#include "core/document/timeline.h"
#include "core/draw/layer_descriptor.h"
#include "render/camera.h"

namespace mes {

/// All that the picture depends on and that can change.
struct ShownState {
  std::uint64_t document = 0;  ///< revisions
  std::uint64_t selection = 0;
  std::uint64_t layers = 0;
  LayerIndex solo = kNoLayer;
  std::uint64_t panes = 0;       ///< what is shown beside the main one
  PaneEvolution evolution{};     ///< that panes show states of; as at the start where none does
  bool has_differences = false;  ///< of the panes, marked
  ComputationSettings settings{};
  render::Camera view{};
  std::vector<render::Camera> pane_views{};  ///< of panes beside the main one that have their own
  LegendScope legend = LegendScope::none;
  std::optional<PaperPlace> legend_at{};  ///< none: the lower right corner
  ScaleMarks marks{};
  bool annotations = true;  ///< shown
  std::string caption{};
  friend bool operator==(const ShownState&, const ShownState&) = default;
};

/// What is still under way by the user's hand.
struct AtRest {
  bool view = true;      ///< neither panned nor gliding
  bool controls = true;  ///< no slider, colour or field of a panel is in use
};

enum class Change : std::uint8_t { none, view, texts, selection, layers, panes, settings, document };

class Recorder {
 public:
  Recorder(const ShownState& start, bool each_motion) : captured_(start), each_motion_(each_motion) {}

  /// The state whose results are complete once the patches that are there have been taken; none: still computing.
  void note_complete(const std::optional<ShownState>& state) { complete_ = state; }
  void note_captured(const ShownState& state) { captured_ = state; }

  /// The weightiest difference from the last frame.
  Change change(const ShownState& now) const;
  bool is_due(const ShownState& now, const AtRest& rest) const;
  /// A change has no frame yet, and will get one if nothing else happens.
  bool holds_input(const ShownState& now, const AtRest& rest, bool is_cancelled) const;

 private:
  bool wants_frame(const ShownState& now, const AtRest& rest) const;

  ShownState captured_;
  std::optional<ShownState> complete_{};
  bool each_motion_ = false;
};

/// What a manifest says of it; a change of the document has the name that the timeline gives to its last one.
std::string name_of(Change change, const TimelineLog& timeline);

}  // namespace mes
