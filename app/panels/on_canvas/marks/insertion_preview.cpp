// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/insertion_preview.h"

#include <algorithm>
#include <ranges>

#include "app/panels/on_canvas/marks/shape_pen.h"
#include "app/ui/screen/theme.h"

namespace mes {
namespace {

PenLook pen_look(const Gui& gui, const ProvenanceLine& line, PrimitiveKind kind) {
  const float unit = gui.unit();
  const PenMark mark = PenMark::dot;
  const bool goes = line.role == ProvenanceRole::origin;
  if (kind == PrimitiveKind::triangle) return {to_imgui(palette::vermilion, 0.35), 1.2F * unit, mark};
  if (line.is_heavy) return {to_imgui(goes ? palette::vermilion : palette::green, 0.9), 4.0F * unit, mark};
  if (line.role == ProvenanceRole::itself) return {to_imgui(palette::purple, 0.9), 2.0F * unit, mark};
  return {to_imgui(palette::sky, 0.9), 1.4F * unit, mark};
}

}  // namespace

void InsertionPreview::follow(Engine& engine, const Canvas& canvas, const Editor& editor, bool is_wanted) {
  if (!is_wanted || canvas.has_pointer()) {
    asked_.reset();
    lines_.clear();
    return;
  }
  // The sample would be put at the snapped position.
  const ToolFeedback feedback = canvas.tool().feedback();
  const Place place{feedback.snap ? feedback.snap->place : canvas.pointer().world, editor.document().revision()};
  if (asked_ == place) return;
  if (asked_ && asked_->document != place.document) lines_.clear();
  if (is_asking_ || canvas.view_at_pointer().is_moving() || engine.status().busy) return;
  asked_ = place;
  is_asking_ = true;
  ProvenanceQuestion question;
  question.ticket = ++ticket_;
  question.at = place.world;
  question.wish = ProvenanceWish::insertion;
  engine.ask(std::move(question));
}

bool InsertionPreview::take(const Provenance& answer) {
  if (answer.ticket < kFirstTicket || answer.ticket >= 2 * kFirstTicket) return false;
  is_asking_ = false;
  lines_.clear();
  if (asked_ && answer.ticket == ticket_) lines_ = answer.lines;
  return true;
}

void InsertionPreview::draw(const Gui& gui, const PanePart& pane, double content_scale) const {
  // Draws removed elements below added ones.
  for (const ProvenanceRole role : {ProvenanceRole::origin, ProvenanceRole::itself, ProvenanceRole::product})
    for (const ProvenanceLine& line : lines_) {
      if (line.role != role) continue;
      for (const ProvenanceShape& shape : line.shapes)
        ShapePen(gui, pane, content_scale, pen_look(gui, line, shape.kind)).draw(shape);
    }
}

void InsertionPreview::draw_words(const Gui& gui, const PanePart& pane, const Canvas& canvas) const {
  if (lines_.size() < 2 || !asked_) return;
  constexpr float kBeside = 18.0F;
  const float unit = gui.unit();
  const auto on_screen = [&](double px) { return static_cast<float>(px / canvas.content_scale()) * unit; };
  const Vec2 px = pane.camera.to_screen(asked_->world);
  float width = 0.0F;
  for (const ProvenanceLine& line : lines_ | std::views::drop(1))
    width = std::max(width, ImGui::CalcTextSize(line.text.c_str()).x);
  const float step = ImGui::GetTextLineHeight() + 2 * unit;
  const float height = static_cast<float>(lines_.size() - 1) * step;
  const Insets& panels = canvas.view().insets();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  // Uses the other side of the point if there is too little room on this side.
  const auto beside = [&](float from, float size, float end) {
    return from + kBeside * unit + size <= end ? from + kBeside * unit : from - kBeside * unit - size;
  };
  ImVec2 at{beside(pane.shift.x + on_screen(px.x), width, pane.shift.x + screen.x - on_screen(panels.right)),
            beside(pane.shift.y + on_screen(px.y), height, pane.shift.y + screen.y - on_screen(panels.bottom))};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const ProvenanceLine& line : lines_ | std::views::drop(1)) {
    const float end = at.x + ImGui::CalcTextSize(line.text.c_str()).x;
    list.AddRectFilled({at.x - 4 * unit, at.y - unit}, {end + 4 * unit, at.y + step}, gui.colors().panel, 2 * unit);
    list.AddText(at, gui.colors().text, line.text.c_str());
    at.y += step;
  }
}

}  // namespace mes
