// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/spacing_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/geometry/box_tree.h"
#include "core/base/jobs/parallel.h"

namespace mes {
namespace {

// Limit for arc length over straight distance: a half circle has pi / 2, a right angle at most the square root of 2.
constexpr double kDetour = 1.5;
// Probes at most so many steps away along the curve are never near it.
constexpr double kOwn = 2.0;

struct Probe {
  Vec2 position;
  std::uint32_t curve;
  double along;  // arc length from the beginning of the curve
};

/// Adds points at even arc lengths along a stretch, both ends included.
void add_probes(const MeasuredCurve& curve, const Stretch& stretch, std::size_t intervals, std::uint32_t index,
                double before, std::vector<Probe>& out) {
  std::size_t piece = stretch.first;
  const std::size_t last = stretch.first + stretch.count - 1;
  double passed = 0.0;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double wanted = stretch.length * (static_cast<double>(i) / static_cast<double>(intervals));
    while (piece < last && wanted >= passed + curve.lengths[piece].total()) passed += curve.lengths[piece++].total();
    const double t = i == intervals ? 1.0 : curve.lengths[piece].parameter_at(wanted - passed);
    out.push_back({curve.pieces[piece].at(t), index, before + wanted});
  }
}

std::size_t probe_intervals(double length, double step) {
  constexpr double kLeast = 4.0;
  return static_cast<std::size_t>(std::max(kLeast, std::ceil(length / step)));
}

/// Nodes at even arc lengths; the spacings are not yet filled in.
StretchSpacing even_nodes(double length, double step) {
  const std::size_t intervals = probe_intervals(length, step);
  StretchSpacing out{length, {}, std::vector<double>(intervals + 1)};
  out.at.reserve(intervals + 1);
  for (std::size_t i = 0; i <= intervals; ++i)
    out.at.push_back(length * (static_cast<double>(i) / static_cast<double>(intervals)));
  return out;
}

/// Finds the distance from a probe to other curves.
struct Surroundings {
  std::span<const Probe> probes;
  std::span<const MeasuredCurve> curves;
  std::span<const double> lengths;  // for each curve
  const BoxTree<std::uint32_t>& tree;

  /// `in_order` has the number of the probe at each place of the tree; kNone marks a place without a probe.
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::span<const std::uint32_t> in_order;
  std::span<const std::uint32_t> place_in_order;

  /// Distance from probe `own` to the nearest point of other parts; `widest` if there is none. The search stops below
  /// `nearest`. `step` is the distance between the probes of its curve.
  double distance_to_others(std::uint32_t own, double step, double nearest, double widest) const {
    const Probe& probe = probes[own];
    double out = widest;
    double bound = widest * widest;
    const auto look_at = [&](std::uint32_t i) {
      const Probe& other = probes[i];
      const double along = other.curve == probe.curve ? along_curve(probe, other) : along_arcs(probe, other);
      if (!(along > kOwn * step)) return;
      // Nearly all others are the neighbours along the curve. Squares tell most of them without a root.
      constexpr double kRounding = 1e-9;
      const Vec2 gap = other.position - probe.position;
      if (along * along < (1.0 - kRounding) * kDetour * kDetour * dot(gap, gap)) return;
      const double away = length(gap);
      if (!(away < out) || !(along > kDetour * away)) return;
      out = away;
      bound = out <= nearest ? -1.0 : away * away;
    };
    // A box of the tree that reaches to the probe may hold thousands of others that are far and do not count, as where many
    // curves meet; it could come before the box of those that are near.
    constexpr std::uint32_t kBeside = 8;
    const std::uint32_t place = place_in_order[own];
    const auto end = std::min(in_order.size(), std::size_t{place} + kBeside);
    for (std::size_t at = place - std::min(place, kBeside); at < end; ++at)
      if (in_order[at] != kNone) look_at(in_order[at]);
    tree.visit_near(probe.position, bound, look_at);
    return out;
  }

 private:
  double along_curve(const Probe& probe, const Probe& other) const {
    const double along = std::abs(other.along - probe.along);
    return curves[probe.curve].is_closed ? std::min(along, lengths[probe.curve] - along) : along;
  }
  /// Distance along the arcs through a common node.
  double along_arcs(const Probe& probe, const Probe& other) const {
    double out = std::numeric_limits<double>::infinity();
    const auto to_end = [this](const Probe& p, std::size_t end) {
      return end == 0 ? p.along : lengths[p.curve] - p.along;
    };
    for (const std::size_t i : {0U, 1U})
      for (const std::size_t k : {0U, 1U}) {
        const std::uint32_t node = curves[probe.curve].nodes[i];
        if (node == MeasuredCurve::kNoNode || node != curves[other.curve].nodes[k]) continue;
        out = std::min(out, to_end(probe, i) + to_end(other, k));
      }
    return out;
  }
};

/// Calls `use(i, passed)` for each node, with the number of spacings between the beginning and the node.
template <class Use>
void for_each_passed(const StretchSpacing& field, Use use) {
  double passed = 0.0;
  use(0, passed);
  double before = 0.5 / field.spacing[0];
  for (std::size_t i = 1; i < field.spacing.size(); ++i) {
    const double here = 0.5 / field.spacing[i];
    passed += (before + here) * (field.at[i] - field.at[i - 1]);
    use(i, passed);
    before = here;
  }
}

double whole_count(double passed) {
  constexpr double kRounding = 1e-9;
  return std::max(1.0, std::ceil(passed * (1.0 - kRounding)));
}

}  // namespace

