// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/graph.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <utility>

#include "core/base/jobs/isolated.h"
#include "core/engine/memory_lack.h"
#include "core/graph/size_refusal.h"

namespace mes {

void Graph::post(std::shared_ptr<const DocumentDelta> delta) {
  post(kMainVariant, std::move(delta));
}

void Graph::post(VariantIndex variant, std::shared_ptr<const DocumentDelta> delta) {
  if (variant >= variants_.size()) return;  // the variant found no memory
  MES_ASSERT(variants_[variant]->has_document);
  for (const StructureNode& node : nodes_)
    if (node.source != nullptr && node.variant == variant) node.source->post(delta);
}

void Graph::post_settings(const ComputationSettings& settings) {
  structures().get<SettingsSource>().post(settings);
}

void Graph::set_demand(std::span<const VariantLayer> layers) {
  for_each_layer([](VariantLayer /*layer*/, LayerNode& node) { node.demanded = false; });
  for (const VariantLayer layer : layers) {
    if (find(layer) == nullptr) continue;
    LayerNode& node = node_of(layer);
    // A variant that shares the layer may have had its own before the registry changed.
    if (layer.variant == kMainVariant || !node.structures.empty()) node.demanded = true;
  }
  for_each_layer([](VariantLayer /*layer*/, LayerNode& node) {
    if (node.demanded) return;
    node.sent = false;
    node.state = NodeState::inactive;
  });
  demand_changed_ = true;
}

void Graph::set_needed_structures(std::span<const std::string_view> ids) {
  for (StructureNode& node : nodes_)
    node.needed_itself = node.variant == kMainVariant && std::ranges::find(ids, node.structure->id()) != ids.end();
  demand_changed_ = true;
}

void Graph::set_want_findings(bool wanted) {
  if (wanted == want_findings_) return;
  want_findings_ = wanted;
  demand_changed_ = true;
}

void Graph::mark_needed() {
  for (StructureNode& node : nodes_) node.needed = node.needed_itself;
  nodes_.front().needed = true;
  demanded_.clear();
  for_each_layer([this](VariantLayer layer, const LayerNode& node) {
    if (!node.demanded) return;
    demanded_.push_back(layer);
    for (const std::size_t structure : node.structures) nodes_[structure].needed = true;
  });
  for (StructureNode& node : nodes_)
    if (want_findings_ && node.variant == kMainVariant && node.structure->is_judge()) node.needed = true;
  // Inputs are listed before their consumers.
  for (std::size_t i = nodes_.size(); i-- > 0;)
    if (nodes_[i].needed)
      for (const std::size_t input : nodes_[i].inputs) nodes_[input].needed = true;
  sources_.clear();
  needed_.clear();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].source != nullptr) sources_.push_back(i);
    if (nodes_[i].needed) needed_.push_back(i);
  }
  demand_changed_ = false;
  ++demand_;
}

double Graph::lap_ms() {
  const std::int64_t now =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
          .count();
  const double elapsed = 1e-6 * static_cast<double>(now - lap_ns_);
  lap_ns_ = now;
  return elapsed;
}

void Graph::bring_up_to_date(StructureNode& node, JobControl& job) {
  bool inputs_changed =
      node.source != nullptr && (node.source->has_pending() || (node.synced == 0 && node.state != NodeState::failed));
  // A failed structure is retried only after its inputs have changed.
  const std::uint64_t seen = node.state == NodeState::failed ? node.tried : node.synced;
  bool may_update =
      !is_one_shot() && node.synced != 0 && node.synced + 1 == run_ && node.state == NodeState::up_to_date;
  for (const std::size_t i : node.inputs) {
    const StructureNode& input = nodes_[i];
    if (input.state != NodeState::up_to_date) {
      node.state = NodeState::blocked;
      node.reason = std::string(input.structure->id()) + ": " + input.reason;
      return;
    }
    if (input.changed <= seen && seen != 0) continue;
    inputs_changed = true;
    may_update = may_update && input.rebuilt != run_;
  }
  if (!inputs_changed && (node.state == NodeState::up_to_date || node.state == NodeState::failed)) {
    if (std::exchange(node.has_changes, false)) node.structure->clear_changes();
    if (node.state == NodeState::up_to_date) node.synced = run_;
    return;
  }
  compute(node, may_update, job);
}

