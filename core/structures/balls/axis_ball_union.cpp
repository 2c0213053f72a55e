// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/axis_ball_union.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "core/base/geometry/angle.h"
#include "core/graph/explain.h"

namespace mes {
namespace {

constexpr double kShareOfSampling = 0.05;  // fraction of the work of sampling an axis and making the union after it

/// Balls from a list, or those of another union if the factor is 1.
class ListedBalls final : public BallFamily {
 public:
  ListedBalls(const BallUnion* plain, std::shared_ptr<const DiskList> disks)
      : plain_(plain), disks_(std::move(disks)) {}

  std::size_t rows() const override { return is_plain() ? plain_->family().rows() : disks_->size(); }
  std::string_view rows_of() const override { return is_plain() ? plain_->family().rows_of() : std::string_view(); }
  bool is_ball(FamilySlot row) const override {
    if (is_plain()) return plain_->family().is_ball(row);
    return disks_->has(row);
  }
  Disk plain_disk(FamilySlot row) const override {
    return is_plain() ? plain_->family().disk(row) : (*disks_)[row].disk;
  }
  bool is_from_samples() const override { return is_plain() && plain_->family().touch_samples(); }
  BallOrigin origin(FamilySlot row) const override {
    return is_from_samples() ? plain_->family().origin(row) : BallOrigin::disk;
  }
  std::array<Vec2, 3> corners(FamilySlot row) const override {
    return is_from_samples() ? plain_->family().corners(row) : std::array<Vec2, 3>{};
  }
  void touched_samples(FamilySlot row, std::vector<TouchedSample>& out) const override {
    if (is_from_samples()) plain_->family().touched_samples(row, out);
  }
  // The structure that fills the list tracks changes.
  bool has_changed() const override { return false; }
  bool is_plain() const { return plain_ != nullptr && scale() == 1.0; }

 private:
  const BallUnion* plain_;
  std::shared_ptr<const DiskList> disks_;
};

/// The spacing of balls about nodes of an axis, and along its pieces.
struct AxisSpacing {
  explicit AxisSpacing(const UnionTables& tables) : about(tables.node_count(), 0.0), along(tables.axis.size(), 0.0) {}

  Table<AxisNodeSlot, double> about;
  Table<AxisPieceSlot, double> along;
};

/// The distance of the two samples on the circle of a ball that enclose the middle of an arc; infinite if the ball
/// touches fewer than two samples.
class TouchedGaps {
 public:
  explicit TouchedGaps(const BallFamily& family) : family_(family) {}

  double across(const BoundaryArc& arc) {
    touched_.clear();
    family_.touched_samples(arc.ball, touched_);
    if (touched_.size() < 2) return std::numeric_limits<double>::infinity();
    const Vec2 center = family_.plain_disk(arc.ball).center;
    const auto direction = [center](Vec2 at) { return angle_of(at - center); };
    const double from = direction(arc.from);
    const double middle = from + 0.5 * turn_between(from, direction(arc.to));
    // The last sample before the middle, and the first one after it.
    const auto after = [&](const TouchedSample& sample) { return turn_between(middle, direction(sample.position)); };
    const auto [next, last] = std::ranges::minmax(touched_, {}, after);
    return distance(next.position, last.position);
  }

 private:
  /// Counter-clockwise angle, from 0 to a whole turn.
  static double turn_between(double from, double to) {
    constexpr double kWhole = 2.0 * std::numbers::pi;
    const double turn = std::fmod(to - from, kWhole);
    return turn < 0.0 ? turn + kWhole : turn;
  }

