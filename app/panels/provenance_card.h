// SPDX-License-Identifier: GPL-3.0-or-later
// What was clicked, what it comes from and what it made: as text on a card, and drawn over the picture.
#pragma once

#include <memory>
#include <optional>

#include "app/canvas/canvas.h"
#include "app/canvas/tools/tool.h"
#include "app/model/layer_stack.h"
#include "app/ui/gui.h"
#include "core/draw/provenance.h"
#include "core/engine/engine.h"

namespace mes {

/// It holds for one state of the document: an edit takes it away. Threads: the window's.
class ProvenanceCard {
 public:
  /// What lies under the pointer in the visible layers; the answer comes with a later patch.
  void ask(Engine& engine, const LayerStack& layers, const Pointer& pointer, std::uint64_t document_revision);
  /// An answer; those to earlier questions are passed over.
  void take(std::unique_ptr<Provenance> answer);
  /// True when there was something to take away.
  bool clear();
  const Provenance* shown() const { return answer_.get(); }

  /// `corner`: lower left. Draws the shapes behind all panels.
  void draw(const Gui& gui, const Canvas& canvas, std::uint64_t document_revision, ImVec2 corner, ImVec2 room);

 private:
  std::uint64_t ticket_ = 0;
  std::uint64_t document_revision_ = 0;
  std::unique_ptr<Provenance> answer_;
  std::size_t pointed_at_ = 0;  ///< line under the pointer, counted from one; 0 = none
};

}  // namespace mes
