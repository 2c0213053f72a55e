// SPDX-License-Identifier: GPL-3.0-or-later
// Highlights the element under the pointer that a click on the canvas would ask about.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "app/canvas/canvas.h"
#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/panels/on_canvas/marks/pane_part.h"
#include "app/ui/screen/gui.h"
#include "core/engine/engine.h"

namespace mes {

/// Guarantees: at most one question is under way, and none while the engine computes, the view moves or a gesture has
/// the pointer; so the mark may trail a fast pointer, and nothing waits for it. It belongs to the document and the
/// layers on screen, or is hidden. Threads: the window's.
class PointedElement {
 public:
  struct Scene {
    const Canvas& canvas;
    const Editor& editor;
    const LayerStack& layers;
    bool is_over_canvas = false;
    bool may_ask = false;  ///< false while a click waits for its answer
  };

  /// Call it once per frame: asks about the element under the pointer if it has moved.
  void follow(Engine& engine, const Scene& scene);
  /// Returns true if the answer was to a question of this object.
  bool take(const Provenance& answer);
  void draw(const Gui& gui, const PanePart& pane, double content_scale) const;

 private:
  struct Place {
    Vec2 world{};
    double units_per_px = 0.0;
    std::uint64_t document = 0;
    std::uint64_t layers = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };

  // Tickets of cards begin at one.
  static constexpr std::uint64_t kFirstTicket = std::uint64_t{1} << 63U;
  std::uint64_t ticket_ = kFirstTicket;
  bool is_asking_ = false;
  std::optional<Place> asked_;  // empty: nothing is pointed at
  std::optional<ProvenanceShape> shape_;
};

}  // namespace mes
