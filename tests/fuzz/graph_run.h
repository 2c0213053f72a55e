// SPDX-License-Identifier: GPL-3.0-or-later
// A graph with every layer shown, and the mirror that takes its patches.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/graph.h"
#include "tests/fuzz/reader_checks.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/state_of_graph.h"

namespace mes::fuzz {

/// Thrown when an input takes longer than a fuzzer may wait: signs of nested roots can take minutes each.
struct TooMuchWork {};

/// Asks for a stop after three seconds of work of the process, or five seconds on the clock, which counts unions with
/// naive arithmetic as well: they run in processes of their own. The driver ends the process after thirty seconds of
/// work, so a finding of too much time is work that does not answer to the stop.
class WorkLimit {
 public:
  std::stop_token token() const { return stop_.get_token(); }
  bool is_reached() const { return stop_.stop_requested(); }

 private:
  std::stop_source stop_;
  std::jthread clock_{[this, start = std::clock()](const std::stop_token& over) {
    constexpr std::clock_t kMostWork = 3 * CLOCKS_PER_SEC;
    constexpr int kMostLooks = 100;
    constexpr std::chrono::milliseconds kPause(50);
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any ended;
    for (int i = 0; i < kMostLooks && std::clock() - start < kMostWork && !over.stop_requested(); ++i)
      ended.wait_for(lock, over, kPause, [] { return false; });
    if (!over.stop_requested()) stop_.request_stop();
  }};
};

/// After each `run` every structure and layer is up to date, and the mirror has taken the patch; or the process ends.
/// With naive arithmetic unions may fail.
class GraphRun {
 public:
  /// `is_small`: also the layer that compares with exact arithmetic, whatever the number type. All runs of an input
  /// share a limit.
  GraphRun(const ComputationSettings& settings, bool is_small, const WorkLimit& limit) : limit_(limit) {
    for (LayerIndex layer = 0; layer < layer_descriptors().size(); ++layer)
      if (is_small || layer_descriptors()[layer].id != "precision-difference") layers_.push_back(layer);
    show(layers_);
    graph_.set_want_statistics(true);
    choose(settings);
    graph_.set_on_task([this](std::string_view) {
      if (tasks_left_ > 0 && --tasks_left_ == 0) stop_.request_stop();
    });
  }

  const Graph& graph() const { return graph_; }
  /// Every layer that this run may show.
  const std::vector<LayerIndex>& layers() const { return layers_; }
  void show(std::span<const LayerIndex> layers) { graph_.set_demand(layers); }
  const LayerMirror& mirror() const { return mirror_; }
  test::GeometryState state() const { return test::state_of(graph_); }

  void post(const DocumentDelta& delta) { graph_.post(std::make_shared<const DocumentDelta>(delta)); }

  void choose(const ComputationSettings& settings) {
    graph_.post_settings(settings);
    precision_ = settings.precision;
  }

  void run() {
    tasks_left_ = 0;
    JobControl job(limit_.token());
    if (!graph_.run(patch_, job)) {
      require(limit_.is_reached(), "a run that is not stopped is complete");
      throw TooMuchWork{};
    }
    for (const NodeReport& node : patch_.nodes) {
      if (node.state == NodeState::failed) require_message(node.reason);
      require(is_as_it_should_be(node.state), node.structure + " is computed: " + node.reason);
    }
    for (const LayerReport& layer : patch_.reports)
      require(is_as_it_should_be(layer.state),
              std::string(layer_descriptors()[layer.layer.layer].id) + " is shown: " + layer.reason);
    mirror_.apply(patch_);
  }

  /// A run that is stopped when so many structures and layers have been begun. What it gives is taken all the same.
  void run_and_stop(std::size_t tasks) {
    stop_ = std::stop_source();
    const std::stop_callback at_limit(limit_.token(), [this] { stop_.request_stop(); });
    tasks_left_ = tasks;
    JobControl job(stop_.get_token());
    if (tasks == 0) stop_.request_stop();
    graph_.run(patch_, job);
    mirror_.apply(patch_);
  }

  /// The statistics that are counts, by "structure key".
  std::map<std::string, std::int64_t> counts() const {
    std::map<std::string, std::int64_t> out;
    for (const NodeReport& node : patch_.nodes)
      for (const Stat& stat : node.stats)
        if (const auto* count = std::get_if<std::int64_t>(&stat.value))
          out.emplace(node.structure + ' ' + stat.key, *count);
    return out;
  }

 private:
  /// Plain doubles may contradict themselves, which is noticed, or go on for ever, which is ended.
  bool is_as_it_should_be(NodeState state) const {
    return state == NodeState::up_to_date || state == NodeState::inactive ||
           (precision_ == Precision::naive && (state == NodeState::failed || state == NodeState::blocked));
  }

  const WorkLimit& limit_;
  std::vector<LayerIndex> layers_;
  Precision precision_ = Precision::fast;
  Graph graph_{builtins()};
  FramePatch patch_;
  LayerMirror mirror_;
  std::size_t tasks_left_ = 0;
  std::stop_source stop_;
};

/// The document as data, samples and balls in input order or against it.
inline SampleData data_of(const Document& document, bool is_reversed) {
  SampleData out;
  for (const SampleSlot slot : document.slots_in_input_order()) out.positions.push_back(document.position(slot));
  for (const BallSlot slot : document.ball_slots_in_input_order()) out.balls.push_back(document.disk(slot));
  if (is_reversed) {
    std::ranges::reverse(out.positions);
    std::ranges::reverse(out.balls);
  }
  return out;
}

/// A fresh run of the data.
inline std::unique_ptr<GraphRun> fresh_run(const SampleData& data, const ComputationSettings& settings, bool is_small,
                                           const WorkLimit& limit) {
  Document document;
  const auto delta = replace_all(document, data);
  require(delta.has_value(), "the data make a document");
  auto out = std::make_unique<GraphRun>(settings, is_small, limit);
  out->post(*delta);
  out->run();
  return out;
}

}  // namespace mes::fuzz
