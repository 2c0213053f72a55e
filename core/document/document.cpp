// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document.h"

#include <algorithm>
#include <bit>

#include "core/base/assert.h"

namespace mes {
namespace {

std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 30U;
  x *= 0xbf58476d1ce4e5b9ULL;
  x ^= x >> 27U;
  x *= 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

}  // namespace

Document::Document() : curve_(std::make_shared<const CurveOrder>()) {}

Slot Document::slot_of(SampleId id) const {
  const auto found = slot_of_.find(id);
  return found == slot_of_.end() ? kNoSlot : found->second;
}

std::vector<Slot> Document::slots_in_input_order() const {
  std::vector<Slot> slots;
  slots.reserve(alive_);
  for (Slot slot = 0; slot < id_.size(); ++slot)
    if (id_[slot].is_valid()) slots.push_back(slot);
  std::ranges::sort(slots, {}, [this](Slot slot) { return id_[slot]; });
  return slots;
}

Box2 Document::bounding_box() const {
  Box2 box;
  for (Slot slot = 0; slot < id_.size(); ++slot)
    if (id_[slot].is_valid()) box.add(position_[slot]);
  return box;
}

std::uint64_t Document::digest() const {
  std::uint64_t sum = mix(alive_);
  for (Slot slot = 0; slot < id_.size(); ++slot) {
    if (!id_[slot].is_valid()) continue;
    const std::uint64_t x = mix(std::bit_cast<std::uint64_t>(position_[slot].x) + id_[slot].value);
    sum += mix(x ^ std::bit_cast<std::uint64_t>(position_[slot].y));
  }
  return sum;
}

std::shared_ptr<const SampleSnapshot> Document::snapshot() const {
  return std::make_shared<const SampleSnapshot>(SampleSnapshot{position_, id_, free_});
}

void Document::insert(const SampleEdit& edit) {
  if (!free_.empty() && free_.back() == edit.slot) {
    free_.pop_back();
  } else {
    MES_ASSERT(edit.slot == position_.size());
    position_.emplace_back();
    id_.emplace_back();
  }
  position_[edit.slot] = edit.to;
  id_[edit.slot] = edit.id;
  slot_of_.emplace(edit.id, edit.slot);
  next_id_ = std::max(next_id_, edit.id.value + 1);
  ++alive_;
}

void Document::remove(const SampleEdit& edit) {
  MES_ASSERT(is_alive(edit.slot) && id_[edit.slot] == edit.id);
  slot_of_.erase(edit.id);
  id_[edit.slot] = SampleId{};
  position_[edit.slot] = Vec2{};
  free_.push_back(edit.slot);
  --alive_;
}

void Document::apply(const DocumentDelta& delta) {
  MES_ASSERT(delta.from_revision == revision_);
  // History does not record what changes nothing, so it must not make a revision either.
  if (delta.is_empty()) return;
  if (delta.replaces_all()) {
    position_ = delta.after->position;
    id_ = delta.after->id;
    free_ = delta.after->free_slots;
    alive_ = 0;
    slot_of_.clear();
    slot_of_.reserve(id_.size());
    for (Slot slot = 0; slot < id_.size(); ++slot) {
      if (!id_[slot].is_valid()) continue;
      slot_of_.emplace(id_[slot], slot);
      next_id_ = std::max(next_id_, id_[slot].value + 1);
      ++alive_;
    }
  }
  for (const SampleEdit& edit : delta.edits) {
    switch (edit.kind) {
      case SampleEdit::Kind::insert: insert(edit); break;
      case SampleEdit::Kind::remove: remove(edit); break;
      case SampleEdit::Kind::move:
        MES_ASSERT(is_alive(edit.slot) && id_[edit.slot] == edit.id);
        position_[edit.slot] = edit.to;
        break;
    }
  }
  if (delta.curve_after) curve_ = delta.curve_after;
  revision_ = delta.to_revision;
  highest_revision_ = std::max(highest_revision_, revision_);
}

}  // namespace mes
