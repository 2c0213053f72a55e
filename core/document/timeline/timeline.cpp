// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/timeline/timeline.h"

#include <algorithm>
#include <new>
#include <utility>

#include "core/document/timeline/layer_fold.h"

namespace mes {
namespace {

// Drags of fewer things than this record each move of the pointer.
constexpr std::size_t kLargeEdit = 4096;
// Drags of at most so many annotations, with at most so many highlighted elements together, also record each move.
constexpr std::size_t kManyAnnotations = 32;
constexpr std::size_t kManyHighlighted = 64;
// Limit on the moves of an evolution that are recorded state by state; about 24 bytes each.
constexpr std::size_t kMostEvolutionEdits = 1U << 20U;

std::unexpected<Error> bad_entry(std::string text) {
  return std::unexpected(Error{ErrorCode::bad_input, std::move(text)});
}

std::vector<SampleData::Contour> numbered(const CurveOrder& curve, SampleId first) {
  std::vector<SampleData::Contour> out;
  for (const CurveOrder::Contour& contour : curve.contours) {
    SampleData::Contour& to = out.emplace_back(SampleData::Contour{contour.closed, {}});
    to.points.reserve(contour.samples.size());
    for (const SampleId id : contour.samples) to.points.push_back(id.value - first.value);
  }
  return out;
}

// True if the edit only moves things.
bool is_motion(const TimelineEdit& edit) {
  return edit.removed.empty() && edit.inserted.empty() && edit.removed_balls.empty() && edit.inserted_balls.empty() &&
         !edit.curve && !edit.annotations && !edit.source;
}

// True if the edit only replaces the annotations.
bool is_of_annotations(const TimelineEdit& edit) {
  return edit.annotations && edit.removed.empty() && edit.moved.empty() && edit.inserted.empty() &&
         edit.removed_balls.empty() && edit.changed_balls.empty() && edit.inserted_balls.empty() && !edit.curve &&
         !edit.source;
}

template <class Place>
bool same_things(const std::vector<std::pair<std::uint32_t, Place>>& a,
                 const std::vector<std::pair<std::uint32_t, Place>>& b) {
  return std::ranges::equal(a, b, {}, &std::pair<std::uint32_t, Place>::first,
                            &std::pair<std::uint32_t, Place>::first);
}

bool all_known(const std::vector<std::uint32_t>& numbers, std::size_t known) {
  return std::ranges::all_of(numbers, [known](std::uint32_t number) { return number < known; });
}
template <class Place>
bool all_known(const std::vector<std::pair<std::uint32_t, Place>>& things, std::size_t known) {
  return std::ranges::all_of(things, [known](const auto& thing) { return thing.first < known; });
}

template <class SomeId>
std::vector<SomeId> ids_of(const std::vector<std::uint32_t>& numbers, SomeId first) {
  std::vector<SomeId> out;
  out.reserve(numbers.size());
  for (const std::uint32_t number : numbers) out.push_back(SomeId{first.value + number});
  return out;
}

template <class SomeId, class Place>
std::vector<std::pair<SomeId, Place>> places_of(const std::vector<std::pair<std::uint32_t, Place>>& numbers,
                                                SomeId first) {
  std::vector<std::pair<SomeId, Place>> out;
  out.reserve(numbers.size());
  for (const auto& [number, place] : numbers) out.emplace_back(SomeId{first.value + number}, place);
  return out;
}

TimelineEdit edit_of(const Document& document, const DocumentDelta& delta) {
  TimelineEdit out;
  const std::uint32_t first = document.first_id().value;
  for (const SampleEdit& edit : delta.edits) {
    switch (edit.kind) {
      case SampleEdit::Kind::insert: out.inserted.push_back(edit.to); break;
      case SampleEdit::Kind::remove: out.removed.push_back(edit.id.value - first); break;
      case SampleEdit::Kind::move: out.moved.emplace_back(edit.id.value - first, edit.to); break;
    }
  }
  const std::uint32_t first_ball = document.first_ball_id().value;
  for (const BallEdit& edit : delta.ball_edits) {
    switch (edit.kind) {
      case BallEdit::Kind::insert: out.inserted_balls.push_back(edit.to); break;
      case BallEdit::Kind::remove: out.removed_balls.push_back(edit.id.value - first_ball); break;
      case BallEdit::Kind::change: out.changed_balls.emplace_back(edit.id.value - first_ball, edit.to); break;
    }
  }
  if (delta.curve_after != delta.curve_before) out.curve = numbered(*delta.curve_after, document.first_id());
  if (delta.changes_annotations()) out.annotations = *delta.annotations_after;
  if (delta.changes_source()) {
    const CurveSource* const after = delta.source_after.get();
    SourceEdit& source = out.source.emplace(SourceEdit{.has_curves = after != nullptr});
    if (after != nullptr) {
      const bool are_other = !delta.source_before || delta.source_before->curves != after->curves;
      source = {true, are_other ? after->curves : nullptr, after->sampling, after->first, after->count};
    }
  }
  return out;
}

}  // namespace

LayersChanged difference(const LayerConfiguration& before, const LayerConfiguration& after) {
  LayersChanged out;
  for (const LayerConfiguration::Entry& entry : after.layers) {
    const auto old = std::ranges::find(before.layers, entry.layer, &LayerConfiguration::Entry::layer);
    if (old == before.layers.end() || *old != entry) out.changed.push_back(entry);
  }
  if (!std::ranges::equal(before.layers, after.layers, {}, &LayerConfiguration::Entry::layer,
                          &LayerConfiguration::Entry::layer))
    for (const LayerConfiguration::Entry& entry : after.layers) out.order.push_back(entry.layer);
  if (before.image != after.image) out.image = after.image;
  return out;
}

void apply(const LayersChanged& change, LayerConfiguration& configuration) {
  LayerFold fold(std::move(configuration));
  fold.apply(change);
  configuration = std::move(fold).take();
}

bool changes_document(const TimelineEntry& entry) {
  return std::holds_alternative<TimelineEdit>(entry) || std::holds_alternative<Undone>(entry) ||
         std::holds_alternative<Redone>(entry);
}

bool is_work(const TimelineEntry& entry) {
  if (const auto* layers = std::get_if<LayersChanged>(&entry)) return layers->role != LayersChanged::Role::noted;
  return changes_document(entry);
}

bool is_visible(const TimelineEntry& entry) {
  return !std::holds_alternative<GestureBegun>(entry) && !std::holds_alternative<GestureEnded>(entry);
}

Timeline::Timeline() : data_(std::make_shared<const SampleData>()) {}

void Timeline::restart(std::shared_ptr<const SampleData> data) {
  restart(std::move(data), TimelineLog());
}

void Timeline::restart(std::shared_ptr<const SampleData> data, TimelineLog entries, Lesson lesson) {
  data_ = std::move(data);
  entries_ = std::move(entries);
  lesson_ = std::move(lesson);
  lesson_revision_ = 0;
  gesture_at_.reset();
  is_gesture_overdue_ = false;
  evolution_at_.reset();
  ++generation_;
}

void Timeline::note_edit(const Document& document, const DocumentDelta& delta, const std::string& name,
                         bool continues) {
  end_overdue_gesture();
  TimelineEdit out = edit_of(document, delta);
  if (!gesture_at_) out.name = name;
  out.continues = continues;
  const bool is_large = delta.edits.size() + delta.ball_edits.size() > kLargeEdit ||
                        (out.annotations && (out.annotations->size() > kManyAnnotations ||
                                             highlighted_elements(*out.annotations) > kManyHighlighted));
  if (is_large && gesture_at_ && entries_.size() > *gesture_at_ + 1) {
    const TimelineEntry before = entries_.back();
    if (const auto* last = std::get_if<TimelineEdit>(&before);
        last != nullptr && ((is_of_annotations(*last) && is_of_annotations(out)) ||
                            (is_motion(*last) && is_motion(out) && same_things(last->moved, out.moved) &&
                             same_things(last->changed_balls, out.changed_balls)))) {
      entries_.replace_back(out);
      evolution_at_.reset();
      return;
    }
  }
  entries_.push_back(out);
  evolution_at_.reset();
}

void Timeline::note_evolved(const Document& document, const DocumentDelta& delta, const std::string& name,
                            bool replaces, bool is_state) {
  end_overdue_gesture();
  TimelineEdit out = edit_of(document, delta);
  out.name = name;
  out.replaces = replaces;
  out.is_state = is_state;
  const std::size_t edits = (replaces ? evolution_edits_ : 0) + delta.edits.size();
  if (replaces && evolution_at_) {
    const auto last = std::get<TimelineEdit>(entries_.back());
    if (is_motion(last) && is_motion(out)) {
      out.replaces = last.replaces;
      entries_.replace_back(out);
      evolution_edits_ = edits;
      return;
    }
  }
  entries_.push_back(out);
  evolution_edits_ = edits;
  evolution_at_.reset();
  if (delta.edits.size() > kLargeEdit || evolution_edits_ > kMostEvolutionEdits) evolution_at_ = entries_.size() - 1;
}

void Timeline::note_gesture_begun(const std::string& name) {
  end_overdue_gesture();
  entries_.push_back(GestureBegun{name});
  evolution_at_.reset();
  gesture_at_ = entries_.size() - 1;
}

void Timeline::note_gesture_ended() {
  is_gesture_overdue_ = gesture_at_.has_value();
  try {
    end_overdue_gesture();
  } catch (const std::bad_alloc&) {
    // The next entry will record the end.
  }
}

void Timeline::end_overdue_gesture() {
  if (!is_gesture_overdue_) return;
  bool has_edits = false;
  for (std::size_t i = *gesture_at_; i < entries_.size() && !has_edits; ++i) has_edits = is_work(entries_[i]);
  if (has_edits)
    entries_.push_back(GestureEnded{});
  else
    entries_.erase(*gesture_at_);
  gesture_at_.reset();
  is_gesture_overdue_ = false;
}

void DocumentReplay::change(const DocumentDelta& delta) {
  document_.apply(delta);
  if (listener_) listener_(delta);
}

Expected<void> DocumentReplay::begin(const SampleData& data) {
  const auto delta = replace_all(document_, data);
  if (!delta) return std::unexpected(delta.error());
  change(*delta);
  history_.clear();
  return {};
}

namespace {

/// `known` is the number of samples that exist or existed when the edit is done.
Expected<std::shared_ptr<const CurveSource>> source_after(const Document& document, const SourceEdit& edit,
                                                          std::size_t known) {
  if (!edit.has_curves) return nullptr;
  if (!edit.curves && !document.source()) return bad_entry("samples are taken from curves that are not there");
  if (edit.first > known || edit.count > known - edit.first)
    return bad_entry("the curves name samples that never were");
  if (const auto good = check(edit.sampling); !good) return bad_entry(good.error().text);
  return std::make_shared<const CurveSource>(
      CurveSource{edit.curves ? edit.curves : document.source()->curves, edit.sampling, edit.first, edit.count});
}

}  // namespace

Expected<DocumentDelta> delta_of(const Document& document, const TimelineEdit& edit) {
  if (!edit.removed.empty() && !edit.moved.empty()) return bad_entry("one edit removes samples and moves others");
  const int kinds_of_balls = !edit.removed_balls.empty() + !edit.changed_balls.empty() + !edit.inserted_balls.empty();
  if (kinds_of_balls > 1) return bad_entry("one edit does different things with balls");
  const SampleId first = document.first_id();
  const BallId first_ball = document.first_ball_id();
  const std::size_t known = document.next_id().value - first.value;
  const std::size_t known_balls = document.next_ball_id().value - first_ball.value;
  if (!all_known(edit.removed, known) || !all_known(edit.moved, known)) return bad_entry("an edit of no sample");
  if (!all_known(edit.removed_balls, known_balls) || !all_known(edit.changed_balls, known_balls))
    return bad_entry("an edit of no ball");
  const auto removed = ids_of(edit.removed, first);
  const auto moved = places_of(edit.moved, first);
  const auto removed_balls = ids_of(edit.removed_balls, first_ball);
  const auto changed_balls = places_of(edit.changed_balls, first_ball);
  auto out = change_document(document, {.removed = removed,
                                        .moved = moved,
                                        .inserted = edit.inserted,
                                        .removed_balls = removed_balls,
                                        .changed_balls = changed_balls,
                                        .inserted_balls = edit.inserted_balls});
  if (out && edit.annotations) {
    const NumberedThings numbered{edit.inserted.size() + known, edit.inserted_balls.size() + known_balls};
    if (auto fault = fault_of(*edit.annotations, numbered); !fault.empty()) return bad_entry(std::move(fault));
    if (*edit.annotations != *out->annotations_after)
      out->annotations_after = std::make_shared<const Annotations>(*edit.annotations);
  }
  if (out && edit.source) {
    auto source = source_after(document, *edit.source, known + edit.inserted.size());
    if (!source) return std::unexpected(source.error());
    out->source_after = *std::move(source);
  }
  if (!out || !edit.curve) return out;
  auto curve = std::make_shared<CurveOrder>();
  for (const SampleData::Contour& contour : *edit.curve) {
    if (!all_known(contour.points, known + edit.inserted.size()))
      return bad_entry("a contour names a sample that never was");
    curve->contours.push_back({contour.closed, ids_of(contour.points, first)});
  }
  out->curve_after = std::move(curve);
  return out;
}

namespace {

History::Role role_of(const TimelineEdit& edit) {
  if (edit.is_state) return History::Role::state;
  return edit.continues && !edit.replaces ? History::Role::continues : History::Role::plain;
}

}  // namespace

Expected<void> DocumentReplay::apply_replacement(const TimelineEdit& edit) {
  if (!history_.raise_edit()) return bad_entry("a replacement has no step before it");
  std::vector<DocumentDelta> changes = history_.undo();
  for (const DocumentDelta& back : changes) document_.apply(back);
  const auto delta = delta_of(document_, edit);
  if (!delta) {
    for (const DocumentDelta& again : history_.redo()) document_.apply(again);
    return std::unexpected(delta.error());
  }
  document_.apply(*delta);
  history_.record(*delta, edit.name, role_of(edit));
  if (!delta->is_empty()) changes.push_back(*delta);
  if (listener_) listener_(one_after_the_other(changes));
  return {};
}

Expected<void> DocumentReplay::apply_edit(const TimelineEdit& edit) {
  if (edit.replaces) return apply_replacement(edit);
  const auto delta = delta_of(document_, edit);
  if (!delta) return std::unexpected(delta.error());
  if (delta->is_empty()) return {};
  change(*delta);
  history_.record(*delta, edit.name, role_of(edit));
  return {};
}

// The window or the player owns the layers; this class only keeps their undo steps.
Expected<void> DocumentReplay::apply_layers(const LayersChanged& change) {
  using Role = LayersChanged::Role;
  switch (change.role) {
    case Role::noted: return {};
    case Role::step:
    case Role::joined: {
      if (change.back.size() != 1) return bad_entry("a change of the layers does not say what undoes it");
      History::Layers layers{change, change.back.front()};
      if (change.role == Role::step) {
        if (history_.in_gesture()) return bad_entry("a change of the layers within a gesture");
        history_.record_layers(std::move(layers), change.name);
      } else if (!history_.join_layers(std::move(layers))) {
        return bad_entry("a change of the layers has no step to be part of");
      }
      return {};
    }
    case Role::undone:
      if (!history_.undoes_layers()) return bad_entry("the step to undo is not a change of the layers");
      history_.undo();
      return {};
    case Role::redone:
      if (!history_.redoes_layers()) return bad_entry("the step to redo is not a change of the layers");
      history_.redo();
      return {};
  }
  return {};
}

Expected<void> DocumentReplay::apply(const TimelineEntry& entry) {
  if (const auto* edit = std::get_if<TimelineEdit>(&entry)) return apply_edit(*edit);
  if (const auto* begun = std::get_if<GestureBegun>(&entry)) {
    if (history_.in_gesture()) return bad_entry("a gesture begins within another");
    history_.begin_gesture(begun->name);
  } else if (std::holds_alternative<GestureEnded>(entry)) {
    if (!history_.in_gesture()) return bad_entry("a gesture ends that never began");
    history_.end_gesture();
  } else if (std::holds_alternative<Undone>(entry)) {
    if (!history_.raise_edit()) return bad_entry("there is nothing to undo");
    for (const DocumentDelta& delta : history_.undo()) change(delta);
  } else if (std::holds_alternative<Redone>(entry)) {
    if (!history_.redoes_edit()) return bad_entry("there is nothing to redo");
    for (const DocumentDelta& delta : history_.redo()) change(delta);
  } else if (const auto* layers = std::get_if<LayersChanged>(&entry)) {
    return apply_layers(*layers);
  }
  return {};
}

void DocumentReplay::finish() {
  if (history_.in_gesture()) history_.end_gesture();
}

}  // namespace mes
