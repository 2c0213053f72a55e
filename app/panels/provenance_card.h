// SPDX-License-Identifier: GPL-3.0-or-later
// What was clicked, what it comes from and what it made: as text on a card, and drawn over the picture.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/canvas/canvas.h"
#include "app/canvas/tools/tool.h"
#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/ui/gui.h"
#include "core/draw/provenance.h"
#include "core/engine/engine.h"

namespace mes {

/// What lies under the pointer in the visible layers, top first; the ticket is left to the asker.
ProvenanceQuestion question_at(const Pointer& pointer, const LayerStack& layers);

/// It holds for one state of the document and one selection: an edit takes it away, and so does selecting something
/// else. It can be dragged by its head. Threads: the window's.
class ProvenanceCard {
 public:
  /// What lies under the pointer in the visible layers; the answer comes later.
  void ask(Engine& engine, const LayerStack& layers, const Pointer& pointer, const Editor& editor) {
    ask(engine, layers, question_at(pointer, layers), editor);
  }
  /// The same of some of the layers.
  void ask(Engine& engine, const LayerStack& layers, ProvenanceQuestion question, const Editor& editor);
  /// An answer; those to earlier questions are passed over.
  void take(Provenance answer);
  /// True when there was something to take away.
  bool clear();
  const Provenance* shown() const { return answer_ ? &*answer_ : nullptr; }
  /// A question has no answer yet.
  bool is_asking() const { return is_asking_; }

  /// It shows something that is of this state of the document.
  bool can_be_kept(const Editor& editor) const { return answer_ && is_of(editor); }
  /// What of it is to stay highlighted: the line with this number, or all of it.
  struct Keep {
    std::optional<std::size_t> line;
  };
  /// `corner`: lower left. Draws the shapes behind all panels. A click on a row shows where it is, one with Shift held
  /// asks to keep it highlighted, as the button does for all rows. `keep_key`: that of the action that keeps all, or empty.
  std::optional<Keep> draw(const Gui& gui, Canvas& canvas, const Editor& editor, const LayerStack& layers,
                           ImVec2 corner, ImVec2 room, const std::string& keep_key);
  /// `select_sources` was called for what is shown: the new selection does not take it away. O(1).
  void keep_for(const Editor& editor) { selection_revision_ = editor.selection().revision(); }
  /// Asks about the same place below the layer of what is shown, if the button for that was pressed since the last call.
  /// What is shown stays where nothing lies there.
  void ask_beneath(Engine& engine);
  /// The button that selects what it comes from was pressed since the last call.
  bool wants_sources() { return std::exchange(wants_sources_, false); }

 private:
  void draw_shapes(const Gui& gui, const Canvas& canvas) const;
  /// The number of the line that was clicked.
  std::optional<std::size_t> draw_lines(const Gui& gui, float width);
  /// What was done to it.
  struct HeadClicks {
    bool closed = false;
    bool kept = false;
  };
  /// The rows of tables that the element has, under a fold.
  void draw_rows(const Gui& gui, float width);
  void draw_foot(const Gui& gui);
  std::vector<VariantLayer> layers_beneath() const;
  HeadClicks draw_head(const Gui& gui, const LayerStack& layers, float width, const std::string& keep_key);
  bool is_of(const Editor& editor) const;

  std::uint64_t ticket_ = 0;
  bool is_asking_ = false;
  std::uint64_t document_revision_ = 0;
  std::uint64_t selection_revision_ = 0;
  ImVec2 moved_{};  ///< from its corner, by hand
  bool shows_rows_ = false;
  bool wants_sources_ = false;
  bool wants_beneath_ = false;
  bool asks_beneath_ = false;
  ProvenanceQuestion question_{};     ///< the last one
  std::vector<VariantLayer> layers_;  ///< all that were visible then, top first
  enum class Beneath : std::uint8_t { unknown, nothing, no_layer } beneath_ = Beneath::unknown;
  std::optional<Provenance> answer_;
  std::size_t pointed_at_ = 0;  ///< line under the pointer, counted from one; 0 = none
};

}  // namespace mes
