// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/paths/branch_pruning.h"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

#include "core/base/sum.h"

namespace mes {
namespace {

class BranchPruning {
 public:
  BranchPruning(const PathGraph& graph, std::span<const double> radii, double limit)
      : graph_(graph),
        radii_(radii),
        limit_(limit),
        is_kept_(graph.edges().size(), 1),
        degree_(graph.nodes(), 0),
        reach_(radii.begin(), radii.end()) {
    for (std::uint32_t node = 0; node < graph.nodes(); ++node) degree_[node] = graph.away_from(node).size();
  }

  std::vector<std::uint8_t> run() {
    for (std::uint32_t node = 0; node < graph_.nodes(); ++node)
      if (degree_[node] == 1) offer(node);
    while (!open_.empty()) {
      const auto [salience, end] = open_.top();
      open_.pop();
      if (degree_[end] != 1) continue;
      const Chain arm = chain_from(only_step(end));
      if (degree_[arm.to] < 3) continue;
      // The offer may be out of date: its junction may have become a passage.
      if (const double now = salience_of(arm, end); now != salience)
        offer(end);
      else if (now < limit_)
        prune_at(arm.to);
    }
    return std::move(is_kept_);
  }

 private:
  struct Chain {
    std::vector<PathStep> steps;
    std::uint32_t to = 0;
    double length = 0.0;
  };

  PathStep only_step(std::uint32_t node) const {
    return *std::ranges::find_if(graph_.away_from(node), [&](PathStep step) { return is_kept_[step.edge] != 0; });
  }
  /// From a node on, to the first that has not two edges, or back to the node.
  Chain chain_from(PathStep step) const {
    const std::uint32_t from = graph_.tail(step);
    Chain out;
    Sum length;
    for (;;) {
      out.steps.push_back(step);
      length.add(graph_.length(step));
      out.to = graph_.head(step);
      if (degree_[out.to] != 2 || out.to == from) break;
      const PathStep back = step.reversed();
      step = *std::ranges::find_if(graph_.away_from(out.to),
                                   [&](PathStep next) { return is_kept_[next.edge] != 0 && next != back; });
    }
    out.length = length.value();
    return out;
  }
  double salience_of(const Chain& arm, std::uint32_t end) const {
    return (arm.length + reach_[end] - radii_[arm.to]) / radii_[arm.to];
  }
  void offer(std::uint32_t end) {
    const Chain arm = chain_from(only_step(end));
    if (degree_[arm.to] >= 3) open_.emplace(salience_of(arm, end), end);
  }

  void prune_at(std::uint32_t junction) {
    std::vector<Chain> pruned;
    for (const PathStep step : graph_.away_from(junction)) {
      if (is_kept_[step.edge] == 0) continue;
      Chain arm = chain_from(step);
      const std::uint32_t end = std::exchange(arm.to, junction);
      if (degree_[end] == 1 && salience_of(arm, end) < limit_) {
        reach_[junction] = std::max(reach_[junction], arm.length + reach_[end]);
        pruned.push_back(std::move(arm));
      }
    }
    for (const Chain& arm : pruned) {
      for (const PathStep step : arm.steps) {
        is_kept_[step.edge] = 0;
        --degree_[graph_.tail(step)];
        --degree_[graph_.head(step)];
      }
    }
    if (degree_[junction] == 1) offer(junction);
    if (degree_[junction] != 2) return;
    for (const PathStep step : graph_.away_from(junction)) {
      if (is_kept_[step.edge] == 0) continue;
      if (const std::uint32_t end = chain_from(step).to; degree_[end] == 1) offer(end);
    }
  }

  const PathGraph& graph_;
  std::span<const double> radii_;
  double limit_;
  std::vector<std::uint8_t> is_kept_;
  std::vector<std::size_t> degree_;  // kept edges at each node
  std::vector<double> reach_;        // from each node to the boundary, over its ball and pruned arms
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;  // free ends by salience
};

}  // namespace

std::vector<std::uint8_t> salient_branches(const PathGraph& graph, std::span<const double> radii, double limit) {
  return BranchPruning(graph, radii, limit).run();
}

MergedBranches merge_branches(const PathGraph& graph, std::span<const std::uint8_t> is_kept) {
  std::vector<std::uint8_t> is_open(is_kept.begin(), is_kept.end());
  const auto kept_at = [&](std::uint32_t node) {
    return std::ranges::count_if(graph.away_from(node), [&](PathStep step) { return is_kept[step.edge] != 0; });
  };
  MergedBranches out;
  const auto add_from = [&](PathStep step) {
    const std::uint32_t from = graph.tail(step);
    std::vector<PathStep> chain;
    Sum length;
    for (;;) {
      chain.push_back(step);
      length.add(graph.length(step));
      is_open[step.edge] = 0;
      const std::uint32_t at = graph.head(step);
      if (at == from || kept_at(at) != 2) break;
      step = *std::ranges::find_if(graph.away_from(at), [&](PathStep next) { return is_open[next.edge] != 0; });
    }
    out.edges.push_back({from, graph.head(chain.back()), length.value()});
    out.chains.push_back(std::move(chain));
  };
  for (const bool is_closed : {false, true})
    for (std::uint32_t node = 0; node < graph.nodes(); ++node)
      for (const PathStep step : graph.away_from(node))
        if (is_open[step.edge] != 0 && (kept_at(node) == 2) == is_closed) add_from(step);
  return out;
}

}  // namespace mes