  const BallFamily& family_;
  std::vector<TouchedSample> touched_;
};

/// Spacings along the axis of a union, from those of its balls. A piece has the larger spacing of the balls at its two ends.
/// If an end is not the centre of a ball, it has the largest spacing of the balls whose circles cross at its v-points.
AxisSpacing along_axis(const UnionTables& t, const Table<FamilySlot, double>& spacing, bool is_by_ends) {
  AxisSpacing out(t);
  for (const FamilySlot ball : spacing.rows()) out.about[node_of(ball)] = spacing[ball];
  const Table<VPointSlot, double> at = spacing_of_v_points(t, spacing);
  for (const AxisPieceSlot piece : t.axis.rows()) {
    const AxisPiece& from = t.axis[piece];
    if (!from.is_alive()) continue;
    if (is_by_ends && t.is_ball(from.node[0]) && t.is_ball(from.node[1])) {
      out.along[piece] = std::max(out.about[from.node[0]], out.about[from.node[1]]);
      continue;
    }
    for (const VPointSlot v : from.v)
      if (v != kNoSlot) out.along[piece] = std::max(out.along[piece], at[v]);
    for (const AxisNodeSlot node : from.node)
      if (!t.is_ball(node)) out.about[node] = std::max(out.about[node], out.along[piece]);
  }
  return out;
}

/// For balls that touch samples, or did before they were scaled: the longest chord of their arcs, in unscaled length,
/// but no longer than the samples there are apart. In a scaled union an arc may be the cap of a narrow end.
AxisSpacing spacing_of_arcs(const BallUnion& balls) {
  const UnionTables& t = balls.tables();
  const BallFamily& family = balls.family();
  Table<FamilySlot, double> spacing(t.balls.size(), 0.0);
  if (family.is_from_samples()) {
    TouchedGaps gaps(family);
    for (const BoundaryArc& arc : t.arcs) {
      if (!arc.is_alive() || arc.is_whole != 0) continue;
      const double chord = distance(arc.from, arc.to) / family.scale();
      spacing[arc.ball] = std::max(spacing[arc.ball], std::min(chord, gaps.across(arc)));
    }
  }
  return along_axis(t, spacing, true);
}

AxisSpacing spacing_handed_on(const UnionTables& t, const DiskList& disks) {
  Table<FamilySlot, double> spacing(disks.size(), 0.0);
  for (const FamilySlot ball : disks.rows()) spacing[ball] = disks[ball].spacing;
  return along_axis(t, spacing, false);
}

/// Balls along the axis of a union, as dense as growing or shrinking requires; not part of the graph.
class AlongAxis final : public BallSampling {
 public:
  AlongAxis(SettingsSource& settings, BallUnion& balls)
      : BallSampling("along-axis", settings, balls),
        tables_(balls.tables()),
        shrinking_(std::min(1.0, settings.current()[Parameter::scale_axis_factor])) {}

  /// The balls as a list, with radii divided by `divisor`.
  AxisDisks listed(const AxisSpacing& spacing, double divisor) const {
    const SampledBalls& balls = medial();
    const Table<SampledSlot, double> at = by_row(spacing);
    AxisDisks out{{}, halving().tolerance()};
    for (const SampledSlot row : at.rows()) {
      if (!balls.is_alive(row)) continue;
      const Disk& disk = balls.disk(row);
      // The angle alone does not determine their distance where parts are short, or a tolerance is used.
      const double apart = halving().widest(shrinking_ * disk.radius);
      out.list.push_back({{disk.center, disk.radius / divisor}, std::max(at[row], apart)});
    }
    return out;
  }

 private:
  double shrinking() const override { return shrinking_; }
  bool is_for_growing() const override { return true; }

  Table<SampledSlot, double> by_row(const AxisSpacing& spacing) const {
    Table<SampledSlot, double> out(medial().rows(), 0.0);
    for (const AxisPieceSlot piece : spacing.along.rows())
      for_each_inside(piece, [&](SampledSlot row) { out[row] = spacing.along[piece]; });
    // One of the faces of v-points with one circle is sampled; which one depends on the row numbers.
    std::map<std::pair<double, double>, double> largest;
    for (const VFaceSlot face : tables_.v_faces.rows()) {
      const Vec2 center = tables_.v_faces[face].center;
      const double about = spacing.about[tables_.node_of(face)];
      if (about == 0.0 || !std::isfinite(center.x) || !std::isfinite(center.y)) continue;
      double& at = largest[{center.x, center.y}];
      at = std::max(at, about);
    }
    for (const AxisNodeSlot node : spacing.about.rows()) {
      for_each_about(node, [&](SampledSlot row) {
        const Vec2 center = medial().disk(row).center;
        const auto found = tables_.is_ball(node) ? largest.end() : largest.find({center.x, center.y});
        out[row] = found == largest.end() ? spacing.about[node] : found->second;
      });
    }
    return out;
  }

