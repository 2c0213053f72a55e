// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/layer_list.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <ranges>
#include <utility>

#include "app/layers/layer_topics.h"

namespace mes {
namespace {

bool is_of_another_family(const LayerDescriptor& descriptor, FamilyKind family) {
  return family_of(descriptor).value_or(family) != family;
}

bool shows_the_same(const LayerDescriptor& a, const LayerDescriptor& b) {
  return family_of(a) && family_of(b) && !a.of_any_family.empty() && a.of_any_family == b.of_any_family;
}

/// The layers in drawing order, top first.
LayerSection drawn(const LayerStack& layers, const LayerListOptions& options, bool only_shown) {
  LayerSection out{.kind = only_shown ? LayerSectionKind::shown : LayerSectionKind::order};
  for (const LayerIndex layer : layers.order() | std::views::reverse)
    if ((!only_shown || layers.is_visible(layer)) && matches_search(layers.descriptor(layer), options.search))
      out.rows.push_back(layer);
  return out;
}

LayerSection favorites_of(const LayerStack& layers, const LayerListOptions& options) {
  LayerSection out{.kind = LayerSectionKind::favorites, .title = "Favourites"};
  for (const std::string& id : options.favorites) {
    const LayerIndex layer = layers.find(id);
    if (layer == kNoLayer) continue;
    const LayerDescriptor& descriptor = layers.descriptor(layer);
    const LayerDescriptor* const same =
        family_of(descriptor) ? counterpart_of(layers.descriptors(), descriptor, options.family) : nullptr;
    out.rows.push_back(same == nullptr ? layer : layers.find(same->id));
  }
  out.members = out.rows;
  return out;
}

/// The topics with their members, in listing order.
std::vector<LayerSection> topics_of(const LayerStack& layers, FamilyKind family) {
  std::vector<LayerSection> out;
  for (const LayerTopic& topic : layer_topics())
    out.push_back({.title = std::string(topic.title), .is_of_union = topic.is_of_union});
  // In one place of a list the topmost layer is first, and the family of the options before the others.
  std::vector<std::pair<TopicPlace, LayerIndex>> places;
  for (auto layer = static_cast<LayerIndex>(layers.size()); layer-- > 0;)
    if (!layers.descriptor(layer).is_removed) places.emplace_back(topic_place_of(layers.descriptor(layer)), layer);
  const auto key = [&](const std::pair<TopicPlace, LayerIndex>& place) {
    return std::pair(place.first, is_of_another_family(layers.descriptor(place.second), family));
  };
  std::ranges::stable_sort(places, {}, key);
  for (const auto& [place, layer] : places) out[place.topic].members.push_back(layer);
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
  const bool is_filtered = options.only_shown || !options.search.empty();
  if (!is_filtered) {
    out.sections.push_back(favorites_of(layers, options));
    out.sections.push_back(drawn(layers, options, true));
    out.sections.back().title = "Shown";
    out.sections.back().members = out.sections.back().rows;
  }
  for (LayerSection& section : topics_of(layers, options.family)) {
    const LayerDescriptor* last = nullptr;
    for (const LayerIndex layer : section.members) {
      const LayerDescriptor& descriptor = layers.descriptor(layer);
      const bool is_another = is_of_another_family(descriptor, options.family);
      const bool is_listed_already = is_another && last != nullptr && shows_the_same(*last, descriptor);
      if (options.only_shown ? !layers.is_visible(layer) : is_another && (!is_filtered || is_listed_already))
        continue;
      if (!matches_search(descriptor, options.search)) continue;
      section.rows.push_back(layer);
      last = &descriptor;
    }
    out.listed += section.rows.size();
    std::erase_if(section.members,
                  [&](LayerIndex layer) { return is_of_another_family(layers.descriptor(layer), options.family); });
    if (!section.rows.empty()) out.sections.push_back(std::move(section));
  }
  if (is_filtered) out.left_out = layers.order().size() - out.listed;
  std::erase_if(out.sections, [](const LayerSection& section) { return section.rows.empty(); });
  return out;
}

bool is_favorite(const LayerStack& layers, std::span<const std::string> favorites, LayerIndex layer) {
  const LayerDescriptor& descriptor = layers.descriptor(layer);
  return std::ranges::any_of(favorites, [&](const std::string& id) {
    if (id == descriptor.id) return true;
    const LayerIndex other = layers.find(id);
    return other != kNoLayer && shows_the_same(layers.descriptor(other), descriptor);
  });
}

void toggle_favorite(const LayerStack& layers, std::vector<std::string>& favorites, LayerIndex layer) {
  const bool was_favorite = is_favorite(layers, favorites, layer);
  const LayerDescriptor& descriptor = layers.descriptor(layer);
  if (!was_favorite) return favorites.push_back(descriptor.id);
  std::erase_if(favorites, [&](const std::string& id) { return is_favorite(layers, {&id, 1}, layer); });
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
