// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/registry.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "core/base/assert.h"
#include "core/graph/layer.h"
#include "core/graph/source_structure.h"

namespace mes {
namespace {

/// Whether it depends on the settings, the only source that does not belong to the document.
bool follows_settings(const Structure& structure) {
  const auto* const source = dynamic_cast<const SourceStructure*>(&structure);
  if (source != nullptr) return !source->is_of_document();
  return std::ranges::any_of(structure.inputs(), [](const Structure* input) { return follows_settings(*input); });
}

bool holds(std::span<const std::string> ids, std::string_view id) {
  return std::ranges::find(ids, id) != ids.end();
}

void add_new(std::vector<std::string>& to, std::span<const std::string> ids) {
  for (const std::string& id : ids)
    if (!holds(to, id)) to.push_back(id);
}

}  // namespace

Registry::Registry(const Registry& other)
    : evolutions_(other.evolutions_),
      shapes_(other.shapes_),
      formats_(other.formats_),
      parameters_(other.parameters_),
      structures_(other.structures_),
      layer_entries_(other.layer_entries_),
      layers_(other.layers_) {
  make_prototypes();
}

Registry& Registry::operator=(Registry other) noexcept {
  std::swap(evolutions_, other.evolutions_);
  std::swap(shapes_, other.shapes_);
  std::swap(formats_, other.formats_);
  std::swap(parameters_, other.parameters_);
  std::swap(prototypes_, other.prototypes_);
  std::swap(structures_, other.structures_);
  std::swap(structure_ids_, other.structure_ids_);
  std::swap(layer_entries_, other.layer_entries_);
  std::swap(layers_, other.layers_);
  return *this;
}

void Registry::make_prototypes() {
  prototypes_ = make_structures();
  structure_ids_.clear();
  for (const auto& spec : structures_) structure_ids_.push_back(spec->id);
}

void Registry::add_structure(MakeStructure make) {
  std::shared_ptr<Structure> prototype = make(prototypes_);
  auto spec = std::make_shared<StructureSpec>(StructureSpec{.id = std::string(prototype->id())});
  MES_ASSERT(find_structure(spec->id) == nullptr);
  for (const std::string_view parameter : prototype->parameters()) spec->parameters.emplace_back(parameter);
  spec->all_parameters = spec->parameters;
  for (const Structure* input : prototype->inputs()) {
    const StructureSpec* const known = find_structure(input->id());
    MES_ASSERT(known != nullptr);
    spec->inputs.push_back(known->id);
    add_new(spec->all_parameters, known->all_parameters);
  }
  spec->make = std::move(make);
  if (const auto* const source = dynamic_cast<const SourceStructure*>(prototype.get()))
    spec->is_of_document = source->is_of_document();
  structures_.push_back(std::move(spec));
  structure_ids_.push_back(structures_.back()->id);
  prototypes_.add(std::move(prototype));
}

const StructureSpec* Registry::find_structure(std::string_view id) const {
  const auto found =
      std::ranges::find(structures_, id, [](const auto& spec) -> std::string_view { return spec->id; });
  return found == structures_.end() ? nullptr : found->get();
}

bool Registry::remove_structure(std::string_view id) {
  if (find_structure(id) == nullptr) return false;
  std::vector<std::string> gone{std::string(id)};
  const auto is_lost = [&gone](std::span<const std::string> read) {
    return std::ranges::any_of(read, [&gone](const std::string& one) { return holds(gone, one); });
  };
  // Inputs are listed before the structures that read them.
  for (const auto& spec : structures_)
    if (is_lost(spec->inputs)) gone.push_back(spec->id);
  std::erase_if(structures_, [&gone](const auto& spec) { return holds(gone, spec->id); });
  std::erase_if(layer_entries_, [&](LayerEntry& entry) {
    const bool is_affected = is_lost(entry.reads);
    for (const LayerIndex place : entry.places)
      if (is_affected && place != kNoLayer) layers_[place].is_removed = true;
    return is_affected;
  });
  make_prototypes();
  return true;
}

void Registry::add_parameter(Parameter parameter) {
  MES_ASSERT(find_parameter(parameter.id) == nullptr);
  parameters_.push_back(std::move(parameter));
}

bool Registry::remove_parameter(std::string_view id) {
  const auto found = std::ranges::find(parameters_, id, &Parameter::id);
  if (found == parameters_.end()) return false;
  parameters_.erase(found);
  return true;
}

const Parameter* Registry::find_parameter(std::string_view id) const {
  const auto found = std::ranges::find(parameters_, id, &Parameter::id);
  return found == parameters_.end() ? nullptr : &*found;
}

void Registry::add_layer(const MakeLayer& make) {
  add_layers([make](const StructureSet& structures) {
    std::vector<Layer> out;
    out.push_back(make(structures));
    return out;
  });
}

void Registry::add_layers(MakeLayers make) {
  LayerEntry entry;
  for (Layer& layer : make(prototypes_)) {
    layer.descriptor.follows_settings = std::ranges::any_of(
        layer.structures, [](const Structure* structure) { return follows_settings(*structure); });
    for (const Structure* structure : layer.structures) {
      entry.reads.emplace_back(structure->id());
      add_new(layer.descriptor.parameters, find_structure(structure->id())->all_parameters);
    }
    const auto place = std::ranges::find(layers_, layer.descriptor.id, &LayerDescriptor::id);
    MES_ASSERT(place == layers_.end() || place->is_removed);
    entry.places.push_back(static_cast<LayerIndex>(place - layers_.begin()));
    if (place == layers_.end())
      layers_.push_back(std::move(layer.descriptor));
    else
      *place = std::move(layer.descriptor);
  }
  entry.make = std::move(make);
  layer_entries_.push_back(std::move(entry));
}

bool Registry::remove_layer(std::string_view id) {
  const LayerIndex layer = find_layer(id);
  if (layer == kNoLayer) return false;
  layers_[layer].is_removed = true;
  for (LayerEntry& entry : layer_entries_) std::ranges::replace(entry.places, layer, kNoLayer);
  std::erase_if(layer_entries_, [](const LayerEntry& entry) {
    return std::ranges::all_of(entry.places, [](LayerIndex place) { return place == kNoLayer; });
  });
  return true;
}

LayerIndex Registry::find_layer(std::string_view id) const {
  return mes::find_layer(layers_, id);
}

VariantLayer Registry::layer_in(VariantIndex variant, bool has_document, LayerIndex layer) const {
  const LayerDescriptor& descriptor = layers_[layer];
  const bool is_shared = has_document ? descriptor.structures.empty() : !descriptor.follows_settings;
  return {is_shared ? kMainVariant : variant, layer};
}

StructureSet Registry::make_structures(const StructureSet* shared, bool has_document) const {
  return make_structures(*this, StructureSet(), shared, has_document);
}

StructureSet Registry::make_structures(const Registry& other, const StructureSet& kept, const StructureSet* shared,
                                       bool has_document) const {
  StructureSet set(shared);
  std::unordered_set<std::string_view> own;
  const auto is_in_place = [&](const Structure* input) {
    return set.holds(*input) || (shared != nullptr && shared->holds(*input));
  };
  for (const auto& spec : structures_) {
    // A structure is shared if the variant shares all of its inputs.
    const bool follows_own = std::ranges::any_of(spec->inputs, [&own](const auto& id) { return own.contains(id); });
    const bool is_source = spec->inputs.empty();
    if (shared != nullptr && !(is_source ? !spec->is_of_document || has_document : follows_own)) continue;
    own.insert(spec->id);
    const auto before =
        std::ranges::find(kept.all(), spec->id, [](const auto& structure) { return structure->id(); });
    const bool is_kept = before != kept.all().end() && other.find_structure(spec->id) == spec.get() &&
                         std::ranges::all_of((*before)->inputs(), is_in_place);
    set.add(is_kept ? *before : std::shared_ptr<Structure>(spec->make(set)));
  }
  return set;
}

std::vector<Layer> Registry::make_layers(const StructureSet& structures) const {
  std::vector<Layer> out(layers_.size());
  for (LayerIndex layer = 0; layer < out.size(); ++layer)
    if (layers_[layer].is_removed) out[layer].descriptor = layers_[layer];
  for (const LayerEntry& entry : layer_entries_) {
    std::vector<Layer> made = entry.make(structures);
    MES_ASSERT(made.size() == entry.places.size());
    for (std::size_t i = 0; i < made.size(); ++i)
      if (entry.places[i] != kNoLayer) out[entry.places[i]] = std::move(made[i]);
  }
  return out;
}

}  // namespace mes
