// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry graph: structures and layers, brought up to date on demand.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/base/jobs/task_queue.h"
#include "core/draw/patch.h"
#include "core/draw/variant.h"
#include "core/engine/variant_request.h"
#include "core/graph/layer.h"
#include "core/graph/registry.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

/// Guarantees:
///  1. After a complete `run`, every demanded layer shows the document state of the last posted delta.
///  2. A structure is computed only if it is needed itself or a demanded layer needs it. It follows an edit locally if
///     it was up to date in the previous run; otherwise it is rebuilt. Nothing is computed twice in a run, and nothing
///     at all if nothing changed.
///  3. A structure that throws is *failed*: it and its dependents keep their last patches, and are rebuilt in the next
///     run in which their inputs change.
///  4. Lack of memory never ends a run otherwise: a structure or layer without memory fails with `kOutOfMemory`.
///  5. A variant is brought up to date in the same runs as the main computation, and what they share is computed once.
///
/// Smallest use:
///     Graph graph(registry);
///     graph.set_demand(std::vector{registry.find_layer("medial-axis")});
///     graph.post(delta);
///     FramePatch patch;
///     JobControl job;
///     graph.run(patch, job);
///
/// Threads: `Engine` runs it on a thread of its own. Inside `run`, layers that are sent whole are made on other cores
/// as soon as their structures are done, while `run` continues with later structures; no thread is left at its end.
class Graph {
 public:
  /// The registry must outlive the graph, or its time as the registry of the graph.
  explicit Graph(const Registry& registry);
  /// Replaces the registry by one that was made from it by removals and additions, none of them of a source. Structures
  /// that both have, with unchanged inputs, are kept; others are removed or created. Demand for removed layers ends,
  /// and the next run sends all others whole. The previous registry is not needed any more. Lack of memory throws
  /// `std::bad_alloc` and changes nothing.
  void set_registry(const Registry& registry);

  /// Receives instances of layers: those of one layer in order, from one thread; several layers at once.
  using InstanceTaker = std::function<void(const InstancePiece&)>;
  /// Makes the graph a *one-shot* graph, before its first run and for good. Nothing is updated: each run computes from
  /// scratch, and hands layers to `take` in pieces instead of putting them into patches. So structures and layers keep
  /// no data that only an edit would need, and no layer is ever completely in memory. After a stopped run, or one in
  /// which a layer failed, the taken instances are worthless. Scalars that are not needed are not computed, and may be
  /// 0.
  void make_one_shot(InstanceTaker take, bool needs_scalars = true);

  void post(std::shared_ptr<const DocumentDelta> delta);
  void post_settings(const ComputationSettings& settings);
  /// Posts to the own document of a variant, which is empty at first.
  void post(VariantIndex variant, std::shared_ptr<const DocumentDelta> delta);
  /// Sets the variants 1, 2, ...; all from the first one that differs in more than its settings are created again. If
  /// memory runs out, all variants are dropped and requests to them are ignored.
  void set_variants(std::span<const VariantRequest> variants);
  /// Layers of all variants; a layer that a variant shares is named as that of the main computation (`layer_in`).
  void set_demand(std::span<const VariantLayer> layers);
  void set_demand(std::span<const LayerIndex> of_main) { set_demand(main_layers(of_main)); }
  /// Structures of the main computation that are kept up to date even if no demanded layer needs them. Unknown ids are
  /// ignored.
  void set_needed_structures(std::span<const std::string_view> ids);
  void set_want_statistics(bool wanted) { want_statistics_ = wanted; }
  /// Also keeps the judges of the theorem light up to date, and reports their findings and those of others.
  void set_want_findings(bool wanted);
  /// Asks a question for `answer`. A new question replaces an earlier one with the same wish.
  void ask(ProvenanceQuestion question);
  /// Brings all demanded layers up to date and writes the changes. Returns false if it was stopped: the patch then
  /// holds no layer, its frame and revision are those of the last complete run, and the next run continues.
  bool run(FramePatch& out, JobControl& job);
  bool has_questions() const;
  /// After a complete run: appends answers for this run. Questions that a stop leaves unanswered stay pending. `out`
  /// must have room for `kProvenanceWishes` more.
  void answer(std::vector<Provenance>& out, JobControl& job);
  /// After a complete run, before the next edit: lets structures prepare for that edit. Ends early when stopped. Judges
  /// of the theorem light come last and check the second job, because an edit should not wait for them.
  void get_ready(JobControl& job, JobControl& job_at_leisure);
  void get_ready(JobControl& job) { get_ready(job, job); }
  /// After a complete run: whether data on the structure's rows may be read (`Structure::table_columns`).
  bool is_up_to_date(const Structure& structure) const;
  /// Sets a function that is called with the public id of each structure or layer before work on it begins.
  void set_on_task(std::function<void(std::string_view)> on_task) { on_task_ = std::move(on_task); }

  const StructureSet& structures() const { return variants_.front()->structures; }
  const StructureSet& structures(VariantIndex variant) const { return variants_[variant]->structures; }

