// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/commands.h"

#include <fmt/core.h>
#include <algorithm>
#include <limits>
#include <string>
#include <unordered_set>

#include "core/base/assert.h"
#include "core/document/curve_source.h"
#include "core/document/live_corners.h"

namespace mes {
namespace {

// -0.0 + 0.0 is +0.0: equal points then have equal bits.
Vec2 without_negative_zero(Vec2 p) {
  return {p.x + 0.0, p.y + 0.0};
}
Disk without_negative_zero(const Disk& disk) {
  return {without_negative_zero(disk.center), disk.radius + 0.0};
}

std::unexpected<Error> refuse(std::string text) {
  return std::unexpected(Error{ErrorCode::usage, std::move(text), {}, 0, 0});
}

DocumentDelta delta_from(const Document& document) {
  DocumentDelta delta;
  delta.from_revision = document.revision();
  delta.to_revision = document.next_revision();
  delta.curve_before = delta.curve_after = document.curve_order();
  delta.annotations_before = delta.annotations_after = document.annotations();
  delta.source_before = delta.source_after = document.source();
  return delta;
}

// Conditions on each sample and ball; empty if they hold.
template <class Value>
std::string value_fault_of(const Value& value) {
  std::string out;
  for_each_number(value, [&out](double x) {
    if (const auto fault = range_fault_of(x); fault && out.empty()) out = describe(*fault, x);
  });
  return out;
}
std::string fault_of(Vec2 p) {
  return value_fault_of(p);
}
std::string fault_of(const Disk& disk) {
  return disk.radius < 0.0 ? "a radius is negative" : value_fault_of(disk);
}

// Checks the conditions on all numbers together.
Expected<DocumentDelta> fitting(const Document& document, DocumentDelta delta) {
  const Magnitudes after = document.magnitudes_after(delta);
  if (after.fit()) return delta;
  std::string text;
  for_each_new_number(delta, [&](double x) {
    if (const auto fault = after.fault_of(x); fault && text.empty()) text = describe(*fault, x, after);
  });
  return refuse(std::move(text));
}

bool has_room(std::uint32_t next_id, std::size_t wanted) {
  return wanted < std::numeric_limits<std::uint32_t>::max() - next_id;
}

template <class Tag>
Expected<Slot<Tag>> live_slot(Slot<Tag> slot, Id<Tag> id, std::string_view kind, std::unordered_set<Id<Tag>>& seen) {
  if (slot == kNoSlot) return refuse(fmt::format("{} {} does not exist", kind, id.value));
  if (!seen.insert(id).second) return refuse(fmt::format("{} {} is named twice", kind, id.value));
  return slot;
}
Expected<SampleSlot> live_slot(const Document& document, SampleId id, std::unordered_set<SampleId>& seen) {
  return live_slot(document.slot_of(id), id, "sample", seen);
}
Expected<BallSlot> live_slot(const Document& document, BallId id, std::unordered_set<BallId>& seen) {
  return live_slot(document.ball_slot_of(id), id, "ball", seen);
}

/// Fills `values`, and assigns fresh ids.
template <class Value, class SomeId>
Expected<void> number(std::span<const Value> wanted, SomeId first, std::string_view kind, std::vector<Value>& values,
                      std::vector<SomeId>& ids) {
  if (!has_room(first.value, wanted.size())) return refuse(fmt::format("too many {} in one session", kind));
  values.reserve(wanted.size());
  ids.reserve(wanted.size());
  for (const Value& value : wanted) {
    if (auto fault = fault_of(value); !fault.empty()) return refuse(std::move(fault));
    ids.push_back(SomeId{first.value + static_cast<std::uint32_t>(ids.size())});
    values.push_back(without_negative_zero(value));
  }
  return {};
}

}  // namespace

namespace {

// Differences between the edits of samples and of balls.
struct Samples {
  using SomeId = SampleId;
  using Edit = SampleEdit;
  static constexpr auto kChange = SampleEdit::Kind::move;
  static constexpr std::string_view kKind = "samples";
  static std::uint32_t next_id(const Document& document) { return document.next_id().value; }
  static SampleSlot slot_for_new(const Document& document, std::size_t i) { return document.slot_for_new_sample(i); }
  static Vec2 value(const Document& document, SampleSlot slot) { return document.position(slot); }
};
struct Balls {
  using SomeId = BallId;
  using Edit = BallEdit;
  static constexpr auto kChange = BallEdit::Kind::change;
  static constexpr std::string_view kKind = "balls";
  static std::uint32_t next_id(const Document& document) { return document.next_ball_id().value; }
  static BallSlot slot_for_new(const Document& document, std::size_t i) { return document.slot_for_new_ball(i); }
  static Disk value(const Document& document, BallSlot slot) { return document.disk(slot); }
};

/// Appends the edits to the list.
template <class Things, class Value>
Expected<void> add_edits(const Document& document, std::span<const typename Things::SomeId> removed,
                         std::span<const std::pair<typename Things::SomeId, Value>> changed,
                         std::span<const Value> inserted, std::vector<typename Things::Edit>& edits) {
  using Kind = typename Things::Edit::Kind;
  MES_ASSERT(removed.empty() || changed.empty());
  edits.reserve(removed.size() + changed.size() + inserted.size());
  std::unordered_set<typename Things::SomeId> seen;
  for (const auto id : removed) {
    const auto slot = live_slot(document, id, seen);
    if (!slot) return std::unexpected(slot.error());
    edits.push_back({Kind::remove, id, *slot, Things::value(document, *slot), Value{}});
  }
  for (const auto& [id, to] : changed) {
    const auto slot = live_slot(document, id, seen);
    if (!slot) return std::unexpected(slot.error());
    if (auto fault = fault_of(to); !fault.empty()) return refuse(std::move(fault));
    const Value target = without_negative_zero(to);
    if (target == Things::value(document, *slot)) continue;
    edits.push_back({Things::kChange, id, *slot, Things::value(document, *slot), target});
  }
  const std::uint32_t first = Things::next_id(document);
  if (!has_room(first, inserted.size())) return refuse(fmt::format("too many {} in one session", Things::kKind));
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    if (auto fault = fault_of(inserted[i]); !fault.empty()) return refuse(std::move(fault));
    // Reuses the rows that were freed last first.
    const auto slot =
        i < removed.size() ? edits[removed.size() - 1 - i].slot : Things::slot_for_new(document, i - removed.size());
    edits.push_back({Kind::insert, typename Things::SomeId{first + static_cast<std::uint32_t>(i)}, slot, Value{},
                     without_negative_zero(inserted[i])});
  }
  return {};
}

/// Fixes the anchors on removed samples and balls, and drops elements that are highlighted on them.
void leave_where_they_are(const Document& document, DocumentDelta& delta) {
  const Annotations& before = *document.annotations();
  if (before.empty()) return;
  const std::uint32_t first = document.first_id().value;
  std::unordered_set<std::uint32_t> removed;
  for (const SampleEdit& edit : delta.edits)
    if (edit.kind == SampleEdit::Kind::remove) removed.insert(edit.id.value - first);
  const std::uint32_t first_ball = document.first_ball_id().value;
  std::unordered_set<std::uint32_t> removed_balls;
  for (const BallEdit& edit : delta.ball_edits)
    if (edit.kind == BallEdit::Kind::remove) removed_balls.insert(edit.id.value - first_ball);
  if (removed.empty() && removed_balls.empty()) return;
  const auto is_removed = [&](const Anchor& anchor) {
    return std::ranges::any_of(anchor.samples, [&](std::uint32_t number) { return removed.contains(number); }) ||
           std::ranges::any_of(anchor.balls, [&](std::uint32_t number) { return removed_balls.contains(number); });
  };
  Annotations after = before;
  std::erase_if(after, [&](Annotation& annotation) { return lose_elements(annotation, is_removed); });
  for (Annotation& annotation : after)
    for (Anchor& anchor : annotation.anchors)
      if (is_removed(anchor)) anchor = {.at = document.place_of(anchor)};
  if (after != before) delta.annotations_after = std::make_shared<const Annotations>(std::move(after));
}

}  // namespace