void Graph::compute(StructureNode& node, bool may_update, JobControl& job) {
  if (on_task_) on_task_(node.structure->id());
  node.state = NodeState::computing;
  node.reason.clear();
  node.witnesses.clear();
  node.is_refused = false;
  const auto fail = [&node](std::string reason) {
    node.state = NodeState::failed;
    node.reason = std::move(reason);
  };
  // If anything goes wrong from here on, the tables are worthless. The state records this: a structure that is not up
  // to date is rebuilt before anything uses it.
  node.tried = run_;
  node.has_changes = true;
  try {
    node.last_was_rebuild = !(may_update && node.structure->update(job));
    if (node.last_was_rebuild) {
      node.structure->rebuild(job);
      node.rebuilt = run_;
    }
    node.state = NodeState::up_to_date;
    node.synced = run_;
    node.touched = node.structure->touched();
    if (node.last_was_rebuild || node.touched != 0) node.changed = run_;
  } catch (const Cancelled&) {
    throw;
  } catch (const GeometryError& error) {
    fail(error.what());
    node.witnesses = error.witnesses;
    node.is_refused = dynamic_cast<const SizeRefusal*>(&error) != nullptr;
  } catch (const std::bad_alloc&) {
    fail(std::string(kOutOfMemory));
  } catch (const std::exception& error) {
    fail(error.what());
  }
  node.ms = lap_ms();
}

// The drawing frame follows the samples only when they leave it by far, because a new frame requires that every
// instance is sent again.
void Graph::follow_extent() {
  Box2 box;
  bool replaced = false;
  for (const std::size_t i : sources_) {
    const StructureNode& node = nodes_[i];
    const Box2 extent = node.source->extent();
    if (extent.is_empty()) continue;
    box.add(extent.low);
    box.add(extent.high);
    replaced = replaced || node.rebuilt == run_;
  }
  if (!box.is_empty()) {
    const auto outside = [this](Vec2 p) {
      const double reach = std::max(std::abs(p.x - frame_.origin.x), std::abs(p.y - frame_.origin.y)) * frame_.scale;
      return !(reach < 0x1p20);
    };
    if (replaced || outside(box.low) || outside(box.high)) {
      const double half = std::max({0.5 * box.high.x - 0.5 * box.low.x, 0.5 * box.high.y - 0.5 * box.low.y});
      DrawingFrame frame{box.center(), 1.0};
      if (half > 0.0) frame.scale = std::ldexp(1.0, std::clamp(-std::ilogb(half), -1000, 1000));
      frame_ = frame;
    }
  }
}

LayerPatch& Graph::begin_patch(VariantLayer index, FramePatch& out) {
  const LayerDescriptor& descriptor = node_of(index).layer.descriptor;
  if (out.layers.size() <= out.layer_count) out.layers.emplace_back();
  LayerPatch& patch = out.layers[out.layer_count++];
  patch.layer = index;
  patch.has_scalars = !descriptor.scalar.empty();
  patch.scalars_are_names = descriptor.scalars_are_names;
  patch.clear();
  return patch;
}

// Turns the patch into one that removes all instances of the layer.
void Graph::withdraw(LayerPatch& patch) {
  patch.clear();
  LayerNode& node = node_of(patch.layer);
  for (const PrimitiveKind kind : node.layer.descriptor.kinds) patch[kind].reset = true;
  for (const PrimitiveKind kind : node.earlier_kinds) patch[kind].reset = true;
  node.sent = false;
}

// Decides what a layer needs: nothing, an update, or a reset.
Graph::Emission Graph::emission_of(VariantLayer index, FramePatch& out) {
  LayerNode& node = node_of(index);
  before_.push_back({index, node.state, node.sent, node.synced});
  bool changed = false;
  bool may_update = !is_one_shot() && node.sent && node.synced + 1 == run_ && frame_ == sent_frame_;
  for (const std::size_t i : node.structures) {
    const StructureNode& input = nodes_[i];
    if (input.state != NodeState::up_to_date) {
      node.state = input.state;
      node.reason = input.reason;
      // The last good picture stays, unless it belongs to an old frame. If memory ran out, the old frame stays instead.
      if (!node.sent || frame_ == sent_frame_) return Emission::none;
      if (node.reason.ends_with(kOutOfMemory))
        keeps_frame_ = true;
      else
        withdraw(begin_patch(index, out));
      return Emission::none;
    }
    if (input.changed <= node.synced) continue;
    changed = true;
    may_update = may_update && input.rebuilt != run_;
  }
  node.state = NodeState::up_to_date;
  node.reason.clear();
  if (node.sent && !changed && frame_ == sent_frame_) {
    node.synced = run_;
    return Emission::none;
  }
  return may_update ? Emission::update : Emission::reset;
}

void Graph::begin_reset(VariantLayer index, FramePatch& out, TaskQueue& tasks, JobControl& job) {
  LayerPatch& patch = begin_patch(index, out);
  tasks.add([this, &patch, &job] { fill(patch, Emission::reset, job); });
}

// Layers only read tables, and tables of structures that are already brought up to date do not change any more. So
// layers that waited for this structure can start at once.
void Graph::begin_layers(const StructureNode& node, FramePatch& out, TaskQueue& tasks, JobControl& job) {
  for (const VariantLayer index : node.completes) {
    LayerNode& layer = node_of(index);
    if (!layer.demanded) continue;
    layer.begun = run_;
    if (emission_of(index, out) != Emission::none) begin_reset(index, out, tasks, job);
  }
}

