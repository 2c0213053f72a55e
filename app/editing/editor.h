// SPDX-License-Identifier: GPL-3.0-or-later
// The editable document, with the undoable part of the layers: commands, history, selection and index change
// together.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/places/place_index.h"
#include "app/editing/prepared_document.h"
#include "app/editing/selection.h"
#include "app/layers/layer_stack.h"
#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/timeline/history.h"
#include "core/document/timeline/timeline.h"

namespace mes {

/// Guarantees:
///  1. Every change of the document is made here, and reaches the index, the selection and the listener once, in
///     order. A refused command changes nothing.
///  2. A gesture, however many commands it runs, is one step of undo; a cancelled gesture leaves no step. Source curves
///     whose samples it has moved alike, and done nothing else, follow at its end (core/document/moved_curves.h). They
///     are removed with the last of their samples.
///  3. The timeline records each change once and in order; replaying it gives this document and this history.
///  4. Given coordinates that are negligible beside the others of the document (core/base/geometry/coordinate_range.h) are set
///     to zero; other numbers out of range are refused.
///  5. `is_modified` compares states: after undoing back to the saved state it is false. A changed lesson counts as
///     modified until it is saved; steps of undo do not affect it.
///  6. When memory runs out, a function throws std::bad_alloc, and leaves the document, the history, the timeline and
///     the selection as they were. Only the listener may be behind: it gets one replacement of everything as soon as
///     there is room (`catch_up`).
///  7. Layers are changed directly (LayerStack). Their differences become one step of undo when they come to rest or
///     when anything else is done. Edits and layer changes may be reordered, and never undo each other.
///
/// Smallest use:
///     Editor editor([&](auto delta) { engine.post(std::move(delta)); });
///     editor.load(data);
///     editor.begin_gesture("Spray"); editor.insert({{p}}); editor.end_gesture();
///
/// Threads: none; it belongs to the window's thread. Depends on no window and no OpenGL.
class Editor {
 public:
  using Listener = std::function<void(std::shared_ptr<const DocumentDelta>)>;
  /// Without `layers`, which must outlive it, the editor handles the document alone.
  explicit Editor(Listener listener, LayerStack* layers = nullptr);
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  const Document& document() const { return document_; }
  const SampleIndex& index() const { return index_; }
  const CenterIndex& centers() const { return centers_; }
  Selection& selection() { return selection_; }
  const Selection& selection() const { return selection_; }

  /// Replaces everything and clears the history: the loaded state counts as saved.
  Expected<void> load(SampleData data);
  /// Takes over a document with its undo history; `timeline` is what was replayed. It counts as not modified.
  void restore(DocumentReplay replay, std::shared_ptr<const SampleData> data, TimelineLog entries,
               Lesson lesson = {});
  /// The same as these two for a prepared document, in O(1). Requires `fits`. Afterwards `next` holds the previous
  /// content.
  void load(PreparedDocument& next);
  void restore(PreparedDocument& next);
  /// True if this document has given out no revision or id of the new one since `start`, the successor it was made
  /// from.
  bool fits(const Document& start) const {
    return document_.next_revision() <= start.revision() && document_.next_id() <= start.first_id() &&
           document_.next_ball_id() <= start.first_ball_id();
  }
  const Timeline& timeline() const { return timeline_; }

  const Lesson& lesson() const { return timeline_.lesson(); }
  void set_lesson(Lesson lesson) { timeline_.set_lesson(std::move(lesson)); }
  /// A position on the timeline, including the layers, before which nothing will change any more. Not within a
  /// gesture.
  std::size_t settle();
  bool is_lesson_modified() const { return timeline_.lesson_revision() != saved_lesson_; }
  /// Notes that a file holds the lesson as of this revision (`Timeline::lesson_revision`).
  void mark_lesson_saved(std::uint64_t revision) { saved_lesson_ = revision; }

  /// The whole editable content, set aside while something else is edited.
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
  /// Sets the content aside. The document stays as it is, as data without a history.
  Aside put_aside();
  /// Continues with content that this editor has set aside. The layers must be as they were then.
  void take_up(Aside aside);

