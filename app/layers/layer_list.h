// SPDX-License-Identifier: GPL-3.0-or-later
// Lists layers under headings.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/layers/ball_families.h"

namespace mes {

struct LayerListOptions {
  std::string search{};
  bool only_shown = false;
  bool by_order = false;  ///< in drawing order, top first, without headings
  FamilyKind family = FamilyKind::inner;
  std::vector<std::string> favorites{};  ///< ids, in listing order; of a union, of any family
  friend bool operator==(const LayerListOptions&, const LayerListOptions&) = default;
};

enum class LayerSectionKind : std::uint8_t { order, favorites, shown, topic };

struct LayerSection {
  LayerSectionKind kind = LayerSectionKind::topic;
  std::string title{};                ///< empty: no heading
  bool is_of_union = false;           ///< a topic of the union of the family of the options
  std::vector<LayerIndex> rows{};     ///< the listed layers, from top to bottom
  std::vector<LayerIndex> members{};  ///< all layers of the section, listed or not; of a union, of the family in use
};

struct LayerListing {
  std::vector<LayerSection> sections{};
  std::size_t listed = 0;    ///< number of listed layers, each counted once
  std::size_t left_out = 0;  ///< excluded by the search, or because they are hidden
};

/// Lists by subject: first the favourites, then the shown layers in drawing order, top first, then each topic in its own
/// fixed order. Layers of a union are listed for the family of the options; those of other families are among the
/// shown ones. A search, or a list of the shown ones only, has topics alone. A search finds a layer of a union once: for
/// the family of the options if that matches, otherwise for another one.
LayerListing list_layers(const LayerStack& layers, const LayerListOptions& options);

/// True if the layer is a favourite. Layers that show the same for several families are favourites together.
bool is_favorite(const LayerStack& layers, std::span<const std::string> favorites, LayerIndex layer);
/// Makes it the last favourite, or none.
void toggle_favorite(const LayerStack& layers, std::vector<std::string>& favorites, LayerIndex layer);

/// The name below the heading of its topic: "Inner balls: boundary" becomes "Boundary".
std::string short_name(const LayerDescriptor& descriptor);

}  // namespace mes
