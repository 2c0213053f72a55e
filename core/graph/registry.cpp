// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/registry.h"

#include <algorithm>
#include <utility>

#include "core/graph/source_structure.h"

namespace mes {
namespace {

/// A source that is not of the document, the settings, has a say in it.
bool follows_settings(const Structure& structure) {
  const auto* const source = dynamic_cast<const SourceStructure*>(&structure);
  if (source != nullptr) return !source->is_of_document();
  return std::ranges::any_of(structure.inputs(), [](const Structure* input) { return follows_settings(*input); });
}

}  // namespace

void Registry::add_structure(const MakeStructure& make) {
  std::unique_ptr<Structure> prototype = make(prototypes_);
  MES_ASSERT(std::ranges::find(structure_ids_, prototype->id()) == structure_ids_.end());
  StructureEntry entry{.make = make, .inputs = {}};
  for (const Structure* input : prototype->inputs()) {
    const auto all = prototypes_.all();
    const auto found = std::ranges::find(all, input, &std::unique_ptr<Structure>::get);
    MES_ASSERT(found != all.end());
    entry.inputs.push_back(static_cast<std::size_t>(found - all.begin()));
  }
  if (const auto* const source = dynamic_cast<const SourceStructure*>(prototype.get()))
    entry.is_of_document = source->is_of_document();
  structures_.push_back(std::move(entry));
  structure_ids_.push_back(prototype->id());
  prototypes_.add(std::move(prototype));
}

void Registry::add_parameter(Parameter parameter) {
  MES_ASSERT(find_parameter(parameter.id) == nullptr);
  parameters_.push_back(std::move(parameter));
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

void Registry::add_layers(const MakeLayers& make) {
  for (Layer& layer : make(prototypes_)) {
    MES_ASSERT(find_layer(layer.descriptor.id) == kNoLayer);
    layer.descriptor.follows_settings = std::ranges::any_of(
        layer.structures, [](const Structure* structure) { return follows_settings(*structure); });
    layers_.push_back(std::move(layer.descriptor));
  }
  make_layers_.push_back(make);
}

LayerIndex Registry::find_layer(std::string_view id) const {
  const auto found = std::ranges::find(layers_, id, &LayerDescriptor::id);
  return found == layers_.end() ? kNoLayer : static_cast<LayerIndex>(found - layers_.begin());
}

// A structure all of whose inputs a variant shares is shared, too.
StructureSet Registry::make_structures(const StructureSet* shared, bool has_document) const {
  StructureSet set(shared);
  std::vector<bool> is_own;
  for (const StructureEntry& entry : structures_) {
    const bool follows_own =
        std::ranges::any_of(entry.inputs, [&is_own](std::size_t input) { return is_own[input]; });
    const bool is_source = entry.inputs.empty();
    is_own.push_back(shared == nullptr || (is_source ? !entry.is_of_document || has_document : follows_own));
    if (is_own.back()) set.add(entry.make(set));
  }
  return set;
}

std::vector<Layer> Registry::make_layers(const StructureSet& structures) const {
  std::vector<Layer> out;
  out.reserve(layers_.size());
  for (const MakeLayers& make : make_layers_)
    for (Layer& layer : make(structures)) out.push_back(std::move(layer));
  return out;
}

}  // namespace mes
