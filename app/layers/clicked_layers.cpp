// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/clicked_layers.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <span>
#include <string_view>

#include "app/layers/ball_families.h"

namespace mes {
namespace {

constexpr std::array<std::string_view, 1> kOfSamples{"points"};

bool draws(const LayerDescriptor& layer, auto condition) {
  return std::ranges::any_of(layer.kinds, condition);
}

}  // namespace

std::vector<LayerIndex> layers_of_click(const LayerStack& layers, const Clicked& clicked) {
  const auto own = clicked.is_ball ? std::span<const std::string_view>(kOwnBallLayers) : std::span(kOfSamples);
  const std::vector<LayerIndex> visible = layers.visible_layers();
  const auto is_own = [&](LayerIndex layer) {
    return std::ranges::find(own, layers.descriptor(layer).id) != own.end();
  };
  bool is_below = false;
  std::vector<LayerIndex> out;
  for (const LayerIndex layer : std::views::reverse(visible)) {
    if (is_own(layer)) {
      is_below = true;
      continue;
    }
    const bool is_meant = !is_below || draws(layers.descriptor(layer), [&](PrimitiveKind kind) {
      const bool is_area = kind == PrimitiveKind::disk || kind == PrimitiveKind::triangle;
      return clicked.is_on_mark ? kind == PrimitiveKind::point : !is_area;
    });
    if (is_meant) out.push_back(layer);
  }
  return out;
}

}  // namespace mes
