// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the drawing: their visibility, order and styles.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/document/timeline/layers_changed.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

/// Guarantees: `order` is always a permutation of all layers that are not removed, bottom first. Changing it, a style
/// or a visibility never requests geometry by itself: `visible_layers` tells the engine what is needed, and
/// `demand_revision` grows only if that answer changed. Cost: O(layers). Threads: none.
class LayerStack {
 public:
  /// Takes order, visibility and styles from the descriptors.
  explicit LayerStack(std::span<const LayerDescriptor> descriptors);
  /// Takes the descriptors of a registry that was made from the previous one, which must still exist. A removed layer
  /// becomes a missing one. A new layer looks like the missing one of its id, or else as its descriptor says, and is
  /// placed above the layers that it is above there. Ends solo.
  void set_descriptors(std::span<const LayerDescriptor> descriptors);

  /// The number of indices, including those of removed layers. `order` has only the existing ones.
  std::size_t size() const { return descriptors_.size(); }
  /// Descriptors by layer index.
  std::span<const LayerDescriptor> descriptors() const { return descriptors_; }
  const LayerDescriptor& descriptor(LayerIndex layer) const { return descriptors_[layer]; }
  /// kNoLayer if no layer has this id.
  LayerIndex find(std::string_view id) const;
  /// The layers from bottom to top.
  std::span<const LayerIndex> order() const { return order_; }
  bool is_visible(LayerIndex layer) const { return solo_ == kNoLayer ? visible_[layer] : solo_ == layer; }
  /// The visible layers from bottom to top.
  std::vector<LayerIndex> visible_layers() const;
  std::uint64_t demand_revision() const { return demand_revision_; }
  /// Grows with every change of the value of `configuration`.
  std::uint64_t revision() const { return revision_; }

  void set_visible(LayerIndex layer, bool visible);
  /// Shows this layer alone until `end_solo`, or until any visibility is set; the visibilities are kept.
  void solo(LayerIndex layer);
  void end_solo();
  LayerIndex soloed() const { return solo_; }

  /// Moves a layer to just above (`above`) or just below another one.
  void move(LayerIndex layer, LayerIndex target, bool above);

  const LayerStyle& style(LayerIndex layer) const { return styles_[layer]; }
  void set_style(LayerIndex layer, const LayerStyle& style);
  void reset_style(LayerIndex layer) { set_style(layer, descriptors_[layer].style); }
  bool has_default_style(LayerIndex layer) const { return styles_[layer] == descriptors_[layer].style; }
  /// Restores the initial order, visibility and styles.
  void reset();

  const BackgroundImage& image() const { return image_; }
  void set_image(const BackgroundImage& image);

  /// All settings as a value. Solo is only a way of viewing and not included.
  LayerConfiguration configuration() const;
  /// Layers that are not named are hidden, keep their style and move below the named ones, in their present order; so
  /// do missing ones. Entries for layers missing here are kept for `configuration`. Ends solo.
  void set_configuration(const LayerConfiguration& configuration);
  /// Changes what the difference names and leaves the rest. Ends solo if a visibility changes.
  void apply(const LayersChanged& change);
  /// Number of layers that a configuration named and that do not exist here.
  std::size_t missing_count() const { return missing_.size(); }
  void forget_missing();

 private:
  /// A layer that does not exist here, positioned just above an existing one, or at the bottom (kNoLayer).
  struct Missing {
    LayerConfiguration::Entry entry;
    LayerIndex above = kNoLayer;
  };
  static constexpr std::size_t kMostMissing = 1000;
  void add_missing(LayerConfiguration::Entry entry, LayerIndex above);
  void restack(std::span<const std::string> order);

  std::span<const LayerDescriptor> descriptors_;
  std::vector<LayerIndex> order_;
  std::vector<bool> visible_;
  std::vector<LayerStyle> styles_;
  std::vector<Missing> missing_;  // from bottom to top
  LayerIndex solo_ = kNoLayer;
  BackgroundImage image_;
  std::uint64_t demand_revision_ = 0;
  std::uint64_t revision_ = 0;
};

/// Transfers the style of a layer to another one. A colour map is kept only if the other layer has numbers to show by
/// it, and the range of the map only if its quantity is the same.
LayerStyle style_for(const LayerDescriptor& to, const LayerDescriptor& from, LayerStyle style);

/// True if a search text matches the layer: every word occurs in its name, id or group, or begins a word of its
/// synonyms, or, from three letters on, of its tooltip, whatever the case.
bool matches_search(const LayerDescriptor& descriptor, std::string_view text);

}  // namespace mes
