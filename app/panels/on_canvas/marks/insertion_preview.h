// SPDX-License-Identifier: GPL-3.0-or-later
// Previews the changes that a sample at the pointer would cause, before it is inserted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/canvas/canvas.h"
#include "app/editing/editor.h"
#include "app/panels/on_canvas/marks/pane_part.h"
#include "app/ui/screen/gui.h"
#include "core/engine/engine.h"

namespace mes {

/// Guarantees: at most one question is under way, and none while the engine computes, the view moves or a gesture has
/// the pointer; so it may trail a fast pointer, and nothing waits for it. The preview belongs to the document on
/// screen, or is hidden. Threads: the window's.
class InsertionPreview {
 public:
  /// Call it once per frame. `is_wanted`: the preview is on, the pointer is over the canvas, and the tool inserts.
  void follow(Engine& engine, const Canvas& canvas, const Editor& editor, bool is_wanted);
  /// Returns true if the answer was to a question of this object.
  bool take(const Provenance& answer);
  void draw(const Gui& gui, const PanePart& pane, double content_scale) const;
  /// Draws the removals and additions as lines of text beside the point, clear of the panels.
  void draw_words(const Gui& gui, const PanePart& pane, const Canvas& canvas) const;

 private:
  struct Place {
    Vec2 world{};
    std::uint64_t document = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };

  // Between the tickets of cards and those of pointed elements.
  static constexpr std::uint64_t kFirstTicket = std::uint64_t{1} << 62U;
  std::uint64_t ticket_ = kFirstTicket;
  bool is_asking_ = false;
  std::optional<Place> asked_;  // empty: nothing is shown
  std::vector<ProvenanceLine> lines_;
};

}  // namespace mes
