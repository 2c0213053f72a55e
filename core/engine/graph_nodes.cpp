// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of the graph: creates them from a registry, for each variant, and follows changes of both.
#include <algorithm>
#include <atomic>
#include <iterator>
#include <new>
#include <utility>

#include "core/engine/graph.h"

namespace mes {
namespace {

std::uint64_t next_origin() {
  static std::atomic<std::uint64_t> count = 0;
  return ++count;
}

}  // namespace

Graph::Graph(const Registry& registry) : registry_(&registry) {
  add(std::make_unique<Variant>(Variant{.structures = registry.make_structures()}));
  samples_ = &structures().get<Samples>();
}

Graph::Graph(const Registry& registry, const Graph& before)
    : registry_(&registry), samples_(before.samples_), take_(before.take_), needs_scalars_(before.needs_scalars_) {
  for (const auto& old : before.variants_) {
    const StructureSet* const shared = variants_.empty() ? nullptr : &structures();
    add(std::make_unique<Variant>(
        Variant{.structures = registry.make_structures(*before.registry_, old->structures, shared, old->has_document),
                .has_document = old->has_document}));
  }
  // A new source would miss everything that was posted to the old one.
  for (const StructureNode& old : before.nodes_)
    MES_ASSERT(old.source == nullptr || variants_[old.variant]->structures.holds(*old.structure));
  for (StructureNode& node : nodes_) {
    const auto same = std::ranges::find_if(before.nodes_, [&node](const StructureNode& old) {
      return old.variant == node.variant && old.structure->id() == node.structure->id();
    });
    if (same == before.nodes_.end()) continue;
    node.needed_itself = same->needed_itself;
    if (same->structure != node.structure) continue;
    StructureNode kept = *same;
    kept.inputs = std::move(node.inputs);
    kept.settings = node.settings;
    kept.completes = std::move(node.completes);
    node = std::move(kept);
  }
  before.for_each_layer([this](VariantLayer layer, const LayerNode& old) {
    if (find(layer) == nullptr) return;
    LayerNode& node = node_of(layer);
    node.demanded = old.demanded && (layer.variant == kMainVariant || !node.structures.empty());
    node.sent = old.sent && node.demanded;
    node.earlier_kinds = old.earlier_kinds;
    node.earlier_kinds.insert(node.earlier_kinds.end(), old.layer.descriptor.kinds.begin(),
                              old.layer.descriptor.kinds.end());
    std::erase_if(node.earlier_kinds, [&kinds = node.layer.descriptor.kinds](PrimitiveKind kind) {
      return std::ranges::find(kinds, kind) != kinds.end();
    });
  });
}

void Graph::set_registry(const Registry& registry) {
  Graph next(registry, *this);
  registry_ = &registry;
  origin_ = next.origin_;
  nodes_.swap(next.nodes_);
  variants_.swap(next.variants_);
  sources_.swap(next.sources_);
  needed_.swap(next.needed_);
  demanded_.swap(next.demanded_);
  demand_changed_ = true;
}

void Graph::make_one_shot(InstanceTaker take, bool needs_scalars) {
  MES_ASSERT(run_ == 0);
  take_ = std::move(take);
  needs_scalars_ = needs_scalars;
  for (const StructureNode& node : nodes_) node.structure->forgo_updates();
}

void Graph::add(std::unique_ptr<Variant> added) {
  const auto index = static_cast<VariantIndex>(variants_.size());
  added->first_node = nodes_.size();
  Variant& variant = *variants_.emplace_back(std::move(added));
  const auto position_of = [this](const Structure* structure) {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].structure == structure) return i;
    assertion_failed("a structure is listed after its inputs", __FILE_NAME__, __LINE__);
  };
  for (const auto& structure : variant.structures.all()) {
    StructureNode node;
    node.structure = structure.get();
    node.variant = index;
    node.source = dynamic_cast<SourceStructure*>(structure.get());
    if (is_one_shot()) structure->forgo_updates();
    for (const Structure* input : structure->inputs()) {
      node.inputs.push_back(position_of(input));
      if (dynamic_cast<const SettingsSource*>(input) != nullptr) node.settings = node.inputs.back();
    }
    nodes_.push_back(std::move(node));
  }
  for (Layer& layer : registry_->make_layers(variant.structures)) {
    LayerNode node;
    const bool is_shared =
        index != kMainVariant && std::ranges::none_of(layer.structures, [&](const Structure* structure) {
          return variant.structures.holds(*structure);
        });
    if (is_shared) {
      layer.parts.clear();
    } else {
      std::ranges::transform(layer.structures, std::back_inserter(node.structures), position_of);
      // Sources are brought up to date before all other structures.
      const auto turn = [this](std::size_t position) {
        return std::pair(nodes_[position].source == nullptr, position);
      };
      const auto last = std::ranges::max_element(node.structures, {}, turn);
      if (last != node.structures.end())
        nodes_[*last].completes.emplace_back(index, static_cast<LayerIndex>(variant.layers.size()));
    }
    node.layer = std::move(layer);
    variant.layers.push_back(std::move(node));
  }
  // Reserved here, because a run could not handle a lack of memory.
  sources_.reserve(nodes_.size());
  needed_.reserve(nodes_.size());
  demanded_.reserve(variants_.size() * variant.layers.size());
  demand_changed_ = true;
  origin_ = next_origin();
}

void Graph::drop_variants(std::size_t kept) {
  if (kept == variants_.size()) return;
  const std::size_t nodes = variants_[kept]->first_node;
  nodes_.resize(nodes);
  for (StructureNode& node : nodes_)
    std::erase_if(node.completes, [kept](VariantLayer layer) { return layer.variant >= kept; });
  variants_.resize(kept);
  demand_changed_ = true;
  origin_ = next_origin();
}

const Graph::LayerNode* Graph::find(VariantLayer layer) const {
  if (layer.variant >= variants_.size() || layer.layer >= variants_[layer.variant]->layers.size()) return nullptr;
  const LayerNode& node = variants_[layer.variant]->layers[layer.layer];
  return node.layer.descriptor.is_removed ? nullptr : &node;
}

void Graph::set_variants(std::span<const VariantRequest> wanted) try {
  std::size_t kept = 1;
  while (kept < variants_.size() && kept <= wanted.size() &&
         variants_[kept]->has_document == wanted[kept - 1].has_document)
    ++kept;
  drop_variants(kept);
  while (variants_.size() <= wanted.size()) {
    const bool has_document = wanted[variants_.size() - 1].has_document;
    add(std::make_unique<Variant>(Variant{.structures = registry_->make_structures(&structures(), has_document),
                                          .has_document = has_document}));
  }
  for (std::size_t i = 0; i < wanted.size(); ++i)
    variants_[i + 1]->structures.get<SettingsSource>().post(wanted[i].settings);
} catch (const std::bad_alloc&) {
  drop_variants(1);
}

}  // namespace mes