  const UnionTables& tables_;
  double shrinking_;
};

/// A step of the skeleton: not part of the graph, with settings of its own.
class StepUnion final : public DiskListUnion {
 public:
  StepUnion(SettingsSource& settings, DiskList disks) : DiskListUnion("skeleton-step", {&settings}, settings) {
    set_disks(std::move(disks));
  }
};

}  // namespace

DiskListUnion::DiskListUnion(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                             const BallUnion* plain)
    : DiskListUnion(id, std::move(inputs), settings, plain, std::make_shared<DiskList>()) {}

DiskListUnion::DiskListUnion(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                             const BallUnion* plain, const std::shared_ptr<DiskList>& disks)
    : BallUnion(id, std::move(inputs), settings, Parameter::scale_axis_factor,
                std::make_unique<ListedBalls>(plain, disks)),
      settings_(settings),
      disks_(disks) {}

void DiskListUnion::refine(UnionTables& tables) {
  hairs_ = {};
  if (factor() == 1.0) return;
  const double apart =
      std::min(1.0, factor()) * distance_of_sampled(settings_.current()[Parameter::medial_sampling_angle]);
  Table<FamilySlot, double> spacing(disks_->size(), 0.0);
  for (const FamilySlot ball : spacing.rows()) {
    const ListedBall& from = (*disks_)[ball];
    spacing[ball] = share_of_spacing(factor()) * std::max(from.spacing, apart * from.disk.radius);
  }
  hairs_ = cut_hairs(tables, spacing);
  tables.measures.axis_length = std::max(0.0, tables.measures.axis_length - hairs_.length);
}

StatList DiskListUnion::statistics() const {
  StatList out = BallUnion::statistics();
  out.insert(out.end(), {{"hairs", hairs_.pieces}, {"hair_length", hairs_.length}});
  return out;
}

AxisBallUnion::AxisBallUnion(std::string_view id, SettingsSource& settings, BallUnion& plain)
    : DiskListUnion(id, {&settings, &plain}, settings, &plain), source_(settings), plain_(plain) {}

AxisDisks AxisBallUnion::disks(JobControl& job) {
  const JobShare share(job, kShareOfSampling);
  AlongAxis sampling(source_, plain_);
  sampling.rebuild(job);
  return sampling.listed(spacing_of_arcs(plain_), 1.0);
}

void AxisBallUnion::rebuild(JobControl& job) {
  angle_ = wanted_angle();
  tolerance_ = 0.0;
  if (wanted_factor() == 1.0) {
    set_disks({});
    forget_hairs();
    take_over(plain_);
    return;
  }
  AxisDisks disks = this->disks(job);
  const JobShare rest(job, 1.0);
  tolerance_ = disks.tolerance;
  listed_ = disks.list.size();
  set_disks(std::move(disks.list));
  BallUnion::rebuild(job);
}

bool AxisBallUnion::update(JobControl& job) {
  if (factor() == 1.0 && wanted_factor() == 1.0) return follow(plain_);
  if (plain_.changes().size() != 0 || (factor() != 1.0 && angle_ != wanted_angle())) return false;
  return BallUnion::update(job);
}

// At a factor of 1 the other union reports the findings.
void AxisBallUnion::find(std::vector<Finding>& out) const {
  if (factor() == 1.0) return;
  BallUnion::find(out);
  find_tolerance(id(), tolerance_, listed_, out);
}

StatList AxisBallUnion::statistics() const {
  StatList out = DiskListUnion::statistics();
  out.push_back({"tolerance", tolerance_});
  return out;
}

void AxisBallUnion::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (factor() == 1.0) return plain_.explain(kind, row, out);
  if (kind == ElementKind::axis_piece) {
    BallUnion::explain(kind, row, out);
    return explain_divided_radii(*this, AxisPieceSlot(row), out);
  }
  const FamilySlot ball(row);
  if (kind != ElementKind::ball) return BallUnion::explain(kind, row, out);
  if (!tables().balls.has(ball) || !family().is_ball(ball)) return;
  ProvenanceShapes itself;
  itself.circle(family().plain_disk(ball));
  out.say(ProvenanceRole::itself,
          "Ball about a point of " + axis_text() + ", radius " + number_text(family().plain_disk(ball).radius),
          itself);
  explain_scale(ball, out);
  explain_place(ball, out);
}

