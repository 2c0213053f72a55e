// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/evolution_layers.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "app/layers/ball_families.h"
#include "core/document/document.h"

namespace mes {
namespace {

/// The family whose balls the evolution scales; nothing if it moves samples.
std::optional<FamilyKind> family_of(const Evolution& evolution) {
  const ParameterMove* const move = evolution.moved_parameter();
  if (move == nullptr) return std::nullopt;
  if (move->parameter == Parameter::a_scale) return FamilyKind::inner;
  if (move->parameter == Parameter::p_scale) return FamilyKind::polar;
  if (move->parameter == Parameter::b_scale) return FamilyKind::own;
  return std::nullopt;
}

/// True if it scales the balls along the axis, from which the scale axis is made.
bool is_of_scale_axis(const Evolution& evolution) {
  const ParameterMove* const move = evolution.moved_parameter();
  return move != nullptr && move->parameter == Parameter::scale_axis_factor;
}

bool is_skeleton(const Evolution& evolution) {
  const ParameterMove* const move = evolution.moved_parameter();
  return move != nullptr && move->renews_balls;
}

constexpr std::array<std::string_view, 4> kScaled{"scale-union", "a-scale-union", "p-scale-union", "b-scale-union"};

/// True if the layer shows the result of such an evolution.
bool is_of_skeleton(const LayerDescriptor& layer) {
  return std::ranges::find(layer.parameters, Parameter::scale_skeleton_step.id) != layer.parameters.end();
}
bool is_of_scale_axis(const LayerDescriptor& layer) {
  return is_of_skeleton(layer) || std::ranges::find_first_of(layer.structures, kScaled) != layer.structures.end();
}

/// True if it grows disks about the samples, and the balls of all families, additively.
bool is_additive(const Evolution& evolution) {
  const ParameterMove* const move = evolution.moved_parameter();
  return move != nullptr && move->parameter == Parameter::alpha_radius;
}

}  // namespace

std::vector<LayerIndex> layers_to_show(const Evolution& evolution, const LayerStack& layers,
                                       const Document& document) {
  const auto family = family_of(evolution);
  const auto follows = [&](LayerIndex layer) {
    const LayerDescriptor& descriptor = layers.descriptor(layer);
    const auto of = mes::family_of(descriptor);
    if (descriptor.kinds.empty()) return false;
    if (is_skeleton(evolution)) return is_of_skeleton(descriptor);
    if (is_of_scale_axis(evolution)) return is_of_scale_axis(descriptor);
    if (is_additive(evolution)) return growth_of(descriptor).has_value();
    return family ? of == family : of != FamilyKind::own;
  };
  if (std::ranges::any_of(layers.visible_layers(), follows)) return {};
  std::vector<std::string> ids{"points", "curve"};
  auto shown = mes::family_of(layers.descriptors(), layers.configuration());
  if (!shown && document.sample_count() == 0 && document.ball_count() != 0) shown = FamilyKind::own;
  const std::string prefix = shown ? std::string(letter_of(*shown)) + "-" : "";
  if (is_skeleton(evolution)) {
    ids = {std::string(letter_of(shown.value_or(FamilyKind::inner))) + "-scale-skeleton"};
  } else if (is_of_scale_axis(evolution)) {
    // For the inner balls, uses those of the one-step axis, which are cheaper.
    const std::string letter = shown == FamilyKind::inner ? "" : prefix;
    ids = {letter + "scale-axis-grown-disks", letter + "scale-axis-boundary", letter + "scale-axis"};
  }
  if (is_additive(evolution)) {
    ids = {prefix + "alpha-disks", prefix + "alpha-triangles", prefix + "alpha-edges", prefix + "alpha-boundary"};
  }
  if (family) {
    const std::string letter = *family == FamilyKind::inner ? "a-" : *family == FamilyKind::polar ? "p-" : "b-";
    ids = {letter + "inner-disks", letter + "union-boundary", letter + "ball-medial-axis"};
  }
  std::vector<LayerIndex> out;
  for (const std::string& id : ids)
    if (const LayerIndex layer = layers.find(id); layer != kNoLayer) out.push_back(layer);
  return out;
}

std::optional<GrowthOf> shown_growth(const LayerStack& layers, GrowthOf preferred) {
  std::optional<GrowthOf> out;
  for (const LayerIndex layer : layers.visible_layers()) {
    const auto of = growth_of(layers.descriptor(layer));
    if (of == preferred) return of;
    if (of && (!out || *of < *out)) out = of;
  }
  return out;
}

}  // namespace mes
