// SPDX-License-Identifier: GPL-3.0-or-later
// The three families of balls whose union is studied: which one the layers show, and the same layers for another.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/layers/layer_stack.h"
#include "core/document/settings/pane_choice.h"

namespace mes {

class Document;

inline constexpr std::array kBallFamilies{FamilyKind::inner, FamilyKind::polar, FamilyKind::own};

/// The layers that show own balls themselves, without their union.
inline constexpr std::array<std::string_view, 3> kOwnBallLayers{"b-inner-disks", "b-inner-circles",
                                                                "b-inner-centers"};

LayerGroup group_of(FamilyKind family);
/// The family's letter in the ids of layers: "a", "p" or "b".
std::string_view letter_of(FamilyKind family);
/// The family of a layer of a union; nothing for other layers.
std::optional<FamilyKind> family_of(const LayerDescriptor& descriptor);
/// The layer that shows the same for another family, as "a-v-points" and "b-v-points" do, or null. The layer must be one
/// of a union.
const LayerDescriptor* counterpart_of(std::span<const LayerDescriptor> descriptors, const LayerDescriptor& layer,
                                      FamilyKind family);
/// True if the document has the source of the balls: samples, or own balls.
bool has_balls(const Document& document, FamilyKind family);

/// `descriptors`, here and below, are those of all known layers; entries of other layers are ignored.
///
/// Replaces all visible layers of other families by the same layers of this family. A layer takes the position of its
/// counterpart, and the style given for it, or else that of the counterpart. Own balls drawn without their union
/// stay.
LayerConfiguration in_family(std::span<const LayerDescriptor> descriptors, const LayerConfiguration& layers,
                             FamilyKind family);
/// The only family whose union the visible layers show; nothing if there is none or several.
std::optional<FamilyKind> family_of(std::span<const LayerDescriptor> descriptors, const LayerConfiguration& layers);

/// The family that the window shows.
///
/// Guarantees: it is one that the document has, if it has any, except between `choose` and `begin`. It changes by
/// itself only when the document has lost all its balls and has those of another family. Threads: none.
class FamilyChoice {
 public:
  FamilyKind family() const { return family_; }
  /// Keeps the family for this document, whatever the document has.
  void choose(FamilyKind family) {
    family_ = family;
    is_chosen_ = true;
  }
  /// Notes that the layers now show this family, although nobody chose it.
  void note_shown(FamilyKind family) { family_ = family; }
  /// Another document replaces this one.
  void begin() { *this = {}; }
  /// Call it once per frame. Returns true if the family has changed.
  bool follow(const Document& document);

 private:
  FamilyKind family_ = FamilyKind::inner;
  bool is_chosen_ = false;
};

/// Adapts a bundle to the window's family: a bundle of inner balls stands for all families, and one of another family
/// for those that the document has.
LayerConfiguration adapted(std::span<const LayerDescriptor> descriptors, const LayerConfiguration& bundle,
                           FamilyKind family, const Document& document);

}  // namespace mes
