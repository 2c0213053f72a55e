// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/user_balls.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/graph/explain.h"

namespace mes {

void UserBalls::post(std::shared_ptr<const DocumentDelta> delta) {
  if (delta->replaces_all() || !delta->ball_edits.empty()) pending_.push_back(std::move(delta));
}

// Allocates all memory first, so that pending deltas are applied completely or not at all; nothing else could restore
// the rows.
void UserBalls::make_room() {
  recorder_.begin(disk_.size());
  std::size_t rows = disk_.size();
  for (const auto& delta : pending_) {
    if (delta->replaces_all()) rows = std::max(rows, delta->balls_after->disk.size());
    for (const auto& edit : delta->ball_edits) {
      // Only the first note of a row counts, and no delta is applied yet.
      recorder_.note(edit.slot, is_alive(edit.slot));
      rows = std::max(rows, edit.slot.index() + std::size_t{1});
    }
  }
  const auto grow = [rows](auto& column) {
    if (column.capacity() < rows) column.reserve(std::max(rows, column.capacity() + column.capacity() / 2));
  };
  grow(disk_);
  grow(id_);
}

void UserBalls::apply(const DocumentDelta& delta) {
  if (delta.replaces_all()) {
    MES_ASSERT(delta.balls_after != nullptr);
    disk_ = delta.balls_after->disk;
    id_ = delta.balls_after->id;
    count_ = 0;
    for (const BallId id : id_) count_ += id.is_valid() ? 1U : 0U;
  }
  for (const BallEdit& edit : delta.ball_edits) {
    if (!disk_.has(edit.slot)) {
      MES_ASSERT(edit.slot == disk_.next() && edit.kind == BallEdit::Kind::insert);
      disk_.emplace_back();
      id_.emplace_back();
    }
    const bool lives = edit.kind != BallEdit::Kind::remove;
    MES_ASSERT(id_[edit.slot].is_valid() == (edit.kind != BallEdit::Kind::insert));
    disk_[edit.slot] = lives ? edit.to : Disk{};
    id_[edit.slot] = lives ? edit.id : BallId{};
    if (lives) extent_.add(bounding_box_of(edit.to));
    if (edit.kind == BallEdit::Kind::insert) ++count_;
    if (edit.kind == BallEdit::Kind::remove) --count_;
  }
}

void UserBalls::rebuild(JobControl&) {
  make_room();
  for (const auto& delta : pending_) apply(*delta);
  pending_.clear();
  changes_.clear();
  extent_ = Box2{};
  for (const BallSlot slot : disk_.rows())
    if (id_[slot].is_valid()) extent_.add(bounding_box_of(disk_[slot]));
}

bool UserBalls::update(JobControl&) {
  for (const auto& delta : pending_)
    if (delta->replaces_all()) return false;
  make_room();
  for (const auto& delta : pending_) apply(*delta);
  pending_.clear();
  recorder_.finish(changes_, [this](BallSlot slot) { return id_[slot].is_valid(); });
  return true;
}

StatList UserBalls::statistics() const {
  std::int64_t zero = 0;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const BallSlot slot : disk_.rows()) {
    if (!id_[slot].is_valid()) continue;
    const double radius = disk_[slot].radius;
    if (radius == 0.0) ++zero;
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {{"balls", static_cast<std::int64_t>(count_)},
          {"zero_radius", zero},
          {"radius_min", count_ == 0 ? none : least},
          {"radius_max", count_ == 0 ? none : most}};
}

void UserBalls::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const BallSlot ball(row);
  if (kind != ElementKind::own_ball || !is_alive(ball)) return;
  ProvenanceShapes itself;
  itself.circle(disk(ball), {.balls = {ball}});
  itself.point({disk(ball).center, {.balls = {ball}}});
  out.say(ProvenanceRole::itself,
          "Ball at " + place_text(disk(ball).center) + ", radius " + number_text(disk(ball).radius), itself);
}

}  // namespace mes
