// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry engine on its own thread: takes document deltas and the set of wanted layers, gives back patches.
//
// What it guarantees:
//  1. No call but `sync` ever waits for a computation.
//  2. Deltas are applied in the order of `post`. Several pending ones are computed as one step: the newest state
//     wins.
//  3. Patches come out in order and each builds on the one before; none is skipped or shared.
//  4. A structure that fails leaves its layers at their last good picture; the report says why.
//  5. Variants are computed in the same steps as the main computation, and are in the same patches.
//  6. `cancel` ends the running computation within a fraction of a second; what it had to do stays pending until
//     the next `post`, `set_demand` or `resume`.
//
// Smallest use:
//     Engine engine(registry, {});
//     engine.set_demand({registry.find_layer("medial-axis")});
//     engine.post(std::make_shared<const DocumentDelta>(delta));
//     while (auto patch = engine.sync()) { scene.apply(*patch); engine.recycle(std::move(patch)); }
//
// Threads: all methods may be called from one other thread (the window's). `wake` is called from the engine's thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/delta.h"
#include "core/draw/patch.h"
#include "core/draw/variant.h"
#include "core/engine/variant_request.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

class Registry;

/// A change of the document of one variant.
struct VariantDelta {
  VariantIndex variant = kMainVariant;
  std::shared_ptr<const DocumentDelta> delta;
};

/// A change of the variants. Those that keep their kind keep their documents.
struct VariantStep {
  std::optional<std::vector<VariantRequest>> variants{};  ///< 1, 2, ...; none: as they were
  std::vector<VariantDelta> deltas{};                     ///< of variants that have documents
};

/// What changes together and is computed as one step.
struct EngineStep {
  std::vector<std::shared_ptr<const DocumentDelta>> deltas;
  ComputationSettings settings;
  std::vector<VariantLayer> demand;  ///< of all variants (`layer_in`)
  VariantStep beside{};
};

struct EngineStatus {
  bool busy = false;       ///< something is being computed or waits to be; answering questions does not count
  bool cancelled = false;  ///< work is pending after `cancel`
  std::string task;        ///< public id of the structure or layer at work; empty when idle
  double progress = 0.0;   ///< of that task, in [0, 1]; 0 when unknown
  double busy_ms = 0.0;    ///< since the running computation began
};

class Engine {
 public:
  struct Options {
    std::function<void()>
        wake;  ///< a patch or an answer is ready or the status changed; must be quick and must not throw
    /// Makes the engine's graph a one-shot one (core/engine/graph.h). Called on threads of the engine; must not throw.
    std::function<void(const InstancePiece&)> take_instances{};
    /// Whether scalars of what is taken are needed.
    bool needs_scalars = true;
  };

  /// The registry has to outlive it.
  Engine(const Registry& registry, Options options);
  /// Keeps the registry alive until it has taken another.
  Engine(std::shared_ptr<const Registry> registry, Options options);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Takes another registry, as `Graph::set_registry`, and keeps it alive. Demand may name its layers from now on. Where
  /// memory does not suffice, the engine goes on with the one before and does not hear of layers that it lacks.
  void set_registry(std::shared_ptr<const Registry> registry);
  void post(std::shared_ptr<const DocumentDelta> delta);
  /// Layers to keep up to date. A layer that comes into demand is sent whole (reset); one that leaves costs nothing.
  void set_demand(std::vector<VariantLayer> layers);
  /// Number type and parameters. A computation with other settings is abandoned.
  void set_settings(const ComputationSettings& settings);
  /// All three at once: no patch shows some of it without the rest. So what follows depends on the steps alone, and
  /// not on how fast they come.
  void post(EngineStep step);
  /// The next patches carry `NodeReport::stats`; O(n) for some structures, so only while they are looked at.
  void set_want_statistics(bool wanted);
  /// The next patches carry `NodeReport::findings`, of the theorem's judges too.
  void set_want_findings(bool wanted);
  /// Answered after the next complete run; see `take_answers`. Does not hold up what is being computed, does not count
  /// as busy, and waits while something is to be computed, even where the answer was begun. A later question takes the
  /// place of one with the same wish that is not answered.
  void ask(ProvenanceQuestion question);
  void cancel();
  void resume();

  /// What was answered since the last call. Never waits.
  std::vector<Provenance> take_answers();
  /// The next finished patch, or null. Never waits.
  std::unique_ptr<FramePatch> poll();
  /// Waits until everything posted is computed and everything asked is answered, then as `poll`; null when all patches
  /// have been taken.
  std::unique_ptr<FramePatch> sync();
  /// Gives a patch's memory back for the next one.
  void recycle(std::unique_ptr<FramePatch> patch);
  EngineStatus status() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mes
