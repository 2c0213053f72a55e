// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the clicked element, its sources and its results: as text on a card, and drawn over the picture.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/canvas/canvas.h"
#include "app/canvas/tools/tool.h"
#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/ui/screen/gui.h"
#include "app/ui/widgets/widgets.h"
#include "core/draw/provenance.h"
#include "core/engine/engine.h"

namespace mes {

/// The question for the elements under the pointer in the visible layers, top first; the caller sets the ticket.
ProvenanceQuestion question_at(const Pointer& pointer, const LayerStack& layers);

/// The answer is valid for one state of the document and one selection: an edit or a new selection removes it. The
/// card opens in the corner where it hides least of the drawing and its marks. Once dragged by its header, it stays
/// where it is. Threads: the window's.
class ProvenanceCard {
 public:
  /// Asks about the elements under the pointer in the visible layers; the answer comes later.
  void ask(Engine& engine, const LayerStack& layers, const Pointer& pointer, const Editor& editor) {
    ask(engine, layers, question_at(pointer, layers), editor);
  }
  /// The same for some of the layers.
  void ask(Engine& engine, const LayerStack& layers, ProvenanceQuestion question, const Editor& editor);
  /// Takes an answer; ignores those to earlier questions.
  void take(Provenance answer);
  /// Removes the answer; returns true if there was one.
  bool clear();
  const Provenance* shown() const { return answer_ ? &*answer_ : nullptr; }
  /// True while a question has no answer yet.
  bool is_asking() const { return is_asking_; }

  /// True if it shows an answer for this state of the document.
  bool can_be_kept(const Editor& editor) const { return answer_ && is_of(editor); }
  /// The part that stays highlighted: the line with this number, or everything.
  struct Keep {
    std::optional<std::size_t> line;
  };
  /// `room`: where it may be; `hides`: how much of the drawing a box on the screen would hide. Draws the shapes behind
  /// all panels. A click on a row shows its element, a click with Shift asks to keep it highlighted, and the button asks
  /// that for all rows. `keep_key`: key of the action that keeps all, or empty.
  std::optional<Keep> draw(const Gui& gui, Canvas& canvas, const Editor& editor, const LayerStack& layers,
                           const PanelArea& room, const std::function<std::size_t(const Box2&)>& hides,
                           const std::string& keep_key);
  /// Call it after `select_sources` for this answer, so that the new selection does not remove it. O(1).
  void keep_for(const Editor& editor) { selection_revision_ = editor.selection().revision(); }
  /// Looks for what lies below the shown element, which the card offers by its name; shows it if its button was pressed
  /// since the last call. Call it once a frame.
  void look_beneath(Engine& engine);
  /// True if the button that selects the sources was pressed since the last call.
  bool wants_sources() { return std::exchange(wants_sources_, false); }

 private:
  void draw_shapes(const Gui& gui, const Canvas& canvas) const;
  /// Returns the number of the clicked line.
  std::optional<std::size_t> draw_lines(const Gui& gui, float width);
  /// The clicks on the header.
  struct HeadClicks {
    bool closed = false;
    bool kept = false;
  };
  /// Draws the table rows of the element, which can be folded.
  void draw_rows(const Gui& gui, float width);
  void draw_foot(const Gui& gui, const LayerStack& layers, float width);
  std::vector<VariantLayer> layers_beneath() const;
  HeadClicks draw_head(const Gui& gui, const LayerStack& layers, float width, const std::string& keep_key);
  bool is_of(const Editor& editor) const;
  /// Chooses the corner for a card of this size, unless it was dragged.
  void choose_corner(const PanelArea& room, ImVec2 size, const std::function<std::size_t(const Box2&)>& hides);

  std::uint64_t ticket_ = 0;
  bool is_asking_ = false;
  std::uint64_t document_revision_ = 0;
  std::uint64_t selection_revision_ = 0;
  int frames_to_place_ = 0;  ///< a new card is measured first
  float height_ = 0.0F;
  bool is_dragged_ = false;
  bool is_right_ = false;  ///< its corner
  bool is_top_ = false;
  ImVec2 moved_{};  ///< offset from its corner by dragging
  bool shows_rows_ = false;
  bool wants_sources_ = false;
  bool wants_beneath_ = false;
  ProvenanceQuestion question_{};     ///< the last question
  std::vector<VariantLayer> layers_;  ///< all layers visible at that time, top first
  /// State of the question for the elements beneath: not yet asked, asked, or answered in `beneath_answer_`.
  enum class Beneath : std::uint8_t { unknown, asked, known } beneath_ = Beneath::unknown;
  std::optional<Provenance> answer_;
  std::optional<Provenance> beneath_answer_;  ///< nothing lies there
  std::size_t pointed_at_ = 0;                ///< line under the pointer, counted from one; 0 = none
};

}  // namespace mes
