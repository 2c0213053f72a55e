// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/cuts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/curves/internal/network.h"
#include "core/curves/internal/repeated_positions.h"

namespace mes {
namespace {

using Step = CurveNetwork::Step;
using Walk = CurveNetwork::Walk;

bool may_have_cuts(const std::vector<PlaneCurve>& curves, const std::function<bool(Vec2)>& on_cut) {
  RepeatedPositions repeated;
  for (const PlaneCurve& curve : curves) {
    if (!curve.is_closed() || !curve.is_polyline()) continue;
    // A closed curve ends where it starts.
    const auto vertices = std::span(curve.points()).first(curve.piece_count());
    if (std::ranges::any_of(vertices, on_cut) || !repeated.find(vertices).empty()) return true;
  }
  return false;
}

bool is_tip(Vec2 before, Vec2 at, Vec2 after) {
  constexpr double kLeastAngle = 0x1p-30;
  const Vec2 back = before - at;
  const Vec2 on = after - at;
  return dot(back, on) > 0.0 && std::abs(cross(back, on)) <= kLeastAngle * dot(back, on);
}

bool has_tip(std::span<const Vec2> ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 before = ring[(i + ring.size() - 1) % ring.size()];
    if (is_tip(before, ring[i], ring[(i + 1) % ring.size()])) return true;
  }
  return false;
}

/// Marks the arcs that have the same region on both sides.
std::vector<bool> cuts_of(const CurveNetwork& network, const std::function<bool(Vec2)>& on_cut) {
  struct Use {
    std::size_t forward = 0, backward = 0;  // a walk that uses the arc, and the number of such uses
    std::size_t forward_count = 0, backward_count = 0;
  };
  std::vector<Use> uses(network.arcs.size());
  for (std::size_t w = 0; w < network.walks.size(); ++w) {
    if (!network.walks[w].is_closed) continue;
    for (const Step& step : network.walks[w].steps) {
      Use& use = uses[step.arc];
      (step.is_backwards ? use.backward : use.forward) = w;
      ++(step.is_backwards ? use.backward_count : use.forward_count);
    }
  }
  std::vector<bool> out(network.arcs.size(), false);
  for (std::size_t arc = 0; arc < out.size(); ++arc) {
    const Use& use = uses[arc];
    if (use.forward_count != 1 || use.backward_count != 1) continue;
    out[arc] = use.forward == use.backward || std::ranges::all_of(network.arcs[arc].points(), on_cut);
  }
  return out;
}

/// Closed walks along all steps. A part that returns to a node becomes a walk of its own.
std::vector<Walk> closed_walks(const CurveNetwork& network, const std::vector<Step>& steps) {
  const auto from = [&](const Step& step) { return network.nodes[step.arc][step.is_backwards ? 1 : 0]; };
  const auto to = [&](const Step& step) { return network.nodes[step.arc][step.is_backwards ? 0 : 1]; };
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> leaving;
  for (std::size_t i = steps.size(); i-- > 0;) leaving[from(steps[i])].push_back(i);
  std::vector<bool> is_used(steps.size());
  std::vector<Walk> out;
  for (std::size_t first = 0; first < steps.size(); ++first) {
    if (is_used[first]) continue;
    std::vector<Step> path;
    std::unordered_map<std::uint32_t, std::size_t> met{{from(steps[first]), 0}};  // steps to the node
    for (std::uint32_t node = from(steps[first]);;) {
      std::vector<std::size_t>& ways = leaving[node];
      while (!ways.empty() && is_used[ways.back()]) ways.pop_back();
      if (ways.empty()) break;
      const Step step = steps[ways.back()];
      is_used[ways.back()] = true;
      path.push_back(step);
      node = to(step);
      const auto [found, is_new] = met.try_emplace(node, path.size());
      if (is_new) continue;
      const auto begin = path.begin() + static_cast<std::ptrdiff_t>(found->second);
      for (auto it = begin; it + 1 != path.end(); ++it) met.erase(to(*it));
      out.push_back({{begin, path.end()}, true});
      path.erase(begin, path.end());
    }
  }
  return out;
}

}  // namespace

void remove_spikes(std::vector<Vec2>& points, std::size_t begin) {
  std::span<const Vec2> ring = std::span(points).subspan(begin);
  const bool repeats_first = ring.size() > 1 && ring.front() == ring.back();
  if (repeats_first) ring = ring.first(ring.size() - 1);
  if (!has_tip(ring)) return;
  std::deque<Vec2> left;
  for (const Vec2 p : ring) {
    while (left.size() > 1 && is_tip(left[left.size() - 2], left.back(), p)) left.pop_back();
    if (left.empty() || left.back() != p) left.push_back(p);
  }
  for (bool has_changed = true; has_changed && left.size() > 2;) {
    has_changed = true;
    if (left.front() == left.back() || is_tip(left[left.size() - 2], left.back(), left.front()))
      left.pop_back();
    else if (is_tip(left.back(), left.front(), left[1]))
      left.pop_front();
    else
      has_changed = false;
  }
  if (left.size() < 3) return;
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(begin), points.end());
  points.insert(points.end(), left.begin(), left.end());
  if (repeats_first) points.push_back(left.front());
}

std::vector<PlaneCurve> without_cuts(std::vector<PlaneCurve> curves, double resolution,
                                     const std::function<bool(Vec2)>& on_cut, JobControl* job) {
  for (PlaneCurve& curve : curves) {
    if (!curve.is_closed() || !curve.is_polyline() || !has_tip(std::span(curve.points()).first(curve.piece_count())))
      continue;
    std::vector<Vec2> points = curve.points();
    remove_spikes(points);
    PlaneCurve left(points.front());
    left.lines_to(std::span(points).subspan(1));
    left.close();
    left.name = curve.name;
    curve = std::move(left);
  }
  if (!may_have_cuts(curves, on_cut)) return curves;
  const auto network = network_of(curves, resolution, job, true);
  if (!network) return curves;
  const std::vector<bool> is_cut = cuts_of(*network, on_cut);
  if (std::ranges::none_of(is_cut, [](bool cut) { return cut; })) return curves;
  std::vector<PlaneCurve> out;
  std::vector<Step> loose;
  for (const Walk& walk : network->walks) {
    if (!walk.is_closed || std::ranges::none_of(walk.steps, [&](const Step& step) { return is_cut[step.arc]; })) {
      out.push_back(curve_of(*network, walk));
      continue;
    }
    for (const Step& step : walk.steps)
      if (!is_cut[step.arc]) loose.push_back(step);
  }
  for (const Walk& walk : closed_walks(*network, loose)) out.push_back(curve_of(*network, walk));
  return out;
}

}  // namespace mes
