// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/places/ball_pick.h"

#include <algorithm>
#include <cmath>

namespace mes {

BallPick nearest_ball(const Document& document, Vec2 p, double radius) {
  BallPick best{kNoSlot, radius};
  if (!is_finite(p) || !(radius >= 0.0)) return best;
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count())) {
    if (!document.is_ball_alive(slot)) continue;
    const Disk& disk = document.disk(slot);
    // Rejects nearly all balls, which are far away, without a root. The factor makes up for rounding.
    const double reach = (disk.radius + best.distance) * (1.0 + 0x1p-50);
    if (std::abs(disk.center.x - p.x) > reach || std::abs(disk.center.y - p.y) > reach) continue;
    const double to_center = distance(disk.center, p);
    const double d = std::min(to_center, std::abs(to_center - disk.radius));
    if (d <= best.distance) best = {slot, d};
  }
  return best;
}

PickedThing thing_at(const Document& document, const SampleIndex& index, Vec2 p, double radius, PickedKinds kinds) {
  const SampleSlot sample = kinds.samples ? index.nearest(p, radius) : SampleSlot(kNoSlot);
  if (!kinds.balls) return {sample, kNoSlot};
  if (sample == kNoSlot) return {kNoSlot, nearest_ball(document, p, radius).slot};
  // A ball must be nearer than the sample: samples lie on circles more often than beside them.
  const double to_sample = distance(document.position(sample), p);
  const BallPick ball = nearest_ball(document, p, to_sample);
  if (ball.slot != kNoSlot && ball.distance < to_sample) return {kNoSlot, ball.slot};
  return {sample, kNoSlot};
}

std::vector<BallSlot> balls_in_box(const Document& document, const Box2& box) {
  std::vector<BallSlot> out;
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count()))
    if (document.is_ball_alive(slot) && box.contains(document.disk(slot).center)) out.push_back(slot);
  return out;
}

}  // namespace mes
