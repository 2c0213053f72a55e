// SPDX-License-Identifier: GPL-3.0-or-later
// The registry knows which structures and layers there are. A graph is made of one, and code that lists, names or draws
// layers reads one.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/document/parameter.h"
#include "core/draw/layer_descriptor.h"
#include "core/graph/layer.h"
#include "core/graph/structure.h"

namespace mes {

struct Evolution;
struct ShapeDescriptor;

/// Things that are known by their ids, in the order in which they were added. Whoever holds one keeps it, also after it
/// has been removed here.
template <class T>
class NamedList {
 public:
  /// Its id must be new.
  void add(std::string id, std::shared_ptr<const T> thing) {
    MES_ASSERT(find(id) == nullptr);
    ids_.push_back(std::move(id));
    things_.push_back(std::move(thing));
  }
  /// False: there is none.
  bool remove(std::string_view id) {
    const auto found = std::ranges::find(ids_, id);
    if (found == ids_.end()) return false;
    things_.erase(things_.begin() + (found - ids_.begin()));
    ids_.erase(found);
    return true;
  }
  /// Null: there is none.
  std::shared_ptr<const T> find(std::string_view id) const {
    const auto found = std::ranges::find(ids_, id);
    return found == ids_.end() ? nullptr : things_[static_cast<std::size_t>(found - ids_.begin())];
  }
  std::span<const std::string> ids() const { return ids_; }
  std::span<const std::shared_ptr<const T>> all() const { return things_; }

 private:
  std::vector<std::string> ids_;
  std::vector<std::shared_ptr<const T>> things_;  // as many as ids
};

/// Smallest use:
///     Registry registry;
///     registry.add_structure<Samples>();
///     registry.add_structure<SettingsSource>();
///     registry.add_layer(make_points_layer);
///     Graph graph(registry);
///
/// Each structure and each layer is made once when it is added, without data, to know its id, what it reads and how it
/// is drawn. Threads: several may read while none adds.
class Registry {
 public:
  using MakeStructure = std::function<std::unique_ptr<Structure>(const StructureSet&)>;
  using MakeLayer = std::function<Layer(const StructureSet&)>;
  using MakeLayers = std::function<std::vector<Layer>(const StructureSet&)>;

  /// A structure whose inputs have been added before. Its id must be new.
  void add_structure(const MakeStructure& make);
  /// A structure whose constructor takes the given inputs.
  template <class S, class... Inputs>
  void add_structure() {
    add_structure([](const StructureSet& set) { return std::make_unique<S>(set.get<Inputs>()...); });
  }
  /// A layer above those that have been added before, over structures that have been. Its id must be new.
  void add_layer(const MakeLayer& make);
  /// Several of them, bottom first.
  void add_layers(const MakeLayers& make);

  /// Evolutions (core/evolutions/evolution.h).
  NamedList<Evolution>& evolutions() { return evolutions_; }
  const NamedList<Evolution>& evolutions() const { return evolutions_; }
  /// Shapes (core/shapes/shape.h).
  NamedList<ShapeDescriptor>& shapes() { return shapes_; }
  const NamedList<ShapeDescriptor>& shapes() const { return shapes_; }

  /// A number that structures read from the settings. Its id must be new.
  void add_parameter(Parameter parameter);

  /// In the order in which they were added.
  std::span<const Parameter> parameters() const { return parameters_; }
  /// Null: there is none with that id. Valid until one is added.
  const Parameter* find_parameter(std::string_view id) const;
  /// Public ids, inputs before consumers.
  std::span<const std::string_view> structures() const { return structure_ids_; }
  /// In default stacking order: first = bottom. A `LayerIndex` is a position here.
  std::span<const LayerDescriptor> layers() const { return layers_; }
  /// The position of a public id, or kNoLayer.
  LayerIndex find_layer(std::string_view id) const;

  /// Every structure, inputs before consumers.
  ///
  /// A variant of a shared set has settings of its own, samples and balls of its own if it has a document, and whatever
  /// depends on these: the others are not made.
  StructureSet make_structures(const StructureSet* shared = nullptr, bool has_document = false) const;
  /// Every layer over the given structures, by position.
  std::vector<Layer> make_layers(const StructureSet& structures) const;

 private:
  struct StructureEntry {
    MakeStructure make;
    std::vector<std::size_t> inputs;  ///< positions
    bool is_of_document = false;      ///< a source that a variant without a document shares
  };

  NamedList<Evolution> evolutions_;
  NamedList<ShapeDescriptor> shapes_;
  std::vector<Parameter> parameters_;
  StructureSet prototypes_;
  std::vector<StructureEntry> structures_;
  std::vector<std::string_view> structure_ids_;
  std::vector<MakeLayers> make_layers_;
  std::vector<LayerDescriptor> layers_;
};

}  // namespace mes
