// SPDX-License-Identifier: GPL-3.0-or-later
// Chords that stand for curved pieces of outlines. Private to core/structures/outline.
//
// Guarantee: two pieces that go along the same curve in opposite directions have the same chords.
#pragma once

#include <optional>
#include <vector>

#include "core/curves/curve.h"

namespace mes {

/// A chord begins where the one before ends.
struct OutlineChord {
  Vec2 to{};
  std::optional<Vec2> center{};  ///< of the circle that it stands for
  bool is_arc = false;           ///< the piece is an arc of that circle
};

/// Adds the chords that stand for a piece; they are within the tolerance of it.
void add_chords_of(const Piece& piece, double tolerance, std::vector<OutlineChord>& out);

/// The angle of a point on the ellipse of an arc.
double angle_on(const EllipticArc& arc, Vec2 p);

/// True if the directions differ by so little that a curve goes on smoothly.
bool go_on(Vec2 before, Vec2 after);

/// Distance of a point from the line through a chord.
double distance_from_chord(Vec2 p, Vec2 from, Vec2 to);

}  // namespace mes
