// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/annotate_tool.h"

#include <utility>

namespace mes {
namespace {

/// Offset in logical pixels from an element to the words beside it.
constexpr Vec2 kBeside{22.0, -22.0};

}  // namespace

Anchor AnnotateTool::anchor_at(const Pointer& pointer) const {
  return context_.annotations.anchor_at(pointer.world, kPickRadiusPx * pointer.units_per_px, true);
}

void AnnotateTool::press(const Pointer& pointer) {
  now_ = pointer;
  Pressed pressed{.at = pointer};
  pressed.annotation = context_.annotation_at ? context_.annotation_at(pointer.px) : std::nullopt;
  const Document& document = context_.editor.document();
  // A highlight does not take a press on an element: highlighted elements are there to be annotated.
  if (pressed.annotation && *pressed.annotation < document.annotations()->size() &&
      (*document.annotations())[*pressed.annotation].kind == AnnotationKind::highlight &&
      !anchor_at(pointer).is_fixed())
    pressed.annotation.reset();
  if (pressed.annotation && *pressed.annotation < document.annotations()->size()) {
    pressed.before = (*document.annotations())[*pressed.annotation];
    const double reach = kPickRadiusPx * pointer.units_per_px;
    // Only anchors of shapes are ends that can be dragged. Text is moved as a whole, and of a highlight only its
    // text.
    if (shows_without_words(pressed.before.kind) && pressed.before.kind != AnnotationKind::highlight)
      for (std::size_t i = 0; i < pressed.before.anchors.size(); ++i)
        if (distance(document.place_of(pressed.before.anchors[i]), pointer.world) <= reach) pressed.end = i;
  } else {
    pressed.annotation.reset();
    under_pointer_ = pressed.anchor = anchor_at(pointer);
  }
  pressed_ = std::move(pressed);
}

/// The annotation as it would be with the pointer here.
Annotation AnnotateTool::moved(const Pointer& pointer) const {
  Annotation out = pressed_->before;
  if (pressed_->end) {
    out.anchors[*pressed_->end] = under_pointer_;
    return out;
  }
  const Vec2 way = pointer.world - pressed_->at.world;
  const bool is_text = out.kind == AnnotationKind::text && out.anchors[0].is_fixed();
  const bool is_free_arrow =
      out.kind == AnnotationKind::arrow && out.anchors[0].is_fixed() && out.anchors[1].is_fixed();
  if (is_text || is_free_arrow) {
    for (Anchor& anchor : out.anchors) anchor.at = anchor.at + way;
  } else {
    out.shift = out.shift + pointer.px - pressed_->at.px;
  }
  return out;
}

void AnnotateTool::drag(const Pointer& pointer) {
  if (!pressed_) return;
  now_ = pointer;
  under_pointer_ = anchor_at(pointer);
  const bool was_dragged = pressed_->is_dragged;
  if (distance(pressed_->at.px, pointer.px) > kDragThresholdPx) pressed_->is_dragged = true;
  if (!pressed_->is_dragged || !pressed_->annotation) return;
  if (!was_dragged) context_.editor.begin_gesture("Move annotation");
  accepted(context_.annotations.move(*pressed_->annotation, moved(pointer)));
}

void AnnotateTool::end_gesture() {
  if (pressed_ && pressed_->annotation && pressed_->is_dragged) context_.editor.end_gesture();
  pressed_.reset();
}

/// Makes the annotation of a click or of a drag over free space.
void AnnotateTool::make(const Pointer& pointer) {
  const Anchor& from = pressed_->anchor;
  const bool is_on_element = !from.is_fixed();
  Annotation out{.anchors = {from}};
  if (!pressed_->is_dragged) {
    out.kind = is_on_element ? AnnotationKind::leader : AnnotationKind::text;
    if (is_on_element) out.shift = kBeside;
  } else if (is_on_element) {
    out.kind = AnnotationKind::leader;
    out.shift = pointer.px - pressed_->at.px;
  } else {
    out.kind = AnnotationKind::arrow;
    out.anchors.push_back(under_pointer_);
  }
  accepted(context_.annotations.begin(std::move(out)));
}

void AnnotateTool::release(const Pointer& pointer) {
  if (!pressed_) return;
  drag(pointer);
  if (!pressed_->annotation)
    make(pointer);
  else if (!pressed_->is_dragged)
    context_.annotations.select(*pressed_->annotation);
  end_gesture();
}

void AnnotateTool::cancel() {
  if (pressed_ && pressed_->annotation && pressed_->is_dragged) context_.editor.cancel_gesture();
  pressed_.reset();
  context_.annotations.follow();
}

void AnnotateTool::hover(const Pointer& pointer) {
  now_ = pointer;
  under_pointer_ = anchor_at(pointer);
  hovered_ = context_.annotation_at ? context_.annotation_at(pointer.px) : std::nullopt;
}

void AnnotateTool::leave() {
  now_.reset();
  hovered_.reset();
}

ToolFeedback AnnotateTool::feedback() const {
  ToolFeedback out;
  if (pressed_ && !pressed_->annotation && pressed_->is_dragged && now_)
    out.line = {context_.editor.document().place_of(pressed_->anchor), now_->world};
  if (pressed_ && pressed_->annotation)
    out.annotation = pressed_->annotation;
  else if (!pressed_)
    out.annotation = hovered_;
  const bool moves_words = pressed_ && pressed_->annotation && !pressed_->end;
  if (!now_ || moves_words || (!pressed_ && hovered_)) return out;
  // A line to words keeps the element where it began; any other end takes the one under the pointer.
  const bool is_leader = pressed_ && !pressed_->annotation && !pressed_->anchor.is_fixed();
  const Anchor& on = is_leader ? pressed_->anchor : under_pointer_;
  if (!on.is_fixed()) out.ringed = context_.editor.document().place_of(on);
  return out;
}

PointerShape AnnotateTool::pointer_shape() const {
  return hovered_ || (pressed_ && pressed_->annotation) ? PointerShape::hand : PointerShape::crosshair;
}

}  // namespace mes
