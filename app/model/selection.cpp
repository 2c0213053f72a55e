// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/selection.h"

#include <fmt/core.h>
#include <algorithm>

namespace mes {

bool Selection::Mask::add(Slot slot) {
  if (slot >= bits.size()) bits.resize(slot + 1, 0);
  if (bits[slot] != 0) return false;
  bits[slot] = 1;
  ++count;
  return true;
}

bool Selection::Mask::remove(Slot slot) {
  if (!contains(slot)) return false;
  bits[slot] = 0;
  --count;
  return true;
}

void Selection::Mask::clear() {
  if (count != 0) std::ranges::fill(bits, std::uint8_t{0});
  count = 0;
}

std::vector<Slot> Selection::Mask::slots() const {
  std::vector<Slot> out;
  out.reserve(count);
  for (Slot slot = 0; slot < bits.size() && out.size() < count; ++slot)
    if (bits[slot] != 0) out.push_back(slot);
  return out;
}

void Selection::clear() {
  if (is_empty()) return;
  samples_.clear();
  balls_.clear();
  ++revision_;
}

void Selection::select_all(const Document& document) {
  for (Slot slot = 0; slot < document.slot_count(); ++slot)
    if (document.is_alive(slot)) samples_.add(slot);
  for (Slot slot = 0; slot < document.ball_slot_count(); ++slot)
    if (document.is_ball_alive(slot)) balls_.add(slot);
  ++revision_;
}

void Selection::invert(const Document& document) {
  const auto turn = [](Mask& mask, Slot slot) {
    if (!mask.remove(slot)) mask.add(slot);
  };
  for (Slot slot = 0; slot < document.slot_count(); ++slot)
    if (document.is_alive(slot)) turn(samples_, slot);
  for (Slot slot = 0; slot < document.ball_slot_count(); ++slot)
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
  const auto some = [](std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
  };
  if (samples == 0 && balls == 0) return "nothing";
  if (balls == 0) return some(samples, "sample");
  return (samples == 0 ? "" : some(samples, "sample") + " and ") + some(balls, "ball");
}

std::string noun_of(const Selection& selection) {
  std::string samples = selection.sample_count() == 1 ? "sample" : "samples";
  std::string balls = selection.ball_count() == 1 ? "ball" : "balls";
  if (selection.ball_count() == 0) return samples;
  return selection.sample_count() == 0 ? balls : samples + " and " + balls;
}

}  // namespace mes
