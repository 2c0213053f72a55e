// SPDX-License-Identifier: GPL-3.0-or-later
// Unlimited undo and redo, of the document and of how the layers look. One gesture, however many deltas it made, is
// one step.
//
// Smallest use:
//     history.begin_gesture("Move samples");
//     document.apply(moved); history.record(moved);  // once or often
//     history.end_gesture();
//     for (const DocumentDelta& delta : history.undo()) document.apply(delta);
//
// Moves of the same samples within one gesture are merged, so that an hour of dragging costs one step's memory.
//
// Steps that edit the document and steps that change layers do not touch each other, so they may change places: the
// last edit can be undone below changes of layers (`raise_edit`), and a change of layers leaves edits that can be
// redone as they are. What `redo` would bring back of the layers is lost with such a change, as edits are with an
// edit.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/delta.h"
#include "core/document/layers_changed.h"

namespace mes {

class History {
  struct Step;

 public:
  /// Deltas recorded until `end_gesture` form one step called `name`. Gestures do not nest. Ending one asks for no
  /// memory.
  void begin_gesture(std::string name);
  void end_gesture();
  bool in_gesture() const { return gesture_open_; }
  /// An edit is a step of its own, or continues the last step, or leads to a state of an evolution. State 0 is the
  /// document before that edit.
  enum class Role : std::uint8_t { plain, continues, state };
  /// Notes an applied delta; outside a gesture it is a step of its own, or more of the last one where `extend` is
  /// possible. Forgets what could be redone.
  void record(const DocumentDelta& delta, const std::string& name = {}, Role role = Role::plain);

  /// A step to be recorded once all else has succeeded: everything it needs is there, so `record` asks for no memory.
  /// A draft that is not recorded leaves no trace. While there is one, nothing else is done with the history but
  /// `undo` and `raise_edit`.
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
  /// Prepares what `record` does.
  Draft draft(const DocumentDelta& delta, const std::string& name, Role role = Role::plain);

  /// Makes the delta part of the newest step if that has this name, nothing came between, and the delta only gives
  /// the same things other places; whether it did. If not, it is not recorded. Asks for no memory.
  bool extend(const DocumentDelta& delta, const std::string& name);

  /// A change of the layers and the way back.
  struct Layers {
    LayersChanged change{};
    LayersChanged back{};
  };
  /// Makes a change of the layers a step. Not within a gesture.
  void record_layers(Layers layers, const std::string& name);
  Draft draft(Layers layers, const std::string& name);
  /// Makes it part of the newest step, or of the gesture; false when there is none.
  bool join_layers(Layers layers);
  /// What `undo` (`redo`) does to the layers, beside the deltas; null: nothing.
  const LayersChanged* layers_of_undo() const;
  const LayersChanged* layers_of_redo() const;
  /// Whether `undo` (`redo`) takes a step of layers alone.
  bool undoes_layers() const { return can_undo() && !steps_[position_ - 1].is_edit(); }
  bool redoes_layers() const { return can_redo() && !steps_[position_].is_edit(); }
  bool redoes_edit() const { return can_redo() && steps_[position_].is_edit(); }
  /// Moves the last edit above the changes of layers that came after it, where `undo` takes it; false: there is none.
  bool raise_edit();
  /// What `raise_edit` and `undo` would give.
  std::vector<DocumentDelta> back_of_last_edit() const;
  /// What leads to the document before the last edit, a gesture under way included; empty: there is none.
  std::vector<DocumentDelta> way_before_last_edit() const;
  /// The revision of that document.
  std::optional<std::uint64_t> revision_before_last_edit() const;
  /// Whether the last edit led to a state of an evolution: state 0 is what was before it.
  bool last_edit_is_state() const;
  /// What `undo` (`redo`) would give.
  std::vector<DocumentDelta> deltas_of_undo() const { return can_undo() ? back_of(steps_[position_ - 1]) : Deltas(); }
  std::vector<DocumentDelta> deltas_of_redo() const { return can_redo() ? steps_[position_].deltas : Deltas(); }
  /// Takes a step without giving its deltas.
  void step_back();
  void step_on();

  bool can_undo() const { return position_ > 0 && !gesture_open_; }
  bool can_redo() const { return position_ < steps_.size() && !gesture_open_; }
  /// Name of the step that undo (redo) would take; empty when there is none.
  std::string undo_name() const { return can_undo() ? steps_[position_ - 1].name : std::string(); }
  std::string redo_name() const { return can_redo() ? steps_[position_].name : std::string(); }
  /// Takes a step. Deltas to apply, in order; empty when there is nothing to undo (redo).
  std::vector<DocumentDelta> undo();
  std::vector<DocumentDelta> redo();
  std::size_t step_count() const { return steps_.size() - (gesture_open_ ? 1 : 0); }
  /// Number of steps done and not undone; equal numbers after equal work mean "unchanged since".
  std::size_t position() const { return position_; }
  void clear();

 private:
  using Deltas = std::vector<DocumentDelta>;
  struct Step {
    std::string name;
    std::vector<DocumentDelta> deltas{};
    std::optional<Layers> layers{};
    bool is_state = false;  ///< of an evolution
    bool is_edit() const { return !deltas.empty(); }
  };
  static std::vector<DocumentDelta> back_of(const Step& step);
  bool can_extend(const DocumentDelta& delta, const std::string& name) const;
  std::deque<Step>::iterator undone() { return steps_.begin() + static_cast<std::ptrdiff_t>(position_); }
  std::optional<std::size_t> last_edit() const;
  const Step* newest_edit() const;
  static bool are_same_moves(const DocumentDelta& earlier, const DocumentDelta& later);
  static bool merge_moves(DocumentDelta& earlier, const DocumentDelta& later);

  std::deque<Step> steps_;  // no copies to make room; the last one is kept free for an open gesture
  std::size_t position_ = 0;
  bool gesture_open_ = false;
  Step gesture_;
};

}  // namespace mes
