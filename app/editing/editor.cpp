// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/editor.h"

#include "app/layers/layer_step_name.h"
#include "core/base/assert.h"
#include "core/document/moved_curves.h"

namespace mes {

namespace {

Vec2& place_of(Vec2& p) {
  return p;
}
Vec2& place_of(Disk& disk) {
  return disk.center;
}
template <class Id, class Thing>
Vec2& place_of(std::pair<Id, Thing>& thing) {
  return place_of(thing.second);
}

// The positions that tools give, with negligible coordinates set to zero: a pointer close to an axis, or a nudge onto
// it, means the axis. A coordinate is negligible relative to those of the document. Radii stay, so that no ball
// vanishes.
template <class Thing>
std::vector<Thing> placed(const Document& document, std::span<const Thing> things) {
  std::vector<Thing> out(things.begin(), things.end());
  Magnitudes all = document.magnitudes();
  for (Thing& thing : out) for_each_number(place_of(thing), [&all](double x) { all.add(x); });
  for (Thing& thing : out) {
    Vec2& p = place_of(thing);
    p = {without_traces(p.x, all.most), without_traces(p.y, all.most)};
  }
  return out;
}

}  // namespace

Editor::Editor(Listener listener, LayerStack* layers)
    : index_(document_),
      centers_(document_),
      listener_(std::move(listener)),
      told_revision_(document_.revision()),
      layers_(layers) {}

std::vector<Editor::Posted> Editor::posted(std::span<const DocumentDelta> deltas) {
  std::vector<Posted> out;
  out.reserve(deltas.size());
  for (const DocumentDelta& delta : deltas) out.push_back(std::make_shared<const DocumentDelta>(delta));
  return out;
}

DocumentDelta Editor::replacement() const {
  DocumentDelta out;
  out.from_revision = told_revision_;
  out.to_revision = document_.revision();
  out.before = out.after = document_.snapshot();
  out.balls_before = out.balls_after = document_.ball_snapshot();
  out.curve_before = out.curve_after = document_.curve_order();
  out.annotations_before = out.annotations_after = document_.annotations();
  out.source_before = out.source_after = document_.source();
  return out;
}

void Editor::follow(const DocumentDelta& delta) {
  index_.follow(delta);
  centers_.follow(delta);
  selection_.follow(delta);
}

void Editor::tell(const Posted& delta) {
  if (told_revision_ != delta->from_revision) return catch_up();
  try {
    if (listener_) listener_(delta);
    told_revision_ = delta->to_revision;
  } catch (const std::bad_alloc&) {
    catch_up();
  }
}

void Editor::catch_up() {
  if (told_revision_ == document_.revision()) return;
  try {
    if (listener_) listener_(std::make_shared<const DocumentDelta>(replacement()));
    told_revision_ = document_.revision();
  } catch (const std::bad_alloc&) {
    // The listener stays behind until the next call.
  }
}

Expected<void> Editor::load(SampleData data) {
  auto loaded = std::make_shared<const SampleData>(std::move(data));
  DocumentReplay replay(document_);
  if (auto begun = replay.begin(*loaded); !begun) return begun;
  PreparedDocument next(std::move(replay), std::move(loaded));
  load(next);
  return {};
}

void Editor::restore(DocumentReplay replay, std::shared_ptr<const SampleData> data, TimelineLog entries,
                     Lesson lesson) {
  PreparedDocument next(std::move(replay), std::move(data), std::move(entries), std::move(lesson));
  restore(next);
}

void Editor::load(PreparedDocument& next) {
  take(next);
  noted_layers_.reset();
}

void Editor::restore(PreparedDocument& next) {
  auto noted = noted_layers_;
  if (layers_ != nullptr) noted = layers_->configuration();
  take(next);
  noted_layers_ = std::move(noted);
  if (layers_ != nullptr) noted_revision_ = layers_->revision();
}

// Observers see one replacement. Allocations precede the first change: move constructors of deques allocate.
void Editor::take(PreparedDocument& next) {
  MES_ASSERT(next.document_.revision() >= document_.next_revision());
  MES_ASSERT(next.document_.first_id() >= document_.next_id());
  MES_ASSERT(next.document_.first_ball_id() >= document_.next_ball_id());
  if (in_gesture()) end_gesture();
  const std::shared_ptr<DocumentDelta> change = std::move(next.change_);
  change->from_revision = told_revision_;
  change->curve_before = document_.curve_order();
  change->annotations_before = document_.annotations();
  change->source_before = document_.source();
  History before;
  std::shared_ptr<const SampleData> data = timeline_.data();
  data.swap(next.data_);
  timeline_.restart(std::move(data), std::move(next.entries_), std::move(next.lesson_));
  std::swap(document_, next.document_);
  before = std::move(history_);
  history_ = std::move(next.history_);
  next.history_ = std::move(before);
  index_.swap_tables(next.index_);
  centers_.swap_tables(next.centers_);
  saved_layers_.reset();
  saved_lesson_ = 0;
  mark_saved();
  selection_.follow(*change);
  tell(change);
}

std::size_t Editor::settle() {
  MES_ASSERT(!in_gesture());
  note_layers();
  timeline_.settle();
  return timeline_.entries().size();
}

Editor::Aside Editor::put_aside() {
  cancel_gesture();
  note_layers();
  auto data = std::make_shared<const SampleData>(data_of(document_));
  Aside out{.document = document_,
            .history = std::exchange(history_, {}),
            .timeline = std::exchange(timeline_, {}),
            .noted_layers = std::exchange(noted_layers_, {}),
            .saved_layers = std::exchange(saved_layers_, {}),
            .saved_revision = saved_revision_,
            .evolved_revision = evolved_revision_,
            .saved_lesson = std::exchange(saved_lesson_, 0)};
  timeline_.restart(std::move(data));
  take_layers_as_noted();
  return out;
}

void Editor::take_up(Aside aside) {
  if (in_gesture()) end_gesture();
  aside.document.number_after(document_);
  document_ = std::move(aside.document);
  history_ = std::move(aside.history);
  timeline_ = std::move(aside.timeline);
  saved_layers_ = std::move(aside.saved_layers);
  compared_revision_ = ~std::uint64_t{0};
  saved_revision_ = aside.saved_revision;
  evolved_revision_ = aside.evolved_revision;
  saved_lesson_ = aside.saved_lesson;
  noted_layers_ = std::move(aside.noted_layers);
  noted_revision_ = ~std::uint64_t{0};  // layers are compared when they come to rest
  if (told_revision_ == document_.revision()) return;
  const auto change = std::make_shared<const DocumentDelta>(replacement());
  follow(*change);
  tell(change);
}

void Editor::begin_gesture(std::string name) {
  note_layers();
  timeline_.note_gesture_begun(name);
  try {
    history_.begin_gesture(std::move(name));
  } catch (const std::bad_alloc&) {
    timeline_.note_gesture_ended();
    throw;
  }
}

void Editor::end_gesture() {
  try {
    if (const auto deltas = history_.gesture(); deltas.size() == 1)
      if (auto source = source_after_move(document_, deltas.front().edits))
        record(set_source(document_, std::move(source)), {});
  } catch (const std::bad_alloc&) {
    // The curves stay where they are.
  }
  close_gesture();
}

void Editor::close_gesture() {
  history_.end_gesture();
  timeline_.note_gesture_ended();
}

// All allocations precede the first change.
void Editor::record(const DocumentDelta& delta, const std::string& name, bool continues) {
  if (delta.is_empty()) return;
  note_layers();
  const auto change = std::make_shared<const DocumentDelta>(delta);
  document_.make_room_for({&delta, 1});
  History::Draft step = history_.draft(delta, name, continues ? History::Role::continues : History::Role::plain);
  timeline_.note_edit(document_, delta, name, continues);
  document_.apply(delta);
  step.record();
  follow(delta);
  tell(change);
}

Expected<std::vector<SampleSlot>> Editor::insert(std::span<const Vec2> positions, const std::string& name) {
  auto delta = insert_samples(document_, placed(document_, positions));
  if (!delta) return std::unexpected(delta.error());
  std::vector<SampleSlot> slots;
  slots.reserve(delta->edits.size());
  for (const SampleEdit& edit : delta->edits) slots.push_back(edit.slot);
  record(*delta, name);
  return slots;
}

Expected<std::vector<BallSlot>> Editor::insert_balls(std::span<const Disk> disks, const std::string& name) {
  auto delta = mes::insert_balls(document_, placed(document_, disks));
  if (!delta) return std::unexpected(delta.error());
  std::vector<BallSlot> slots;
  slots.reserve(delta->ball_edits.size());
  for (const BallEdit& edit : delta->ball_edits) slots.push_back(edit.slot);
  record(*delta, name);
  return slots;
}

Expected<void> Editor::annotate(Annotations annotations, const std::string& name, bool continues) {
  return perform(mes::annotate(document_, std::move(annotations)), name, continues);
}

Expected<void> Editor::perform(const Expected<DocumentDelta>& delta, const std::string& name, bool continues) {
  if (!delta) return std::unexpected(delta.error());
  record(*delta, name, continues);
  return {};
}

Expected<void> Editor::move(std::span<const std::pair<SampleId, Vec2>> samples,
                            std::span<const std::pair<BallId, Disk>> balls, const std::string& name) {
  auto delta =
      change_document(document_, {.moved = placed(document_, samples), .changed_balls = placed(document_, balls)});
  if (delta && !in_gesture())
    if (auto source = source_after_move(document_, delta->edits)) delta->source_after = std::move(source);
  return perform(delta, name);
}

Expected<void> Editor::remove(std::span<const SampleId> samples, std::span<const BallId> balls,
                              const std::string& name) {
  auto delta = change_document(document_, {.removed = samples, .removed_balls = balls});
  if (delta && are_all_of_source(document_, samples)) delta->source_after = nullptr;
  return perform(delta, name);
}

Expected<void> Editor::remove_selection() {
  std::vector<SampleId> samples;
  for (const SampleSlot slot : selection_.slots()) samples.push_back(document_.id(slot));
  std::vector<BallId> balls;
  for (const BallSlot slot : selection_.ball_slots()) balls.push_back(document_.ball_id(slot));
  return remove(samples, balls, "Delete " + noun_of(selection_));
}

Expected<void> Editor::nudge_selection(Vec2 offset) {
  std::vector<std::pair<SampleId, Vec2>> samples;
  for (const SampleSlot slot : selection_.slots())
    samples.emplace_back(document_.id(slot), document_.position(slot) + offset);
  std::vector<std::pair<BallId, Disk>> balls;
  for (const BallSlot slot : selection_.ball_slots()) {
    const Disk& disk = document_.disk(slot);
    balls.emplace_back(document_.ball_id(slot), Disk{disk.center + offset, disk.radius});
  }
  return move(samples, balls, "Nudge");
}

Expected<void> Editor::scale_selected_balls(double factor, double least, bool continues) {
  std::vector<std::pair<BallId, Disk>> balls;
  for (const BallSlot slot : selection_.ball_slots()) {
    const Disk& disk = document_.disk(slot);
    const double radius = disk.radius == 0.0 && factor > 1.0 ? least : disk.radius;
    balls.emplace_back(document_.ball_id(slot), Disk{disk.center, radius * factor});
  }
  return perform(change_balls(document_, balls), balls.size() == 1 ? "Change radius" : "Change radii", continues);
}

Expected<void> Editor::evolve(std::span<const Vec2> positions, std::span<const SampleData::Contour> contours,
                              const std::string& name, bool continues) {
  if (!continues) evolved_revision_ = ~std::uint64_t{0};
  return show_in_place(
      evolved_revision_, [&](const Document& before) { return arrange_samples(before, positions, contours); }, name,
      true);
}

Expected<void> Editor::resample(const SampleData& data, const std::string& name, bool continues) {
  if (!continues) resampled_revision_ = ~std::uint64_t{0};
  return show_in_place(
      resampled_revision_, [&](const Document& before) { return mes::resample(before, data); }, name, false);
}

Expected<void> Editor::show_in_place(std::uint64_t& shown,
                                     const std::function<Expected<DocumentDelta>(const Document&)>& make,
                                     const std::string& name, bool is_state) {
  MES_ASSERT(!in_gesture());
  note_layers();
  std::vector<DocumentDelta> changes;
  if (document_.revision() == shown) changes = history_.back_of_last_edit();
  const bool replaces = !changes.empty();
  Document next = document_;
  for (const DocumentDelta& back : changes) next.apply(back);
  const auto delta = make(next);
  if (!delta) return std::unexpected(delta.error());
  const bool is_new = !delta->is_empty();
  if (is_new) {
    next.apply(*delta);
    changes.push_back(*delta);
  }
  if (changes.empty()) return {};
  // Observers of the document see one change.
  const auto change = std::make_shared<const DocumentDelta>(one_after_the_other(changes));
  const auto go_back = [&] {
    if (replaces && history_.raise_edit()) history_.step_back();
  };
  if (is_new) {
    History::Draft step = history_.draft(*delta, name, is_state ? History::Role::state : History::Role::plain);
    timeline_.note_evolved(document_, *delta, name, replaces, is_state);
    go_back();
    step.record();
    shown = next.revision();
  } else {
    timeline_.note(Undone{});
    go_back();
  }
  document_ = std::move(next);
  follow(*change);
  tell(change);
  return {};
}

std::optional<Document> Editor::resume_evolution() {
  const std::vector<DocumentDelta> changes = history_.back_of_last_edit();
  if (changes.empty()) return std::nullopt;
  Document before = document_;
  for (const DocumentDelta& back : changes) before.apply(back);
  evolved_revision_ = document_.revision();
  return before;
}

Document Editor::before_last_edit() const {
  Document before = document_;
  for (const DocumentDelta& back : history_.way_before_last_edit()) before.apply(back);
  return before;
}

void Editor::cancel_gesture() {
  if (!in_gesture()) return;
  const std::size_t before = history_.position();
  close_gesture();
  if (history_.position() != before) take_back();
}

// All allocations precede the first change.
void Editor::take_step(const std::vector<DocumentDelta>& deltas, const TimelineEntry& entry,
                       void (History::*step)()) {
  const std::vector<Posted> changes = posted(deltas);
  document_.make_room_for(deltas);
  timeline_.note(entry);
  (history_.*step)();
  for (const Posted& change : changes) {
    document_.apply(*change);
    follow(*change);
    tell(change);
  }
}

void Editor::undo() {
  note_layers();
  take_back();
}

void Editor::take_back() {
  if (!can_undo()) return;
  const LayersChanged* const found = history_.layers_of_undo();
  const auto layers = found == nullptr ? std::nullopt : std::optional(*found);
  const bool is_of_layers = history_.undoes_layers();
  if (is_of_layers)
    history_.step_back();
  else
    take_step(history_.deltas_of_undo(), Undone{}, &History::step_back);
  if (layers) show_layers(*layers, is_of_layers ? LayersChanged::Role::undone : LayersChanged::Role::noted);
}

void Editor::redo() {
  note_layers();
  if (!can_redo()) return;
  const LayersChanged* const found = history_.layers_of_redo();
  const auto layers = found == nullptr ? std::nullopt : std::optional(*found);
  const bool is_of_layers = history_.redoes_layers();
  if (is_of_layers)
    history_.step_on();
  else
    take_step(history_.deltas_of_redo(), Redone{}, &History::step_on);
  if (layers) show_layers(*layers, is_of_layers ? LayersChanged::Role::redone : LayersChanged::Role::noted);
}

void Editor::undo_edit() {
  note_layers();
  // Reordering independent steps changes nothing.
  if (history_.raise_edit()) take_step(history_.deltas_of_undo(), Undone{}, &History::step_back);
}

std::optional<Editor::ChangedLayers> Editor::changed_layers() {
  if (layers_ == nullptr || (noted_layers_ && layers_->revision() == noted_revision_)) return std::nullopt;
  LayerConfiguration now = layers_->configuration();
  if (!noted_layers_) {
    timeline_.note(difference({}, now));
    set_noted(std::move(now));
    return std::nullopt;
  }
  History::Layers layers{difference(*noted_layers_, now), difference(now, *noted_layers_)};
  if (layers.change.is_empty()) {
    set_noted(std::move(now));
    return std::nullopt;
  }
  return ChangedLayers{std::move(layers), std::move(now)};
}

void Editor::set_noted(LayerConfiguration layers) {
  noted_layers_ = std::move(layers);
  noted_revision_ = layers_->revision();
}

void Editor::note_layers(const std::string& name) {
  if (in_gesture()) return;
  auto changed = changed_layers();
  if (!changed) return;
  const History::Layers& layers = changed->layers;
  LayersChanged entry = layers.change;
  entry.role = LayersChanged::Role::step;
  entry.name = name.empty() ? name_of_change(*layers_, layers.back, layers.change) : name;
  entry.back.push_back(layers.back);
  History::Draft step = history_.draft(layers, entry.name);
  timeline_.note(entry);
  step.record();
  set_noted(std::move(changed->now));
}

void Editor::join_layers() {
  if (!in_gesture() && !can_undo()) return note_layers();
  auto changed = changed_layers();
  if (!changed) return;
  LayersChanged entry = changed->layers.change;
  entry.role = LayersChanged::Role::joined;
  entry.back.push_back(changed->layers.back);
  history_.join_layers(std::move(changed->layers));
  timeline_.note(std::move(entry));
  set_noted(std::move(changed->now));
}

void Editor::take_layers_as_noted() {
  if (layers_ == nullptr) return;
  noted_layers_ = layers_->configuration();
  noted_revision_ = layers_->revision();
}

void Editor::replace_layers(const std::function<void()>& replace) {
  if (layers_ == nullptr) return replace();
  note_layers();
  const LayerConfiguration before = layers_->configuration();
  const bool is_saved = saved_layers_ == before;
  const bool is_pending = layers_->revision() != noted_revision_;
  replace();
  if (is_saved) set_saved_layers(layers_->configuration());
  if (!noted_layers_) return;
  LayersChanged change = difference(before, layers_->configuration());
  if (is_pending)
    mes::apply(change, *noted_layers_);
  else
    take_layers_as_noted();
  if (!change.is_empty()) timeline_.note(std::move(change));
}

void Editor::set_saved_layers(std::optional<LayerConfiguration> layers) {
  saved_layers_ = std::move(layers);
  compared_revision_ = ~std::uint64_t{0};
}

void Editor::show_layers(LayersChanged change, LayersChanged::Role role) {
  if (layers_ == nullptr) return;
  // Layer changes within a cancelled gesture are not noted yet, and stay so.
  const bool is_pending = layers_->revision() != noted_revision_;
  layers_->apply(change);
  if (is_pending && noted_layers_)
    mes::apply(change, *noted_layers_);
  else
    take_layers_as_noted();
  change.role = role;
  timeline_.note(std::move(change));
}

Editor::Work Editor::work() const {
  const bool is_evolved = document_.revision() == evolved_revision_;
  return {.revision = is_evolved ? revision_before_last_edit() : document_.revision(),
          .is_evolved = is_evolved,
          .lesson = timeline_.lesson_revision(),
          .layers = saved_layers_ && layers_ != nullptr ? layers_->revision() : 0};
}

void Editor::mark_unsaved() {
  constexpr std::uint64_t kNever = ~std::uint64_t{0};
  saved_revision_ = kNever;
  saved_lesson_ = timeline_.lesson() == Lesson{} ? timeline_.lesson_revision() : kNever;
}

bool Editor::is_modified() const {
  if (document_.revision() != saved_revision_ || is_lesson_modified()) return true;
  if (!saved_layers_ || layers_ == nullptr) return false;
  if (compared_revision_ != layers_->revision()) {
    compared_revision_ = layers_->revision();
    are_layers_modified_ = layers_->configuration() != *saved_layers_;
  }
  return are_layers_modified_;
}

}  // namespace mes