double StretchSpacing::count() const {
  double all = 0.0;
  for_each_passed(*this, [&all](std::size_t, double passed) { all = passed; });
  return whole_count(all);
}

std::vector<double> StretchSpacing::places() const {
  std::vector<double> passed(spacing.size());
  for_each_passed(*this, [&passed](std::size_t i, double here) { passed[i] = here; });
  const double wanted = whole_count(passed.back());
  const double each = passed.back() / wanted;
  std::vector<double> out;
  constexpr double kMostAtOnce = 1e6;
  out.reserve(static_cast<std::size_t>(std::min(wanted, kMostAtOnce)));
  std::size_t i = 1;
  for (double k = 0.0; k < wanted; ++k) {
    while (i + 1 < passed.size() && passed[i] <= k * each) ++i;
    const double within = (k * each - passed[i - 1]) / (passed[i] - passed[i - 1]);
    out.push_back(at[i - 1] + within * (at[i] - at[i - 1]));
  }
  return out;
}

namespace {

/// The nodes at which so many arcs meet that some have hardly an angle between them. Around such a node, others are as
/// near as one likes, and a search would find all arcs for each of them.
std::vector<bool> crowded_nodes(std::span<const MeasuredCurve> curves) {
  constexpr std::uint32_t kCrowd = 64;
  std::vector<std::uint32_t> arcs;
  for (const MeasuredCurve& curve : curves)
    for (const std::uint32_t node : curve.nodes) {
      if (node == MeasuredCurve::kNoNode) continue;
      if (node >= arcs.size()) arcs.resize(node + std::size_t{1});
      ++arcs[node];
    }
  std::vector<bool> out;
  for (const std::uint32_t count : arcs) out.push_back(count > kCrowd);
  return out;
}

bool is_at_crowd(const Probe& probe, const MeasuredCurve& curve, double length, double step,
                 const std::vector<bool>& is_crowded) {
  const auto is_near = [&](std::uint32_t node, double along) {
    return node != MeasuredCurve::kNoNode && is_crowded[node] && along <= kOwn * step;
  };
  return is_near(curve.nodes[0], probe.along) || is_near(curve.nodes[1], length - probe.along);
}

/// Whether a stretch begins at a corner or a node, and whether it ends at one.
std::array<bool, 2> corners_at(const MeasuredCurve& curve, const Stretch& stretch, double corner_angle) {
  const std::size_t count = curve.pieces.size();
  const auto turns = [&](std::size_t before, std::size_t after) {
    const Vec2 a = curve.pieces[before].last_direction();
    const Vec2 b = curve.pieces[after].first_direction();
    return std::abs(std::atan2(cross(a, b), dot(a, b))) > corner_angle;
  };
  const auto is_corner = [&](std::size_t piece) {
    const bool is_end = piece == 0 || piece == count;
    if (is_end && curve.nodes[piece == 0 ? 0 : 1] != MeasuredCurve::kNoNode) return true;
    if (is_end && !curve.is_closed) return false;
    return turns((piece + count - 1) % count, piece % count);
  };
  return {is_corner(stretch.first), is_corner(stretch.first + stretch.count)};
}

}  // namespace

