// SPDX-License-Identifier: GPL-3.0-or-later
// Finds vertices of curves that lie on other curves. Private to core/curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// A piece of a curve that may touch others. Equal vertices have one index, across all of these curves.
struct TouchingPiece {
  Piece piece{};
  std::uint32_t curve = 0;
  std::uint32_t from = 0;  ///< index of the vertex
  std::uint32_t to = 0;
};

struct Contact {
  std::uint32_t vertex = 0;
  std::uint32_t piece = 0;
  double parameter = 0.0;  ///< 0 or 1: the vertices coincide
};

struct Contacts {
  std::vector<bool> is_candidate{};     ///< for each curve: its box overlaps that of another curve
  std::vector<TouchingPiece> pieces{};  ///< all pieces of candidates, in order
  std::vector<Vec2> vertices{};         ///< all vertices of candidates, without duplicates
  std::vector<Contact> contacts{};      ///< between vertices and pieces that do not end exactly there, by vertex
  double tolerance = 0.0;               ///< upper bound; at most 1/128 of the pieces at a contact
  std::size_t work = 0;                 ///< of the search: one for each box compared with a vertex, 16 for each piece
};

/// `resolution` as in `CurveSet`. If `within_curves`, every curve is a candidate. O(n log n). Throws `Cancelled` if
/// there is a job.
Contacts contacts_of(const std::vector<PlaneCurve>& curves, double resolution, bool within_curves, JobControl* job);

}  // namespace mes
