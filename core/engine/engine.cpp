// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/engine.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <iterator>
#include <mutex>
#include <new>
#include <optional>
#include <thread>
#include <utility>

#include "core/engine/graph.h"

namespace mes {

struct Engine::Impl {
  Impl(std::shared_ptr<const Registry> first, Options given)
      : options(std::move(given)), registry(std::move(first)), graph(*registry) {
    found.reserve(kProvenanceWishes);
    if (options.take_instances) graph.make_one_shot(options.take_instances, options.needs_scalars);
    graph.set_on_task([this](std::string_view id) {
      const std::lock_guard lock(mutex);
      status.task = id;
    });
    thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
  }
  ~Impl() {
    // Takes the lock: a notification between the worker's check of the stop token and its sleep would be lost.
    const std::lock_guard lock(mutex);
    stopping = true;
    job_stop.request_stop();
    awaited.request_stop();
    thread.request_stop();
    work_there.notify_all();
  }

  // Stops the running answer, because its subject is about to change.
  void stop_answering() {
    if (is_answering) job_stop.request_stop();
  }
  void add(std::shared_ptr<const DocumentDelta> delta) {
    stop_answering();
    // A replacement of everything makes the running computation obsolete.
    if (delta->replaces_all()) job_stop.request_stop();
    deltas.push_back(std::move(delta));
    status.cancelled = false;
  }
  void set(const ComputationSettings& wanted) {
    status.cancelled = false;
    if (wanted == latest_settings) return;
    latest_settings = wanted;
    settings = wanted;
    job_stop.request_stop();
  }
  void add(VariantStep step) {
    if (step.variants && *step.variants == latest_variants) step.variants.reset();
    if (!step.variants && step.deltas.empty()) return;
    stop_answering();
    status.cancelled = false;
    if (step.variants) {
      latest_variants = *step.variants;
      job_stop.request_stop();
    }
    variant_steps.push_back(std::move(step));
  }
  void set(std::vector<VariantLayer> layers) {
    stop_answering();
    demand = std::move(layers);
    demand_changed = true;
    status.cancelled = false;
  }

  void add(ProvenanceQuestion question) {
    // Reserved here, so that the engine's thread needs no memory to hand over the answers.
    constexpr std::size_t kMostAsked = 2 * kProvenanceWishes;
    answers.reserve(answers.size() + kMostAsked);
    std::erase_if(questions, [&](const ProvenanceQuestion& earlier) { return earlier.wish == question.wish; });
    questions.push_back(std::move(question));
  }

  void take_registry() try {
    if (!next_registry) return;
    graph.set_registry(*next_registry);
    registry = std::move(next_registry);
  } catch (const std::bad_alloc&) {
    next_registry.reset();
  }

  bool has_to_compute() const {
    return next_registry || !deltas.empty() || !variant_steps.empty() || settings || demand_changed ||
           want_statistics != has_statistics || want_findings != has_findings || unfinished;
  }
  bool has_work() const { return has_to_compute() || !questions.empty(); }
  /// Called under the lock, after new work was added.
  void announce() {
    if (!has_work()) return;
    awaited.request_stop();
    work_there.notify_one();
  }

  void work(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    for (;;) {
      work_there.wait(lock, [&] { return stop.stop_requested() || (has_work() && !status.cancelled); });
      if (stop.stop_requested()) return;
      status.busy = has_to_compute();
      take_registry();
      for (auto& delta : deltas) graph.post(std::move(delta));
      deltas.clear();
      for (VariantStep& step : variant_steps) {
        if (step.variants) graph.set_variants(*step.variants);
        for (auto& [variant, delta] : step.deltas) graph.post(variant, std::move(delta));
      }
      variant_steps.clear();
      if (settings) graph.post_settings(*settings);
      settings.reset();
      if (demand_changed) graph.set_demand(demand);
      demand_changed = false;
      graph.set_want_statistics(want_statistics);
      has_statistics = want_statistics;
      graph.set_want_findings(want_findings);
      has_findings = want_findings;
      for (ProvenanceQuestion& question : questions) graph.ask(std::move(question));
      questions.clear();
      unfinished = false;
      job_stop = std::stop_source();
      if (stopping) job_stop.request_stop();
      job.set_token(job_stop.get_token());
      awaited = std::stop_source();
      job_at_leisure.set_token(awaited.get_token());
      is_running = true;
      started = std::chrono::steady_clock::now();
      std::unique_ptr<FramePatch> patch = take_spare();
      const bool is_news = status.busy;
      lock.unlock();
      if (is_news) wake();

      graph.run(*patch, job);

      lock.lock();
      const bool is_complete = patch->complete;
      if (!is_complete) unfinished = true;
      finished.push_back(std::move(patch));
      status.busy = false;
      if (is_complete && graph.has_questions()) answer(lock);
      is_running = false;
      if (!has_to_compute()) status.cancelled = false;  // too late: the work is already done
      status.task.clear();
      idle.notify_all();
      const bool has_time = is_complete && !has_work();
      lock.unlock();
      wake();
      if (has_time) graph.get_ready(job, job_at_leisure);
      lock.lock();
    }
  }

  // The finished patch does not wait for the answers.
  void answer(std::unique_lock<std::mutex>& lock) {
    is_answering = true;
    // A stop that came too late for the run does not concern the answers.
    job_stop = std::stop_source();
    if (stopping || has_to_compute()) job_stop.request_stop();
    job.set_token(job_stop.get_token());
    lock.unlock();
    wake();
    graph.answer(found, job);
    lock.lock();
    is_answering = false;
    std::ranges::move(found, std::back_inserter(answers));
    found.clear();
  }

  std::unique_ptr<FramePatch> take_spare() {
    if (spare.empty()) return std::make_unique<FramePatch>();
    auto patch = std::move(spare.back());
    spare.pop_back();
    return patch;
  }

