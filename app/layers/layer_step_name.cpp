// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/layer_step_name.h"

#include <fmt/core.h>
#include <algorithm>

namespace mes {
namespace {

using Entry = LayerConfiguration::Entry;

std::string name_of(const LayerStack& layers, const std::string& id) {
  const LayerIndex layer = layers.find(id);
  return layer == kNoLayer ? id : std::string(layers.descriptor(layer).name);
}

// The one layer whose removal makes both orders equal; empty if there is none.
std::string moved_layer(const std::vector<std::string>& before, const std::vector<std::string>& after) {
  const auto [old, fresh] = std::ranges::mismatch(before, after);
  if (old == before.end() || fresh == after.end()) return {};
  for (const std::string& candidate : {*old, *fresh}) {
    std::vector<std::string> a = before;
    std::vector<std::string> b = after;
    std::erase(a, candidate);
    std::erase(b, candidate);
    if (a == b) return candidate;
  }
  return {};
}

std::string name_of_picture_change(const BackgroundImage& before, const BackgroundImage& after) {
  if (after.file.empty()) return "Remove the picture";
  if (before.file.empty()) return "Picture underneath";
  return before.file == after.file ? "Place the picture" : "Replace the picture";
}

std::string name_of_style_change(const std::string& layer, LayerStyle before, const LayerStyle& after) {
  before.color_map = after.color_map;
  before.range_locked = after.range_locked;
  before.range_low = after.range_low;
  before.range_high = after.range_high;
  return (before == after ? "Colour map of " : "Style of ") + layer;
}

std::string name_of_entries(const LayerStack& layers, const LayersChanged& before, const LayersChanged& after) {
  const auto old_of = [&](const Entry& entry) {
    return std::ranges::find(before.changed, entry.layer, &Entry::layer);
  };
  const auto is_only_visibility = [&](const Entry& entry) {
    const auto old = old_of(entry);
    return old != before.changed.end() && old->style == entry.style;
  };
  const Entry& first = after.changed.front();
  if (std::ranges::all_of(after.changed, is_only_visibility) &&
      std::ranges::all_of(after.changed, [&](const Entry& entry) { return entry.visible == first.visible; })) {
    const std::string verb = first.visible ? "Show " : "Hide ";
    return verb + (after.changed.size() == 1 ? name_of(layers, first.layer)
                                             : fmt::format("{} layers", after.changed.size()));
  }
  const auto old = old_of(first);
  if (after.changed.size() == 1 && old != before.changed.end() && old->visible == first.visible)
    return name_of_style_change(name_of(layers, first.layer), old->style, first.style);
  return "Change layers";
}

}  // namespace

std::string name_of_change(const LayerStack& layers, const LayersChanged& before, const LayersChanged& after) {
  const bool is_of_picture = std::ranges::all_of(after.changed, [&](const Entry& entry) {
    const LayerIndex layer = layers.find(entry.layer);
    return layer != kNoLayer && layers.descriptor(layer).kinds.empty();
  });
  if (before.image && after.image && after.order.empty() && is_of_picture)
    return name_of_picture_change(*before.image, *after.image);
  if (after.image || (!after.order.empty() && !after.changed.empty())) return "Change layers";
  if (after.order.empty()) return name_of_entries(layers, before, after);
  const std::string moved = moved_layer(before.order, after.order);
  return moved.empty() ? "Restack layers" : "Restack " + name_of(layers, moved);
}

}  // namespace mes
