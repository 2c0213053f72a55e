// SPDX-License-Identifier: GPL-3.0-or-later
// The user's balls with their radii scaled, as their union takes them and as they are drawn.
#pragma once

#include "core/structures/inputs/settings_source.h"
#include "core/structures/inputs/user_balls.h"

namespace mes {

/// Rows: those of `UserBalls`. Radii are multiplied by the parameter `b-scale` and rounded. Nothing is stored, so an
/// edit costs what it changes; a new scale changes every row.
class ScaledUserBalls final : public Structure {
 public:
  ScaledUserBalls(SettingsSource& settings, UserBalls& balls);

  std::size_t row_count() const { return balls_.row_count(); }
  bool is_alive(BallSlot slot) const { return balls_.is_alive(slot); }
  Disk disk(BallSlot slot) const { return {balls_.disk(slot).center, balls_.disk(slot).radius * scale_}; }
  double scale() const { return scale_; }
  const ChangeSet<BallSlot>& changes() const { return balls_.changes(); }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return changes().size(); }
  std::vector<std::string_view> parameters() const override { return {Parameter::b_scale.id}; }
  StatList statistics() const override { return {{"scale", scale_}}; }
  std::vector<TableColumns> table_columns() const override;

 private:
  double wanted() const { return settings_.current()[Parameter::b_scale]; }

  const SettingsSource& settings_;
  const UserBalls& balls_;
  double scale_ = 1.0;
};

}  // namespace mes
