// SPDX-License-Identifier: GPL-3.0-or-later
// A workbench keeps a document and the geometry that follows it, for callers that wait for their results.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/document/commands.h"
#include "core/document/timeline/history.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/graph.h"
#include "core/engine/theorem_light.h"
#include "core/io/format.h"

namespace mes {

/// Options that say how much a workbench keeps. The defaults suit interactive use.
struct WorkbenchOptions {
  /// false: `load` and `open` give their data to the structures alone; the document stays empty, other edits are
  /// refused, and there is no history.
  bool keeps_document = true;
  bool keeps_history = true;    ///< false: nothing can be undone, and edits cost no memory
  bool keeps_instances = true;  ///< false: layers are only in `patch()`, as changes since the previous run
  /// Makes the graph a one-shot graph, which hands instances out in pieces and keeps nothing for later edits
  /// (`Graph::make_one_shot`). The workbench then keeps no document and no instances.
  Graph::InstanceTaker take_instances{};
  bool needs_scalars = true;  ///< false: a one-shot graph may skip scalars that are expensive to compute
};

/// A variant is computed beside the document, with other settings or other data (core/draw/variant.h).
struct WorkbenchVariant {
  ComputationSettings settings{};
  std::shared_ptr<const SampleData> data{};  ///< null: the variant shares the document
};

/// A workbench owns a document, its history and its settings, and computes the structures and layers that the caller
/// asks for. An edit changes the document at once; `run` brings the results up to date. The window, which must not
/// wait, uses an `Engine` instead.
///
/// Guarantees:
///  1. After a `run` without error, every needed structure and every shown layer is that of the present document and
///     settings. A run computes only what has changed since the run before.
///  2. An edit or a setting that is refused changes nothing.
///  3. After a `run` with the error `cannot_compute`, everything that does not depend on the failed structures is up to
///     date, and `nodes()` has the reasons. The next run that changes their inputs tries them again.
///  4. After a `run` with the error `cancelled`, instances and digests are as before it, and no structure can be read
///     by its id. The next run completes the work.
///  5. Results that are read by a public id are never outdated by a failure: `structure`, `statistic`, `instances` and
///     `digest` return the results of the last run, or an error that says why there are none.
///
/// Smallest use:
///     Workbench bench(builtins());
///     JobControl job;
///     bench.insert(points);
///     bench.show({"medial-axis"});
///     if (bench.run(job)) draw(*bench.instances("medial-axis", PrimitiveKind::segment));
///
/// Cost: an edit takes O(size of the change), a run takes as long as `Graph::run`, and reading takes O(number of
/// structures or layers) to look up an id. Lack of memory in an edit throws `std::bad_alloc`; the workbench can then
/// only be destroyed.
/// Threads: none inside except those of the graph, which end with `run`. One thread at a time may use a workbench;
/// other threads may watch or stop a run by its `JobControl`.
class Workbench {
 public:
  /// The registry must contain the sources `Samples` and `SettingsSource`, and must outlive the workbench.
  explicit Workbench(const Registry& registry, WorkbenchOptions options = {});
  /// Replaces the registry by one that was made from it without a change of its sources and outlives the workbench
  /// instead. Document, history, settings and demand stay as they are; there are no results before the next run, which
  /// computes the new structures. Removed structures are not needed any more.
  void set_registry(const Registry& registry);

  // The document. A step of undo is one edit, or all edits between `begin_step` and `end_step`.

  /// Reads a file of any format and replaces the document by its data. A session also sets its settings; other files
  /// leave the settings as they are. Returns information on the file, with its data. Error: as `read_sample_file`.
  Expected<LoadedFile> open(const std::filesystem::path& path, JobControl& job, const ReadRequest& request = {},
                            std::string_view format = {});
  /// Does the same for bytes in memory; `name` stands for the file in messages.
  Expected<LoadedFile> open_bytes(std::string_view bytes, const std::string& name, JobControl& job,
                                  const ReadRequest& request = {}, std::string_view format = {});
  /// Replaces the document. All samples and balls get new ids. Error: as `replace_all`.
  Expected<void> load(const SampleData& data);

  /// Returns the ids of the new samples, in the order of their positions. Error, here and below: as `change_document`.
  Expected<std::vector<SampleId>> insert(std::span<const Vec2> positions);
  Expected<std::vector<BallId>> insert_balls(std::span<const Disk> disks);
  Expected<void> move(std::span<const std::pair<SampleId, Vec2>> targets);
  Expected<void> remove(std::span<const SampleId> ids);
  Expected<void> change_balls(std::span<const std::pair<BallId, Disk>> targets);
  Expected<void> remove_balls(std::span<const BallId> ids);
  /// Replaces the contours. Their points are indices of samples in input order. Error: `bad_input` for an index that
  /// does not exist.
  Expected<void> set_contours(std::span<const SampleData::Contour> contours);
  /// Applies the result of a command for the present document. If the command failed, returns its error unchanged.
  Expected<void> apply(Expected<DocumentDelta> delta, const std::string& name = {});

  /// Steps cannot be nested.
  void begin_step(std::string name) { history_.begin_gesture(std::move(name)); }
  void end_step() { history_.end_gesture(); }
  /// Both return false if there is nothing to undo or redo.
  bool undo() { return apply_all(history_.undo()); }
  bool redo() { return apply_all(history_.redo()); }
  /// Afterwards nothing can be undone or redone. Not inside a step.
  void forget_history() { history_.clear(); }

  const Document& document() const& { return document_; }
  /// Gives the document away. The workbench cannot be used afterwards.
  Document document() && { return std::move(document_); }
  const History& history() const { return history_; }