Expected<DocumentDelta> change_document(const Document& document, const DocumentChange& change) {
  DocumentDelta delta = delta_from(document);
  if (auto done = add_edits<Samples>(document, change.removed, change.moved, change.inserted, delta.edits); !done)
    return std::unexpected(done.error());
  if (auto done = add_edits<Balls>(document, change.removed_balls, change.changed_balls, change.inserted_balls,
                                   delta.ball_edits);
      !done)
    return std::unexpected(done.error());
  leave_where_they_are(document, delta);
  return fitting(document, std::move(delta));
}

namespace {

/// `first` is the id of the first sample in the data.
Expected<void> add_contours(const SampleData& data, std::uint32_t first, CurveOrder& curve) {
  for (const auto& contour : data.contours) {
    CurveOrder::Contour out{contour.closed, {}};
    out.samples.reserve(contour.points.size());
    for (const std::uint32_t index : contour.points) {
      if (index >= data.positions.size()) return refuse("a contour names a point that does not exist");
      out.samples.push_back(SampleId{first + index});
    }
    curve.contours.push_back(std::move(out));
  }
  return {};
}

/// True if there is no source, or if it names samples of the data.
bool is_source_of(const SampleData& data) {
  return !data.source || (data.source->curves && data.source->first <= data.positions.size() &&
                          data.source->count <= data.positions.size() - data.source->first);
}

std::shared_ptr<const CurveSource> shifted(const std::shared_ptr<const CurveSource>& source, std::uint32_t by) {
  if (!source || by == 0) return source;
  CurveSource out = *source;
  out.first += by;
  return std::make_shared<const CurveSource>(std::move(out));
}

}  // namespace

