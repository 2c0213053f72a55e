// SPDX-License-Identifier: GPL-3.0-or-later
// What the drawing shows: which layers, in which order, in which style.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/document/layers_changed.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

/// What it guarantees: `order` is always a permutation of all layers that are not removed, bottom first; changing it, a style or a
/// visibility never asks for geometry by itself: `visible_layers` tells the engine what is wanted, and
/// `demand_revision` grows only when that answer changed. Cost: O(layers). Threads: none.
class LayerStack {
 public:
  /// Takes order, visibility and styles from the descriptors.
  explicit LayerStack(std::span<const LayerDescriptor> descriptors);
  /// Takes the descriptors of a registry that was made from the one before, which still lives. A layer that is gone is a
  /// missing one from now on. One that is new looks as a missing one of its id, or else as its descriptor says, above the
  /// layers that it is above there. Ends solo.
  void set_descriptors(std::span<const LayerDescriptor> descriptors);

  /// Counts indices, also those of layers that were removed. `order` has the layers that are there.
  std::size_t size() const { return descriptors_.size(); }
  /// The descriptor of a layer is at its index.
  std::span<const LayerDescriptor> descriptors() const { return descriptors_; }
  const LayerDescriptor& descriptor(LayerIndex layer) const { return descriptors_[layer]; }
  /// kNoLayer when there is none of this id.
  LayerIndex find(std::string_view id) const;
  /// Bottom first.
  std::span<const LayerIndex> order() const { return order_; }
  bool is_visible(LayerIndex layer) const { return solo_ == kNoLayer ? visible_[layer] : solo_ == layer; }
  /// Visible ones, bottom first.
  std::vector<LayerIndex> visible_layers() const;
  std::uint64_t demand_revision() const { return demand_revision_; }
  /// Grows with every change of what `configuration` gives.
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
  /// Order, visibility and styles as at the beginning.
  void reset();

  const BackgroundImage& image() const { return image_; }
  void set_image(const BackgroundImage& image);

  /// All of it as a value. Solo is a way of looking and not part of it.
  LayerConfiguration configuration() const;
  /// Layers that are not named are hidden, keep their style and go below those that are, in their present order; missing
  /// ones likewise. What is said of layers that are missing here is kept for `configuration`. Ends solo.
  void set_configuration(const LayerConfiguration& configuration);
  /// Changes what the difference names and leaves all else. Ends solo where a visibility changes.
  void apply(const LayersChanged& change);
  /// Layers that a configuration named and that there are not.
  std::size_t missing_count() const { return missing_.size(); }
  void forget_missing();

 private:
  /// A layer that there is not, just above one that there is, or at the bottom (kNoLayer).
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
  std::vector<Missing> missing_;  // bottom first
  LayerIndex solo_ = kNoLayer;
  BackgroundImage image_;
  std::uint64_t demand_revision_ = 0;
  std::uint64_t revision_ = 0;
};

/// The style of a layer for another one. A colour map goes along, but not to a layer without numbers to show by it; the
/// range of the map only to a layer of the same quantity.
LayerStyle style_for(const LayerDescriptor& to, const LayerDescriptor& from, LayerStyle style);

/// Whether a search text picks the layer: every word of it occurs in its name, id or group, whatever the case.
bool matches_search(const LayerDescriptor& descriptor, std::string_view text);

}  // namespace mes
