// SPDX-License-Identifier: GPL-3.0-or-later
// The local feature size of curves, and how well samples represent them.
//
// The local feature size at a point of a curve is its distance to the medial axis of all curves, on both sides. Samples
// are an epsilon-sample of curves if every point has a sample within epsilon times its feature size. The axis of the
// samples themselves is a poor measure: where there are too few samples, it misses features of the curves. So this
// class uses the axis of other, finer samples, which it makes as dense as needed.
//
// Guarantees:
//  1. Sizes are lower bounds as far as an estimate can be: the sizes that the finer samples show, less four times the
//     square of the epsilon of these samples. Tests compare with shapes whose axis is known.
//  2. At corners, and where curves meet, sizes fall to zero, and no density of samples has an epsilon. These points are
//     *exempt*: near them, up to where the size stops growing, it counts as at least a quarter of the largest size
//     there.
//  3. `standing` uses the sizes of 1 and 2. For every interval of the curves between two samples it returns an upper
//     bound: half the length of the interval over the least size on it. So every point has a sample within epsilon
//     times its feature size, and half the distance of neighbours is at most epsilon times the size of either.
//  4. Results of `places` and `filled` have, by `standing`, at most the epsilon that was asked for.
//
// Smallest use:
//     auto field = FeatureField::of(curves, request, sizes);
//     if (field) use(field->standing(positions).epsilon);
//
// Cost: `of` asks for the sizes of one list of samples where bends determine the density, and of about ten lists
// elsewhere; the last list is twice as long as an epsilon of 0.25 needs. The rest is O(samples log places). Threads:
// const members may be called in parallel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/box_tree.h"
#include "core/base/jobs/job_control.h"
#include "core/curves/sampling.h"

namespace mes {

struct MeasuredCurve;

/// The quality with which samples represent curves.
struct CurveStanding {
  double epsilon = 0.0;       ///< maximum over all intervals; 0 without an axis, infinite where a curve has no sample
  Vec2 place{};               ///< point of the curves in the middle of that interval
  std::size_t exempt = 0;     ///< number of corners and meetings of curves (guarantee 2)
  std::size_t off_curve = 0;  ///< number of samples that lie on no curve
  std::vector<Vec2> sparse{};  ///< middle points of all intervals with an epsilon above 1 (`kMostEpsilon`)
  /// Index pairs of samples that are neighbours along the curves, at different positions.
  std::vector<std::array<std::uint32_t, 2>> neighbours{};
};

/// Samples to insert between two neighbours along a curve, in order from the first to the second.
struct FilledInterval {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::vector<Vec2> positions{};
};

class FeatureField {
 public:
  /// Computes the field of the curves as the request treats them: with its corners, rounded if it says so. Its number
  /// of samples determines how close to a corner samples may be (`kFinestFeature`). Error: as in `sample`, or an error
  /// of `sizes`; `bad_input` for more than `most` samples. Throws `Cancelled`.
  static Expected<FeatureField> of(const CurveSet& curves, const SamplingRequest& request, const FeatureSizes& sizes,
                                   JobControl* job = nullptr, std::size_t most = 10'000'000);

  /// Whether a point lies on the curves or is one of their isolated points, up to rounding.
  bool is_on_curves(Vec2 position) const;
  bool has_axis() const { return has_axis_; }
  /// Corners of the curves, and other points where curves meet, come very close or turn abruptly.
  const std::vector<Vec2>& exempt() const { return exempt_; }

  /// The curves as `sample` sees them: arc by arc if they touch.
  std::span<const MeasuredCurve> measured() const;

  /// For each measured curve and each of its stretches between corners: the arc lengths of samples, from the beginning
  /// (included) to the end (excluded). Sizes are not raised near corners, so samples get denser there, down to a
  /// thousandth of the mean distance. Error: `bad_input` for more than `most`.
  Expected<std::vector<std::vector<std::vector<double>>>> places(double epsilon, std::size_t most) const;

  /// The quality with which samples at these positions represent the curves. Equal positions count as one sample.
  CurveStanding standing(std::span<const Vec2> positions, JobControl* job = nullptr) const;

  /// Samples to insert so that all intervals between samples have the epsilon; they lie exactly on the curves. Near
  /// exempt points they are as dense as the sizes of guarantee 2 ask for, or, if `is_strict`, as in `places`.
  std::vector<FilledInterval> filled(std::span<const Vec2> positions, double epsilon, bool is_strict,
                                     JobControl* job = nullptr) const;

 private:
  struct Node {
    Vec2 position{};
    double along = 0.0;    // arc length from the beginning of the curve
    double size = 0.0;     // a lower bound
    double regular = 0.0;  // raised near exempt points
  };
  /// A curve cut into short parts. A closed curve lists its first node once.
  struct Line {
    std::size_t curve = 0;
    bool is_closed = false;
    double length = 0.0;
    double finest = 0.0;
    double widest = 0.0;
    std::vector<Node> nodes{};
    std::vector<std::size_t> corners{};    // nodes at which stretches begin; empty for a closed curve without corners
    std::vector<std::size_t> meetings{};   // other exempt nodes
    std::vector<std::size_t> stretches{};  // nodes at which stretches begin, then one past the last
  };
  /// The part between two nodes.
  struct Part {
    Vec2 a{}, b{};
    double arc = 0.0;
  };
  /// Consecutive parts, named by the nodes at which they begin.
  struct Parts {
    Box2 box{};
    std::uint32_t line = 0;
    std::uint32_t first = 0;
    std::uint32_t end = 0;
  };
  /// A sample on a line.
  struct Hit {
    std::uint32_t line = 0;
    double along = 0.0;
    std::uint32_t sample = 0;
  };
  struct Walk;

  static Part part_of(const Line& line, std::size_t node);
  /// Largest sum of the distances from a point on a part to its ends.
  double longest_detour(const Part& part) const { return part.arc * (1.0 + 1e-9) + 2.0 * slack_; }
  static void find_meetings(Line& line, const std::vector<double>& epsilons);
  static void exempt_about(Line& line, const std::vector<double>& epsilons, std::size_t node, std::ptrdiff_t way);
  void make_tree();
  std::vector<Hit> hits(std::span<const Vec2> positions, std::vector<bool>& is_on, JobControl* job) const;
  template <class Use>
  void for_each_interval(const std::vector<Hit>& hits, Use use) const;

  std::shared_ptr<const std::vector<MeasuredCurve>> measured_;
  std::vector<Line> lines_;
  std::vector<Vec2> points_;  // isolated points
  std::vector<Vec2> exempt_;
  BoxTree<Parts> tree_;
  double slack_ = 0.0;
  bool has_axis_ = false;
};

/// Samples by the rule `feature_size` of the curves that `field` belongs to; the request may differ from that of the
/// field only in its epsilon. Otherwise like `sample`.
Expected<SampledCurves> sample_by_field(const CurveSet& curves, const SamplingRequest& request,
                                        const FeatureField& field, JobControl* job = nullptr);

}  // namespace mes
