// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/selection.h"

#include <algorithm>

namespace mes {

void Selection::add(Slot slot) {
  if (slot >= mask_.size()) mask_.resize(slot + 1, 0);
  if (mask_[slot] != 0) return;
  mask_[slot] = 1;
  ++count_;
  ++revision_;
}

void Selection::remove(Slot slot) {
  if (!contains(slot)) return;
  mask_[slot] = 0;
  --count_;
  ++revision_;
}

void Selection::clear() {
  if (count_ == 0) return;
  std::ranges::fill(mask_, std::uint8_t{0});
  count_ = 0;
  ++revision_;
}

void Selection::select_all(const Document& document) {
  mask_.assign(document.slot_count(), 0);
  for (Slot slot = 0; slot < mask_.size(); ++slot) mask_[slot] = document.is_alive(slot) ? 1 : 0;
  count_ = document.sample_count();
  ++revision_;
}

void Selection::invert(const Document& document) {
  mask_.resize(document.slot_count(), 0);
  for (Slot slot = 0; slot < mask_.size(); ++slot) mask_[slot] = document.is_alive(slot) && mask_[slot] == 0 ? 1 : 0;
  count_ = document.sample_count() - count_;
  ++revision_;
}

std::vector<Slot> Selection::slots() const {
  std::vector<Slot> out;
  out.reserve(count_);
  for (Slot slot = 0; slot < mask_.size() && out.size() < count_; ++slot)
    if (mask_[slot] != 0) out.push_back(slot);
  return out;
}

void Selection::follow(const DocumentDelta& delta) {
  if (delta.replaces_all()) {
    clear();
    return;
  }
  for (const SampleEdit& edit : delta.edits)
    if (edit.kind == SampleEdit::Kind::remove) remove(edit.slot);
}

}  // namespace mes
