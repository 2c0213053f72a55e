// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>

#include "core/base/assert.h"
#include "core/document/curve_source.h"
#include "core/kernel/circumcircle.h"

namespace mes {
namespace {

std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 30U;
  x *= 0xbf58476d1ce4e5b9ULL;
  x ^= x >> 27U;
  x *= 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

// These points are for drawing: they are rounded, and no decision uses them. Not finite if a point does not exist.

/// The point on the line of centres with equal power to both circles.
Vec2 equal_power(const Disk& a, const Disk& b) {
  const Vec2 way = b.center - a.center;
  const double size = length(way);
  return a.center + (0.5 + 0.5 * ((a.radius - b.radius) / size) * ((a.radius + b.radius) / size)) * way;
}

/// The crossing of two circles to the left of the vector from the first centre to the second; if they do not cross, the
/// midpoint of the complex crossings.
Vec2 left_crossing(const Disk& a, const Disk& b) {
  const Vec2 way = b.center - a.center;
  const double size = length(way);
  const double sum = a.radius + b.radius;
  const double difference = a.radius - b.radius;
  // Written as a product, which keeps its digits when the circles nearly touch.
  const double across = 0.25 * ((sum - size) / size) * ((sum + size) / size) * ((size - difference) / size) *
                        ((size + difference) / size);
  return equal_power(a, b) + std::sqrt(std::max(across, 0.0)) * perpendicular(way);
}

Vec2 power_center(const Disk& a, const Disk& b, const Disk& c) {
  const Vec2 p = b.center - a.center;
  const Vec2 q = c.center - a.center;
  const auto right = [&a](const Disk& disk, Vec2 way) {
    return 0.5 * (dot(way, way) + (a.radius - disk.radius) * (a.radius + disk.radius));
  };
  const double x = right(b, p);
  const double y = right(c, q);
  const double determinant = cross(p, q);
  return a.center + Vec2{(x * q.y - y * p.y) / determinant, (p.x * y - q.x * x) / determinant};
}

// Counts the new numbers of an edit, and uncounts the old ones; an insertion has no old ones, a removal no new ones.
template <class Edit>
void count(const Edit& edit, MagnitudeCounts& counts) {
  if (edit.kind != Edit::Kind::insert) for_each_number(edit.from, [&counts](double x) { counts.remove(x); });
  if (edit.kind != Edit::Kind::remove) for_each_number(edit.to, [&counts](double x) { counts.add(x); });
}

void count(const DocumentDelta& delta, MagnitudeCounts& counts) {
  const auto add = [&counts](double x) { counts.add(x); };
  if (delta.replaces_all()) {
    counts = {};
    // Dead rows hold zeros, which are not counted.
    for (const Vec2 p : delta.after->position) for_each_number(p, add);
    for (const Disk& disk : delta.balls_after->disk) for_each_number(disk, add);
  }
  for (const SampleEdit& edit : delta.edits) count(edit, counts);
  for (const BallEdit& edit : delta.ball_edits) count(edit, counts);
}

/// Reserves the rows that all edits together need.
template <class Edits, class ThingRows>
void make_room_for(std::span<const DocumentDelta> deltas, Edits edits_of, ThingRows& rows) {
  using ThingId = typename ThingRows::ThingId;
  std::size_t inserted = 0;
  std::size_t removed = 0;
  ThingId last{rows.first_id()};
  for (const DocumentDelta& delta : deltas) {
    for (const auto& edit : std::invoke(edits_of, delta)) {
      using Kind = decltype(edit.kind);
      if (edit.kind == Kind::remove) ++removed;
      if (edit.kind != Kind::insert) continue;
      ++inserted;
      last = std::max(last, edit.id);
    }
  }
  rows.make_room(inserted, last, removed);
}

}  // namespace

Document::Document()
    : curve_(std::make_shared<const CurveOrder>()), annotations_(std::make_shared<const Annotations>()) {}

Document Document::successor() const {
  Document out;
  out.revision_ = out.highest_revision_ = highest_revision_ + 1;
  out.samples_.number_from(samples_.next_id());
  out.balls_.number_from(balls_.next_id());
  return out;
}

Vec2 Document::place_of(const Anchor& anchor) const {
  if (!anchor.balls.empty()) {
    const Vec2 place = place_by_balls(anchor);
    return is_finite(place) ? place : anchor.at;
  }
  std::array<Vec2, 3> on{};
  if (anchor.samples.empty() || anchor.samples.size() > on.size()) return anchor.at;
  for (std::size_t i = 0; i < anchor.samples.size(); ++i) {
    const SampleSlot slot = slot_of(SampleId{first_id().value + anchor.samples[i]});
    if (slot == kNoSlot) return anchor.at;
    on[i] = position(slot);
  }
  if (anchor.samples.size() == 1) return on[0];
  const Vec2 center = circumcircle(on[0], on[1], on[2]).center;
  return is_finite(center) ? center : anchor.at;
}

std::optional<std::array<Disk, 4>> Document::followed_disks(const Anchor& anchor) const {
  std::array<Disk, 4> out{};
  if (anchor.balls.empty() || anchor.balls.size() > out.size()) return std::nullopt;
  for (std::size_t i = 0; i < anchor.balls.size(); ++i) {
    const BallSlot slot = ball_slot_of(BallId{first_ball_id().value + anchor.balls[i]});
    if (slot == kNoSlot) return std::nullopt;
    out[i] = {disk(slot).center, anchor.scale * disk(slot).radius};
  }
  return out;
}

Vec2 Document::place_by_balls(const Anchor& anchor) const {
  const auto on = followed_disks(anchor);
  if (!on) return anchor.at;
  const auto& [a, b, c, d] = *on;
  switch (anchor.balls.size()) {
    case 1: return a.center;
    case 2:
      return anchor.along != 0.0 ? equal_power(a, b) + anchor.along * (b.center - a.center) : left_crossing(a, b);
    case 3: return power_center(a, b, c);
    default: {
      const Vec2 from = left_crossing(a, b);
      const Vec2 to = left_crossing(c, d);
      return 0.5 * from + 0.5 * to + anchor.along * perpendicular(to - from);
    }
  }
}

double Document::radius_unit(const Anchor& anchor) const {
  if (anchor.samples.size() == 3) {
    std::array<Vec2, 3> on{};
    for (std::size_t i = 0; i < on.size(); ++i) {
      const SampleSlot slot = slot_of(SampleId{first_id().value + anchor.samples[i]});
      if (slot == kNoSlot) return 1.0;
      on[i] = position(slot);
    }
    return circumcircle(on[0], on[1], on[2]).radius;
  }
  const auto on = followed_disks(anchor);
  if (!on) return 1.0;
  if (anchor.balls.size() == 1) return (*on)[0].radius;
  return anchor.balls.size() == 4 ? distance(place_of(anchor), left_crossing((*on)[0], (*on)[1])) : 1.0;
}

std::vector<SampleId> Document::samples_of_source() const {
  std::vector<SampleId> out;
  if (!source_) return out;
  const std::uint32_t first = first_id().value + source_->first;
  for (std::uint32_t i = 0; i < source_->count; ++i)
    if (const SampleId id{first + i}; slot_of(id) != kNoSlot) out.push_back(id);
  return out;
}

Box2 Document::bounding_box() const {
  Box2 box;
  for (const SampleSlot slot : slots_below<SampleSlot>(slot_count()))
    if (is_alive(slot)) box.add(position(slot));
  for (const BallSlot slot : slots_below<BallSlot>(ball_slot_count()))
    if (is_ball_alive(slot)) box.add(bounding_box_of(disk(slot)));
  for (const Annotation& annotation : *annotations_)
    for (const Anchor& anchor : annotation.anchors)
      if (anchor.is_fixed()) box.add(anchor.at);
  return box;
}

std::uint64_t Document::digest_of_sample(SampleSlot slot) const {
  const std::uint64_t x = mix(bits_of(position(slot).x) + (id(slot).value - first_id().value));
  return mix(x ^ bits_of(position(slot).y));
}

std::uint64_t Document::digest_of_ball(BallSlot slot) const {
  constexpr std::uint64_t kOtherThanSamples = 0x9e3779b97f4a7c15ULL;
  const std::uint64_t x =
      mix(bits_of(disk(slot).center.x) + kOtherThanSamples + (ball_id(slot).value - first_ball_id().value));
  return mix(mix(x ^ bits_of(disk(slot).center.y)) ^ bits_of(disk(slot).radius));
}

std::uint64_t Document::sample_digest() const {
  return mix(sample_count()) + sample_sum_;
}

std::uint64_t Document::ball_digest() const {
  return ball_sum_;
}

std::shared_ptr<const SampleSnapshot> Document::snapshot() const {
  return std::make_shared<const SampleSnapshot>(
      SampleSnapshot{samples_.values(), samples_.ids(), samples_.free_slots(), first_id(), map_});
}

std::shared_ptr<const BallSnapshot> Document::ball_snapshot() const {
  return std::make_shared<const BallSnapshot>(
      BallSnapshot{balls_.values(), balls_.ids(), balls_.free_slots(), first_ball_id()});
}

Magnitudes Document::magnitudes_after(const DocumentDelta& delta) const {
  if (!delta.replaces_all()) {
    const Magnitudes now = magnitudes();
    Magnitudes with_new = now;
    for_each_new_number(delta, [&with_new](double x) { with_new.add(x); });
    if (with_new.least == now.least && with_new.most == now.most) return now;
    // If everything fits including the removed numbers, it also fits without them.
    if (with_new.fit()) return with_new;
  }
  MagnitudeCounts after = magnitudes_;
  count(delta, after);
  return after.magnitudes();
}

void Document::replace_all(const DocumentDelta& delta) {
  MES_ASSERT(delta.balls_after != nullptr);
  auto samples =
      samples_.replaced_by(delta.after->position, delta.after->id, delta.after->free_slots, delta.after->first);
  MagnitudeCounts magnitudes;
  count(delta, magnitudes);
  MES_ASSERT(magnitudes.magnitudes().fit());
  balls_ = balls_.replaced_by(delta.balls_after->disk, delta.balls_after->id, delta.balls_after->free_slots,
                              delta.balls_after->first);
  samples_ = std::move(samples);
  magnitudes_ = magnitudes;
  map_ = delta.after->map;
  sample_sum_ = ball_sum_ = 0;
  for (const SampleSlot slot : slots_below<SampleSlot>(slot_count()))
    if (is_alive(slot)) sample_sum_ += digest_of_sample(slot);
  for (const BallSlot slot : slots_below<BallSlot>(ball_slot_count()))
    if (is_ball_alive(slot)) ball_sum_ += digest_of_ball(slot);
}

void Document::apply(const SampleEdit& edit) {
  if (is_alive(edit.slot)) sample_sum_ -= digest_of_sample(edit.slot);
  switch (edit.kind) {
    case SampleEdit::Kind::insert: samples_.insert(edit.slot, edit.id, edit.to); break;
    case SampleEdit::Kind::remove: samples_.remove(edit.slot, edit.id); break;
    case SampleEdit::Kind::move: samples_.set(edit.slot, edit.id, edit.to); break;
  }
  if (is_alive(edit.slot)) sample_sum_ += digest_of_sample(edit.slot);
}

void Document::apply(const BallEdit& edit) {
  if (is_ball_alive(edit.slot)) ball_sum_ -= digest_of_ball(edit.slot);
  switch (edit.kind) {
    case BallEdit::Kind::insert: balls_.insert(edit.slot, edit.id, edit.to); break;
    case BallEdit::Kind::remove: balls_.remove(edit.slot, edit.id); break;
    case BallEdit::Kind::change: balls_.set(edit.slot, edit.id, edit.to); break;
  }
  if (is_ball_alive(edit.slot)) ball_sum_ += digest_of_ball(edit.slot);
}

void Document::make_room_for(std::span<const DocumentDelta> deltas) {
  mes::make_room_for(deltas, &DocumentDelta::edits, samples_);
  mes::make_room_for(deltas, &DocumentDelta::ball_edits, balls_);
}

void Document::apply(const DocumentDelta& delta) {
  MES_ASSERT(delta.from_revision == revision_);
  MES_ASSERT(delta.replaces_all() || magnitudes_after(delta).fit());
  // The history does not record an empty delta, so it must not create a revision either.
  if (delta.is_empty()) return;
  if (delta.replaces_all()) {
    replace_all(delta);
  } else {
    make_room_for({&delta, 1});
    count(delta, magnitudes_);
  }
  for (const SampleEdit& edit : delta.edits) apply(edit);
  for (const BallEdit& edit : delta.ball_edits) apply(edit);
  if (delta.curve_after) curve_ = delta.curve_after;
  if (delta.annotations_after) annotations_ = delta.annotations_after;
  source_ = delta.source_after;
  revision_ = delta.to_revision;
  highest_revision_ = std::max(highest_revision_, revision_);
}

}  // namespace mes