Expected<DocumentDelta> annotate(const Document& document, Annotations annotations) {
  if (auto fault = fault_of(annotations, document.numbered_things()); !fault.empty()) return refuse(std::move(fault));
  DocumentDelta delta = delta_from(document);
  if (annotations != *document.annotations())
    delta.annotations_after = std::make_shared<const Annotations>(std::move(annotations));
  return delta;
}

Expected<DocumentDelta> set_contours(const Document& document, CurveOrder contours) {
  for (const CurveOrder::Contour& contour : contours.contours)
    for (const SampleId id : contour.samples)
      if (id.value < document.first_id().value || id.value >= document.next_id().value)
        return refuse("a contour names a sample that never was");
  DocumentDelta delta = delta_from(document);
  if (contours != *document.curve_order())
    delta.curve_after = std::make_shared<const CurveOrder>(std::move(contours));
  return delta;
}

DocumentDelta set_source(const Document& document, std::shared_ptr<const CurveSource> source) {
  DocumentDelta delta = delta_from(document);
  delta.source_after = std::move(source);
  return delta;
}

Expected<DocumentDelta> arrange_samples(const Document& document, std::span<const Vec2> positions,
                                        std::span<const SampleData::Contour> contours) {
  if (positions.size() < document.sample_count()) return refuse("there are fewer places than samples");
  std::vector<SampleId> ids;
  ids.reserve(positions.size());
  std::vector<std::pair<SampleId, Vec2>> targets;
  targets.reserve(document.sample_count());
  for (const SampleSlot slot : document.slots_in_input_order()) {
    targets.emplace_back(document.id(slot), positions[targets.size()]);
    ids.push_back(document.id(slot));
  }
  auto delta = change_document(document, {.moved = targets, .inserted = positions.subspan(targets.size())});
  if (!delta || contours.empty()) return delta;
  for (const SampleEdit& edit : delta->edits)
    if (edit.kind == SampleEdit::Kind::insert) ids.push_back(edit.id);
  auto curve = std::make_shared<CurveOrder>();
  for (const SampleData::Contour& contour : contours) {
    CurveOrder::Contour& out = curve->contours.emplace_back(CurveOrder::Contour{contour.closed, {}});
    out.samples.reserve(contour.points.size());
    for (const std::uint32_t place : contour.points) {
      if (place >= ids.size()) return refuse("a contour names a point that does not exist");
      out.samples.push_back(ids[place]);
    }
  }
  if (*curve != *document.curve_order()) delta->curve_after = std::move(curve);
  return delta;
}

