// SPDX-License-Identifier: GPL-3.0-or-later
// The document as the window edits it, and the layers as far as they can be undone: commands, history, selection and
// index move together.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/place_index.h"
#include "app/editing/prepared_document.h"
#include "app/editing/selection.h"
#include "app/layers/layer_stack.h"
#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/history.h"
#include "core/document/timeline.h"

namespace mes {

/// What it guarantees:
///  1. Every change of the document goes through here, and reaches the index, the selection and the listener once, in
///     order. A refused command changes nothing.
///  2. A gesture, however many commands it runs, is one step of undo; a cancelled gesture leaves no step.
///  3. The timeline tells of each change, once and in order; replaying it gives this document and this history.
///  4. Coordinates that are given here and are nothing beside the others of the document
///     (core/base/coordinate_range.h) are set to zero; other numbers out of range are refused.
///  5. `is_modified` compares states: undoing back to what was saved is "not modified". A lesson that was changed is
///     modified until it is saved; steps of undo do not change it.
///  6. When memory runs out, a function throws std::bad_alloc, and the document, the history, the timeline and what is
///     selected are as they were before. Only the listener may be behind: it gets one replacement of everything as soon
///     as there is room (`catch_up`).
///  7. Layers are changed directly (LayerStack); what is different when they come to rest, or when anything else is
///     done, is one step of undo. Edits and changes of layers may change places, and never undo each other.
///
/// Smallest use:
///     Editor editor([&](auto delta) { engine.post(std::move(delta)); });
///     editor.load(data);
///     editor.begin_gesture("Spray"); editor.insert({{p}}); editor.end_gesture();
///
/// Threads: none; it belongs to the window's thread. It knows no window and no OpenGL.
class Editor {
 public:
  using Listener = std::function<void(std::shared_ptr<const DocumentDelta>)>;
  /// Without `layers`, which outlive it, it is about the document alone.
  explicit Editor(Listener listener, LayerStack* layers = nullptr);
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  const Document& document() const { return document_; }
  const SampleIndex& index() const { return index_; }
  const CenterIndex& centers() const { return centers_; }
  Selection& selection() { return selection_; }
  const Selection& selection() const { return selection_; }

  /// Replaces everything and forgets the history: the loaded state is the saved one.
  Expected<void> load(SampleData data);
  /// Takes over a document with all that can be undone; `timeline` is what was replayed. It counts as not modified.
  void restore(DocumentReplay replay, std::shared_ptr<const SampleData> data, TimelineLog entries,
               Lesson lesson = {});
  /// The same as these two, of what was made aside, in O(1). Not unless `fits`. What was here before is in it afterwards.
  void load(PreparedDocument& next);
  void restore(PreparedDocument& next);
  /// No revision and no id of it was given here since `start`, a successor of this document, from which it was made.
  bool fits(const Document& start) const {
    return document_.next_revision() <= start.revision() && document_.next_id() <= start.first_id() &&
           document_.next_ball_id() <= start.first_ball_id();
  }
  const Timeline& timeline() const { return timeline_; }

  const Lesson& lesson() const { return timeline_.lesson(); }
  void set_lesson(Lesson lesson) { timeline_.set_lesson(std::move(lesson)); }
  /// A place on the timeline, with the layers as they are, at which nothing will change any more. Not within a gesture.
  std::size_t settle();
  bool is_lesson_modified() const { return timeline_.lesson_revision() != saved_lesson_; }
  /// A file holds the lesson as it was at this revision (`Timeline::lesson_revision`).
  void mark_lesson_saved(std::uint64_t revision) { saved_lesson_ = revision; }

  /// All that can be worked on, out of the way while something else is.
  struct Aside {
    Document document;
    History history;
    Timeline timeline;
    std::optional<LayerConfiguration> noted_layers;
    std::optional<LayerConfiguration> saved_layers;
    std::uint64_t saved_revision = 0;
    std::uint64_t evolved_revision = 0;
    std::uint64_t saved_lesson = 0;
  };
  /// The document stays as it is, as data without a history.
  Aside put_aside();
  /// Goes on with what was put aside by this editor. The layers are to be as they were then.
  void take_up(Aside aside);

