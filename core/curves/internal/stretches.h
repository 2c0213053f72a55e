// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a curve and cuts it at its corners. Private to core/curves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"
#include "core/curves/internal/arc_length.h"
#include "core/curves/sampling.h"

namespace mes {

/// A smooth part of a curve, between corners or ends; a closed curve without corners is one stretch.
struct Stretch {
  std::size_t first = 0;  ///< index of its first piece
  std::size_t count = 0;
  double length = 0.0;
};

/// A curve without pieces of zero length, or shorter than a document can represent (2^-500).
struct MeasuredCurve {
  std::vector<Piece> pieces;  ///< for a closed curve with corners, rotated to begin at one
  std::vector<PieceLength> lengths;
  std::vector<Stretch> stretches;  ///< empty if all of the curve is one point
  bool is_closed = false;
  bool has_corner_at_start = true;  ///< false for a closed curve without corners
  /// For an arc of a network (network.h): its first and last node, and the length of the curve that it is a part of.
  std::array<std::uint32_t, 2> nodes{kNoNode, kNoNode};
  double whole = 0.0;  ///< 0: the arc is not part of another curve

  static constexpr std::uint32_t kNoNode = 0xffffffffU;
  double length() const;
  double length_of_whole() const { return whole > 0.0 ? whole : length(); }
};

/// Calls `use(Vec2)` at increasing arc lengths from the beginning of a stretch.
template <class Use>
void for_each_place(const MeasuredCurve& curve, const Stretch& stretch, const std::vector<double>& places, Use use) {
  std::size_t piece = stretch.first;
  double before = 0.0;
  const std::size_t last = stretch.first + stretch.count - 1;
  for (const double wanted : places) {
    while (piece < last && wanted >= before + curve.lengths[piece].total()) before += curve.lengths[piece++].total();
    use(curve.pieces[piece].at(curve.lengths[piece].parameter_at(wanted - before)));
  }
}

/// Length below which pieces make no corners: about a hundredth of the distance between samples.
double negligible_length(const CurveSet& curves, const SamplingRequest& request);

/// Measures a curve. Corners are where the tangent turns by more than `corner_angle`; if it is negative, wherever two
/// pieces meet. Pieces shorter than `negligible`, and those below 1e-9 of the longest, come from rounded coordinates
/// and have no direction of their own. If `starts_at_corner`, the start of a closed curve is a corner whatever its
/// angle. Throws `Cancelled` if there is a job.
MeasuredCurve measured(const PlaneCurve& curve, double corner_angle, double negligible, JobControl* job = nullptr,
                       bool starts_at_corner = false);

}  // namespace mes