SkeletonUnion::SkeletonUnion(std::string_view id, SettingsSource& settings, BallUnion& plain)
    : AxisBallUnion(id, settings, plain), settings_(settings) {}

bool SkeletonUnion::update(JobControl& job) {
  const bool is_same_step = settings_.current()[Parameter::scale_skeleton_step] == beginning_.step;
  return (is_same_step || factor() == 1.0) && AxisBallUnion::update(job);
}

void SkeletonUnion::rebuild(JobControl& job) {
  steps_ = 0;
  AxisBallUnion::rebuild(job);
}

std::string SkeletonUnion::axis_text() const {
  if (steps_ == 0) return AxisBallUnion::axis_text();
  return "the scale axis after step " + std::to_string(steps_) + ", at a factor of " + number_text(factor_of(steps_));
}

AxisDisks SkeletonUnion::disks(JobControl& job) {
  const ComputationSettings& settings = settings_.current();
  Beginning beginning{settings[Parameter::scale_skeleton_step], settings[Parameter::medial_sampling_angle],
                      AxisBallUnion::disks(job)};
  if (beginning != beginning_) kept_.clear();
  beginning_ = std::move(beginning);
  // A remainder that rounding leaves between the last step and the factor is no step.
  while (factor_of(steps_ + 1) < wanted_factor() * (1.0 - 0x1p-40)) ++steps_;
  Step now{0, beginning_.disks};
  if (steps_ == 0) return now.disks;
  const auto last =
      std::ranges::find_if(kept_.rbegin(), kept_.rend(), [&](const Step& step) { return step.number <= steps_; });
  if (last != kept_.rend()) now = *last;
  const std::size_t before = now.number;
  while (now.number < steps_) {
    job.checkpoint();
    // Each step makes a union, and so does the factor after the last step.
    const JobShare share(job,
                         static_cast<double>(now.number + 1 - before) / static_cast<double>(steps_ + 1 - before));
    now.disks = after_step(now.disks, factor_of(now.number + 1), job);
    ++now.number;
    keep(now);
  }
  return now.disks;
}

// The last step is always kept: the next factor begins with it.
void SkeletonUnion::keep(const Step& step) {
  kept_.insert(std::ranges::upper_bound(kept_, step.number, {}, &Step::number), step);
  const auto balls = [this] {
    std::size_t out = 0;
    for (const Step& kept : kept_) out += kept.disks.list.size();
    return out;
  };
  for (std::size_t apart = 2; kept_.size() > 1 && balls() > kMostKept; apart *= 2)
    std::erase_if(kept_, [&](const Step& kept) { return kept.number != step.number && kept.number % apart != 0; });
}

AxisDisks SkeletonUnion::after_step(const AxisDisks& disks, double factor, JobControl& job) const {
  SettingsSource settings;
  ComputationSettings chosen = settings_.current();
  chosen.precision = Precision::fast;
  chosen[Parameter::scale_axis_factor] = factor;
  settings.post(chosen);
  settings.rebuild(job);
  StepUnion balls(settings, disks.list);
  in_share(job, 1.0 - kShareOfSampling, [&] { balls.rebuild(job); });
  AlongAxis sampling(settings, balls);
  sampling.rebuild(job);
  AxisDisks out = sampling.listed(spacing_handed_on(balls.tables(), disks.list), factor);
  out.tolerance = std::max(out.tolerance, disks.tolerance);
  return out;
}

StatList SkeletonUnion::statistics() const {
  StatList out = AxisBallUnion::statistics();
  out.push_back({"steps_before", static_cast<std::int64_t>(steps_)});
  return out;
}

}  // namespace mes
