// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/samples_alone.h"

#include <array>
#include <memory>
#include <utility>

#include "core/builtins/builtins.h"
#include "core/document/commands.h"

namespace mes {

Expected<void> compute_samples_alone(Graph& graph, std::span<const Vec2> positions, std::string_view layer,
                                     JobControl& job) {
  return compute_alone(graph, {.positions = {positions.begin(), positions.end()}}, layer, job);
}

Expected<void> compute_alone(Graph& graph, const SampleData& data, std::string_view layer, JobControl& job) {
  auto delta = replace_all(Document(), data);
  if (!delta) return std::unexpected(delta.error());
  graph.set_demand(std::array{find_layer(layer)});
  graph.post(std::make_shared<const DocumentDelta>(std::move(*delta)));
  FramePatch patch;
  if (!graph.run(patch, job)) throw Cancelled{};
  for (const NodeReport& node : patch.nodes)
    if (node.state == NodeState::failed)
      return std::unexpected(
          Error{ErrorCode::cannot_compute, "structure " + node.structure + " failed: " + node.reason, {}, 0, 0});
  return {};
}

}  // namespace mes
