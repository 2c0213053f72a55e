// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/ball_families.h"

#include <algorithm>

#include "core/document/document.h"

namespace mes {
namespace {

using Entry = LayerConfiguration::Entry;

using Descriptors = std::span<const LayerDescriptor>;

/// Null if no layer has this id.
const LayerDescriptor* descriptor_of(Descriptors descriptors, std::string_view id) {
  const LayerIndex layer = find_layer(descriptors, id);
  return layer == kNoLayer ? nullptr : &descriptors[layer];
}

std::optional<FamilyKind> family_of_layer(const LayerDescriptor* layer) {
  return layer == nullptr ? std::nullopt : family_of(*layer);
}

// True for own balls as drawn by hand, which are shown beside the union of any family.
bool is_plain(const LayerDescriptor& layer) {
  return layer.structures.size() == 1 && layer.structures.front() == "scaled-balls";
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

const LayerDescriptor* counterpart_of(Descriptors descriptors, const LayerDescriptor& layer, FamilyKind family) {
  const std::string_view shown = layer.of_any_family;
  const auto found = std::ranges::find_if(descriptors, [&](const LayerDescriptor& other) {
    return !shown.empty() && !other.is_removed && other.of_any_family == shown && other.group == group_of(family);
  });
  return found == descriptors.end() ? nullptr : &*found;
}

bool has_balls(const Document& document, FamilyKind family) {
  return family == FamilyKind::own ? document.ball_count() != 0 : document.sample_count() != 0;
}

LayerConfiguration in_family(Descriptors descriptors, const LayerConfiguration& layers, FamilyKind family) {
  LayerConfiguration out = layers;
  const bool is_of_union = std::ranges::any_of(layers.layers, [&](const Entry& entry) {
    const LayerDescriptor* const layer = descriptor_of(descriptors, entry.layer);
    return entry.visible && family_of_layer(layer) == FamilyKind::own && !is_plain(*layer);
  });
  for (Entry& entry : out.layers) {
    const LayerDescriptor* const layer = descriptor_of(descriptors, entry.layer);
    const auto of = family_of_layer(layer);
    if (!entry.visible || !of || *of == family || (is_plain(*layer) && !is_of_union)) continue;
    const LayerDescriptor* const counterpart = counterpart_of(descriptors, *layer, family);
    if (counterpart == nullptr) continue;
    const std::string id(counterpart->id);
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

std::optional<FamilyKind> family_of(Descriptors descriptors, const LayerConfiguration& layers) {
  std::optional<FamilyKind> out;
  for (const Entry& entry : layers.layers) {
    const LayerDescriptor* const layer = descriptor_of(descriptors, entry.layer);
    const auto of = family_of_layer(layer);
    if (!entry.visible || !of || is_plain(*layer)) continue;
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

LayerConfiguration adapted(Descriptors descriptors, const LayerConfiguration& bundle, FamilyKind family,
                           const Document& document) {
  const auto of = family_of(descriptors, bundle);
  if (!of || (*of != FamilyKind::inner && has_balls(document, *of))) return bundle;
  return in_family(descriptors, bundle, family);
}

}  // namespace mes
