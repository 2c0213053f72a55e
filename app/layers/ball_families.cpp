// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/ball_families.h"

#include <algorithm>

#include "core/builtins/builtins.h"

namespace mes {
namespace {

using Entry = LayerConfiguration::Entry;

std::optional<FamilyKind> family_of_layer(std::string_view id) {
  const LayerIndex layer = builtins().find_layer(id);
  return layer == kNoLayer ? std::nullopt : family_of(builtins().layers()[layer]);
}

// Own balls as they are drawn by hand: shown beside the union of any family.
bool is_plain(std::string_view id) {
  const LayerIndex layer = builtins().find_layer(id);
  const auto& structures = builtins().layers()[layer].structures;
  return structures.size() == 1 && structures.front() == "scaled-balls";
}

/// The layer that shows the same of another family, as "a-v-points" and "b-v-points" do, or kNoLayer.
LayerIndex counterpart_of(std::string_view id, FamilyKind family) {
  const auto layers = builtins().layers();
  const std::string_view shown = layers[builtins().find_layer(id)].of_any_family;
  const auto found = std::ranges::find_if(layers, [&](const LayerDescriptor& other) {
    return !shown.empty() && other.of_any_family == shown && other.group == group_of(family);
  });
  return found == layers.end() ? kNoLayer : static_cast<LayerIndex>(found - layers.begin());
}

}  // namespace

std::string_view letter_of(FamilyKind family) {
  constexpr std::array<std::string_view, kBallFamilies.size()> kLetters{"a", "p", "b"};
  return kLetters[static_cast<std::size_t>(family)];
}

LayerGroup group_of(FamilyKind family) {
  switch (family) {
    case FamilyKind::inner: return LayerGroup::union_a;
    case FamilyKind::polar: return LayerGroup::union_p;
    case FamilyKind::own: break;
  }
  return LayerGroup::union_b;
}

std::optional<FamilyKind> family_of(const LayerDescriptor& descriptor) {
  const auto found = std::ranges::find(kBallFamilies, descriptor.group, group_of);
  return found == kBallFamilies.end() ? std::nullopt : std::optional(*found);
}

bool has_balls(const Document& document, FamilyKind family) {
  return family == FamilyKind::own ? document.ball_count() != 0 : document.sample_count() != 0;
}

LayerConfiguration in_family(const LayerConfiguration& layers, FamilyKind family) {
  LayerConfiguration out = layers;
  const bool is_of_union = std::ranges::any_of(layers.layers, [](const Entry& entry) {
    return entry.visible && family_of_layer(entry.layer) == FamilyKind::own && !is_plain(entry.layer);
  });
  for (Entry& entry : out.layers) {
    const auto of = family_of_layer(entry.layer);
    if (!entry.visible || !of || *of == family || (is_plain(entry.layer) && !is_of_union)) continue;
    const LayerIndex counterpart = counterpart_of(entry.layer, family);
    if (counterpart == kNoLayer) continue;
    const std::string id(builtins().layers()[counterpart].id);
    const auto other = std::ranges::find(out.layers, id, &Entry::layer);
    if (other == out.layers.end()) {
      entry.layer = id;
    } else if (other->visible) {
      entry.visible = false;
    } else {
      std::swap(entry.layer, other->layer);
      std::swap(entry.style, other->style);
    }
  }
  return out;
}

std::optional<FamilyKind> family_of(const LayerConfiguration& layers) {
  std::optional<FamilyKind> out;
  for (const Entry& entry : layers.layers) {
    const auto of = family_of_layer(entry.layer);
    if (!entry.visible || !of || is_plain(entry.layer)) continue;
    if (out && *out != *of) return std::nullopt;
    out = of;
  }
  return out;
}

bool FamilyChoice::follow(const Document& document) {
  if (is_chosen_ || has_balls(document, family_)) return false;
  const auto found =
      std::ranges::find_if(kBallFamilies, [&](FamilyKind family) { return has_balls(document, family); });
  if (found == kBallFamilies.end()) return false;
  family_ = *found;
  return true;
}

LayerConfiguration adapted(const LayerConfiguration& bundle, FamilyKind family, const Document& document) {
  const auto of = family_of(bundle);
  if (!of || (*of != FamilyKind::inner && has_balls(document, *of))) return bundle;
  return in_family(bundle, family);
}

}  // namespace mes
