// SPDX-License-Identifier: GPL-3.0-or-later
// Results of a run, by their public ids.
#include <algorithm>

#include "core/workbench/internal/refusals.h"
#include "core/workbench/workbench.h"

namespace mes {

Expected<const NodeReport*> Workbench::readable_node(std::string_view structure) const {
  if (std::ranges::find(registry_->structures(), structure) == registry_->structures().end())
    return refusals::unknown("structure", structure);
  if (!patch_.complete) return refusals::stopped();
  const auto node = std::ranges::find(patch_.nodes, structure, &NodeReport::structure);
  if (node == patch_.nodes.end() || node->state == NodeState::inactive)
    return refusals::not_computed("structure", structure);
  if (node->state != NodeState::up_to_date) return refusals::failed("structure", structure, node->reason);
  return &*node;
}

Expected<const Structure*> Workbench::structure(std::string_view id) const {
  if (auto node = readable_node(id); !node) return std::unexpected(std::move(node.error()));
  for (const auto& structure : graph_->structures().all())
    if (structure->id() == id) return structure.get();
  return refusals::unknown("structure", id);
}

Expected<StatValue> Workbench::statistic(std::string_view structure, std::string_view key) const {
  const auto node = readable_node(structure);
  if (!node) return std::unexpected(node.error());
  const StatList& stats = (*node)->stats;
  const auto found = std::ranges::find(stats, key, &Stat::key);
  if (found != stats.end()) return found->value;
  if (stats.empty()) return refusals::usage(fmt::format("structure {} has no statistics", structure));
  return refusals::unknown("statistic", key);
}

Expected<LayerIndex> Workbench::readable(std::string_view layer) const {
  const LayerIndex index = registry_->find_layer(layer);
  if (index == kNoLayer) return refusals::unknown("layer", layer);
  if (!options_.keeps_instances) return refusals::usage("this workbench keeps no instances");
  if (index >= patch_.reports.size() || patch_.reports[index].state == NodeState::inactive)
    return refusals::not_computed("layer", layer);
  if (const LayerReport& report = patch_.reports[index]; has_failed(report.state))
    return refusals::failed("layer", layer, report.reason);
  return index;
}

Expected<std::span<const double>> Workbench::instances(std::string_view layer, PrimitiveKind kind) const {
  const auto index = readable(layer);
  if (!index) return std::unexpected(index.error());
  return mirror_.instances(*index, kind);
}

Expected<LayerDigest> Workbench::digest(std::string_view layer) const {
  const auto index = readable(layer);
  if (!index) return std::unexpected(index.error());
  return mirror_.digest(*index);
}

Expected<Provenance> Workbench::ask(ProvenanceQuestion question, JobControl& job) {
  question.ticket = ++ticket_;
  graph_->ask(std::move(question));
  if (auto done = run(job); !done) return std::unexpected(std::move(done.error()));
  std::vector<Provenance> answers;
  graph_->answer(answers, job);
  // Earlier stopped questions may have been answered too.
  for (Provenance& answer : answers)
    if (answer.ticket == ticket_) return std::move(answer);
  return refusals::stopped();
}

}  // namespace mes