Expected<DocumentDelta> resample(const Document& document, const SampleData& data) {
  const std::vector<SampleId> removed = document.samples_of_source();
  auto delta = change_document(document, {.removed = removed, .inserted = data.positions});
  if (!delta) return delta;
  auto curve = std::make_shared<CurveOrder>();
  const std::unordered_set<SampleId> gone(removed.begin(), removed.end());
  for (const CurveOrder::Contour& contour : document.curve_order()->contours)
    if (std::ranges::any_of(contour.samples,
                            [&](SampleId id) { return document.slot_of(id) != kNoSlot && !gone.contains(id); }))
      curve->contours.push_back(contour);
  const std::uint32_t first = document.next_id().value;
  if (auto done = add_contours(data, first, *curve); !done) return std::unexpected(done.error());
  if (*curve != *document.curve_order()) delta->curve_after = std::move(curve);
  if (!is_source_of(data)) return refuse("the curves name samples that do not exist");
  delta->source_after = shifted(data.source, first - document.first_id().value);
  return delta;
}

Expected<DocumentDelta> replace_all(const Document& document, const SampleData& data) {
  DocumentDelta delta = delta_from(document);
  auto after = std::make_shared<SampleSnapshot>();
  const std::uint32_t first = document.next_id().value;
  if (auto done = number(std::span(data.positions), document.next_id(), "samples", after->position.values(),
                         after->id.values());
      !done)
    return std::unexpected(done.error());
  auto balls_after = std::make_shared<BallSnapshot>();
  if (auto done = number(std::span(data.balls), document.next_ball_id(), "balls", balls_after->disk.values(),
                         balls_after->id.values());
      !done)
    return std::unexpected(done.error());
  auto curve = std::make_shared<CurveOrder>();
  if (auto done = add_contours(data, first, *curve); !done) return std::unexpected(done.error());
  if (!is_source_of(data)) return refuse("the curves name samples that do not exist");
  delta.source_after = data.source;
  if (auto fault = fault_of(data.annotations, {data.positions.size(), data.balls.size()}); !fault.empty())
    return refuse(std::move(fault));
  delta.annotations_after = std::make_shared<const Annotations>(data.annotations);
  after->first = document.next_id();
  after->map = data.map;
  balls_after->first = document.next_ball_id();
  delta.before = document.snapshot();
  delta.after = std::move(after);
  delta.balls_before = document.ball_snapshot();
  delta.balls_after = std::move(balls_after);
  delta.curve_after = std::move(curve);
  return fitting(document, std::move(delta));
}

SampleData data_of(const Document& document) {
  SampleData out;
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  out.positions.reserve(slots.size());
  Table<SampleSlot, std::uint32_t> place(document.slot_count(), 0);
  for (const SampleSlot slot : slots) {
    place[slot] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(document.position(slot));
  }
  for (const CurveOrder::Contour& contour : document.curve_order()->contours) {
    SampleData::Contour kept{.closed = contour.closed, .points = {}};
    for (const SampleId id : live_corners(document, contour)) kept.points.push_back(place[document.slot_of(id)]);
    if (!kept.points.empty()) out.contours.push_back(std::move(kept));
  }
  Table<BallSlot, std::uint32_t> ball_place(document.ball_slot_count(), 0);
  for (const BallSlot slot : document.ball_slots_in_input_order()) {
    ball_place[slot] = static_cast<std::uint32_t>(out.balls.size());
    out.balls.push_back(document.disk(slot));
  }
  const std::uint32_t first = document.first_id().value;
  if (const std::shared_ptr<const CurveSource>& source = document.source()) {
    // The samples of the source are consecutive in input order.
    const std::vector<SampleId> left = document.samples_of_source();
    CurveSource renumbered = *source;
    renumbered.first = left.empty() ? 0 : place[document.slot_of(left.front())];
    renumbered.count = static_cast<std::uint32_t>(left.size());
    out.source = std::make_shared<const CurveSource>(std::move(renumbered));
  }
  out.map = document.map();
  out.annotations = *document.annotations();
  for (Annotation& annotation : out.annotations) {
    for (Anchor& anchor : annotation.anchors) {
      anchor.at = document.place_of(anchor);
      for (std::uint32_t& number : anchor.samples) {
        const SampleSlot slot = document.slot_of(SampleId{first + number});
        if (slot == kNoSlot) {
          anchor.samples.clear();
          break;
        }
        number = place[slot];
      }
      for (std::uint32_t& number : anchor.balls) {
        const BallSlot slot = document.ball_slot_of(BallId{document.first_ball_id().value + number});
        if (slot == kNoSlot) {
          anchor = {.at = anchor.at};
          break;
        }
        number = ball_place[slot];
      }
    }
  }
  return out;
}

}  // namespace mes
