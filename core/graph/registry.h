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

#include "core/base/named_list.h"
#include "core/document/parameter.h"
#include "core/draw/layer_descriptor.h"
#include "core/graph/layer.h"
#include "core/graph/structure.h"

namespace mes {

struct Evolution;
struct Format;
struct ShapeDescriptor;

/// What a registry knows of a structure.
struct StructureSpec {
  std::string id{};
  std::vector<std::string> inputs{};          ///< ids
  std::vector<std::string> parameters{};      ///< ids of those that it reads itself
  std::vector<std::string> all_parameters{};  ///< with those of all that it is computed from
  std::function<std::unique_ptr<Structure>(const StructureSet&)> make{};
  bool is_of_document = false;  ///< a source that a variant without a document shares
};

/// Smallest use:
///     Registry registry;
///     registry.add_structure<Samples>();
///     registry.add_structure<SettingsSource>();
///     registry.add_layer(make_points_layer);
///     Graph graph(registry);
///
/// What it guarantees: a layer keeps its index. It is not given to a layer of another id after a removal, and the layer
/// has it again when its id is added again. A copy has the same things at the same indices, and changes by itself. So
/// what grows and shrinks while the program runs is a copy, which graphs then follow (`Graph::set_registry`).
///
/// Each structure and each layer is made once when it is added, without data, to know its id, what it reads and how it
/// is drawn; copies and removals make all again. A change that throws ends its use. Threads: many read or one changes.
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

  /// A structure whose inputs have been added before. Its id must be new.
  void add_structure(MakeStructure make);
  /// A structure whose constructor takes the given inputs.
  template <class S, class... Inputs>
  void add_structure() {
    add_structure([](const StructureSet& set) { return std::make_unique<S>(set.get<Inputs>()...); });
  }
  /// A layer above all others, or at the place of a removed one of its id, over structures that have been added.
  void add_layer(const MakeLayer& make);
  /// Several of them, bottom first.
  void add_layers(MakeLayers make);

  /// With it goes what is computed from it: structures, and layers that read one of them together with those that were
  /// added in the same call. False: there is none.
  bool remove_structure(std::string_view id);
  bool remove_layer(std::string_view id);
  bool remove_parameter(std::string_view id);

  /// Evolutions (core/evolutions/evolution.h).
  NamedList<Evolution>& evolutions() { return evolutions_; }
  const NamedList<Evolution>& evolutions() const { return evolutions_; }
  /// Shapes (core/shapes/shape.h).
  NamedList<ShapeDescriptor>& shapes() { return shapes_; }
  const NamedList<ShapeDescriptor>& shapes() const { return shapes_; }
  /// File formats (core/io/format_spec.h), in the order in which contents are tried.
  NamedList<Format>& formats() { return formats_; }
  const NamedList<Format>& formats() const { return formats_; }

  /// A number that structures read from the settings. Its id must be new.
  void add_parameter(Parameter parameter);

  /// In the order in which they were added.
  std::span<const Parameter> parameters() const { return parameters_; }
  /// Null: there is none with that id. Valid until one is added or removed.
  const Parameter* find_parameter(std::string_view id) const;
  /// Null: there is none with that id. Valid until one is added or removed.
  const StructureSpec* find_structure(std::string_view id) const;
  /// Public ids, inputs before consumers.
  std::span<const std::string_view> structures() const { return structure_ids_; }
  /// In default stacking order: first = bottom. A `LayerIndex` is a position here, so that places of layers that were
  /// removed are among them (`LayerDescriptor::is_removed`). Valid until one is added or removed.
  std::span<const LayerDescriptor> layers() const { return layers_; }
  /// The position of a public id, or kNoLayer.
  LayerIndex find_layer(std::string_view id) const;
  /// The layer that a variant shows: its own, or that of the main computation where they share it. `has_document` says
  /// that the variant has samples and balls of its own.
  VariantLayer layer_in(VariantIndex variant, bool has_document, LayerIndex layer) const;

  /// Every structure, inputs before consumers.
  ///
  /// A variant of a shared set has settings of its own, samples and balls of its own if it has a document, and whatever
  /// depends on these: the others are not made.
  StructureSet make_structures(const StructureSet* shared = nullptr, bool has_document = false) const;
  /// The same, where a set of another registry is at hand: structures of equal specs and kept inputs are those of `kept`.
  StructureSet make_structures(const Registry& other, const StructureSet& kept, const StructureSet* shared,
                               bool has_document) const;
  /// Every layer over the given structures, by position; nothing at the places of those that were removed.
  std::vector<Layer> make_layers(const StructureSet& structures) const;

 private:
  struct LayerEntry {
    MakeLayers make;
    std::vector<LayerIndex> places{};  ///< of what it makes; kNoLayer: removed
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
