// SPDX-License-Identifier: GPL-3.0-or-later
// The local feature size of curves, and how densely samples stand for them.
//
// The local feature size of a place of a curve is its distance to the medial axis of all curves, on both sides. Samples
// are an epsilon-sample of curves if every place has one within epsilon times its feature size. The axis of the samples
// themselves says little of that: where there are too few, it misses what the curves have there. So the axis here is
// that of other, finer samples, which are as dense as it asks for.
//
// What it guarantees:
//  1. Sizes are lower bounds as far as an estimate can be: what the finer samples show, less four times the square of
//     their own epsilon. Tests compare with shapes whose axis is known.
//  2. At corners, and where curves meet, sizes fall to zero, and no density of samples has an epsilon. These places are
//     *exempt*: about them a size counts as no less than a quarter of the largest up to where it stops growing.
//  3. `standing` gives, by sizes of 1 with 2, an upper bound for every interval of the curves between two samples: half
//     its length over the least size on it. So every place has a sample within epsilon times its feature size, and half
//     the distance of neighbours is at most epsilon times the size of either.
//  4. What `places` and `filled` give has, by `standing`, at most the epsilon that was asked for.
//
// Smallest use:
//     auto field = FeatureField::of(curves, request, sizes);
//     if (field) use(field->standing(positions).epsilon);
//
// Cost: `of` asks for the sizes of one list of samples where bends say enough, and of some ten elsewhere, at the end of
// twice as many as an epsilon of 0.25 needs; the rest is O(samples log places). Threads: const members may be called side by side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/box_tree.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/curves/sampling.h"

namespace mes {

struct MeasuredCurve;

/// How samples stand for curves.
struct CurveStanding {
  double epsilon = 0.0;    ///< the largest of all intervals; 0 without an axis, infinite where a curve has no sample
  Vec2 place{};            ///< a place of the curves in the middle of that interval
  std::size_t exempt = 0;  ///< corners and meetings of curves (guarantee 2)
  std::size_t off_curve = 0;   ///< samples that lie on no curve
  std::vector<Vec2> sparse{};  ///< such places of all intervals above 1 (`kMostEpsilon`)
  /// Samples that follow each other along the curves, by their numbers, and are at different places.
  std::vector<std::array<std::uint32_t, 2>> neighbours{};
};

/// "epsilon 0.241 (2 corners exempt)".
std::string epsilon_text(double epsilon, std::size_t exempt);

/// Samples to insert between two that follow each other along a curve, in order from the one to the other.
struct FilledInterval {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::vector<Vec2> positions{};
};

class FeatureField {
 public:
  /// Of the curves as the request asks for them: its corners, rounded if it says so; its number says how near to a corner
  /// places may be (finest_feature.h). Error: as of `sample`, or that of `sizes`; `bad_input` for more than `most` places.
  /// Throws `Cancelled`.
  static Expected<FeatureField> of(const CurveSet& curves, const SamplingRequest& request, const FeatureSizes& sizes,
                                   JobControl* job = nullptr, std::size_t most = 10'000'000);

  /// The samples lie on curves, or are points beside them; up to rounding.
  bool is_on_curves(Vec2 position) const;
  bool has_axis() const { return has_axis_; }
  /// Corners of the curves, and other places where curves meet, come very near or turn at once.
  const std::vector<Vec2>& exempt() const { return exempt_; }

  /// The curves as they are sampled, arc by arc where they touch.
  std::span<const MeasuredCurve> measured() const;

  /// For each of them, for each of its stretches between corners: lengths of arc from its beginning on, which is among them,
  /// and its end not. Sizes are as they are at corners too, so samples get ever nearer to each other there, down to a
  /// thousandth of the mean. Error: `bad_input` for more than `most`.
  Expected<std::vector<std::vector<std::vector<double>>>> places(double epsilon, std::size_t most) const;

  /// Samples that have the same position are one.
  CurveStanding standing(std::span<const Vec2> positions, JobControl* job = nullptr) const;

  /// What is to be inserted so that all intervals between samples have the epsilon; exactly on the curves. Towards exempt
  /// places as near to each other as they have it there, or by `is_strict` as `places` has it.
  std::vector<FilledInterval> filled(std::span<const Vec2> positions, double epsilon, bool is_strict,
                                     JobControl* job = nullptr) const;

 private:
  struct Node {
    Vec2 position{};
    double along = 0.0;    // from the beginning of the curve
    double size = 0.0;     // a lower bound
    double regular = 0.0;  // of that what counts beside exempt places
  };
  /// A curve cut into short parts. A closed one has its first node once.
  struct Line {
    std::size_t curve = 0;
    bool is_closed = false;
    double length = 0.0;
    double finest = 0.0;
    double widest = 0.0;
    std::vector<Node> nodes{};
    std::vector<std::size_t> corners{};    // nodes at which stretches begin; of a closed curve without any none
    std::vector<std::size_t> meetings{};   // other exempt nodes
    std::vector<std::size_t> stretches{};  // nodes at which they begin, and one behind the last
  };
  /// Between two nodes.
  struct Part {
    Vec2 a{}, b{};
    double arc = 0.0;
  };
  /// Some in a row, by the nodes at which they begin.
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
  /// The most that the distances from a place on a part to its ends add up to.
  double longest_detour(const Part& part) const { return part.arc * (1.0 + 1e-9) + 2.0 * slack_; }
  static void find_meetings(Line& line, const std::vector<double>& epsilons);
  static void exempt_about(Line& line, const std::vector<double>& epsilons, std::size_t node, std::ptrdiff_t way);
  void make_tree();
  std::vector<Hit> hits(std::span<const Vec2> positions, std::vector<bool>& is_on, JobControl* job) const;
  template <class Use>
  void for_each_interval(const std::vector<Hit>& hits, Use use) const;

  std::shared_ptr<const std::vector<MeasuredCurve>> measured_;
  std::vector<Line> lines_;
  std::vector<Vec2> points_;  // on no curve
  std::vector<Vec2> exempt_;
  BoxTree<Parts> tree_;
  double slack_ = 0.0;
  bool has_axis_ = false;
};

/// Samples by the rule `feature_size`, of curves whose field this is, for a request that differs in its epsilon alone. As
/// `sample` otherwise.
Expected<SampledCurves> sample_by_field(const CurveSet& curves, const SamplingRequest& request,
                                        const FeatureField& field, JobControl* job = nullptr);

}  // namespace mes
