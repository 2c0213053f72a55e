// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/picture_check.h"

#include <algorithm>

#include "core/document/commands.h"
#include "tests/support/builtin_layers.h"

namespace mes::test {
namespace {

std::string failure_in(const FramePatch& patch) {
  for (const NodeReport& node : patch.nodes)
    if (node.state == NodeState::failed) return node.structure + " failed: " + node.reason;
  for (const LayerReport& report : patch.reports)
    if (report.state == NodeState::failed)
      return std::string(layer_descriptors()[report.layer.layer].id) + " failed: " + report.reason;
  return {};
}

std::string counts_of(const LayerMirror& mirror, LayerIndex layer) {
  std::string out;
  for (const PrimitiveKind kind : layer_descriptors()[layer].kinds)
    out += ' ' + std::to_string(mirror.count(layer, kind)) + ' ' + std::string(name_of(kind));
  return out;
}

}  // namespace

bool Consumer::run(std::int64_t stop_at) {
  JobControl job;
  job.stop_at_look(stop_at);
  const bool is_complete = graph.run(patch, job);
  MES_ASSERT(patch.complete == is_complete);
  mirror.apply(patch);
  return is_complete;
}

std::string difference_from_fresh(const Consumer& consumer, const Document& document,
                                  const ComputationSettings& settings, std::span<const LayerIndex> layers) {
  if (const std::string failure = failure_in(consumer.patch); !failure.empty()) return failure;
  if (consumer.patch.document_revision != document.revision()) return "the picture is of another document state";
  SampleData data = data_of(document);
  data.annotations.clear();
  data.source.reset();
  Consumer fresh;
  fresh.graph.post_settings(settings);
  fresh.graph.set_demand(layers);
  fresh.graph.post(std::make_shared<const DocumentDelta>(*replace_all({}, data)));
  fresh.run();
  if (const std::string failure = failure_in(fresh.patch); !failure.empty()) return "afresh, " + failure;
  for (const LayerIndex layer : layers) {
    const LayerDescriptor& descriptor = layer_descriptors()[layer];
    if (descriptor.id == "last-change") continue;
    if (consumer.mirror.digest(layer) != fresh.mirror.digest(layer))
      return "layer " + std::string(descriptor.id) + " differs:" + counts_of(consumer.mirror, layer) + ", afresh" +
             counts_of(fresh.mirror, layer);
  }
  return {};
}

}  // namespace mes::test
