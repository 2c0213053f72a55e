// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/layer_stack.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/layers/words/synonyms.h"
#include "core/base/assert.h"
#include "core/base/lower_case.h"

namespace mes {
LayerStack::LayerStack(std::span<const LayerDescriptor> descriptors) : descriptors_(descriptors) {
  reset();
}

void LayerStack::reset() {
  order_.clear();
  visible_.clear();
  styles_.clear();
  missing_.clear();
  for (LayerIndex layer = 0; layer < descriptors_.size(); ++layer) {
    if (!descriptors_[layer].is_removed) order_.push_back(layer);
    visible_.push_back(descriptors_[layer].visible_at_start && !descriptors_[layer].is_removed);
    styles_.push_back(descriptors_[layer].style);
  }
  solo_ = kNoLayer;
  image_ = {};
  ++revision_;
  ++demand_revision_;
}

void LayerStack::set_descriptors(std::span<const LayerDescriptor> descriptors) {
  const LayerConfiguration before = configuration();
  descriptors_ = descriptors;
  reset();
  set_configuration(before);
  std::vector<LayerIndex> by_index = order_;
  std::ranges::sort(by_index);
  for (auto layer = by_index.begin(); layer != by_index.end(); ++layer) {
    const bool was_named = std::ranges::find(before.layers, descriptors_[*layer].id,
                                             &LayerConfiguration::Entry::layer) != before.layers.end();
    if (was_named) continue;
    visible_[*layer] = descriptors_[*layer].visible_at_start;
    std::erase(order_, *layer);
    const auto below = layer == by_index.begin() ? order_.begin() : std::ranges::find(order_, *std::prev(layer)) + 1;
    order_.insert(below, *layer);
  }
}

LayerConfiguration LayerStack::configuration() const {
  LayerConfiguration out;
  const auto add_missing = [&](LayerIndex above) {
    for (const Missing& missing : missing_)
      if (missing.above == above) out.layers.push_back(missing.entry);
  };
  add_missing(kNoLayer);
  for (const LayerIndex layer : order_) {
    out.layers.push_back({std::string(descriptors_[layer].id), visible_[layer], styles_[layer]});
    add_missing(layer);
  }
  out.image = image_;
  return out;
}

void LayerStack::set_configuration(const LayerConfiguration& configuration) {
  std::vector<bool> is_named(descriptors_.size(), false);
  std::vector<LayerIndex> named;
  const std::vector<LayerIndex> before = visible_layers();
  std::vector<Missing> missing = std::exchange(missing_, {});
  for (const LayerConfiguration::Entry& entry : configuration.layers) {
    const LayerIndex layer = find(entry.layer);
    if (layer == kNoLayer) {
      std::erase_if(missing, [&entry](const Missing& other) { return other.entry.layer == entry.layer; });
      add_missing(entry, named.empty() ? kNoLayer : named.back());
      continue;
    }
    if (is_named[layer]) continue;
    is_named[layer] = true;
    named.push_back(layer);
    visible_[layer] = entry.visible;
    styles_[layer] = entry.style;
  }
  for (Missing& other : missing) {
    other.entry.visible = false;
    add_missing(std::move(other.entry), kNoLayer);
  }
  std::vector<LayerIndex> order;
  for (const LayerIndex layer : order_) {
    if (is_named[layer]) continue;
    order.push_back(layer);
    visible_[layer] = false;
  }
  order.insert(order.end(), named.begin(), named.end());
  order_ = std::move(order);
  solo_ = kNoLayer;
  image_ = configuration.image;
  ++revision_;
  if (visible_layers() != before) ++demand_revision_;
}

// Ignores layers beyond the maximum, because a file that named them could not be read again.
void LayerStack::add_missing(LayerConfiguration::Entry entry, LayerIndex above) {
  if (missing_.size() < kMostMissing) missing_.push_back({std::move(entry), above});
}

void LayerStack::forget_missing() {
  if (missing_.empty()) return;
  missing_.clear();
  ++revision_;
}

LayerIndex LayerStack::find(std::string_view id) const {
  return find_layer(descriptors_, id);
}

void LayerStack::apply(const LayersChanged& change) {
  for (const LayerConfiguration::Entry& entry : change.changed) {
    const LayerIndex layer = find(entry.layer);
    if (layer == kNoLayer) {
      const auto known = std::ranges::find(missing_, entry.layer, [](const Missing& one) { return one.entry.layer; });
      if (known == missing_.end())
        add_missing(entry, order_.empty() ? kNoLayer : order_.back());
      else
        known->entry = entry;
      ++revision_;
      continue;
    }
    if (visible_[layer] != entry.visible) set_visible(layer, entry.visible);
    set_style(layer, entry.style);
  }
  if (!change.order.empty()) restack(change.order);
  if (change.image) set_image(*change.image);
}

// Layers that are not named stay below, in their order. Missing layers that are not named are dropped.
void LayerStack::restack(std::span<const std::string> order) {
  std::vector<LayerIndex> rest = order_;
  std::vector<LayerIndex> named;
  std::vector<Missing> missing;
  for (const std::string& id : order) {
    const LayerIndex layer = find(id);
    if (layer != kNoLayer) {
      if (std::erase(rest, layer) == 1) named.push_back(layer);
      continue;
    }
    const auto known = std::ranges::find(missing_, id, [](const Missing& one) { return one.entry.layer; });
    if (known != missing_.end()) missing.push_back({known->entry, named.empty() ? kNoLayer : named.back()});
  }
  ++revision_;
  missing_ = std::move(missing);
  rest.insert(rest.end(), named.begin(), named.end());
  order_ = std::move(rest);
}

std::vector<LayerIndex> LayerStack::visible_layers() const {
  std::vector<LayerIndex> out;
  for (const LayerIndex layer : order_)
    if (is_visible(layer)) out.push_back(layer);
  return out;
}

void LayerStack::set_visible(LayerIndex layer, bool visible) {
  if (solo_ == kNoLayer && visible_[layer] == visible) return;
  solo_ = kNoLayer;
  visible_[layer] = visible;
  ++revision_;
  ++demand_revision_;
}

void LayerStack::solo(LayerIndex layer) {
  if (solo_ == layer) return;
  solo_ = layer;
  ++demand_revision_;
}

void LayerStack::end_solo() {
  if (solo_ == kNoLayer) return;
  solo_ = kNoLayer;
  ++demand_revision_;
}

void LayerStack::move(LayerIndex layer, LayerIndex target, bool above) {
  if (layer == target) return;
  const auto from = std::ranges::find(order_, layer);
  MES_ASSERT(from != order_.end());
  order_.erase(from);
  auto to = std::ranges::find(order_, target);
  MES_ASSERT(to != order_.end());
  order_.insert(above ? to + 1 : to, layer);
  ++revision_;
}

void LayerStack::set_style(LayerIndex layer, const LayerStyle& style) {
  if (styles_[layer] == style) return;
  styles_[layer] = style;
  ++revision_;
}

void LayerStack::set_image(const BackgroundImage& image) {
  if (image_ == image) return;
  image_ = image;
  ++revision_;
}

LayerStyle style_for(const LayerDescriptor& to, const LayerDescriptor& from, LayerStyle style) {
  if (to.scalar.empty()) style.color_map.clear();
  if (to.scalar != from.scalar) {
    const LayerStyle unlocked;
    style.range_locked = unlocked.range_locked;
    style.range_low = unlocked.range_low;
    style.range_high = unlocked.range_high;
  }
  return style;
}

bool matches_search(const LayerDescriptor& descriptor, std::string_view text) {
  constexpr std::size_t kLettersOfTooltip = 3;
  const std::string haystack =
      lower_case(descriptor.name) + ' ' + lower_case(descriptor.id) + ' ' + lower_case(title_of(descriptor.group));
  const std::string synonyms = ' ' + std::string(synonyms_of(descriptor.id));
  const std::string tooltip = ' ' + lower_case(descriptor.tooltip);
  const std::string needle = lower_case(text);
  std::size_t begin = 0;
  while (begin < needle.size()) {
    const std::size_t end = std::min(needle.find(' ', begin), needle.size());
    const std::string word = needle.substr(begin, end - begin);
    begin = end + 1;
    if (word.empty() || haystack.find(word) != std::string::npos) continue;
    const std::string beginning = ' ' + word;
    if (synonyms.find(beginning) != std::string::npos) continue;
    if (word.size() < kLettersOfTooltip || tooltip.find(beginning) == std::string::npos) return false;
  }
  return true;
}

}  // namespace mes
