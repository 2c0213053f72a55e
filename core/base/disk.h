// SPDX-License-Identifier: GPL-3.0-or-later
// A disk of the plane, the ball of the two-dimensional literature. Plain data; the radius is not negative.
#pragma once

#include "core/base/vec2.h"

namespace mes {

struct Disk {
  Vec2 center{};
  double radius = 0.0;
  friend bool operator==(const Disk&, const Disk&) = default;
};

}  // namespace mes
