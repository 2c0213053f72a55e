// SPDX-License-Identifier: GPL-3.0-or-later
// Growing the balls along the axis of a union: the scale axis and the scale skeleton of each family of balls.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/internal/sampling/scale_hairs.h"
#include "core/structures/balls/scale_axis.h"

namespace mes {

/// A ball that is in no table of the document.
struct ListedBall {
  Disk disk;
  double spacing = 0.0;  ///< of the samples about the ball; 0 if unknown: then the angle alone decides
  friend bool operator==(const ListedBall&, const ListedBall&) = default;
};
using DiskList = Table<FamilySlot, ListedBall>;
/// Balls along an axis.
struct AxisDisks {
  DiskList list;
  double tolerance = 0.0;  ///< tolerance with which they were sampled (`next_tolerance`)
  friend bool operator==(const AxisDisks&, const AxisDisks&) = default;
};

/// The union of balls from a list, with radii multiplied by `scale-axis-factor`.
///
/// At factors other than 1, spurious branches (*hairs*) are cut off its axis, as off that of `ScaleUnion`. The spacing
/// of a ball is that of the list or, if larger, the distance at which `medial-sampling-angle` has equal balls of its
/// radius (below 1: its shrunk radius). In `fast`, many balls are decided by rounded numbers unless these are in doubt
/// (`BallUnion`).
class DiskListUnion : public BallUnion {
 public:
  /// The factor that radii were multiplied by.
  double factor() const { return family().scale(); }
  std::vector<std::string_view> parameters() const override {
    return {Parameter::union_shortcut.id, Parameter::scale_axis_factor.id, Parameter::medial_sampling_angle.id};
  }
  StatList statistics() const override;

 protected:
  /// At a factor of 1 the balls are those of `plain`, if it is given, instead of those of the list.
  DiskListUnion(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                const BallUnion* plain = nullptr);
  void set_disks(DiskList disks) { *disks_ = std::move(disks); }
  double wanted_factor() const { return settings_.current()[Parameter::scale_axis_factor]; }
  void forget_hairs() { hairs_ = {}; }

 private:
  DiskListUnion(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                const BallUnion* plain, const std::shared_ptr<DiskList>& disks);
  void refine(UnionTables& tables) override;

  const SettingsSource& settings_;
  std::shared_ptr<DiskList> disks_;
  ScaleHairs hairs_;
};

/// The union of the balls that are sampled along the axis of another union, with radii multiplied by
/// `scale-axis-factor`. Its axis, with radii divided by the factor again, is the *scale axis* of that union.
///
/// Guarantees:
///  1. At a factor of 1 its tables are those of the other union.
///  2. At other factors the balls are those of `BallSampling::medial`, as doubles, whatever the number type; below 1
///     they are as dense as the shrunk balls require. Neighbours along a piece meet: it is halved up to twenty times
///     until they do, however short its parts are.
///  3. Between the nodes of the axis there are at most `kMostBallsBetween`. If there would be more, neighbours are as
///     far apart as a tolerance allows, which `findings` reports, or the structure fails (as `AxisSampling`).
///
/// Spacings: a ball of the other union that touches samples has the longest chord of its arcs, which is an edge of the
/// curve where the shape is certified. A ball between has the larger spacing of the two ends of its piece. For a scaled
/// ball the chord is divided by the scale, and is at most the distance of the two samples that enclosed the middle of
/// the arc before. Balls of the document touch no samples: for these only the angle counts.
///
/// Rows of balls: at a factor of 1 those of the other union, with its changes; otherwise those of a list that each
/// change recomputes. `ScaleUnion` does the same with the one-step axis.
/// Source: Giesen, Miklos, Pauly and Wormser 2009.
class AxisBallUnion : public DiskListUnion {
 public:
  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  StatList statistics() const override;
  void find(std::vector<Finding>& out) const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  AxisBallUnion(std::string_view id, SettingsSource& settings, BallUnion& plain);
  /// The balls that grow by the factor: those along the axis of the other union.
  virtual AxisDisks disks(JobControl& job);
  /// The axis along which these balls lie, in words.
  virtual std::string axis_text() const { return "the axis of the union"; }

