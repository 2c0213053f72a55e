// SPDX-License-Identifier: GPL-3.0-or-later
// Click for text, drag from an element for text with a line to it, or drag from anywhere else for an arrow; drag text
// and ends to move them.
#pragma once

#include "app/canvas/tools/tool.h"
#include "app/editing/tools/annotation_editor.h"

namespace mes {

/// Guarantees: a drag of an annotation is one step of undo. A click on one chooses it in the editor, where its text is
/// edited. Ends and lines attach to the element under the pointer, a sample or a Voronoi vertex, and follow it.
class AnnotateTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return pressed_.has_value(); }
  void hover(const Pointer& pointer) override;
  void leave() override;
  bool clear() override { return context_.annotations.close(); }
  ToolFeedback feedback() const override;
  PointerShape pointer_shape() const override;
  std::string_view hint() const override {
    return "Click to write; drag for an arrow, from a sample or ball for a line to text; drag text to move it";
  }

 private:
  struct Pressed {
    Pointer at{};
    Anchor anchor{};                          ///< the first anchor of a new annotation
    std::optional<std::size_t> annotation{};  ///< the existing annotation under the press
    std::optional<std::size_t> end{};         ///< index of the pressed anchor in `before`
    Annotation before{};
    bool is_dragged = false;
  };
  Anchor anchor_at(const Pointer& pointer) const;
  Annotation moved(const Pointer& pointer) const;
  void end_gesture();
  void make(const Pointer& pointer);

  std::optional<Pressed> pressed_;
  std::optional<Pointer> now_;
  Anchor under_pointer_;  // found once per move of the pointer; each frame reads it
  std::optional<std::size_t> hovered_;
};

}  // namespace mes
