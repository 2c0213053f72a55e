// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/layer_list.h"

#include <algorithm>
#include <cctype>
#include <ranges>

namespace mes {
namespace {

bool is_of_another_family(LayerGroup group, FamilyKind family) {
  return std::ranges::any_of(kBallFamilies,
                             [&](FamilyKind other) { return other != family && group_of(other) == group; });
}

/// The layers in drawing order, top first.
LayerSection drawn(const LayerStack& layers, const LayerListOptions& options, bool only_shown) {
  LayerSection out;
  for (const LayerIndex layer : layers.order() | std::views::reverse)
    if ((!only_shown || layers.is_visible(layer)) && matches_search(layers.descriptor(layer), options.search))
      out.rows.push_back(layer);
  out.shown = layers.visible_layers().size();
  out.size = layers.order().size();
  return out;
}

LayerSection section_of(const LayerStack& layers, const LayerListOptions& options, LayerGroup group) {
  LayerSection out{.title = std::string(title_of(group)), .group = group};
  const bool is_hidden_family = options.search.empty() && is_of_another_family(group, options.family);
  for (auto layer = static_cast<LayerIndex>(layers.size()); layer-- > 0;) {
    const LayerDescriptor& descriptor = layers.descriptor(layer);
    if (descriptor.group != group || descriptor.is_removed) continue;
    const bool is_shown = layers.is_visible(layer);
    ++out.size;
    out.shown += is_shown ? 1U : 0U;
    if (((options.only_shown || is_hidden_family) && !is_shown) || !matches_search(descriptor, options.search))
      continue;
    out.rows.push_back(layer);
  }
  return out;
}

}  // namespace

LayerListing list_layers(const LayerStack& layers, const LayerListOptions& options) {
  LayerListing out;
  if (options.by_order) {
    out.sections.push_back(drawn(layers, options, options.only_shown));
    out.listed = out.sections.front().rows.size();
    out.left_out = layers.order().size() - out.listed;
    return out;
  }
  if (options.search.empty() && !options.only_shown) {
    out.sections.push_back(drawn(layers, options, true));
    out.sections.front().title = "Shown";
    if (out.sections.front().rows.empty()) out.sections.clear();
  }
  for (const LayerGroup group : kLayerGroups) {
    LayerSection section = section_of(layers, options, group);
    out.listed += section.rows.size();
    const bool is_filtered = options.only_shown || !options.search.empty();
    if (is_filtered) out.left_out += section.size - section.rows.size();
    if (!section.rows.empty()) out.sections.push_back(std::move(section));
  }
  return out;
}

std::string short_name(const LayerDescriptor& descriptor) {
  std::string out(descriptor.name);
  const std::string prefix = std::string(title_of(descriptor.group)) + ": ";
  if (!out.starts_with(prefix)) return out;
  out.erase(0, prefix.size());
  if (!out.empty()) out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out;
}

}  // namespace mes
