// SPDX-License-Identifier: GPL-3.0-or-later
// The regular triangulation of balls, and when each of its corners, edges and triangles enters while the balls grow.
// These functions need no CGAL header.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"
#include "core/base/table.h"
#include "core/structures/balls/internal/growth/radical_axis.h"
#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// Rows of `BallBirths`, each kind in the order in which it enters.
using GrownCornerSlot = Slot<struct GrownCornerTag>;
using GrownEdgeSlot = Slot<struct GrownEdgeTag>;
using GrownTriangleSlot = Slot<struct GrownTriangleTag>;

/// Squared radii grow by one number, the *power*, which may be negative. A corner, edge or triangle enters at the least
/// power at which its balls have a common point that lies in the power cells of all of them. This is the power of the
/// smallest circle orthogonal to its balls, if no other ball has a smaller power at its centre; else that of the first
/// edge or triangle at it.
struct BallBirths {
  struct Corner {
    InputSlot ball;
    std::uint32_t rank = 0;
  };
  /// `f[0]` lies to the left of v[0] -> v[1], `f[1]` to the right; kNoSlot outside.
  struct Edge {
    std::array<GrownCornerSlot, 2> v{};
    std::array<GrownTriangleSlot, 2> f{};
    std::uint32_t rank = 0;
    RadicalAxis axis;  ///< radical axis of both ends
  };
  /// Corners run counter-clockwise; neighbour and edge i lie opposite corner i; kNoSlot outside.
  struct Triangle {
    std::array<GrownCornerSlot, 3> v{};
    std::array<GrownTriangleSlot, 3> n{};
    std::array<GrownEdgeSlot, 3> e{};
    std::uint32_t rank = 0;
    Vec2 center{};  ///< centre of the orthogonal circle, rounded, in the coordinates of the document
  };
  /// A rank: an interval that holds its power, in the frame, and balls whose smallest orthogonal circle has that power.
  struct Level {
    double low = 0.0;
    double high = 0.0;
    std::array<InputSlot, 3> balls{};  ///< missing ones at the end are kNoSlot
  };

  Table<GrownCornerSlot, Corner> corners;
  Table<GrownEdgeSlot, Edge> edges;
  Table<GrownTriangleSlot, Triangle> triangles;
  std::vector<Level> levels;  ///< by rank
  std::size_t hidden = 0;     ///< balls without a power cell, duplicates among them
};

/// Exact for the balls as their `origin` defines them: equal powers share a rank, and others are ordered. Among
/// simplices of one rank and dimension, lexicographically smaller centres come first. The order of input decides only
/// which of several regular triangulations is taken. Throws `Cancelled`.
BallBirths ball_births(const PipelineInput& input, JobControl& job);

/// Number of levels with a power of at most `radius` squared, in units of the document; exact. Not for `radius` < 0.
std::uint32_t levels_within(const PipelineInput& input, const std::vector<BallBirths::Level>& levels, double radius);

}  // namespace mes
