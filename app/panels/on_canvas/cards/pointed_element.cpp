// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/cards/pointed_element.h"

#include "app/panels/on_canvas/cards/provenance_card.h"
#include "app/panels/on_canvas/marks/shape_pen.h"
#include "app/ui/screen/theme.h"

namespace mes {

void PointedElement::follow(Engine& engine, const Scene& scene) {
  const Canvas& canvas = scene.canvas;
  if (!scene.is_over_canvas || canvas.has_pointer() || !canvas.tool().feedback().asks) {
    asked_.reset();
    shape_.reset();
    return;
  }
  const Pointer pointer = canvas.pointer();
  const Place place{pointer.world, pointer.units_per_px, scene.editor.document().revision(), scene.layers.revision()};
  if (asked_ == place) return;
  if (asked_ && (asked_->document != place.document || asked_->layers != place.layers)) shape_.reset();
  if (is_asking_ || !scene.may_ask || canvas.view_at_pointer().is_moving() || engine.status().busy) return;
  asked_ = place;
  is_asking_ = true;
  ProvenanceQuestion question = question_at(pointer, scene.layers);
  question.ticket = ++ticket_;
  question.wish = ProvenanceWish::shape;
  engine.ask(std::move(question));
}

bool PointedElement::take(const Provenance& answer) {
  if (answer.ticket < kFirstTicket) return false;
  is_asking_ = false;
  shape_.reset();
  if (asked_ && answer.ticket == ticket_ && !answer.lines.empty()) shape_ = answer.lines.front().shapes.front();
  return true;
}

void PointedElement::draw(const Gui& gui, const PanePart& pane, double content_scale) const {
  if (!shape_) return;
  // Areas are drawn lightly: in the middle of the drawing there is always one under the pointer.
  const bool is_area = shape_->kind == PrimitiveKind::disk || shape_->kind == PrimitiveKind::triangle;
  const ImU32 color = to_imgui(palette::vermilion, is_area ? 0.4 : 0.65);
  ShapePen(gui, pane, content_scale, {color, (is_area ? 1.5F : 4.0F) * gui.unit(), PenMark::dot}).draw(*shape_);
}

}  // namespace mes
