// SPDX-License-Identifier: GPL-3.0-or-later
// A curve measured and cut at its corners. Private to core/curves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/job_control.h"
#include "core/curves/curve.h"
#include "core/curves/internal/arc_length.h"
#include "core/curves/sampling.h"

namespace mes {

/// A smooth part of a curve, between corners or ends; a closed curve without corners is one stretch.
struct Stretch {
  std::size_t first = 0;  ///< of its pieces
  std::size_t count = 0;
  double length = 0.0;
};

/// A curve without its pieces of no length, or of less than a document can hold (2^-500).
struct MeasuredCurve {
  std::vector<Piece> pieces;  ///< of a closed curve with corners from one of them on
  std::vector<PieceLength> lengths;
  std::vector<Stretch> stretches;  ///< none where all of the curve is one point
  bool is_closed = false;
  bool has_corner_at_start = true;  ///< false for a closed curve without corners
  /// Of an arc of a network (network.h): its nodes, first and last, and the length of the curve that it is a part of.
  std::array<std::uint32_t, 2> nodes{kNoNode, kNoNode};
  double whole = 0.0;  ///< 0: it is a curve of its own

  static constexpr std::uint32_t kNoNode = 0xffffffffU;
  double length() const;
  double length_of_whole() const { return whole > 0.0 ? whole : length(); }
};

/// Calls `use(Vec2)` at lengths of arc from the beginning of a stretch, which increase.
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

/// The length of pieces that make no corners: a hundredth of about what lies between samples.
double negligible_length(const CurveSet& curves, const SamplingRequest& request);

/// Corners are where the tangent turns by more than `corner_angle`; if that is negative, wherever two pieces meet. Pieces shorter than `negligible`, and those below
/// 1e-9 of the longest, have no direction of their own, for they come from rounded coordinates. Throws `Cancelled` if there is a job.
/// A closed curve `starts_at_corner` if its start is one whatever its angle.
MeasuredCurve measured(const PlaneCurve& curve, double corner_angle, double negligible, JobControl* job = nullptr,
                       bool starts_at_corner = false);

}  // namespace mes