  // Settings. They apply from the next run on.

  const ComputationSettings& settings() const { return settings_; }
  /// Does not check the values.
  void choose(const ComputationSettings& settings);
  /// Values beyond the range of a limit are set to the end of the range. Error: `usage` for an unknown parameter,
  /// another value beyond its range, or a fraction where a whole number is expected.
  Expected<void> set(std::string_view parameter, double value);
  Expected<void> set(const Parameter& parameter, double value);
  void set_precision(Precision precision);
  /// Error: `usage` for an unknown number type.
  Expected<void> set_precision(std::string_view id);

  /// Computes these variants in the same runs, replacing all earlier ones, whose layers are hidden. Variants are
  /// numbered from 1; `layer_in` says which of their layers are their own. Error: as `replace_all`.
  Expected<void> compare_with(std::span<const WorkbenchVariant> variants);
  /// Documents of the variants; empty for a variant that shares the workbench's.
  const std::vector<Document>& variant_documents() const& { return variant_documents_; }
  std::vector<Document> variant_documents() && { return std::move(variant_documents_); }

  // Demand. Each call replaces the previous one; nothing is computed without demand.

  /// Chooses the layers whose instances are computed. Error: `usage` for an unknown layer.
  Expected<void> show(std::span<const std::string_view> layers);
  Expected<void> show(std::initializer_list<std::string_view> layers) { return show(std::span(layers)); }
  void show(std::span<const LayerIndex> layers) { show(main_layers(layers)); }
  void show(std::vector<VariantLayer> layers);
  /// Chooses structures that are computed even if no shown layer reads them. Error: `usage` for an unknown structure.
  Expected<void> need(std::span<const std::string_view> structures);
  Expected<void> need(std::initializer_list<std::string_view> structures) { return need(std::span(structures)); }
  template <class... S>
  void need() {
    graph_->set_needed_structures(std::vector<std::string_view>{get<S>().id()...});
  }
  /// The next runs report counters and measures. Some take O(n).
  void set_want_statistics(bool wanted) { graph_->set_want_statistics(wanted); }
  /// The next runs also compute the judges of the theorem light, and report their findings.
  void set_want_findings(bool wanted) { graph_->set_want_findings(wanted); }
  /// Sets a function that is called with the id of each structure or layer before work on it begins.
  void set_on_task(std::function<void(std::string_view)> on_task) { graph_->set_on_task(std::move(on_task)); }

  // Computing.

  /// Brings everything demanded up to date. Error: `cannot_compute` with the first cause, `cancelled`, or
  /// `out_of_memory` if there is no room for the instances.
  Expected<void> run(JobControl& job);
  /// Does the same for code that is itself part of a job, and throws `Cancelled` when the job is stopped.
  Expected<void> run_or_throw(JobControl& job);
  /// Prepares data that only the next edit needs, to make it faster. Optional, after a run; ends early when stopped.
  void get_ready(JobControl& job) { graph_->get_ready(job); }

  // Results of the last run.

  /// Returns a structure by its public id. Error: it is unknown, was not needed, failed, or was left unfinished by a
  /// stop.
  Expected<const Structure*> structure(std::string_view id) const;
  /// Returns a structure by its type. Its tables are meaningful only if it was up to date after the last run.
  template <class T>
  const T& get() const {
    return graph_->structures().get<T>();
  }
  /// Returns a counter or a measure of a structure by its public key. Error: as `structure`; statistics were not
  /// wanted; the key does not exist.
  Expected<StatValue> statistic(std::string_view structure, std::string_view key) const;
  /// Returns the instances of a kind, `stride_of(kind)` doubles each (core/draw/primitives.h). They are valid until the
  /// next run. Error: the layer is unknown, was not shown, failed, or instances are not kept.
  Expected<std::span<const double>> instances(std::string_view layer, PrimitiveKind kind) const;
  /// Returns the digest that `mesecina compute --digest` writes. Error: as `instances`.
  Expected<LayerDigest> digest(std::string_view layer) const;
  /// The mirror holds the instances of all layers, including outdated ones of hidden or failed layers.
  const LayerMirror& mirror() const { return mirror_; }

  /// One report for each structure of the registry, in its order, then those of variants; empty before the first run.
  std::span<const NodeReport> nodes() const { return patch_.nodes; }
  /// One report for each layer, likewise.
  std::span<const LayerReport> layers() const { return patch_.reports; }
  /// The theorem light is `none` unless findings were wanted.
  TheoremLight light() const { return light_of(patch_.nodes); }
  /// The patch of the last run.
  const FramePatch& patch() const { return patch_; }
  const Graph& graph() const { return *graph_; }

  /// Runs, and answers the question about the results; sets the ticket of the question. Layers that are not shown are
  /// ignored. Error: as `run`.
  Expected<Provenance> ask(ProvenanceQuestion question, JobControl& job);

 private:
  Expected<LoadedFile> take(Expected<LoadedFile> file);
  bool apply_all(const std::vector<DocumentDelta>& deltas);
  /// Returns the layer if its instances are those of the last run.
  Expected<LayerIndex> readable(std::string_view layer) const;
  Expected<const NodeReport*> readable_node(std::string_view structure) const;
  const Registry* registry_;
  WorkbenchOptions options_;
  Document document_;
  History history_;
  ComputationSettings settings_;
  std::vector<Document> variant_documents_;
  std::vector<VariantLayer> shown_;
  std::unique_ptr<Graph> graph_;
  FramePatch patch_;
  LayerMirror mirror_;
  std::uint64_t ticket_ = 0;  // ticket of the last question
};

}  // namespace mes