  /// Makes what became different in the layers a step of undo, called `name`, or by what it is. To be called when no
  /// control of theirs is held, so that a slider being dragged makes one step; edits and undo call it first. The
  /// first time after `load` it notes how the layers are, without a step.
  void note_layers(const std::string& name = {});
  /// The same for the change that the function makes, as one step.
  template <class Change>
  void change_layers(const std::string& name, Change change) {
    note_layers();
    change();
    note_layers(name);
  }
  /// Calls a function that replaces all layers by those of another registry. The call adds no step of undo, and does not
  /// mark unmodified layers as modified.
  void replace_layers(const std::function<void()>& replace);
  /// Makes it part of the newest step instead: an edit shows what it made.
  void join_layers();
  /// The layers were brought back with the document: they are on its timeline already.
  void take_layers_as_noted();
  /// How the layers are in the file of the document; nothing: it has no file that could hold them. Only with such a
  /// file do changes of layers count as modifications.
  void set_saved_layers(std::optional<LayerConfiguration> layers);

  /// For what happens beside the document: views, layers, settings.
  void note(const TimelineEntry& entry) { timeline_.note(entry); }
  /// Rows of the new samples.
  Expected<std::vector<SampleSlot>> insert(std::span<const Vec2> positions, const std::string& name);
  Expected<std::vector<BallSlot>> insert_balls(std::span<const Disk> disks, const std::string& name);
  /// Samples and balls that go together are one change.
  Expected<void> move(std::span<const std::pair<SampleId, Vec2>> targets, const std::string& name) {
    return move(targets, {}, name);
  }
  Expected<void> move(std::span<const std::pair<SampleId, Vec2>> samples,
                      std::span<const std::pair<BallId, Disk>> balls, const std::string& name);
  Expected<void> remove(std::span<const SampleId> ids, const std::string& name) { return remove(ids, {}, name); }
  Expected<void> remove(std::span<const SampleId> samples, std::span<const BallId> balls, const std::string& name);
  /// Makes these the annotations. With `continues`, it is the same step as the call before if nothing else happened
  /// since, and there are as many as before.
  Expected<void> annotate(Annotations annotations, const std::string& name, bool continues = false);
  /// Makes these the contours.
  Expected<void> set_contours(CurveOrder contours, const std::string& name) {
    return perform(mes::set_contours(document_, std::move(contours)), name);
  }
  /// A change as it stands on a timeline.
  Expected<void> perform(const TimelineEdit& edit) {
    return perform(delta_of(document_, edit), edit.name, edit.continues);
  }
  Expected<void> remove_selection();
  /// Shifts what is selected. Repeated nudges within a gesture are one step.
  Expected<void> nudge_selection(Vec2 offset);
  /// Multiplies the radii of the selected balls; those of zero grow from `least`. With `continues`, it is the same
  /// step as the call before if nothing else happened since.
  Expected<void> scale_selected_balls(double factor, double least, bool continues);

  /// Shows another state of an evolution, the samples in input order and then new ones; see `arrange_samples`. All
  /// states of one evolution are one step of undo: with `continues`, and as long as nothing else happened, each takes the
  /// place of the one before, and `name` that of its name. Not within a gesture.
  Expected<void> evolve(std::span<const Vec2> positions, std::span<const SampleData::Contour> contours,
                        const std::string& name, bool continues = true);
  /// Takes other samples of the document's curves, or of other curves; see `mes::resample`. With `continues`, they take
  /// the place of those of the call before if nothing else happened since: one step of undo, of this name. Not within a
  /// gesture.
  Expected<void> resample(const SampleData& data, const std::string& name, bool continues);
  /// Takes the last step of undo for the state of an evolution, whose place the next `evolve` takes. The document
  /// before that step; nothing when there is none.
  std::optional<Document> resume_evolution();

  void begin_gesture(std::string name);
  void end_gesture();
  /// Ends the gesture and takes back what it did.
  void cancel_gesture();
  bool in_gesture() const { return history_.in_gesture(); }

