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

#include "core/base/job_control.h"
#include "core/base/task_queue.h"
#include "core/draw/patch.h"
#include "core/draw/variant.h"
#include "core/engine/variant_request.h"
#include "core/graph/registry.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

/// What it guarantees:
///  1. After a complete `run`, every demanded layer shows the document state of the last posted delta.
///  2. A structure is computed only if it is needed itself or a demanded layer needs it. It follows an edit locally when
///     it was up to date in the run before; otherwise it is rebuilt. Nothing is computed twice in a run, nothing at all
///     when nothing changed.
///  3. A structure that throws is *failed*: it and what depends on it keep their last patches, and are rebuilt in the
///     next run in which their inputs change.
///  4. Lack of memory ends no run in another way: what found no room is failed, and the reason is `kOutOfMemory`.
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
/// as soon as their structures are done, while it goes on with the structures after those; none is left at its end.
class Graph {
 public:
  /// The registry has to outlive it, or its place as the registry of the graph.
  explicit Graph(const Registry& registry);
  /// Takes another registry, made from the present one by removals and additions, of which none is of a source. Structures
  /// that both have, with what they are computed from, stay as they are; others are gone or new. Demand of layers that are
  /// gone ends, and all others are sent whole by the next run. The present registry is not needed any more. Lack of memory
  /// throws `std::bad_alloc` and changes nothing.
  void set_registry(const Registry& registry);

  /// Takes instances of layers. Those of one layer come in order, from one thread; several layers may come at once.
  using InstanceTaker = std::function<void(const InstancePiece&)>;
  /// Makes the graph a *one-shot* one, before its first run and for good: nothing is updated, each run computes anew,
  /// and layers are handed to `take` in pieces instead of being put into patches. So neither structures nor layers keep
  /// what only an edit would need, and no layer is ever in memory as a whole. After a run that was stopped or of which a
  /// layer failed, what was taken is worthless. Where scalars are not needed they are not looked for, and may be 0.
  void make_one_shot(InstanceTaker take, bool needs_scalars = true);

  void post(std::shared_ptr<const DocumentDelta> delta);
  void post_settings(const ComputationSettings& settings);
  /// To the document of a variant that has one, empty at first.
  void post(VariantIndex variant, std::shared_ptr<const DocumentDelta> delta);
  /// The variants 1, 2, ...; those from the first one on that differs in more than its settings are made anew. Where
  /// memory does not suffice, there are none, and what is asked of them is not heard.
  void set_variants(std::span<const VariantRequest> variants);
  /// Layers of all variants; of what a variant shares, that of the main computation (`layer_in`).
  void set_demand(std::span<const VariantLayer> layers);
  void set_demand(std::span<const LayerIndex> of_main) { set_demand(main_layers(of_main)); }
  /// Structures of the main computation that are kept up to date even if no demanded layer needs them. Ids that the
  /// registry does not have are ignored.
  void set_needed_structures(std::span<const std::string_view> ids);
  void set_want_statistics(bool wanted) { want_statistics_ = wanted; }
  /// Keeps the judges of the theorem light up to date too, and reports what they and others find.
  void set_want_findings(bool wanted);
  /// For `answer`. A later question takes the place of an earlier one with the same wish.
  void ask(ProvenanceQuestion question);
  /// Brings all demanded layers up to date and writes what changed. False when it was stopped: the patch then holds
  /// no layer, its frame and revision are those of the last complete run, and the next run goes on.
  bool run(FramePatch& out, JobControl& job);
  bool has_questions() const;
  /// After a complete run: adds answers to what was asked, of that run. What is not answered when it is stopped stays
  /// asked. `out` has room for `kProvenanceWishes` more.
  void answer(std::vector<Provenance>& out, JobControl& job);
  /// After a complete run, before the next edit comes: the structures make what the next edit needs. Ends early when
  /// stopped. Judges of the theorem light come last and look at the second job: an edit that waits for them would
  /// rather come first.
  void get_ready(JobControl& job, JobControl& job_at_leisure);
  void get_ready(JobControl& job) { get_ready(job, job); }
  /// After a complete run: what the structure says of its rows may be read (`Structure::table_columns`).
  bool is_up_to_date(const Structure& structure) const;
  /// Called with the public id of each structure or layer before it is worked on.
  void set_on_task(std::function<void(std::string_view)> on_task) { on_task_ = std::move(on_task); }

  const StructureSet& structures() const { return variants_.front()->structures; }
  const StructureSet& structures(VariantIndex variant) const { return variants_[variant]->structures; }

