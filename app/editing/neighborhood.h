// SPDX-License-Identifier: GPL-3.0-or-later
// What to show around a place of the plane.
#pragma once

#include "core/base/box2.h"
#include "core/document/document.h"

namespace mes {

/// A square around `place` with its nearest neighbours: the twenty nearest samples and balls, where a ball is as far
/// as the nearer of its centre and its circle. On a curve these are some ten samples on either side. Of fewer than
/// twenty it holds all; it has no extent if all of them lie at the place. Cost: O(samples + balls).
Box2 neighborhood_of(const Document& document, Vec2 place);

}  // namespace mes
