// SPDX-License-Identifier: GPL-3.0-or-later
// The registry lists all structures and layers. Graphs are created from one, and code that lists, names or draws layers
// reads one.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/named_list.h"
#include "core/document/settings/parameter.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/variant.h"
#include "core/graph/structure.h"

namespace mes {

struct Evolution;
struct Format;
struct Layer;
struct ShapeDescriptor;

/// The registry's entry for a structure.
struct StructureSpec {
  std::string id{};
  std::vector<std::string> inputs{};          ///< ids
  std::vector<std::string> parameters{};      ///< ids of the parameters that it reads itself
  std::vector<std::string> all_parameters{};  ///< including those of its direct and indirect inputs
  std::function<std::unique_ptr<Structure>(const StructureSet&)> make{};
  bool is_of_document = false;  ///< a source that variants without a document share
};

/// Smallest use:
///     Registry registry;
///     registry.add_structure<Samples>();
///     registry.add_structure<SettingsSource>();
///     registry.add_layer(make_points_layer);
///     Graph graph(registry);
///
/// Guarantees: a layer keeps its index. After a removal, no layer with another id gets the index, and the layer
/// gets it back when its id is added again. A copy has the same entries at the same indices, and changes independently.
/// So code that adds and removes entries at run time uses a copy, which graphs then follow (`Graph::set_registry`).
///
/// Each structure and each layer is created once when it is added, without data, to learn its id, its inputs and its
/// style; copies and removals create all of them again. After a change that throws, the registry must not be used.
/// Threads: many may read, or one may change it.
class Registry {
 public:
  Registry() = default;
  Registry(const Registry& other);
  Registry(Registry&&) = default;
  Registry& operator=(Registry other) noexcept;
  ~Registry() = default;

  using MakeStructure = decltype(StructureSpec::make);
  using MakeLayer = std::function<Layer(const StructureSet&)>;
  using MakeLayers = std::function<std::vector<Layer>(const StructureSet&)>;

  /// Adds a structure whose inputs have been added before. Its id must be new.
  void add_structure(MakeStructure make);
  /// Adds a structure whose constructor takes the given inputs.
  template <class S, class... Inputs>
  void add_structure() {
    add_structure([](const StructureSet& set) { return std::make_unique<S>(set.get<Inputs>()...); });
  }
  /// Adds a layer on top, or at the index of a removed one with the same id, over structures that have been added.
  void add_layer(const MakeLayer& make);
  /// Adds several layers, bottom first.
  void add_layers(MakeLayers make);

  /// Also removes its dependents: structures, and layers that read one of them together with those added in the same
  /// call. Returns false if there is no such structure.
  bool remove_structure(std::string_view id);
  bool remove_layer(std::string_view id);
  bool remove_parameter(std::string_view id);

  /// Evolutions (core/evolutions/evolution.h).
  NamedList<Evolution>& evolutions() { return evolutions_; }
  const NamedList<Evolution>& evolutions() const { return evolutions_; }
  /// Shapes (core/shapes/shape.h).
  NamedList<ShapeDescriptor>& shapes() { return shapes_; }
  const NamedList<ShapeDescriptor>& shapes() const { return shapes_; }
  /// File formats (core/io/format_spec.h), in the order in which they are tried on contents.
  NamedList<Format>& formats() { return formats_; }
  const NamedList<Format>& formats() const { return formats_; }

  /// Adds a number that structures read from the settings. Its id must be new.
  void add_parameter(Parameter parameter);

  /// In the order of addition.
  std::span<const Parameter> parameters() const { return parameters_; }
  /// Null if the id is unknown. Valid until a parameter is added or removed.
  const Parameter* find_parameter(std::string_view id) const;
  /// Null if the id is unknown. Valid until a structure is added or removed.
  const StructureSpec* find_structure(std::string_view id) const;
  /// Public ids, inputs before consumers.
  std::span<const std::string_view> structures() const { return structure_ids_; }
  /// In default stacking order: first = bottom. A `LayerIndex` is a position here, so removed layers keep their
  /// positions (`LayerDescriptor::is_removed`). Valid until a layer is added or removed.
  std::span<const LayerDescriptor> layers() const { return layers_; }
  /// The position of a public id, or kNoLayer.
  LayerIndex find_layer(std::string_view id) const;
  /// The layer that a variant shows: its own, or that of the main computation if they share it. `has_document` tells
  /// whether the variant has its own samples and balls.
  VariantLayer layer_in(VariantIndex variant, bool has_document, LayerIndex layer) const;

  /// Creates every structure, inputs before consumers.
  ///
  /// A variant of a shared set has its own settings, its own samples and balls if it has a document, and all structures
  /// that depend on these; the others are not created.
  StructureSet make_structures(const StructureSet* shared = nullptr, bool has_document = false) const;
  /// The same, but reuses structures of `kept`, a set of another registry, if specs are equal and inputs are reused.
  StructureSet make_structures(const Registry& other, const StructureSet& kept, const StructureSet* shared,
                               bool has_document) const;
  /// Creates every layer over the given structures, by position; removed ones are empty.
  std::vector<Layer> make_layers(const StructureSet& structures) const;

 private:
  struct LayerEntry {
    MakeLayers make;
    std::vector<LayerIndex> places{};  ///< indices of the layers that it creates; kNoLayer: removed
    std::vector<std::string> reads{};  ///< ids of structures
  };

  void make_prototypes();

  NamedList<Evolution> evolutions_;
  NamedList<ShapeDescriptor> shapes_;
  NamedList<Format> formats_;
  std::vector<Parameter> parameters_;
  StructureSet prototypes_;
  std::vector<std::shared_ptr<const StructureSpec>> structures_;
  std::vector<std::string_view> structure_ids_;
  std::vector<LayerEntry> layer_entries_;
  std::vector<LayerDescriptor> layers_;
};

}  // namespace mes