void Graph::emit_layers(FramePatch& out, TaskQueue& tasks, JobControl& job) {
  // All prefetches first, so that their cache misses overlap.
  for (const VariantLayer index : demanded_)
    if (node_of(index).begun != run_ && !is_one_shot())
      for (const auto& part : node_of(index).layer.parts) part->expect_update();
  for (const VariantLayer index : demanded_) {
    if (node_of(index).begun == run_) continue;
    const Emission emission = emission_of(index, out);
    if (emission == Emission::reset) begin_reset(index, out, tasks, job);
    if (emission != Emission::update) continue;
    LayerPatch& patch = begin_patch(index, out);
    fill(patch, emission, job);
    if (patch.is_empty()) --out.layer_count;
  }
  if (!tasks.is_empty()) {
    if (on_task_) on_task_("layers");
    tasks.finish();
  }
  if (is_stopped_) throw Cancelled{};
  // Drop the empty patches of layers that could not be made.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.layer_count; ++i) {
    if (out.layers[i].is_empty()) continue;
    if (i != kept) std::swap(out.layers[i], out.layers[kept]);
    ++kept;
  }
  out.layer_count = kept;
}

// A stopped run sends nothing, because half of its layers would show another state than the rest. The consumer keeps
// its instances, and the finished part is forgotten; `synced` of those layers then lies in the past, so the next run
// sends them whole.
void Graph::take_back(FramePatch& out) {
  for (const LayerBefore& before : before_) {
    LayerNode& node = node_of(before.layer);
    node.state = before.state;
    node.sent = before.sent;
    node.synced = before.synced;
  }
  out.layer_count = 0;
}

void Graph::emit_whole(LayerPart& part, LayerPatch& patch) const {
  if (is_one_shot())
    part.pour({.layer = patch.layer, .scalars_are_names = patch.scalars_are_names, .values = {}}, needs_scalars_,
              take_);
  else
    part.reset(patch);
}

// If filling ends early, the patch stays empty. The consumer then keeps its instances, unless they belong to an old
// frame. Their rows are forgotten, so the layer is sent whole next time.
void Graph::fill(LayerPatch& patch, Emission emission, JobControl& job) {
  LayerNode& node = node_of(patch.layer);
  node.synced = 0;
  const auto fail = [&](std::string reason) {
    patch.clear();
    if (node.sent && frame_ != sent_frame_) withdraw(patch);
    node.state = NodeState::failed;
    node.reason = std::move(reason);
  };
  try {
    if (emission == Emission::update) {
      for (const auto& part : node.layer.parts) part->update(patch);
    } else {
      const auto start = std::chrono::steady_clock::now();
      if (!is_one_shot())
        for (const PrimitiveKind kind : node.earlier_kinds) patch[kind].reset = true;
      for (const auto& part : node.layer.parts) {
        if (job.stop_requested()) {
          is_stopped_ = true;
          return;
        }
        emit_whole(*part, patch);
      }
      node.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }
    node.lost = 0;
    for (const auto& part : node.layer.parts) node.lost += part->lost();
    node.sent = true;
    node.synced = run_;
  } catch (const Cancelled&) {
    patch.clear();
    is_stopped_ = true;
  } catch (const std::bad_alloc&) {
    patch.clear();
    if (node.sent && frame_ != sent_frame_) keeps_frame_ = true;
    node.state = NodeState::failed;
    node.reason = kOutOfMemory;
  } catch (const std::exception& error) {
    fail(error.what());
  }
}

void Graph::report_node(StructureNode& node, NodeReport& report) {
  if (report.structure != node.structure->id()) report.structure = node.structure->id();
  report.variant = node.variant;
  report.state = node.state;
  if (report.reason != node.reason) report.reason = node.reason;
  if (report.witnesses != node.witnesses) report.witnesses = node.witnesses;
  report.is_refused = node.is_refused;
  node.computed = node.tried;
  for (const std::size_t input : node.inputs) node.computed = std::max(node.computed, nodes_[input].computed);
  report.computed = node.computed;
  report.update_ms = node.ms;
  report.touched = node.changed == run_ ? node.touched : 0;
  report.rebuilt = node.last_was_rebuild;
  report.stats.clear();
  report.findings.clear();
  const bool is_judged = want_findings_ && node.variant == kMainVariant;
  report.is_judging = is_judged && node.structure->has_verdict() && node.state == NodeState::up_to_date;
  report.kernel = node.structure->kernel();
  if (node.state != NodeState::up_to_date) return;
  // After a stopped run, the tables of inputs may be newer than those of the structure, and its statistics and findings
  // read both.
  const bool may_ask = node.synced == run_;
  if (is_judged) {
    if (may_ask && (node.findings_run < node.changed || node.findings_run == 0)) {
      node.findings.clear();
      node.structure->find(node.findings);
      node.findings_run = run_;
    }
    report.findings = node.findings;
  }
  if (!want_statistics_) return;
  const bool has_other_settings = node.settings && nodes_[*node.settings].changed > node.stats_run;
  if (may_ask && (node.stats_run < node.changed || has_other_settings || node.stats.empty())) {
    node.stats = node.structure->statistics();
    node.stats_run = run_;
  }
  report.stats = node.stats;
}