  /// Makes the differences in the layers a step of undo, called `name`, or else after the change. Call it when no
  /// control of the layers is held, so that dragging a slider makes one step; edits and undo call it first. The first
  /// call after `load` notes the layers without a step.
  void note_layers(const std::string& name = {});
  /// The same for the change made by a function, as one step.
  template <class Change>
  void change_layers(const std::string& name, Change change) {
    note_layers();
    change();
    note_layers(name);
  }
  /// Calls a function that replaces all layers by those of another registry. The call adds no step of undo, and does
  /// not mark unmodified layers as modified.
  void replace_layers(const std::function<void()>& replace);
  /// Adds layer changes to the newest step instead: an edit shows its result.
  void join_layers();
  /// Notes that the layers were restored with the document: they are on its timeline already.
  void take_layers_as_noted();
  /// The layers in the file of the document; nothing: it has no file that could hold them. Layer changes count as
  /// modifications only with such a file.
  void set_saved_layers(std::optional<LayerConfiguration> layers);

  /// Notes changes outside the document: views, layers, settings.
  void note(const TimelineEntry& entry) { timeline_.note(entry); }
  /// Returns the rows of the new samples.
  Expected<std::vector<SampleSlot>> insert(std::span<const Vec2> positions, const std::string& name);
  Expected<std::vector<BallSlot>> insert_balls(std::span<const Disk> disks, const std::string& name);
  /// Moves samples and balls together as one change.
  Expected<void> move(std::span<const std::pair<SampleId, Vec2>> targets, const std::string& name) {
    return move(targets, {}, name);
  }
  Expected<void> move(std::span<const std::pair<SampleId, Vec2>> samples,
                      std::span<const std::pair<BallId, Disk>> balls, const std::string& name);
  Expected<void> remove(std::span<const SampleId> ids, const std::string& name) { return remove(ids, {}, name); }
  Expected<void> remove(std::span<const SampleId> samples, std::span<const BallId> balls, const std::string& name);
  /// Replaces the annotations. With `continues`, it joins the step of the previous call if nothing else has happened
  /// since, and the number of annotations is the same.
  Expected<void> annotate(Annotations annotations, const std::string& name, bool continues = false);
  /// Replaces the contours.
  Expected<void> set_contours(CurveOrder contours, const std::string& name) {
    return perform(mes::set_contours(document_, std::move(contours)), name);
  }
  /// Makes a change that was recorded on a timeline.
  Expected<void> perform(const TimelineEdit& edit) {
    return perform(delta_of(document_, edit), edit.name, edit.continues);
  }
  Expected<void> remove_selection();
  /// Shifts the selection. Repeated nudges within a gesture are one step.
  Expected<void> nudge_selection(Vec2 offset);
  /// Multiplies the radii of the selected balls; zero radii grow from `least`. With `continues`, it joins the step of
  /// the previous call if nothing else has happened since.
  Expected<void> scale_selected_balls(double factor, double least, bool continues);

  /// Shows another state of an evolution: the samples in input order, then new ones; see `arrange_samples`. All
  /// states of one evolution are one step of undo: with `continues`, and while nothing else happens, each state
  /// replaces the previous one, and its `name` the previous name. Not within a gesture.
  Expected<void> evolve(std::span<const Vec2> positions, std::span<const SampleData::Contour> contours,
                        const std::string& name, bool continues = true);
  /// Takes other samples of the document's curves, or of other curves; see `mes::resample`. With `continues`, they
  /// replace those of the previous call if nothing else has happened since: one step of undo, of this name. Not
  /// within a gesture.
  Expected<void> resample(const SampleData& data, const std::string& name, bool continues);
  /// Treats the last step of undo as the state of an evolution, which the next `evolve` replaces. Returns the
  /// document before that step, or nothing if there is no step.
  std::optional<Document> resume_evolution();

  void begin_gesture(std::string name);
  void end_gesture();
  /// Ends the gesture and undoes it.
  void cancel_gesture();
  bool in_gesture() const { return history_.in_gesture(); }

