// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/leaving_layers.h"

#include <algorithm>
#include <utility>

namespace mes {
namespace {

bool contains(const std::vector<VariantLayer>& layers, VariantLayer layer) {
  return std::ranges::find(layers, layer) != layers.end();
}

}  // namespace

void LeavingLayers::follow(const ShownPanes& shown, const HasPicture& has_picture) {
  if (shown.variants != variants_ || shown.versions != versions_) {
    variants_ = shown.variants;
    versions_ = shown.versions;
    const auto is_of_variant = [](VariantLayer layer) { return layer.variant != kMainVariant; };
    std::erase_if(leaving_, is_of_variant);
    std::erase_if(demand_, is_of_variant);
  }
  const bool brings_more = std::ranges::any_of(
      shown.demand, [&](VariantLayer layer) { return !contains(demand_, layer) && !has_picture(layer); });
  if (brings_more) leaving_.insert(leaving_.end(), demand_.begin(), demand_.end());
  demand_ = shown.demand;
  std::erase_if(leaving_, [this](VariantLayer layer) { return contains(demand_, layer); });
  end_if_complete(has_picture);
}

void LeavingLayers::end_if_complete(const HasPicture& has_picture) {
  if (std::ranges::all_of(demand_, has_picture)) leaving_.clear();
}

bool LeavingLayers::needs(VariantLayer layer) const {
  return contains(demand_, layer) || contains(leaving_, layer);
}

ShownPanes::Layers LeavingLayers::drawn(std::size_t pane, ShownPanes::Layers layers) const {
  if (leaving_.empty() || pane >= last_.size()) return layers;
  // The order is that of the last picture, so that a picture which stays the same is not painted again.
  ShownPanes::Layers out;
  for (const auto& [layer, style] : last_[pane]) {
    const auto now = std::ranges::find(layers, layer, &ShownPanes::Layers::value_type::first);
    if (now != layers.end())
      out.push_back(*now);
    else if (contains(leaving_, layer))
      out.emplace_back(layer, style);
  }
  for (const auto& [layer, style] : layers)
    if (std::ranges::find(out, layer, &ShownPanes::Layers::value_type::first) == out.end())
      out.emplace_back(layer, style);
  return out;
}

const ShownPanes::Layers& LeavingLayers::draw(std::size_t pane, ShownPanes::Layers layers) {
  if (last_.size() <= pane) last_.resize(pane + 1);
  last_[pane] = drawn(pane, std::move(layers));
  return last_[pane];
}

}  // namespace mes
