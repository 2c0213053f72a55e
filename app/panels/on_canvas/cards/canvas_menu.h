// SPDX-License-Identifier: GPL-3.0-or-later
// The menu of a right click on the canvas.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/layers/layer_stack.h"
#include "app/ui/screen/gui.h"
#include "core/engine/engine.h"

namespace mes {

/// Offers what fits the thing at the pointer: an annotation, the selected samples and balls, the element of a layer,
/// and always what fits empty paper.
///
/// Guarantees: it opens at once if the engine computes, without the element, and otherwise when the engine has named
/// the element; so no row moves under the pointer. Esc or a click elsewhere closes it. Arrow keys and Enter work in
/// it. Threads: the window's.
class CanvasMenu {
 public:
  /// The thing at the pointer.
  struct Target {
    Pointer pointer{};
    ImVec2 at{};                              ///< corner of the menu, in screen coordinates
    std::optional<std::size_t> annotation{};  ///< its index in the document
    std::uint64_t document = 0;               ///< revision of the document
    std::string selected{};                   ///< the selection in words if the pointer is on it; else empty
    bool has_samples = false;                 ///< the selection has samples
  };
  /// A command without an action of its own.
  enum class Choice : std::uint8_t {
    none,
    edit_annotation,
    delete_annotation,
    show_card,
    hide_layer,
    show_layer_alone,
    end_solo,
    insert_sample,
    annotate,
  };

  /// Opens the menu for the target. Asks for the element there in the visible layers, if `may_ask`.
  void open(Engine& engine, const LayerStack& layers, Target target, bool may_ask);
  /// Returns true if the answer was to a question of this object.
  bool take(const Provenance& answer);
  /// Call it once per frame. Returns the command that was chosen in it.
  Choice draw(const Gui& gui, const ActionBindings& actions, const LayerStack& layers, const Engine& engine);
  /// The target of the last `open`, and the layer of the element there, or kNoLayer.
  const Target& target() const { return target_; }
  LayerIndex layer() const { return layer_; }

 private:
  Choice draw_rows(const Gui& gui, const ActionBindings& actions, const LayerStack& layers) const;

  // Between the tickets of cards and those of ranges of values.
  static constexpr std::uint64_t kFirstTicket = std::uint64_t{1} << 60U;
  std::uint64_t ticket_ = kFirstTicket;
  Target target_;
  LayerIndex layer_ = kNoLayer;
  bool is_asking_ = false;
  bool is_wanted_ = false;  // it opens as soon as it knows its rows
};

}  // namespace mes