  /// The document before the last edit or the present gesture; the present document if there is none. O(n).
  Document before_last_edit() const;
  /// The revision of that document.
  std::uint64_t revision_before_last_edit() const {
    return history_.revision_before_last_edit().value_or(document_.revision());
  }

  bool can_undo() const { return history_.can_undo(); }
  bool can_redo() const { return history_.can_redo(); }
  std::string undo_name() const { return history_.undo_name(); }
  std::string redo_name() const { return history_.redo_name(); }
  void undo();
  void redo();
  /// Undoes the last edit and leaves the layers as they are, even if they were changed since.
  void undo_edit();

  /// Repeats the changes that the listener missed for lack of memory, if there is room now. Call it once per frame.
  void catch_up();

  bool is_modified() const;
  /// A fingerprint of the work that could be lost: equal values mean that nothing was done in between, or that it was
  /// undone. States of one evolution count as one.
  struct Work {
    std::uint64_t revision = 0;  // revision of the document, or of the one before the evolution
    bool is_evolved = false;
    std::uint64_t lesson = 0;
    std::uint64_t layers = 0;  // if a file holds layers
    friend bool operator==(const Work&, const Work&) = default;
  };
  Work work() const;
  void mark_saved() { mark_saved(document_.revision()); }
  /// Notes that a file holds the document of this revision.
  void mark_saved(std::uint64_t revision) { saved_revision_ = revision; }
  /// Notes that no file holds this state, nor its lesson if there is one.
  void mark_unsaved();

 private:
  using Posted = std::shared_ptr<const DocumentDelta>;
  static std::vector<Posted> posted(std::span<const DocumentDelta> deltas);
  /// One delta for everything, which replaces the state that the listener knows.
  DocumentDelta replacement() const;
  void take(PreparedDocument& next);
  /// Adapts to a document that has changed already. Neither function needs memory to succeed.
  void follow(const DocumentDelta& delta);
  void tell(const Posted& delta);
  /// Records an edit for undo.
  void record(const DocumentDelta& delta, const std::string& name, bool continues = false);
  Expected<void> perform(const Expected<DocumentDelta>& delta, const std::string& name, bool continues = false);
  void take_back();
  void close_gesture();
  /// Makes the delta that `make` returns one step. It replaces the last step if the revision is still `shown`, which
  /// is set to the new revision. `is_state`: the state of an evolution.
  Expected<void> show_in_place(std::uint64_t& shown,
                               const std::function<Expected<DocumentDelta>(const Document&)>& make,
                               const std::string& name, bool is_state);
  /// Applies the deltas and puts `entry` on the timeline; then `step` does the same in the history.
  void take_step(const std::vector<DocumentDelta>& deltas, const TimelineEntry& entry, void (History::*step)());
  /// Applies the layer changes of undo and redo.
  void show_layers(LayersChanged change, LayersChanged::Role role);
  struct ChangedLayers {
    History::Layers layers;
    LayerConfiguration now;
  };
  /// The difference from the noted layers. A difference that makes no step is noted at once.
  std::optional<ChangedLayers> changed_layers();
  void set_noted(LayerConfiguration layers);

  Document document_;
  History history_;
  Timeline timeline_;
  Selection selection_;
  SampleIndex index_;
  CenterIndex centers_;
  Listener listener_;
  std::uint64_t told_revision_ = 0;  // document revision that the listener knows
  LayerStack* layers_;
  std::optional<LayerConfiguration> noted_layers_;  // nothing: they are not on the timeline yet
  std::uint64_t noted_revision_ = 0;                // revision of the layers
  std::optional<LayerConfiguration> saved_layers_;
  mutable std::uint64_t compared_revision_ = ~std::uint64_t{0};  // layers revision for which the next one is valid
  mutable bool are_layers_modified_ = false;
  std::uint64_t saved_revision_ = 0;
  std::uint64_t saved_lesson_ = 0;
  std::uint64_t evolved_revision_ = ~std::uint64_t{0};    // last state of an evolution
  std::uint64_t resampled_revision_ = ~std::uint64_t{0};  // last sampling
};

}  // namespace mes
