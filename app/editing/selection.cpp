// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/selection.h"

#include <fmt/core.h>
#include <algorithm>

#include "core/base/counted.h"

namespace mes {

template <class Row>
bool Selection::Mask<Row>::add(Row slot) {
  if (!bits.has(slot)) bits.resize(slot.index() + std::size_t{1}, 0);
  if (bits[slot] != 0) return false;
  bits[slot] = 1;
  ++count;
  return true;
}

template <class Row>
bool Selection::Mask<Row>::remove(Row slot) {
  if (!contains(slot)) return false;
  bits[slot] = 0;
  --count;
  return true;
}

template <class Row>
void Selection::Mask<Row>::clear() {
  if (count != 0) std::ranges::fill(bits, std::uint8_t{0});
  count = 0;
}

template <class Row>
std::vector<Row> Selection::Mask<Row>::slots() const {
  std::vector<Row> out;
  out.reserve(count);
  for (const Row slot : bits.rows()) {
    if (out.size() == count) break;
    if (bits[slot] != 0) out.push_back(slot);
  }
  return out;
}

template struct Selection::Mask<SampleSlot>;
template struct Selection::Mask<BallSlot>;

void Selection::clear() {
  if (is_empty()) return;
  samples_.clear();
  balls_.clear();
  ++revision_;
}

void Selection::select_all(const Document& document) {
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot)) samples_.add(slot);
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count()))
    if (document.is_ball_alive(slot)) balls_.add(slot);
  ++revision_;
}

void Selection::invert(const Document& document) {
  const auto turn = [](auto& mask, auto slot) {
    if (!mask.remove(slot)) mask.add(slot);
  };
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot)) turn(samples_, slot);
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count()))
    if (document.is_ball_alive(slot)) turn(balls_, slot);
  ++revision_;
}

void Selection::follow(const DocumentDelta& delta) {
  if (delta.replaces_all()) {
    clear();
    return;
  }
  for (const SampleEdit& edit : delta.edits)
    if (edit.kind == SampleEdit::Kind::remove) remove(edit.slot);
  for (const BallEdit& edit : delta.ball_edits)
    if (edit.kind == BallEdit::Kind::remove) remove_ball(edit.slot);
}

std::string counted(std::size_t samples, std::size_t balls) {
  if (samples == 0 && balls == 0) return "nothing";
  if (balls == 0) return counted(samples, "sample");
  return (samples == 0 ? "" : counted(samples, "sample") + " and ") + counted(balls, "ball");
}

std::string noun_of(const Selection& selection) {
  std::string samples = selection.sample_count() == 1 ? "sample" : "samples";
  std::string balls = selection.ball_count() == 1 ? "ball" : "balls";
  if (selection.ball_count() == 0) return samples;
  return selection.sample_count() == 0 ? balls : samples + " and " + balls;
}

}  // namespace mes