 private:
  struct StructureNode {
    Structure* structure = nullptr;
    VariantIndex variant = kMainVariant;
    SourceStructure* source = nullptr;  ///< the structure, if it is one
    std::vector<std::size_t> inputs;
    std::optional<std::size_t> settings;  ///< the input that gives the settings; statistics may depend on them
    std::vector<VariantLayer> completes;  ///< layers for which this is the last structure to wait for
    bool needed_itself = false;           ///< named in `set_needed_structures`
    bool needed = false;  ///< it is read by a demanded layer or a needed structure, is a judge, or needed itself
    NodeState state = NodeState::inactive;
    std::uint64_t synced = 0;    ///< run in which it was last known to be true to its inputs; 0 = never
    std::uint64_t tried = 0;     ///< run in which it was last computed, well or not
    std::uint64_t changed = 0;   ///< run in which its tables last changed
    std::uint64_t computed = 0;  ///< run in which it, or what it is computed from, was last tried
    std::uint64_t rebuilt = 0;   ///< run in which they were last rebuilt
    bool last_was_rebuild = false;
    bool has_changes = false;  ///< its change sets are those of an earlier run, perhaps one that was stopped
    double ms = 0.0;
    std::uint64_t touched = 0;
    std::string reason;
    std::vector<SampleId> witnesses;
    bool is_refused = false;  ///< failed, for its size
    StatList stats;
    std::uint64_t stats_run = 0;
    std::vector<Finding> findings;
    std::uint64_t findings_run = 0;
  };
  struct LayerNode {
    Layer layer;  ///< without parts where a variant shares it
    std::vector<std::size_t> structures;
    /// Kinds that it does not emit, of which the consumer may hold instances: the layer of an earlier registry did.
    std::vector<PrimitiveKind> earlier_kinds{};
    bool demanded = false;
    bool sent = false;  ///< the consumer holds instances of it
    NodeState state = NodeState::inactive;
    std::uint64_t synced = 0;
    std::uint64_t begun = 0;  ///< run in which it did not wait for all structures
    std::uint64_t lost = 0;   ///< primitives that are not finite
    double ms = 0.0;
    std::string reason;
  };
  struct Variant {
    StructureSet structures;
    bool has_document = true;
    std::size_t first_node = 0;
    std::vector<LayerNode> layers{};  ///< by position in the registry
  };

  /// The graph of another registry, with what both have of the structures of `before`, and its demand.
  Graph(const Registry& registry, const Graph& before);
  void add(std::unique_ptr<Variant> variant);
  void drop_variants(std::size_t kept);
  LayerNode& node_of(VariantLayer layer) { return variants_[layer.variant]->layers[layer.layer]; }
  /// Null where the variant found no room, or is gone.
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
  std::uint64_t origin_ = 0;                        // of the nodes, among those of all graphs
  std::vector<std::unique_ptr<Variant>> variants_;  // the main one first
  const Samples* samples_ = nullptr;                // of the main one
  std::vector<StructureNode> nodes_;                // variant by variant, inputs before their consumers
  DrawingFrame frame_;
  DrawingFrame sent_frame_;  ///< of the last complete run, and of all that consumers hold
  std::uint64_t sent_revision_ = 0;
  std::atomic<bool> keeps_frame_ = false;  ///< some layer has a picture in that frame, and no room for another
  std::uint64_t run_ = 0;
  bool demand_changed_ = true;
  std::uint64_t demand_ = 0;  ///< a number for it, among those of this graph
  // What an edit looks at, of the many that there are: made anew when the demand changes.
  std::vector<std::size_t> sources_;
  std::vector<std::size_t> needed_;  ///< structures, sources among them
  std::vector<VariantLayer> demanded_;
  bool want_statistics_ = false;
  bool want_findings_ = false;
  std::array<std::optional<ProvenanceQuestion>, kProvenanceWishes> questions_;  ///< by wish; without an answer
  std::int64_t lap_ns_ = 0;
  std::function<void(std::string_view)> on_task_;
  InstanceTaker take_;  ///< empty unless the graph is a one-shot one
  bool needs_scalars_ = true;

  // Work space of one run.
  struct LayerBefore {
    VariantLayer layer;
    NodeState state;
    bool sent;
    std::uint64_t synced;
  };
  std::vector<LayerBefore> before_;       // layers that were looked at, as they were
  std::atomic<bool> is_stopped_ = false;  // some layer was not made
};

}  // namespace mes
