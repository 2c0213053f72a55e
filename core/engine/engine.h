// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry engine on its own thread: takes document deltas and the set of wanted layers, and returns patches.
//
// Guarantees:
//  1. No call but `sync` ever waits for a computation.
//  2. Deltas are applied in the order of `post`. Several pending ones are computed as one step, which shows only the
//     newest state.
//  3. Patches are returned in order and each builds on the previous one; none is skipped or shared.
//  4. If a structure fails, its layers keep their last good picture, and the report has the reason.
//  5. Variants are computed in the same steps as the main computation, and are in the same patches.
//  6. `cancel` ends the running computation within a fraction of a second; the interrupted work stays pending until the
//     next `post`, `set_demand` or `resume`.
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
#include "core/draw/provenance.h"
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

/// A change of the variants. Variants of unchanged kind keep their documents.
struct VariantStep {
  std::optional<std::vector<VariantRequest>> variants{};  ///< variants 1, 2, ...; unset: unchanged
  std::vector<VariantDelta> deltas{};                     ///< for variants that have documents
};

/// Changes that belong together and are computed as one step.
struct EngineStep {
  std::vector<std::shared_ptr<const DocumentDelta>> deltas;
  ComputationSettings settings;
  std::vector<VariantLayer> demand;  ///< layers of all variants (`layer_in`)
  VariantStep beside{};
};

struct EngineStatus {
  bool busy = false;       ///< a computation is running or pending; questions do not count
  bool cancelled = false;  ///< work is pending after `cancel`
  std::string task;        ///< public id of the structure or layer being computed; empty when idle
  double progress = 0.0;   ///< progress of that task, in [0, 1]; 0 when unknown
  double busy_ms = 0.0;    ///< duration of the running computation so far
};

class Engine {
 public:
  struct Options {
    std::function<void()>
        wake;  ///< a patch or an answer is ready, or the status changed; must be quick and must not throw
    /// Makes the engine's graph a one-shot one (core/engine/graph.h). Called on threads of the engine; must not throw.
    std::function<void(const InstancePiece&)> take_instances{};
    /// Whether the taken instances need their scalars.
    bool needs_scalars = true;
  };

  /// The registry must outlive the engine.
  Engine(const Registry& registry, Options options);
  /// Keeps the registry alive until another one replaces it.
  Engine(std::shared_ptr<const Registry> registry, Options options);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Replaces the registry, like `Graph::set_registry`, and keeps it alive. From now on demand may name its layers. If
  /// memory runs out, the engine keeps the previous registry and ignores layers that it lacks.
  void set_registry(std::shared_ptr<const Registry> registry);
  void post(std::shared_ptr<const DocumentDelta> delta);
  /// Layers to keep up to date. A newly demanded layer is sent whole (reset); a dropped one costs nothing.
  void set_demand(std::vector<VariantLayer> layers);
  /// Sets number type and parameters. A computation with other settings is abandoned.
  void set_settings(const ComputationSettings& settings);
  /// Posts all three at once: no patch shows only a part of them. So the results depend on the steps alone, and not on
  /// their timing.
  void post(EngineStep step);
  /// The next patches carry `NodeReport::stats`; O(n) for some structures, so only while someone looks at them.
  void set_want_statistics(bool wanted);
  /// The next patches carry `NodeReport::findings`, including those of the theorem's judges.
  void set_want_findings(bool wanted);
  /// The answer follows the next complete run; see `take_answers`. A question does not delay computations and does not
  /// count as busy; its answer waits for them, even if it was already begun. A new question replaces an unanswered one
  /// with the same wish.
  void ask(ProvenanceQuestion question);
  void cancel();
  void resume();

  /// Answers since the last call. Never waits.
  std::vector<Provenance> take_answers();
  /// The next finished patch, or null. Never waits.
  std::unique_ptr<FramePatch> poll();
  /// Waits until everything posted is computed and everything asked is answered, then behaves like `poll`; null if all
  /// patches have been taken.
  std::unique_ptr<FramePatch> sync();
  /// Returns a patch's memory for reuse.
  void recycle(std::unique_ptr<FramePatch> patch);
  EngineStatus status() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mes
