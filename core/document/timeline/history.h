// SPDX-License-Identifier: GPL-3.0-or-later
// Unlimited undo and redo of document edits and of layer changes. A gesture is one step, however many deltas it made.
//
// Smallest use:
//     history.begin_gesture("Move samples");
//     document.apply(moved); history.record(moved);  // once or often
//     history.end_gesture();
//     for (const DocumentDelta& delta : history.undo()) document.apply(delta);
//
// Moves of the same samples within one gesture are merged, so that an hour of dragging uses the memory of one step.
//
// Steps that edit the document and steps that change layers are independent, so their order can be swapped: the last
// edit can be undone below later layer changes (`raise_edit`), and a layer change keeps the edits that can be redone.
// It discards the layer changes that can be redone, and an edit discards the edits.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/delta.h"
#include "core/document/timeline/layers_changed.h"

namespace mes {

class History {
  struct Step;

 public:
  /// All deltas until `end_gesture` form one step called `name`. Gestures do not nest. `end_gesture` allocates nothing.
  void begin_gesture(std::string name);
  void end_gesture();
  bool in_gesture() const { return gesture_open_; }
  /// The deltas of the open gesture, moves merged.
  std::span<const DocumentDelta> gesture() const { return gesture_.deltas; }
  /// An edit is a step of its own (`plain`), or continues the last step, or leads to a state of an evolution. State 0
  /// is the document before that edit.
  enum class Role : std::uint8_t { plain, continues, state };
  /// Records an applied delta. Outside a gesture it becomes a step, or extends the last one where `extend` is possible.
  /// Discards the steps that could be redone.
  void record(const DocumentDelta& delta, const std::string& name = {}, Role role = Role::plain);

  /// A prepared step, to be recorded once everything else has succeeded: all memory is reserved, so `record` allocates
  /// nothing. An unrecorded draft leaves no trace. While it exists, only `undo` and `raise_edit` of the history may be
  /// called.
  class Draft {
   public:
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft();
    void record() noexcept;

   private:
    friend class History;
    Draft(History& history, Step step, bool extends);
    History& history_;
    std::unique_ptr<Step> step_;
    bool extends_;
    bool is_recorded_ = false;
  };
  /// Prepares what `record` would do.
  Draft draft(const DocumentDelta& delta, const std::string& name, Role role = Role::plain);

  /// Appends the delta to the newest step if the step has this name, nothing happened in between, and the delta only
  /// moves the same things. Returns whether it did; otherwise nothing is recorded. Allocates nothing.
  bool extend(const DocumentDelta& delta, const std::string& name);

  /// A layer change and its inverse.
  struct Layers {
    LayersChanged change{};
    LayersChanged back{};
  };
  /// Records a layer change as a step. Not within a gesture.
  void record_layers(Layers layers, const std::string& name);
  Draft draft(Layers layers, const std::string& name);
  /// Adds a layer change to the newest step, or to the open gesture; returns false if there is none.
  bool join_layers(Layers layers);
  /// Layer change that `undo` (`redo`) makes besides its deltas; null if none.
  const LayersChanged* layers_of_undo() const;
  const LayersChanged* layers_of_redo() const;
  /// Whether `undo` (`redo`) would take a pure layer step.
  bool undoes_layers() const { return can_undo() && !steps_[position_ - 1].is_edit(); }
  bool redoes_layers() const { return can_redo() && !steps_[position_].is_edit(); }
  bool redoes_edit() const { return can_redo() && steps_[position_].is_edit(); }
  /// Moves the last edit above later layer changes, so that `undo` takes it; returns false if there is no edit.
  bool raise_edit();
  /// The deltas that `raise_edit` and `undo` would return.
  std::vector<DocumentDelta> back_of_last_edit() const;
  /// The deltas to the document before the last edit; an open gesture counts as an edit. Empty if there is none.
  std::vector<DocumentDelta> way_before_last_edit() const;
  /// The revision of that document.
  std::optional<std::uint64_t> revision_before_last_edit() const;
  /// Whether the last edit led to a state of an evolution; its state 0 is the document before it.
  bool last_edit_is_state() const;
  /// The deltas that `undo` (`redo`) would return.
  std::vector<DocumentDelta> deltas_of_undo() const { return can_undo() ? back_of(steps_[position_ - 1]) : Deltas(); }
  std::vector<DocumentDelta> deltas_of_redo() const { return can_redo() ? steps_[position_].deltas : Deltas(); }
  /// Takes a step without returning its deltas.
  void step_back();
  void step_on();

  bool can_undo() const { return position_ > 0 && !gesture_open_; }
  bool can_redo() const { return position_ < steps_.size() && !gesture_open_; }
  /// Name of the step that undo (redo) would take; empty if there is none.
  std::string undo_name() const { return can_undo() ? steps_[position_ - 1].name : std::string(); }
  std::string redo_name() const { return can_redo() ? steps_[position_].name : std::string(); }
  /// Takes a step and returns the deltas to apply, in order; empty if there is nothing to undo (redo).
  std::vector<DocumentDelta> undo();
  std::vector<DocumentDelta> redo();
  std::size_t step_count() const { return steps_.size() - (gesture_open_ ? 1 : 0); }
  /// Number of steps done and not undone; equal values after equal work mean "unchanged since".
  std::size_t position() const { return position_; }
  void clear();

 private:
  using Deltas = std::vector<DocumentDelta>;
  struct Step {
    std::string name;
    std::vector<DocumentDelta> deltas{};
    std::optional<Layers> layers{};
    bool is_state = false;  ///< leads to a state of an evolution
    bool is_edit() const { return !deltas.empty(); }
  };
  static std::vector<DocumentDelta> back_of(const Step& step);
  bool can_extend(const DocumentDelta& delta, const std::string& name) const;
  std::deque<Step>::iterator undone() { return steps_.begin() + static_cast<std::ptrdiff_t>(position_); }
  std::optional<std::size_t> last_edit() const;
  const Step* newest_edit() const;
  static bool are_same_moves(const DocumentDelta& earlier, const DocumentDelta& later);
  static bool merge_moves(DocumentDelta& earlier, const DocumentDelta& later);

  std::deque<Step> steps_;  // a deque, so that growth copies nothing; the last one is kept free for an open gesture
  std::size_t position_ = 0;
  bool gesture_open_ = false;
  Step gesture_;
};

}  // namespace mes
