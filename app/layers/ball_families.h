// SPDX-License-Identifier: GPL-3.0-or-later
// The three families of balls whose union is studied: which one the layers are about, and the same layers of another.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/layers/layer_stack.h"
#include "core/document/document.h"
#include "core/document/pane_choice.h"

namespace mes {

inline constexpr std::array kBallFamilies{FamilyKind::inner, FamilyKind::polar, FamilyKind::own};

LayerGroup group_of(FamilyKind family);
/// Its letter in the ids of layers: "a", "p" or "b".
std::string_view letter_of(FamilyKind family);
/// The family of a layer of a union; nothing for other layers.
std::optional<FamilyKind> family_of(const LayerDescriptor& descriptor);
/// Whether the document has what the balls are made of: samples, or balls of its own.
bool has_balls(const Document& document, FamilyKind family);

/// `descriptors`, here and below, are those of all layers that there are; entries of others are passed over.
///
/// The layers with those of every other family that are visible replaced by those of this one. A layer takes the place
/// of its counterpart; it has the style that is given for it, or else that of the counterpart. Own balls that are drawn
/// without their union stay.
LayerConfiguration in_family(std::span<const LayerDescriptor> descriptors, const LayerConfiguration& layers,
                             FamilyKind family);
/// The one family whose union the visible layers are about; nothing: none, or several.
std::optional<FamilyKind> family_of(std::span<const LayerDescriptor> descriptors, const LayerConfiguration& layers);

/// Which family the window is about.
///
/// What it guarantees: it is one that the document has, if it has any, except after `choose`, until `begin`. It changes
/// by itself only when the document has lost all its balls and has others. Threads: none.
class FamilyChoice {
 public:
  FamilyKind family() const { return family_; }
  /// Stays for this document, whatever it has.
  void choose(FamilyKind family) {
    family_ = family;
    is_chosen_ = true;
  }
  /// The layers are about this family now, and were not chosen for it.
  void note_shown(FamilyKind family) { family_ = family; }
  /// Another document takes the place of this one.
  void begin() { *this = {}; }
  /// Once a frame. True when the family has changed.
  bool follow(const Document& document);

 private:
  FamilyKind family_ = FamilyKind::inner;
  bool is_chosen_ = false;
};

/// A bundle for the family the window is about: one of inner balls stands for all families, and one of another family
/// for those that the document has.
LayerConfiguration adapted(std::span<const LayerDescriptor> descriptors, const LayerConfiguration& bundle,
                           FamilyKind family, const Document& document);

}  // namespace mes
