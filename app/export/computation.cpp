// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/computation.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <string>
#include <string_view>

#include "core/graph/registry.h"

namespace mes {
namespace {

/// The tasks in the order of the graph, so that a position such as "third of seven" is known.
class TaskList {
 public:
  TaskList(const Registry& registry, std::span<const VariantLayer> layers) {
    const auto descriptors = registry.layers();
    for (const VariantLayer layer : layers)
      for (const std::string_view structure : descriptors[layer.layer].structures)
        if (std::ranges::find(tasks_, structure) == tasks_.end()) tasks_.push_back(structure);
    structures_ = tasks_.size();
    for (const VariantLayer layer : layers) tasks_.push_back(descriptors[layer.layer].id);
  }

  /// `progress` is that of the task.
  double fraction(std::string_view task, double progress) {
    const auto found = std::ranges::find(tasks_, task);
    if (found != tasks_.end()) at_ = std::max(at_, static_cast<std::size_t>(found - tasks_.begin()));
    // Emitting a layer is quick compared to computing a structure.
    constexpr double kLayerWeight = 0.1;
    const auto weight_before = [this](std::size_t position) {
      const std::size_t layers = position > structures_ ? position - structures_ : 0;
      return static_cast<double>(position - layers) + kLayerWeight * static_cast<double>(layers);
    };
    const double weight = at_ < structures_ ? 1.0 : kLayerWeight;
    return (weight_before(at_) + weight * progress) / std::max(1e-9, weight_before(tasks_.size()));
  }

 private:
  std::vector<std::string_view> tasks_;
  std::size_t structures_ = 0;
  std::size_t at_ = 0;
};

/// Runs the workbench on a thread of its own, while this one reports the progress.
Expected<ComputationReport> run_to_end(const Registry& registry, Workbench& bench,
                                       const ComputationRequest& request) {
  bench.choose(request.settings);
  bench.show(request.layers);
  if (auto good = bench.need(request.structures); !good) return std::unexpected(good.error());
  bench.set_want_statistics(request.want_statistics);
  bench.set_want_findings(request.want_findings);
  std::mutex mutex;
  std::string task;
  bench.set_on_task([&](std::string_view id) {
    const std::lock_guard lock(mutex);
    task = id;
  });
  const auto task_now = [&] {
    const std::lock_guard lock(mutex);
    return task;
  };
  JobControl job(request.stop);
  auto running = std::async(std::launch::async, [&] { return bench.run(job); });
  TaskList tasks(registry, request.layers);
  constexpr std::chrono::milliseconds kBetweenLooks{100};
  while (running.wait_for(kBetweenLooks) == std::future_status::timeout) {
    const std::string now = task_now();
    if (request.on_progress) request.on_progress(now, tasks.fraction(now, job.progress()));
  }
  auto done = running.get();
  bench.set_on_task({});
  if (request.on_patch) request.on_patch(bench.patch());
  if (!done) return std::unexpected(std::move(done.error()));
  // A short run may end before it notices a stop.
  if (request.stop.stop_requested())
    return std::unexpected(Error{ErrorCode::cancelled, "the computation was stopped", {}, 0, 0});
  ComputationReport out{.nodes = {bench.nodes().begin(), bench.nodes().end()},
                        .reports = {bench.layers().begin(), bench.layers().end()}};
  std::erase_if(out.nodes, [](const NodeReport& node) { return node.state == NodeState::inactive; });
  return out;
}

}  // namespace

Expected<ComputationResult> run_computation(const Registry& registry, const SampleData& data,
                                            const ComputationRequest& request) {
  Workbench bench(registry, {.keeps_history = false, .keeps_instances = false});
  if (auto good = bench.load(data); !good) return std::unexpected(good.error());
  if (auto good = bench.compare_with(request.variants); !good) return std::unexpected(good.error());
  auto report = run_to_end(registry, bench, request);
  if (!report) return std::unexpected(report.error());
  return ComputationResult{.document = std::move(bench).document(),
                           .documents = std::move(bench).variant_documents(),
                           .nodes = std::move(report->nodes),
                           .reports = std::move(report->reports)};
}

Expected<ComputationReport> run_one_shot(const Registry& registry, SampleData data, const ComputationRequest& request,
                                         std::function<void(const InstancePiece&)> take) {
  Workbench bench(registry, {.take_instances = std::move(take), .needs_scalars = request.needs_scalars});
  if (auto good = bench.load(data); !good) return std::unexpected(good.error());
  data = {};
  return run_to_end(registry, bench, request);
}

}  // namespace mes
