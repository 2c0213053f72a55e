// SPDX-License-Identifier: GPL-3.0-or-later
// A curve through changing samples, and the verdict of the graph of structures on its edges.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/sampling_verdict.h"
#include "core/evolutions/moving_curve.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/density/curve_sampling.h"
#include "core/structures/density/feature_size.h"
#include "core/workbench/workbench.h"

namespace mes {

/// The loops of the data, or the chains of the crust if the data have no loops.
MovingCurve curve_of(const SampleData& data, JobControl& job);

/// Angle by which the curve turns at `at`, in degrees: 0 = straight on. 0 if positions coincide.
double turn_at(Vec2 before, Vec2 at, Vec2 after);

/// For each sample: whether the curve has a corner there that no density repairs. The curve turns there by more than
/// twice the arc sine of epsilon (beside a corner, half an edge over the distance to the axis tends to this ratio
/// however short the edge is) and by more than four times the turn of both neighbours together, unlike a smooth curve
/// with few samples.
std::vector<bool> corners_of(const MovingCurve& curve, std::span<const Vec2> positions, double epsilon);

/// Samples and the structures of a registry that judge them. Each change updates the structures locally, except for the
/// theorem's conditions, which are checked on request: that takes longer than everything else where samples are few.
class JudgedSamples {
 public:
  /// `has_curves`: also keeps the curves of the samples. Error: as `replace_all`, or a structure failed. Throws
  /// `Cancelled`.
  static Expected<JudgedSamples> of(const Registry& registry, const SampleData& data, JobControl& job,
                                    bool has_curves = false);

  Expected<void> insert(std::span<const Vec2> positions, JobControl& job);
  /// Checks the theorem's conditions after insertions. They hold no answers before that: `light`,
  /// `verdict` and `EdgeVerdict::is_doubted` must not be read.
  Expected<void> check_theorem(JobControl& job);
  std::span<const Vec2> positions() const { return positions_; }

  /// Verdict on an edge between two samples. Sample numbers are those of the data, then in the order of insertion.
  struct EdgeVerdict {
    bool is_curve = false;    ///< a crust edge, or both samples have the same position
    double epsilon = 0.0;     ///< epsilon of a crust edge; 0 if there is no axis
    bool is_doubted = false;  ///< the theorem's condition fails at one of its ends
  };
  EdgeVerdict judge(std::uint32_t a, std::uint32_t b) const;
  /// Distance to the axis; infinite without one.
  double size(std::uint32_t sample) const;
  TheoremLight light() const { return bench_.light(); }
  SamplingVerdict verdict() const { return sampling_verdict(bench_.nodes()); }
  /// Why the axis is missing, as a sentence without a full stop; empty if there is an axis.
  std::string why_no_axis() const { return std::string(sizes_->reason()); }
  const CurveSampling& curves() const { return bench_.get<CurveSampling>(); }
  /// Number of components of the one-step axis.
  std::int64_t components() const { return count("components"); }
  std::int64_t cycles() const { return count("cycles"); }

 private:
  explicit JudgedSamples(const Registry& registry);
  std::int64_t count(std::string_view key) const;
  SiteSlot site_of(std::uint32_t sample) const;

  Workbench bench_;
  // Found once, since edges are judged by the million.
  const Delaunay* delaunay_;
  const OneStepCrust* crust_;
  const FeatureSize* sizes_;
  const AxisCertificate* certificate_;
  std::vector<Vec2> positions_;
  std::vector<SampleSlot> slots_;
};

}  // namespace mes
