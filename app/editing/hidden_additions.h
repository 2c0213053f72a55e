// SPDX-License-Identifier: GPL-3.0-or-later
// Elements while nothing shows their kind: they are counted when they are added, and clicks pass through them.
#pragma once

#include <array>

#include "app/editing/places/ball_pick.h"
#include "app/layers/layer_stack.h"
#include "core/document/document.h"

namespace mes {

class Editor;

/// The kinds of elements that a user adds to a document.
enum class AddedKind : std::uint8_t { samples, balls, annotations };
inline constexpr std::array kAddedKinds{AddedKind::samples, AddedKind::balls, AddedKind::annotations};

/// The sample or ball that a click at `p` takes among those that are seen: they are selected, or a layer shows their
/// kind.
PickedThing seen_thing_at(const Editor& editor, const LayerStack& layers, Vec2 p, double radius);

/// Counts the elements of each kind that were added since elements of that kind were last visible, or since the
/// document was loaded, less those removed again; a count is zero once the user knows of them. Samples are visible in
/// the layer of points, and balls in the layers of `kOwnBallLayers`. Threads: none.
class HiddenAdditions {
 public:
  /// Begins with another document.
  void begin(const Document& document);
  /// Call it once per frame.
  void follow(const Document& document, const LayerStack& layers, bool shows_annotations);
  /// The number of hidden elements to report.
  std::size_t count(AddedKind kind) const { return of(kind).is_known ? 0 : of(kind).added; }
  /// The user knows; valid until elements of this kind have been visible, or another document is loaded.
  void dismiss(AddedKind kind) { of(kind).is_known = true; }

 private:
  struct Additions {
    std::size_t last = 0;  // number of elements in the document
    std::size_t added = 0;
    bool is_known = false;
  };
  const Additions& of(AddedKind kind) const { return additions_[static_cast<std::size_t>(kind)]; }
  Additions& of(AddedKind kind) { return additions_[static_cast<std::size_t>(kind)]; }
  std::array<Additions, kAddedKinds.size()> additions_{};
};

}  // namespace mes