std::vector<std::vector<StretchSpacing>> spacings_of(std::span<const MeasuredCurve> curves,
                                                     const SpacingLimits& limits, JobControl* job) {
  struct Scale {
    double widest, finest, step;
  };
  std::vector<Probe> probes;
  std::vector<double> lengths;
  std::vector<Scale> scales;
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    constexpr double kFiner = 8.0;
    const double widest = std::min(limits.widest, curves[i].length_of_whole() / limits.least_each);
    const double finest = limits.is_finest_by_curve ? widest / kFiner : std::min(limits.finest, widest);
    scales.push_back({widest, finest, 0.5 * (limits.is_finest_by_curve ? finest : limits.finest)});
    double before = 0.0;
    for (const Stretch& stretch : curves[i].stretches) {
      add_probes(curves[i], stretch, probe_intervals(stretch.length, scales[i].step), i, before, probes);
      before += stretch.length;
    }
    lengths.push_back(before);
  }

  std::vector<std::uint32_t> numbers(probes.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::vector<std::uint32_t> place_in_order(probes.size());
  BoxTree<std::uint32_t> tree;
  tree.build(
      std::span<const std::uint32_t>(numbers),
      [&](std::uint32_t i) {
        return TreeBounds{{probes[i].position, probes[i].position}};
      },
      [&place_in_order](std::uint32_t i, std::uint32_t place) { place_in_order[i] = place; });
  std::vector<std::uint32_t> in_order;
  if (!probes.empty()) in_order.assign(std::size_t{std::ranges::max(place_in_order)} + 1, Surroundings::kNone);
  for (const std::uint32_t i : numbers) in_order[place_in_order[i]] = i;
  const Surroundings surroundings{probes, curves, lengths, tree, in_order, place_in_order};
  const std::vector<bool> is_crowded = crowded_nodes(curves);
  std::vector<double> spacing_at(probes.size());
  parallel_for(probes.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      constexpr std::size_t kOften = 1024;
      if (job != nullptr && k % kOften == 0) job->checkpoint();
      const Probe& probe = probes[k];
      const auto [widest, finest, step] = scales[probe.curve];
      const double reach = (limits.is_finest_by_curve ? widest : limits.widest) / limits.share;
      const double nearest = (limits.is_finest_by_curve ? finest : limits.finest) / limits.share;
      const double away = is_at_crowd(probe, curves[probe.curve], lengths[probe.curve], step, is_crowded)
                              ? nearest
                              : surroundings.distance_to_others(static_cast<std::uint32_t>(k), step, nearest, reach);
      spacing_at[k] = std::clamp(limits.share * away, finest, widest);
    }
  });
  std::vector<std::vector<StretchSpacing>> out(curves.size());
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    const double finest = scales[i].finest;
    for (const Stretch& stretch : curves[i].stretches) {
      StretchSpacing& here = out[i].emplace_back(even_nodes(stretch.length, scales[i].step));
      for (double& spacing : here.spacing) spacing = spacing_at[next++];
      if (!limits.is_finest_by_curve) continue;
      constexpr double kGrowth = 0.5;  // growth of the spacing for each unit of length from a corner
      const auto [begins, ends] = corners_at(curves[i], stretch, limits.corner_angle);
      for (std::size_t k = 0; k < here.at.size(); ++k) {
        if (begins) here.spacing[k] = std::min(here.spacing[k], finest + kGrowth * here.at[k]);
        if (ends) here.spacing[k] = std::min(here.spacing[k], finest + kGrowth * (stretch.length - here.at[k]));
      }
    }
  }
  return out;
}

std::vector<std::vector<StretchSpacing>> spacings_by_curvature(std::span<const MeasuredCurve> curves,
                                                               const SpacingLimits& limits) {
  constexpr double kSteepest = 0.5;
  const double step = 0.5 * limits.finest;
  std::vector<std::vector<StretchSpacing>> out(curves.size());
  std::vector<Probe> probes;
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    const MeasuredCurve& curve = curves[i];
    const double widest = std::min(limits.widest, curve.length() / limits.least_each);
    const double finest = std::min(limits.finest, widest);
    for (const Stretch& stretch : curve.stretches) {
      StretchSpacing& here = out[i].emplace_back(even_nodes(stretch.length, step));
      std::vector<double>& spacing = here.spacing;
      probes.clear();
      add_probes(curve, stretch, spacing.size() - 1, i, 0.0, probes);
      // The angle between consecutive chords, over the length between their midpoints, is the curvature.
      const auto spacing_at = [&](Vec2 before, Vec2 after, double along) {
        const double turn = std::abs(std::atan2(cross(before, after), dot(before, after)));
        return std::clamp(turn > 0.0 ? limits.share * along / turn : widest, finest, widest);
      };
      const auto chord = [&](std::size_t k) { return probes[k + 1].position - probes[k].position; };
      for (std::size_t k = 1; k + 1 < probes.size(); ++k)
        spacing[k] = spacing_at(chord(k - 1), chord(k), 0.5 * (here.at[k + 1] - here.at[k - 1]));
      // A closed curve without corners continues at its beginning.
      const bool goes_on = curve.is_closed && !curve.has_corner_at_start;
      spacing.front() = goes_on ? spacing_at(chord(probes.size() - 2), chord(0), here.at[1]) : spacing[1];
      spacing.back() = goes_on ? spacing.front() : spacing[spacing.size() - 2];
      const auto follow = [&](std::size_t k, std::size_t before) {
        spacing[k] = std::min(spacing[k], spacing[before] + kSteepest * std::abs(here.at[k] - here.at[before]));
      };
      const int rounds = goes_on ? 2 : 1;
      for (int round = 0; round < rounds; ++round) {
        if (round == 1) spacing.front() = spacing.back() = std::min(spacing.front(), spacing.back());
        for (std::size_t k = 1; k < spacing.size(); ++k) follow(k, k - 1);
        for (std::size_t k = spacing.size() - 1; k > 0; --k) follow(k - 1, k);
      }
    }
  }
  return out;
}

}  // namespace mes
