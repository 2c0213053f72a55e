// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/samples.h"

#include <algorithm>
#include <limits>

namespace mes {

Samples::Samples() : SourceStructure("samples"), curve_(std::make_shared<const CurveOrder>()) {}

// Allocates all memory first, so that pending deltas are applied completely or not at all; nothing else could restore
// the rows.
void Samples::make_room() {
  recorder_.begin(position_.size());
  std::size_t rows = position_.size();
  for (const auto& delta : pending_) {
    if (delta->replaces_all()) rows = std::max(rows, delta->after->position.size());
    for (const auto& edit : delta->edits) {
      // Only the first note of a row counts, and no delta is applied yet.
      recorder_.note(edit.slot, is_alive(edit.slot));
      rows = std::max(rows, edit.slot.index() + std::size_t{1});
    }
  }
  const auto grow = [rows](auto& column) {
    if (column.capacity() < rows) column.reserve(std::max(rows, column.capacity() + column.capacity() / 2));
  };
  grow(position_);
  grow(id_);
}

void Samples::apply(const DocumentDelta& delta) {
  // An empty delta makes no revision, here as in the document.
  if (delta.is_empty()) return;
  if (delta.replaces_all()) {
    position_ = delta.after->position;
    id_ = delta.after->id;
    count_ = 0;
    for (const SampleId id : id_) count_ += id.is_valid() ? 1U : 0U;
  }
  for (const SampleEdit& edit : delta.edits) {
    if (!position_.has(edit.slot)) {
      MES_ASSERT(edit.slot == position_.next() && edit.kind == SampleEdit::Kind::insert);
      position_.emplace_back();
      id_.emplace_back();
    }
    const bool lives = edit.kind != SampleEdit::Kind::remove;
    MES_ASSERT(id_[edit.slot].is_valid() == (edit.kind != SampleEdit::Kind::insert));
    position_[edit.slot] = lives ? edit.to : Vec2{};
    id_[edit.slot] = lives ? edit.id : SampleId{};
    if (lives) extent_.add(edit.to);
    if (edit.kind == SampleEdit::Kind::insert) ++count_;
    if (edit.kind == SampleEdit::Kind::remove) --count_;
  }
  if (delta.curve_after) curve_ = delta.curve_after;
  document_revision_ = delta.to_revision;
}

void Samples::rebuild(JobControl&) {
  make_room();
  for (const auto& delta : pending_) apply(*delta);
  pending_.clear();
  changes_.clear();
  extent_ = Box2{};
  for (const SampleSlot slot : position_.rows())
    if (id_[slot].is_valid()) extent_.add(position_[slot]);
}

bool Samples::update(JobControl&) {
  for (const auto& delta : pending_)
    if (delta->replaces_all()) return false;
  make_room();
  const std::shared_ptr<const CurveOrder> before = curve_;
  for (const auto& delta : pending_) apply(*delta);
  has_other_contours_ = before != curve_;
  pending_.clear();
  recorder_.finish(changes_, [this](SampleSlot slot) { return id_[slot].is_valid(); });
  return true;
}

StatList Samples::statistics() const {
  Box2 box;
  for (const SampleSlot slot : position_.rows())
    if (id_[slot].is_valid()) box.add(position_[slot]);
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {{"samples", static_cast<std::int64_t>(count_)},
          {"width", box.is_empty() ? none : box.width()},
          {"height", box.is_empty() ? none : box.height()}};
}

}  // namespace mes