 private:
  double wanted_angle() const { return source_.current()[Parameter::medial_sampling_angle]; }

  SettingsSource& source_;
  BallUnion& plain_;
  double angle_ = 0.0;
  double tolerance_ = 0.0;
  std::size_t listed_ = 0;
};

/// The *scale skeleton*: like `AxisBallUnion`, but the factor is reached in steps of `scale-skeleton-step`: 1 + k d in
/// step k. Each step but the last replaces the balls by those along the axis of their grown union, with radii divided
/// by its factor.
///
/// Spacings are handed on from step to step: a ball that stays keeps its own, and one along the axis of the grown union
/// takes the largest of the balls that cross at the v-points nearest to it. Arcs of grown unions do not count, since at
/// narrow ends they are large.
///
/// Guarantees:
///  1. Up to a factor of 1 + d it is the scale axis.
///  2. It does not depend on the factors used before.
///
/// Steps before the last are made in `fast`, whatever the number type. The balls after each step are kept, so as long
/// as the first balls are the same, a step forwards is one more union. Beyond `kMostKept` balls every second step is
/// kept, then every fourth, and so on: a step backwards is then a few unions. Otherwise the cost is that of (factor -
/// 1) / d unions.
class SkeletonUnion : public AxisBallUnion {
 public:
  bool update(JobControl& job) override;
  void rebuild(JobControl& job) override;
  std::vector<std::string_view> parameters() const override {
    return {Parameter::union_shortcut.id, Parameter::scale_axis_factor.id, Parameter::medial_sampling_angle.id,
            Parameter::scale_skeleton_step.id};
  }
  StatList statistics() const override;

 protected:
  SkeletonUnion(std::string_view id, SettingsSource& settings, BallUnion& plain);

 private:
  static constexpr std::size_t kMostKept = 1'000'000;
  struct Step {
    std::size_t number = 0;
    AxisDisks disks;
  };
  AxisDisks disks(JobControl& job) override;
  std::string axis_text() const override;
  double factor_of(std::size_t step) const { return 1.0 + static_cast<double>(step) * (beginning_.step / 100.0); }
  AxisDisks after_step(const AxisDisks& disks, double factor, JobControl& job) const;
  void keep(const Step& step);

  /// Inputs that the steps depend on.
  struct Beginning {
    double step = 0.0;
    double angle = 0.0;
    AxisDisks disks;
    friend bool operator==(const Beginning&, const Beginning&) = default;
  };

  const SettingsSource& settings_;
  Beginning beginning_;
  std::vector<Step> kept_;  // made from `beginning_`, by number
  std::size_t steps_ = 0;   // number of steps before the last
};

class AScaleUnion final : public AxisBallUnion {
 public:
  AScaleUnion(SettingsSource& settings, AUnion& balls) : AxisBallUnion("a-scale-union", settings, balls) {}
};
class BScaleUnion final : public AxisBallUnion {
 public:
  BScaleUnion(SettingsSource& settings, BUnion& balls) : AxisBallUnion("b-scale-union", settings, balls) {}
};

class AScaleSampling final : public GrownBallSampling {
 public:
  AScaleSampling(SettingsSource& settings, AScaleUnion& balls)
      : GrownBallSampling("a-scale-sampling", settings, balls) {}
};
class BScaleSampling final : public GrownBallSampling {
 public:
  BScaleSampling(SettingsSource& settings, BScaleUnion& balls)
      : GrownBallSampling("b-scale-sampling", settings, balls) {}
};

class ASkeletonUnion final : public SkeletonUnion {
 public:
  ASkeletonUnion(SettingsSource& settings, AUnion& balls) : SkeletonUnion("a-skeleton-union", settings, balls) {}
};
class BSkeletonUnion final : public SkeletonUnion {
 public:
  BSkeletonUnion(SettingsSource& settings, BUnion& balls) : SkeletonUnion("b-skeleton-union", settings, balls) {}
};

}  // namespace mes
