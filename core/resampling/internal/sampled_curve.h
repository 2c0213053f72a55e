// SPDX-License-Identifier: GPL-3.0-or-later
// A curve through samples that change, and what the graph of structures says of its edges.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/evolutions/moving_curve.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/density/curve_sampling.h"
#include "core/structures/density/feature_size.h"
#include "core/workbench/workbench.h"

namespace mes {

/// The loops of the data, or the chains of the crust where there are none.
MovingCurve curve_of(const SampleData& data, JobControl& job);

/// By how much the curve turns at a place, in degrees: 0 = straight on. 0 where places coincide.
double turn_at(Vec2 before, Vec2 at, Vec2 after);

/// By sample: the curve has a corner there that no density repairs. It turns by more than twice the arc sine of epsilon,
/// which half an edge over the distance to the axis beside a corner comes to however short the edge is; and by more than
/// four times as much as at its two neighbours together, which a smooth curve with too few samples does not.
std::vector<bool> corners_of(const MovingCurve& curve, std::span<const Vec2> positions, double epsilon);

/// Samples and the structures of a registry that judge them, following each change locally.
class JudgedSamples {
 public:
  /// With the curves that they were taken from, or without. Error: of `replace_all`, or a structure that failed. Throws
  /// `Cancelled`.
  static Expected<JudgedSamples> of(const Registry& registry, const SampleData& data, JobControl& job,
                                    bool has_curves = false);

  Expected<void> insert(std::span<const Vec2> positions, JobControl& job);
  std::span<const Vec2> positions() const { return positions_; }

  /// What an edge from one sample to another is. Numbers of samples are those of the data, then in the order of insertion.
  struct EdgeVerdict {
    bool is_curve = false;    ///< a crust edge, or both samples lie at one place
    double epsilon = 0.0;     ///< of a crust edge; 0 where there is no axis
    bool is_doubted = false;  ///< what the theorem asks for does not hold at one of its ends
  };
  EdgeVerdict judge(std::uint32_t a, std::uint32_t b) const;
  /// Distance to the axis; infinite without one.
  double size(std::uint32_t sample) const;
  TheoremLight light() const { return bench_.light(); }
  /// The reason for an axis that is missing, as a sentence without a full stop; empty if there is an axis.
  std::string why_no_axis() const { return std::string(bench_.get<FeatureSize>().reason()); }
  const CurveSampling& curves() const { return bench_.get<CurveSampling>(); }
  /// Of the one-step axis.
  std::int64_t components() const { return count("components"); }
  std::int64_t cycles() const { return count("cycles"); }

 private:
  explicit JudgedSamples(const Registry& registry);
  std::int64_t count(std::string_view key) const;
  SiteSlot site_of(std::uint32_t sample) const;

  Workbench bench_;
  std::vector<Vec2> positions_;
  std::vector<SampleSlot> slots_;
};

}  // namespace mes