  std::unique_ptr<FramePatch> take_finished() {
    if (finished.empty()) return nullptr;
    auto patch = std::move(finished.front());
    finished.pop_front();
    return patch;
  }

  void wake() {
    if (options.wake) options.wake();
  }

  Options options;
  std::shared_ptr<const Registry> registry;       // used by the graph
  std::shared_ptr<const Registry> next_registry;  // not yet passed to the graph
  Graph graph;                                    // used only by the engine's thread
  JobControl job;
  JobControl job_at_leisure;  // stopped by any new work
  mutable std::mutex mutex;
  std::condition_variable work_there;
  std::condition_variable idle;
  std::vector<std::shared_ptr<const DocumentDelta>> deltas;
  std::optional<ComputationSettings> settings;  // not yet passed to the graph
  ComputationSettings latest_settings;
  std::vector<VariantRequest> latest_variants;
  std::vector<VariantStep> variant_steps;  // not yet passed to the graph
  std::vector<VariantLayer> demand;
  bool demand_changed = false;
  bool want_statistics = false;
  bool has_statistics = false;
  bool want_findings = false;
  bool has_findings = false;
  std::vector<ProvenanceQuestion> questions;  // not yet passed to the graph
  std::vector<Provenance> answers;            // not yet taken
  std::vector<Provenance> found;              // used only by the engine's thread
  bool unfinished = false;
  bool is_running = false;    // the graph is working; `status.busy` says whether it computes
  bool is_answering = false;  // ... and its last patch is finished
  bool stopping = false;
  std::stop_source job_stop;
  std::stop_source awaited;  // signals work that the worker has not seen
  EngineStatus status;
  std::chrono::steady_clock::time_point started;
  std::deque<std::unique_ptr<FramePatch>> finished;
  std::vector<std::unique_ptr<FramePatch>> spare;
  std::jthread thread;  // last member, so that the thread ends before the members it uses
};

Engine::Engine(const Registry& registry, Options options)
    : Engine(std::shared_ptr<const Registry>(std::shared_ptr<const Registry>(), &registry), std::move(options)) {}
Engine::Engine(std::shared_ptr<const Registry> registry, Options options)
    : impl_(std::make_unique<Impl>(std::move(registry), std::move(options))) {}
Engine::~Engine() = default;

void Engine::set_registry(std::shared_ptr<const Registry> registry) {
  const std::lock_guard lock(impl_->mutex);
  impl_->stop_answering();
  impl_->next_registry = std::move(registry);
  impl_->status.cancelled = false;
  impl_->job_stop.request_stop();
  impl_->announce();
}

void Engine::post(std::shared_ptr<const DocumentDelta> delta) {
  const std::lock_guard lock(impl_->mutex);
  impl_->add(std::move(delta));
  impl_->announce();
}

void Engine::post(EngineStep step) {
  const std::lock_guard lock(impl_->mutex);
  for (auto& delta : step.deltas) impl_->add(std::move(delta));
  impl_->set(step.settings);
  impl_->add(std::move(step.beside));
  impl_->set(std::move(step.demand));
  impl_->announce();
}

void Engine::set_demand(std::vector<VariantLayer> layers) {
  const std::lock_guard lock(impl_->mutex);
  impl_->set(std::move(layers));
  impl_->announce();
}

void Engine::set_settings(const ComputationSettings& settings) {
  const std::lock_guard lock(impl_->mutex);
  impl_->set(settings);
  impl_->announce();
}

void Engine::set_want_statistics(bool wanted) {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->want_statistics == wanted) return;
  impl_->stop_answering();
  impl_->want_statistics = wanted;
  impl_->announce();
}

void Engine::set_want_findings(bool wanted) {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->want_findings == wanted) return;
  impl_->stop_answering();
  impl_->want_findings = wanted;
  impl_->announce();
}

void Engine::ask(ProvenanceQuestion question) {
  const std::lock_guard lock(impl_->mutex);
  impl_->add(std::move(question));
  impl_->announce();
}

void Engine::cancel() {
  const std::lock_guard lock(impl_->mutex);
  if (!impl_->status.busy && !impl_->has_to_compute()) return;
  impl_->status.cancelled = true;
  impl_->job_stop.request_stop();
  impl_->idle.notify_all();
}

void Engine::resume() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->status.cancelled = false;
  }
  impl_->work_there.notify_one();
}

std::vector<Provenance> Engine::take_answers() {
  const std::lock_guard lock(impl_->mutex);
  std::vector<Provenance> out(std::move_iterator(impl_->answers.begin()), std::move_iterator(impl_->answers.end()));
  impl_->answers.clear();
  return out;
}

std::unique_ptr<FramePatch> Engine::poll() {
  const std::lock_guard lock(impl_->mutex);
  return impl_->take_finished();
}

std::unique_ptr<FramePatch> Engine::sync() {
  std::unique_lock lock(impl_->mutex);
  impl_->idle.wait(lock, [this] { return !impl_->is_running && (!impl_->has_work() || impl_->status.cancelled); });
  return impl_->take_finished();
}

void Engine::recycle(std::unique_ptr<FramePatch> patch) {
  constexpr std::size_t kKept = 3;
  const std::lock_guard lock(impl_->mutex);
  if (patch && impl_->spare.size() < kKept) impl_->spare.push_back(std::move(patch));
}

EngineStatus Engine::status() const {
  const std::lock_guard lock(impl_->mutex);
  EngineStatus out = impl_->status;
  out.progress = impl_->job.progress();
  if (out.busy) {
    out.busy_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - impl_->started).count();
  }
  out.busy = out.busy || (impl_->has_to_compute() && !out.cancelled);
  return out;
}

}  // namespace mes
