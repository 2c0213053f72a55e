// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/commands.h"

#include <limits>
#include <string>
#include <unordered_set>

namespace mes {
namespace {

// -0.0 + 0.0 is +0.0: equal points then have equal bits.
Vec2 without_negative_zero(Vec2 p) {
  return {p.x + 0.0, p.y + 0.0};
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

Expected<Slot> live_slot(const Document& document, SampleId id, std::unordered_set<SampleId>& seen) {
  const Slot slot = document.slot_of(id);
  if (slot == kNoSlot) return refuse("sample " + std::to_string(id.value) + " does not exist");
  if (!seen.insert(id).second) return refuse("sample " + std::to_string(id.value) + " is named twice");
  return slot;
}

}  // namespace

Expected<DocumentDelta> insert_samples(const Document& document, std::span<const Vec2> positions) {
  DocumentDelta delta = delta_from(document);
  delta.edits.reserve(positions.size());
  const auto free = document.free_slots();
  if (positions.size() >= std::numeric_limits<std::uint32_t>::max() - document.next_id().value)
    return refuse("too many samples in one session");
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!is_finite(positions[i])) return refuse("a coordinate is not a finite number");
    const Slot slot =
        i < free.size() ? free[free.size() - 1 - i] : static_cast<Slot>(document.slot_count() + i - free.size());
    delta.edits.push_back({SampleEdit::Kind::insert,
                           SampleId{document.next_id().value + static_cast<std::uint32_t>(i)}, slot, Vec2{},
                           without_negative_zero(positions[i])});
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
    if (!is_finite(to)) return refuse("a coordinate is not a finite number");
    const Vec2 target = without_negative_zero(to);
    if (target == document.position(*slot)) continue;
    delta.edits.push_back({SampleEdit::Kind::move, id, *slot, document.position(*slot), target});
  }
  return delta;
}

Expected<DocumentDelta> replace_all(const Document& document, const SampleData& data) {
  DocumentDelta delta = delta_from(document);
  auto after = std::make_shared<SampleSnapshot>();
  const std::uint32_t first = document.next_id().value;
  if (data.positions.size() >= std::numeric_limits<std::uint32_t>::max() - first)
    return refuse("too many samples in one session");
  after->position.reserve(data.positions.size());
  after->id.reserve(data.positions.size());
  for (const Vec2 p : data.positions) {
    if (!is_finite(p)) return refuse("a coordinate is not a finite number");
    after->id.push_back(SampleId{first + static_cast<std::uint32_t>(after->id.size())});
    after->position.push_back(without_negative_zero(p));
  }
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
  delta.before = document.snapshot();
  delta.after = std::move(after);
  delta.curve_after = std::move(curve);
  return delta;
}

}  // namespace mes
