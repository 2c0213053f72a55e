// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/commands.h"

#include <limits>
#include <string>
#include <unordered_set>

#include "core/base/assert.h"

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
  return delta;
}

// What all samples and all balls must satisfy; empty when they do.
std::string fault_of(Vec2 p) {
  return is_finite(p) ? std::string() : "a coordinate is not a finite number";
}
std::string fault_of(const Disk& disk) {
  if (!is_finite(disk)) return "a coordinate or a radius is not a finite number";
  return disk.radius < 0.0 ? "a radius is negative" : std::string();
}

bool has_room(std::uint32_t next_id, std::size_t wanted) {
  return wanted < std::numeric_limits<std::uint32_t>::max() - next_id;
}

template <class SomeId>
Expected<Slot> live_slot(Slot slot, SomeId id, std::string_view kind, std::unordered_set<SomeId>& seen) {
  const auto named = [&] { return std::string(kind) + ' ' + std::to_string(id.value); };
  if (slot == kNoSlot) return refuse(named() + " does not exist");
  if (!seen.insert(id).second) return refuse(named() + " is named twice");
  return slot;
}
Expected<Slot> live_slot(const Document& document, SampleId id, std::unordered_set<SampleId>& seen) {
  return live_slot(document.slot_of(id), id, "sample", seen);
}
Expected<Slot> live_slot(const Document& document, BallId id, std::unordered_set<BallId>& seen) {
  return live_slot(document.ball_slot_of(id), id, "ball", seen);
}

/// Fills in `values` and fresh ids.
template <class Value, class SomeId>
Expected<void> number(std::span<const Value> wanted, SomeId first, std::string_view kind, std::vector<Value>& values,
                      std::vector<SomeId>& ids) {
  if (!has_room(first.value, wanted.size())) return refuse("too many " + std::string(kind) + " in one session");
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

Expected<DocumentDelta> insert_samples(const Document& document, std::span<const Vec2> positions) {
  DocumentDelta delta = delta_from(document);
  delta.edits.reserve(positions.size());
  const std::uint32_t first = document.next_id().value;
  if (!has_room(first, positions.size())) return refuse("too many samples in one session");
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (auto fault = fault_of(positions[i]); !fault.empty()) return refuse(std::move(fault));
    delta.edits.push_back({SampleEdit::Kind::insert, SampleId{first + static_cast<std::uint32_t>(i)},
                           document.slot_for_new_sample(i), Vec2{}, without_negative_zero(positions[i])});
  }
  return delta;
}

Expected<DocumentDelta> remove_samples(const Document& document, std::span<const SampleId> ids) {
  DocumentDelta delta = delta_from(document);
  delta.edits.reserve(ids.size());
  std::unordered_set<SampleId> seen;
  for (const SampleId id : ids) {
    const auto slot = live_slot(document, id, seen);
    if (!slot) return std::unexpected(slot.error());
    delta.edits.push_back({SampleEdit::Kind::remove, id, *slot, document.position(*slot), Vec2{}});
  }
  return delta;
}

Expected<DocumentDelta> move_samples(const Document& document, std::span<const std::pair<SampleId, Vec2>> targets) {
  DocumentDelta delta = delta_from(document);
  delta.edits.reserve(targets.size());
  std::unordered_set<SampleId> seen;
  for (const auto& [id, to] : targets) {
    const auto slot = live_slot(document, id, seen);
    if (!slot) return std::unexpected(slot.error());
    if (auto fault = fault_of(to); !fault.empty()) return refuse(std::move(fault));
    const Vec2 target = without_negative_zero(to);
    if (target == document.position(*slot)) continue;
    delta.edits.push_back({SampleEdit::Kind::move, id, *slot, document.position(*slot), target});
  }
  return delta;
}

Expected<DocumentDelta> insert_balls(const Document& document, std::span<const Disk> disks) {
  DocumentDelta delta = delta_from(document);
  delta.ball_edits.reserve(disks.size());
  const std::uint32_t first = document.next_ball_id().value;
  if (!has_room(first, disks.size())) return refuse("too many balls in one session");
  for (std::size_t i = 0; i < disks.size(); ++i) {
    if (auto fault = fault_of(disks[i]); !fault.empty()) return refuse(std::move(fault));
    delta.ball_edits.push_back({BallEdit::Kind::insert, BallId{first + static_cast<std::uint32_t>(i)},
                                document.slot_for_new_ball(i), Disk{}, without_negative_zero(disks[i])});
  }
  return delta;
}

