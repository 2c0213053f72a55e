// SPDX-License-Identifier: GPL-3.0-or-later
// The area to show around a point of the plane.
#pragma once

#include "core/base/geometry/box2.h"
#include "core/document/document.h"

namespace mes {

/// A square around `place` with its twenty nearest samples and balls; the distance of a ball is that to its centre or
/// its circle, whichever is nearer. On a curve these are some ten samples on either side. If there are fewer than
/// twenty, it contains all; it has no extent if all of them coincide with `place`. Cost: O(samples + balls).
Box2 neighborhood_of(const Document& document, Vec2 place);

}  // namespace mes
