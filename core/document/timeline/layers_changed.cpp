// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/timeline/layers_changed.h"

#include <algorithm>

namespace mes {

void append(LayersChanged& first, const LayersChanged& second) {
  for (const LayerConfiguration::Entry& entry : second.changed) {
    const auto known = std::ranges::find(first.changed, entry.layer, &LayerConfiguration::Entry::layer);
    if (known == first.changed.end())
      first.changed.push_back(entry);
    else
      *known = entry;
  }
  if (!second.order.empty()) first.order = second.order;
  if (second.image) first.image = second.image;
}

}  // namespace mes