Expected<DocumentDelta> remove_balls(const Document& document, std::span<const BallId> ids) {
  DocumentDelta delta = delta_from(document);
  delta.ball_edits.reserve(ids.size());
  std::unordered_set<BallId> seen;
  for (const BallId id : ids) {
    const auto slot = live_slot(document, id, seen);
    if (!slot) return std::unexpected(slot.error());
    delta.ball_edits.push_back({BallEdit::Kind::remove, id, *slot, document.disk(*slot), Disk{}});
  }
  return delta;
}

Expected<DocumentDelta> change_balls(const Document& document, std::span<const std::pair<BallId, Disk>> targets) {
  DocumentDelta delta = delta_from(document);
  delta.ball_edits.reserve(targets.size());
  std::unordered_set<BallId> seen;
  for (const auto& [id, to] : targets) {
    const auto slot = live_slot(document, id, seen);
    if (!slot) return std::unexpected(slot.error());
    if (auto fault = fault_of(to); !fault.empty()) return refuse(std::move(fault));
    const Disk target = without_negative_zero(to);
    if (target == document.disk(*slot)) continue;
    delta.ball_edits.push_back({BallEdit::Kind::change, id, *slot, document.disk(*slot), target});
  }
  return delta;
}

Expected<DocumentDelta> together(Expected<DocumentDelta> samples, const Expected<DocumentDelta>& balls) {
  if (!samples) return samples;
  if (!balls) return balls;
  MES_ASSERT(samples->from_revision == balls->from_revision && samples->ball_edits.empty() && balls->edits.empty());
  MES_ASSERT(!samples->replaces_all() && !balls->replaces_all());
  samples->ball_edits = balls->ball_edits;
  return samples;
}

Expected<DocumentDelta> arrange_samples(const Document& document, std::span<const Vec2> positions,
                                        std::span<const SampleData::Contour> contours) {
  if (positions.size() < document.sample_count()) return refuse("there are fewer places than samples");
  std::vector<SampleId> ids;
  ids.reserve(positions.size());
  std::vector<std::pair<SampleId, Vec2>> targets;
  targets.reserve(document.sample_count());
  for (const Slot slot : document.slots_in_input_order()) {
    targets.emplace_back(document.id(slot), positions[targets.size()]);
    ids.push_back(document.id(slot));
  }
  auto delta = move_samples(document, targets);
  if (!delta) return delta;
  const auto inserted = insert_samples(document, positions.subspan(targets.size()));
  if (!inserted) return inserted;
  delta->edits.insert(delta->edits.end(), inserted->edits.begin(), inserted->edits.end());
  if (contours.empty()) return delta;
  for (const SampleEdit& edit : inserted->edits) ids.push_back(edit.id);
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

Expected<DocumentDelta> replace_all(const Document& document, const SampleData& data) {
  DocumentDelta delta = delta_from(document);
  auto after = std::make_shared<SampleSnapshot>();
  const std::uint32_t first = document.next_id().value;
  if (auto done = number(std::span(data.positions), document.next_id(), "samples", after->position, after->id); !done)
    return std::unexpected(done.error());
  auto balls_after = std::make_shared<BallSnapshot>();
  if (auto done = number(std::span(data.balls), document.next_ball_id(), "balls", balls_after->disk, balls_after->id);
      !done)
    return std::unexpected(done.error());
  auto curve = std::make_shared<CurveOrder>();
  for (const auto& contour : data.contours) {
    CurveOrder::Contour out{contour.closed, {}};
    out.samples.reserve(contour.points.size());
    for (const std::uint32_t index : contour.points) {
      if (index >= data.positions.size()) return refuse("a contour names a point that does not exist");
      out.samples.push_back(SampleId{first + index});
    }
    curve->contours.push_back(std::move(out));
  }
  after->first = document.next_id();
  balls_after->first = document.next_ball_id();
  delta.before = document.snapshot();
  delta.after = std::move(after);
  delta.balls_before = document.ball_snapshot();
  delta.balls_after = std::move(balls_after);
  delta.curve_after = std::move(curve);
  return delta;
}

}  // namespace mes
