// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/empty_view.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "core/base/counted.h"
#include "core/document/document.h"

namespace mes {
namespace {

void show(LayerStack& layers, std::span<const std::string_view> ids) {
  for (const std::string_view id : ids)
    if (const LayerIndex layer = layers.find(id); layer != kNoLayer) layers.set_visible(layer, true);
}

}  // namespace

std::string label_of(ShowInstead what) {
  switch (what) {
    case ShowInstead::samples: return "Show the samples";
    case ShowInstead::own_balls: return "Show my own balls and their axis";
    case ShowInstead::inner_family: return "Show these layers of the inner balls";
    case ShowInstead::own_family: return "Show these layers of my own balls";
  }
  return {};
}

void show_instead(ShowInstead what, LayerStack& layers) {
  switch (what) {
    case ShowInstead::samples: return show(layers, std::array<std::string_view, 1>{"points"});
    case ShowInstead::own_balls:
      show(layers, kOwnBallLayers);
      return show(layers, std::array<std::string_view, 1>{"b-ball-medial-axis"});
    case ShowInstead::inner_family:
      return layers.set_configuration(in_family(layers.descriptors(), layers.configuration(), FamilyKind::inner));
    case ShowInstead::own_family:
      return layers.set_configuration(in_family(layers.descriptors(), layers.configuration(), FamilyKind::own));
  }
}

std::optional<EmptyView> empty_view(const Document& document, const LayerStack& layers,
                                    const std::function<bool(LayerIndex)>& shows) {
  if (document.is_empty()) return std::nullopt;
  std::size_t shown = 0;
  std::size_t of_own_balls = 0;
  std::size_t of_other_balls = 0;
  for (const LayerIndex layer : layers.visible_layers()) {
    const LayerDescriptor& descriptor = layers.descriptor(layer);
    // The picture to trace is not part of the document.
    if (descriptor.kinds.empty()) continue;
    if (shows(layer)) return std::nullopt;
    ++shown;
    if (const auto family = family_of(descriptor)) ++(*family == FamilyKind::own ? of_own_balls : of_other_balls);
  }
  const bool has_samples = document.sample_count() != 0;
  const auto something = has_samples ? ShowInstead::samples : ShowInstead::own_balls;
  if (shown == 0) return EmptyView{"No layer is shown.", something};
  if (!has_samples && of_own_balls < shown)
    return EmptyView{"The layers shown are made of samples. This document has " +
                         counted(document.ball_count(), "ball") + " of your own and no samples.",
                     of_other_balls != 0 ? ShowInstead::own_family : ShowInstead::own_balls};
  if (document.ball_count() == 0 && of_own_balls == shown)
    return EmptyView{"The layers shown are made of your own balls. This document has " +
                         counted(document.sample_count(), "sample") + " and no balls of your own.",
                     ShowInstead::inner_family};
  return EmptyView{
      "The layers shown have nothing to show for these " + std::string(has_samples ? "samples." : "balls."),
      something};
}

}  // namespace mes