 private:
  struct StructureNode {
    Structure* structure = nullptr;
    VariantIndex variant = kMainVariant;
    SourceStructure* source = nullptr;  ///< the structure, if it is a source
    std::vector<std::size_t> inputs;
    std::optional<std::size_t> settings;  ///< index of the settings input; statistics may depend on the settings
    std::vector<VariantLayer> completes;  ///< layers that wait for this structure last
    bool needed_itself = false;           ///< named in `set_needed_structures`
    bool needed = false;  ///< read by a demanded layer or a needed structure, a judge, or needed itself
    NodeState state = NodeState::inactive;
    std::uint64_t synced = 0;    ///< run in which it was last known to match its inputs; 0 = never
    std::uint64_t tried = 0;     ///< run in which it was last computed, successfully or not
    std::uint64_t changed = 0;   ///< run in which its tables last changed
    std::uint64_t computed = 0;  ///< run in which it or one of its inputs was last tried
    std::uint64_t rebuilt = 0;   ///< run in which it was last rebuilt
    bool last_was_rebuild = false;
    bool has_changes = false;  ///< change sets are from an earlier run, perhaps a stopped one
    double ms = 0.0;
    std::uint64_t touched = 0;
    std::string reason;
    std::vector<SampleId> witnesses;
    bool is_refused = false;  ///< failed because of its size
    StatList stats;
    std::uint64_t stats_run = 0;
    std::vector<Finding> findings;
    std::uint64_t findings_run = 0;
  };
  struct LayerNode {
    Layer layer;  ///< has no parts if a variant shares it
    std::vector<std::size_t> structures;
    /// Kinds that it does not emit but the consumer may hold: the layer of an earlier registry emitted them.
    std::vector<PrimitiveKind> earlier_kinds{};
    bool demanded = false;
    bool sent = false;  ///< the consumer holds its instances
    NodeState state = NodeState::inactive;
    std::uint64_t synced = 0;
    std::uint64_t begun = 0;  ///< run in which it started before all structures were done
    std::uint64_t lost = 0;   ///< number of primitives that are not finite
    double ms = 0.0;
    std::string reason;
  };
  struct Variant {
    StructureSet structures;
    bool has_document = true;
    std::size_t first_node = 0;
    std::vector<LayerNode> layers{};  ///< indexed by position in the registry
  };

  /// Graph of another registry, which takes over from `before` the structures that both have, and its demand.
  Graph(const Registry& registry, const Graph& before);
  void add(std::unique_ptr<Variant> variant);
  void drop_variants(std::size_t kept);
  LayerNode& node_of(VariantLayer layer) { return variants_[layer.variant]->layers[layer.layer]; }
  /// Null if the variant found no memory, or no longer exists.
  const LayerNode* find(VariantLayer layer) const;
  template <class Visit>
  void for_each_layer(Visit visit) const {
    for (VariantIndex variant = 0; variant < variants_.size(); ++variant)
      for (LayerIndex layer = 0; layer < variants_[variant]->layers.size(); ++layer)
        visit(VariantLayer(variant, layer), variants_[variant]->layers[layer]);
  }
  void mark_needed();
  void bring_up_to_date(StructureNode& node, JobControl& job);
  void compute(StructureNode& node, bool may_update, JobControl& job);
  void begin_reset(VariantLayer index, FramePatch& out, TaskQueue& tasks, JobControl& job);
  void begin_layers(const StructureNode& node, FramePatch& out, TaskQueue& tasks, JobControl& job);
  LayerPatch& begin_patch(VariantLayer index, FramePatch& out);
  void withdraw(LayerPatch& patch);
  enum class Emission : std::uint8_t { none, update, reset };
  Emission emission_of(VariantLayer index, FramePatch& out);
  void emit_layers(FramePatch& out, TaskQueue& tasks, JobControl& job);
  void take_back(FramePatch& out);
  void fill(LayerPatch& patch, Emission emission, JobControl& job);
  void emit_whole(LayerPart& part, LayerPatch& patch) const;
  bool is_one_shot() const { return take_ != nullptr; }
  void follow_extent();
  void report(FramePatch& out);
  void report_node(StructureNode& node, NodeReport& out);
  void report_all_inactive(FramePatch& out);
  static void report_inactive(const StructureNode& node, NodeReport& out);
  void report_lack_of_memory(FramePatch& out);
  void give_up_for_lack_of_memory(FramePatch& out);
  void find_answer(const ProvenanceQuestion& question, Provenance& out, JobControl& job) const;
  std::vector<ProvenanceLine> sources_of_values(const ProvenanceQuestion& question,
                                                const std::function<bool(const Structure&)>& is_current,
                                                JobControl& job) const;
  double lap_ms();

  const Registry* registry_;
  std::uint64_t origin_ = 0;                        // identifies the nodes among those of all graphs
  std::vector<std::unique_ptr<Variant>> variants_;  // the main computation first
  const Samples* samples_ = nullptr;                // samples of the main computation
  std::vector<StructureNode> nodes_;                // variant by variant, inputs before their consumers
  DrawingFrame frame_;
  DrawingFrame sent_frame_;  ///< frame of the last complete run, and of all instances that consumers hold
  std::uint64_t sent_revision_ = 0;
  std::atomic<bool> keeps_frame_ = false;  ///< a layer has a picture in that frame, and no memory for another
  std::uint64_t run_ = 0;
  bool demand_changed_ = true;
  std::uint64_t demand_ = 0;  ///< identifies the demand within this graph
  // The nodes that an edit visits, out of all; computed again when the demand changes.
  std::vector<std::size_t> sources_;
  std::vector<std::size_t> needed_;  ///< structures, including sources
  std::vector<VariantLayer> demanded_;
  bool want_statistics_ = false;
  bool want_findings_ = false;
  std::array<std::optional<ProvenanceQuestion>, kProvenanceWishes> questions_;  ///< unanswered questions, by wish
  std::int64_t lap_ns_ = 0;
  std::function<void(std::string_view)> on_task_;
  InstanceTaker take_;  ///< empty unless this is a one-shot graph
  bool needs_scalars_ = true;

  // Working memory of one run.
  struct LayerBefore {
    VariantLayer layer;
    NodeState state;
    bool sent;
    std::uint64_t synced;
  };
  std::vector<LayerBefore> before_;       // state of the visited layers before the run
  std::atomic<bool> is_stopped_ = false;  // some layer was not made
};

}  // namespace mes
