// SPDX-License-Identifier: GPL-3.0-or-later
// Lists layers under headings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/layers/ball_families.h"

namespace mes {

struct LayerListOptions {
  std::string search{};
  bool only_shown = false;
  bool by_order = false;  ///< in drawing order, top first, without headings
  FamilyKind family = FamilyKind::inner;
  friend bool operator==(const LayerListOptions&, const LayerListOptions&) = default;
};

struct LayerSection {
  std::string title{};                ///< empty: no heading
  std::optional<LayerGroup> group{};  ///< nothing: the shown layers, or all layers
  std::vector<LayerIndex> rows{};     ///< top layer first
  std::size_t shown = 0;              ///< number of visible layers in the group, listed or not
  std::size_t size = 0;
};

struct LayerListing {
  std::vector<LayerSection> sections{};
  std::size_t listed = 0;    ///< number of listed layers, each counted once
  std::size_t left_out = 0;  ///< excluded by the search, or because they are hidden
};

/// Lists by subject: first the shown layers in drawing order, then each group in its own fixed order. One family of
/// balls is listed completely, the others only as far as they are shown. A search finds layers of every family, under
/// their headings.
LayerListing list_layers(const LayerStack& layers, const LayerListOptions& options);

/// The name below the heading of its group: "Inner balls: boundary" becomes "Boundary".
std::string short_name(const LayerDescriptor& descriptor);

}  // namespace mes
