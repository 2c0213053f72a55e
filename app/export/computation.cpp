// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/computation.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>

#include "core/builtins/builtins.h"
#include "core/draw/variant.h"
#include "core/engine/engine.h"

namespace mes {
namespace {

/// Lets the engine's thread rouse this one.
class Bell {
 public:
  void ring() {
    {
      const std::lock_guard lock(mutex_);
      rung_ = true;
    }
    condition_.notify_one();
  }
  void wait(std::chrono::milliseconds at_most) {
    std::unique_lock lock(mutex_);
    condition_.wait_for(lock, at_most, [this] { return rung_; });
    rung_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool rung_ = false;
};

/// The work as a list of tasks in the order of the engine, so that "the third of seven" is known.
class TaskList {
 public:
  explicit TaskList(std::span<const VariantLayer> layers) {
    const auto descriptors = layer_descriptors();
    for (const VariantLayer layer : layers)
      for (const std::string_view structure : descriptors[layer.layer].structures)
        if (std::ranges::find(tasks_, structure) == tasks_.end()) tasks_.push_back(structure);
    structures_ = tasks_.size();
    for (const VariantLayer layer : layers) tasks_.push_back(descriptors[layer.layer].id);
  }

  double fraction(const EngineStatus& status) {
    const auto found = std::ranges::find(tasks_, status.task);
    if (found != tasks_.end()) at_ = std::max(at_, static_cast<std::size_t>(found - tasks_.begin()));
    // Emitting a layer is quick beside computing a structure.
    constexpr double kLayerWeight = 0.1;
    const auto weight_before = [this](std::size_t position) {
      const std::size_t layers = position > structures_ ? position - structures_ : 0;
      return static_cast<double>(position - layers) + kLayerWeight * static_cast<double>(layers);
    };
    const double weight = at_ < structures_ ? 1.0 : kLayerWeight;
    return (weight_before(at_) + weight * status.progress) / std::max(1e-9, weight_before(tasks_.size()));
  }

 private:
  std::vector<std::string_view> tasks_;
  std::size_t structures_ = 0;
  std::size_t at_ = 0;
};

std::unexpected<Error> failure_of(std::span<const NodeReport> nodes, std::span<const LayerReport> reports) {
  // A failed structure is the cause; blocked ones and layers follow from it.
  for (const NodeReport& node : nodes)
    if (node.state == NodeState::failed)
      return std::unexpected(
          Error{ErrorCode::cannot_compute, "structure " + node.structure + " failed: " + node.reason, {}, 0, 0});
  for (const LayerReport& report : reports)
    if (report.state == NodeState::failed || report.state == NodeState::blocked)
      return std::unexpected(
          Error{ErrorCode::cannot_compute,
                "layer " + std::string(layer_descriptors()[report.layer.layer].id) + " failed: " + report.reason,
                {},
                0,
                0});
  return std::unexpected(Error{ErrorCode::cannot_compute, "the computation did not finish", {}, 0, 0});
}

/// What the engine is given of variants, and their documents.
Expected<VariantStep> variants_of(std::span<const ComputedVariant> wanted, std::vector<Document>& documents) {
  VariantStep out;
  if (wanted.empty()) return out;
  out.variants.emplace();
  for (const ComputedVariant& variant : wanted) {
    out.variants->push_back({variant.settings, variant.data != nullptr});
    Document& document = documents.emplace_back();
    if (!variant.data) continue;
    auto replacement = replace_all(document, *variant.data);
    if (!replacement) return std::unexpected(replacement.error());
    const auto index = static_cast<VariantIndex>(out.variants->size());
    out.deltas.push_back({index, std::make_shared<const DocumentDelta>(std::move(*replacement))});
    document.apply(*out.deltas.back().delta);
  }
  return out;
}

/// Posts the step and waits for the end of it.
Expected<ComputationReport> run_to_end(EngineStep step, const ComputationRequest& request,
                                       std::function<void(const InstancePiece&)> take) {
  const std::uint64_t revision = step.deltas.front()->to_revision;
  ComputationReport result;
  Bell bell;
  TaskList tasks(request.layers);
  Engine engine(
      builtins(),
      {.wake = [&bell] { bell.ring(); }, .take_instances = std::move(take), .needs_scalars = request.needs_scalars});
  engine.set_want_statistics(request.want_statistics);
  engine.set_want_findings(request.want_findings);
  engine.post(std::move(step));

  bool is_complete = false;
  for (;;) {
    // The status first: when it says idle, every patch is in the queue by now.
    const EngineStatus status = engine.status();
    while (auto patch = engine.poll()) {
      if (request.on_patch) request.on_patch(*patch);
      is_complete = patch->complete && patch->document_revision == revision;
      result.nodes = patch->nodes;
      result.reports = patch->reports;
      engine.recycle(std::move(patch));
    }
    if (request.stop.stop_requested())
      return std::unexpected(Error{ErrorCode::cancelled, "the computation was stopped", {}, 0, 0});
    if (!status.busy) break;
    if (request.on_progress) request.on_progress(status.task, tasks.fraction(status));
    constexpr std::chrono::milliseconds kBetweenLooks{100};
    bell.wait(kBetweenLooks);
  }

  // What the run says of itself needs room, too.
  if (is_complete && (result.nodes.empty() || result.reports.empty()))
    return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory"});
  std::erase_if(result.nodes, [](const NodeReport& node) { return node.state == NodeState::inactive; });
  const auto is_good = [](NodeState state) { return state == NodeState::up_to_date || state == NodeState::inactive; };
  const bool all_good = is_complete && std::ranges::all_of(result.nodes, is_good, &NodeReport::state) &&
                        std::ranges::all_of(result.reports, is_good, &LayerReport::state);
  if (!all_good) return failure_of(result.nodes, result.reports);
  return result;
}

}  // namespace

Expected<ComputationResult> run_computation(const SampleData& data, const ComputationRequest& request) {
  ComputationResult result;
  auto replacement = replace_all(result.document, data);
  if (!replacement) return std::unexpected(replacement.error());
  const auto delta = std::make_shared<const DocumentDelta>(std::move(*replacement));
  result.document.apply(*delta);

  auto beside = variants_of(request.variants, result.documents);
  if (!beside) return std::unexpected(beside.error());
  auto report = run_to_end(
      {.deltas = {delta}, .settings = request.settings, .demand = request.layers, .beside = std::move(*beside)},
      request, {});
  if (!report) return std::unexpected(report.error());
  result.nodes = std::move(report->nodes);
  result.reports = std::move(report->reports);
  return result;
}

Expected<ComputationReport> run_one_shot(SampleData data, const ComputationRequest& request,
                                         std::function<void(const InstancePiece&)> take) {
  auto replacement = replace_all(Document(), data);
  if (!replacement) return std::unexpected(replacement.error());
  data = {};
  EngineStep step{.deltas = {std::make_shared<const DocumentDelta>(std::move(*replacement))},
                  .settings = request.settings,
                  .demand = request.layers,
                  .beside = {}};
  replacement = DocumentDelta{};
  return run_to_end(std::move(step), request, std::move(take));
}

}  // namespace mes