void Graph::report_inactive(const StructureNode& node, NodeReport& report) {
  report = {};
  report.structure = node.structure->id();
  report.variant = node.variant;
  report.kernel = node.structure->kernel();
}

void Graph::report(FramePatch& out) {
  // Most structures and layers are not needed. Their reports stay in the reused patch, unless it was about others.
  const std::size_t layers = variants_.front()->layers.size();
  if (out.origin != origin_ || out.demand != demand_ || out.nodes.size() != nodes_.size() ||
      out.reports.size() != variants_.size() * layers)
    report_all_inactive(out);
  for (const std::size_t i : needed_) report_node(nodes_[i], out.nodes[i]);
  for (const VariantLayer layer : demanded_) {
    const LayerNode& node = node_of(layer);
    LayerReport& report = out.reports[layer.variant * layers + layer.layer];
    report.state = node.state;
    report.emit_ms = node.ms;
    report.lost = node.lost;
    if (report.reason != node.reason) report.reason = node.reason;
  }
}

void Graph::report_all_inactive(FramePatch& out) {
  out.demand = 0;
  out.nodes.resize(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) report_inactive(nodes_[i], out.nodes[i]);
  out.reports.resize(variants_.size() * variants_.front()->layers.size());
  auto next = out.reports.begin();
  for_each_layer([&next](VariantLayer layer, const LayerNode& /*node*/) {
    *next = {};
    next++->layer = layer;
  });
  out.origin = origin_;
  out.demand = demand_;
}

// Used if there is no memory for the report itself.
void Graph::report_lack_of_memory(FramePatch& out) {
  out.nodes.clear();
  out.demand = 0;
  for (LayerReport& report : out.reports) {
    const LayerNode* const node = find(report.layer);
    report.state = node != nullptr && node->demanded ? NodeState::failed : NodeState::inactive;
    report.reason = kOutOfMemory;
  }
}

// The run itself found no memory. It sends nothing, and the next run sends everything.
void Graph::give_up_for_lack_of_memory(FramePatch& out) {
  take_back(out);
  for_each_layer([](VariantLayer /*layer*/, LayerNode& node) {
    if (!node.demanded) return;
    node.synced = 0;
    node.state = NodeState::failed;
    node.reason = kOutOfMemory;
  });
}

void Graph::get_ready(JobControl& job, JobControl& job_at_leisure) try {
  if (is_one_shot()) return;
  for (const bool are_judges : {false, true})
    for (const StructureNode& node : nodes_)
      if (node.needed && node.state == NodeState::up_to_date && node.synced == run_ &&
          node.structure->is_judge() == are_judges)
        node.structure->get_ready_to_update(are_judges ? job_at_leisure : job);
} catch (const Cancelled&) {
} catch (const std::bad_alloc&) {
}

bool Graph::run(FramePatch& out, JobControl& job) {
  ++run_;
  out.layer_count = 0;
  out.complete = true;
  if (demand_changed_) mark_needed();
  before_.clear();
  is_stopped_ = false;
  keeps_frame_ = false;
  lap_ms();
  TaskQueue tasks;
  try {
    out.layers.reserve(demanded_.size());  // tasks hold references to their patches
    for (const std::size_t i : sources_) {
      job.reset_progress();
      bring_up_to_date(nodes_[i], job);
    }
    follow_extent();
    for (const std::size_t i : needed_) {
      StructureNode& node = nodes_[i];
      if (node.source == nullptr) {
        job.reset_progress();
        bring_up_to_date(node, job);
      }
      if (kForksBesideThreads && node.rebuilt == run_) begin_layers(node, out, tasks, job);
    }
    emit_layers(out, tasks, job);
    if (!keeps_frame_) sent_frame_ = frame_;
    sent_revision_ = samples_->document_revision();
  } catch (const Cancelled&) {
    out.complete = false;
    tasks.drop();
    take_back(out);
  } catch (const std::bad_alloc&) {
    tasks.drop();
    give_up_for_lack_of_memory(out);
  }
  out.frame = sent_frame_;
  out.document_revision = sent_revision_;
  try {
    report(out);
  } catch (const std::bad_alloc&) {
    report_lack_of_memory(out);
  }
  return out.complete;
}

}  // namespace mes
