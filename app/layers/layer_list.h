// SPDX-License-Identifier: GPL-3.0-or-later
// Which layers are listed under which headings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/layers/ball_families.h"

namespace mes {

struct LayerListOptions {
  std::string search{};
  bool only_shown = false;
  bool by_order = false;  ///< as they lie on each other, top first, without headings
  FamilyKind family = FamilyKind::inner;
  friend bool operator==(const LayerListOptions&, const LayerListOptions&) = default;
};

struct LayerSection {
  std::string title{};                ///< empty: no heading
  std::optional<LayerGroup> group{};  ///< nothing: what is shown, or everything
  std::vector<LayerIndex> rows{};     ///< first = top
  std::size_t shown = 0;              ///< of all layers of the group, listed or not
  std::size_t size = 0;
};

struct LayerListing {
  std::vector<LayerSection> sections{};
  std::size_t listed = 0;    ///< layers, each counted once
  std::size_t left_out = 0;  ///< by the search, or because they are not shown
};

/// By subject: what is shown, as it lies on each other, and then each group in an order of its own that nothing
/// changes. Of the families of balls one is listed, and of the others what is shown. A search finds layers of every
/// family, under their headings.
LayerListing list_layers(const LayerStack& layers, const LayerListOptions& options);

/// The name under the heading of its group: "Inner balls: boundary" is "Boundary" there.
std::string short_name(const LayerDescriptor& descriptor);

}  // namespace mes
