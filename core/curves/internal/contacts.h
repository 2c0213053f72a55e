// SPDX-License-Identifier: GPL-3.0-or-later
// Where vertices of curves lie on other curves. Private to core/curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// A piece of a curve that may touch others. Vertices at one place have one number, across all of these curves.
struct TouchingPiece {
  Piece piece{};
  std::uint32_t curve = 0;
  std::uint32_t from = 0;  ///< vertex
  std::uint32_t to = 0;
};

struct Contact {
  std::uint32_t vertex = 0;
  std::uint32_t piece = 0;
  double parameter = 0.0;  ///< 0 or 1: the vertices coincide
};

struct Contacts {
  std::vector<bool> is_candidate{};     ///< of each curve: its box overlaps that of another one
  std::vector<TouchingPiece> pieces{};  ///< of the candidates, in order
  std::vector<Vec2> vertices{};         ///< of the candidates, all different
  std::vector<Contact> contacts{};      ///< of vertices with pieces that do not end at their very place, by vertex
  double tolerance = 0.0;               ///< the largest; at a contact it is at most 1/128 of the pieces there
};

/// `resolution` as `CurveSet` has it. Every curve is a candidate if `within_curves`. O(n log n). Throws `Cancelled` if there
/// is a job.
Contacts contacts_of(const std::vector<PlaneCurve>& curves, double resolution, bool within_curves, JobControl* job);

}  // namespace mes
