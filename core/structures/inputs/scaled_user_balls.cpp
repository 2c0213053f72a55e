// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/scaled_user_balls.h"

namespace mes {

ScaledUserBalls::ScaledUserBalls(SettingsSource& settings, UserBalls& balls)
    : Structure("scaled-balls", {&settings, &balls}), settings_(settings), balls_(balls) {}

void ScaledUserBalls::rebuild(JobControl&) {
  scale_ = wanted();
}

bool ScaledUserBalls::update(JobControl&) {
  return scale_ == wanted();
}

}  // namespace mes