  /// The document before the last edit, a gesture under way included; the present one when there is none. O(n).
  Document before_last_edit() const;
  /// Its revision.
  std::uint64_t revision_before_last_edit() const {
    return history_.revision_before_last_edit().value_or(document_.revision());
  }

  bool can_undo() const { return history_.can_undo(); }
  bool can_redo() const { return history_.can_redo(); }
  std::string undo_name() const { return history_.undo_name(); }
  std::string redo_name() const { return history_.redo_name(); }
  void undo();
  void redo();
  /// Takes the last edit back and leaves the layers as they are, also where they were changed since.
  void undo_edit();

  /// Repeats what the listener missed for lack of memory, if there is room now. Call it once a frame.
  void catch_up();

  bool is_modified() const;
  /// What there is to lose: equal values mean that nothing was done in between, or that it was taken back. States of an
  /// evolution that take each other's place count as one.
  struct Work {
    std::uint64_t revision = 0;  // of the document, or of the one before the evolution
    bool is_evolved = false;
    std::uint64_t lesson = 0;
    std::uint64_t layers = 0;  // where a file holds layers
    friend bool operator==(const Work&, const Work&) = default;
  };
  Work work() const;
  void mark_saved() { mark_saved(document_.revision()); }
  /// The document as it was at this revision.
  void mark_saved(std::uint64_t revision) { saved_revision_ = revision; }
  /// No file holds this state.
  void mark_unsaved() { saved_revision_ = ~std::uint64_t{0}; }

 private:
  using Posted = std::shared_ptr<const DocumentDelta>;
  static std::vector<Posted> posted(std::span<const DocumentDelta> deltas);
  /// Everything as one delta that replaces the state that the listener knows.
  DocumentDelta replacement() const;
  void take(PreparedDocument& next);
  /// For a document that has changed already. These ask for no memory, or do without.
  void follow(const DocumentDelta& delta);
  void tell(const Posted& delta);
  /// An edit that can be undone.
  void record(const DocumentDelta& delta, const std::string& name, bool continues = false);
  Expected<void> perform(const Expected<DocumentDelta>& delta, const std::string& name, bool continues = false);
  void take_back();
  /// Makes what `make` says of the document one step; if the document is as `shown` says, it takes the place of the last
  /// one. `shown` is the revision afterwards. `is_state`: of an evolution.
  Expected<void> show_in_place(std::uint64_t& shown,
                               const std::function<Expected<DocumentDelta>(const Document&)>& make,
                               const std::string& name, bool is_state);
  /// Applies the deltas and puts `entry` on the timeline; then `step` does the same in the history.
  void take_step(const std::vector<DocumentDelta>& deltas, const TimelineEntry& entry, void (History::*step)());
  /// What undo and redo do to the layers.
  void show_layers(LayersChanged change, LayersChanged::Role role);
  struct ChangedLayers {
    History::Layers layers;
    LayerConfiguration now;
  };
  /// What is different from what is noted. What makes no step is noted at once.
  std::optional<ChangedLayers> changed_layers();
  void set_noted(LayerConfiguration layers);

  Document document_;
  History history_;
  Timeline timeline_;
  Selection selection_;
  SampleIndex index_;
  CenterIndex centers_;
  Listener listener_;
  std::uint64_t told_revision_ = 0;  // of the document, as the listener knows it
  LayerStack* layers_;
  std::optional<LayerConfiguration> noted_layers_;  // nothing: they are not on the timeline yet
  std::uint64_t noted_revision_ = 0;                // of the layers
  std::optional<LayerConfiguration> saved_layers_;
  mutable std::uint64_t compared_revision_ = ~std::uint64_t{0};  // of the layers for which the next one is true
  mutable bool are_layers_modified_ = false;
  std::uint64_t saved_revision_ = 0;
  std::uint64_t saved_lesson_ = 0;
  std::uint64_t evolved_revision_ = ~std::uint64_t{0};    // the last state of an evolution
  std::uint64_t resampled_revision_ = ~std::uint64_t{0};  // the last sampling
};

}  // namespace mes
