// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/pointer_marks.h"

#include <algorithm>
#include <span>
#include <vector>

#include "app/editing/places/measurement.h"
#include "app/panels/on_canvas/marks/paper_on_canvas.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

// ImGui draws circles as polygons with corners all around; a far too large one is left to its layer.
constexpr double kLargestMarkPx = 10'000.0;
constexpr float kRing = 9.0F;

/// Draws marks at positions in the world and on the canvas.
class Pen {
 public:
  explicit Pen(const PointerMarks& marks)
      : canvas_(marks.canvas),
        camera_(marks.pane.camera),
        list_(*ImGui::GetBackgroundDrawList()),
        unit_(marks.gui.unit()),
        shift_(marks.pane.shift),
        color_(marks.color),
        paper_(marks.background.value_or(Rgb{255, 255, 255})),
        ink_(to_imgui(marks.color)) {}

  void ring(Vec2 world) const { list_.AddCircle(at(to_px(world)), kRing * unit_, ink_, 0, 2.0F * unit_); }
  void dot(Vec2 world) const { list_.AddCircleFilled(at(to_px(world)), 3.0F * unit_, ink_); }
  void circle(const Disk& disk, float width) const {
    const double radius = disk.radius / (canvas_.content_scale() * camera_.units_per_pixel());
    if (radius < kLargestMarkPx)
      list_.AddCircle(at(to_px(disk.center)), static_cast<float>(radius) * unit_, ink_, 0, width * unit_);
  }
  void segment(Vec2 a, Vec2 b) const { list_.AddLine(at(to_px(a)), at(to_px(b)), ink_, 1.5F * unit_); }
  ImVec2 on_screen(Vec2 world) const { return at(to_px(world)); }
  void stroke(std::span<const Vec2> world) const {
    std::vector<ImVec2> points;
    points.reserve(world.size());
    for (const Vec2 p : world) points.push_back(at(to_px(p)));
    polyline(list_, points, ink_, true, 1.2F * unit_);
  }
  void frame(Vec2 low, Vec2 high) const {
    const ImVec2 a = at(to_px(low));
    const ImVec2 b = at(to_px(high));
    list_.AddRect({a.x, b.y}, {b.x, a.y}, to_imgui(color_, 0.5), 0.0F, 0, unit_);
  }
  void hairline(Vec2 a, Vec2 b) const { list_.AddLine(at(to_px(a)), at(to_px(b)), to_imgui(color_, 0.5), unit_); }
  /// Draws a square or a disk, filled if it is taken.
  void handle(Vec2 world, bool is_round, bool is_taken) const {
    const ImVec2 p = at(to_px(world));
    const float r = 4.0F * unit_;
    const ImU32 inside = is_taken ? ink_ : to_imgui(paper_);
    if (is_round) {
      list_.AddCircleFilled(p, r + unit_, inside);
      list_.AddCircle(p, r + unit_, ink_, 0, 1.2F * unit_);
    } else {
      list_.AddRectFilled({p.x - r, p.y - r}, {p.x + r, p.y + r}, inside);
      list_.AddRect({p.x - r, p.y - r}, {p.x + r, p.y + r}, ink_, 0.0F, 0, 1.2F * unit_);
    }
  }
  void saltire(Vec2 world) const {
    const ImVec2 p = at(to_px(world));
    const float arm = 4.0F * unit_;
    list_.AddLine({p.x - arm, p.y - arm}, {p.x + arm, p.y + arm}, ink_, 1.5F * unit_);
    list_.AddLine({p.x - arm, p.y + arm}, {p.x + arm, p.y - arm}, ink_, 1.5F * unit_);
  }
  /// Draws a cross and the kind of the snap target.
  void snap(const Snap& snap) const {
    const ImVec2 p = at(to_px(snap.place));
    const float arm = 8.0F * unit_;
    list_.AddLine({p.x - arm, p.y}, {p.x + arm, p.y}, ink_, 1.2F * unit_);
    list_.AddLine({p.x, p.y - arm}, {p.x, p.y + arm}, ink_, 1.2F * unit_);
    const ImVec2 words{p.x + arm + 4.0F * unit_, p.y + 4.0F * unit_};
    const ImVec2 size = ImGui::CalcTextSize(snap.name.data(), snap.name.data() + snap.name.size());
    const float margin = 3.0F * unit_;
    list_.AddRectFilled({words.x - margin, words.y}, {words.x + size.x + margin, words.y + size.y},
                        to_imgui(paper_, 0.8), margin);
    list_.AddText(words, ink_, snap.name.data(), snap.name.data() + snap.name.size());
  }
  void line(Vec2 world, Vec2 px) const { list_.AddLine(at(to_px(world)), at(here(px)), ink_, unit_); }
  void box(const Box2& px) const {
    list_.AddRectFilled(at(here(px.low)), at(here(px.high)), to_imgui(color_, 0.13));
    list_.AddRect(at(here(px.low)), at(here(px.high)), ink_, 0.0F, 0, unit_);
  }
  void faint_ring(Vec2 px, double radius_px) const {
    const double radius = radius_px * pointed().units_per_pixel() / camera_.units_per_pixel();
    if (radius < kLargestMarkPx)
      list_.AddCircle(at(here(px)), static_cast<float>(radius) * unit_, to_imgui(color_, 0.56), 0, 1.2F * unit_);
  }

 private:
  const render::Camera& pointed() const { return canvas_.view_at_pointer().camera(); }
  /// Converts a position in the pane of the pointer to this pane.
  Vec2 here(Vec2 px) const {
    return pointed() == camera_ ? px : to_px(pointed().to_world(canvas_.content_scale() * px));
  }
  Vec2 to_px(Vec2 world) const { return (1.0 / canvas_.content_scale()) * camera_.to_screen(world); }
  ImVec2 at(Vec2 px) const {
    return {shift_.x + static_cast<float>(px.x) * unit_, shift_.y + static_cast<float>(px.y) * unit_};
  }

  const Canvas& canvas_;
  const render::Camera& camera_;
  ImDrawList& list_;
  float unit_;
  ImVec2 shift_;
  Rgb color_;
  Rgb paper_;
  ImU32 ink_;
};

/// The part of the pane that no panel covers.
struct FreePart {
  ImVec2 begin;
  ImVec2 end;
};
FreePart free_part(const PointerMarks& marks) {
  const float unit = marks.gui.unit();
  const Insets& panels = marks.canvas.view().insets();
  const auto on_screen = [&](double px) { return static_cast<float>(px / marks.canvas.content_scale()) * unit; };
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 at = marks.pane.shift;
  return {{at.x + on_screen(panels.left), at.y + on_screen(panels.top)},
          {at.x + screen.x - on_screen(panels.right), at.y + screen.y - on_screen(panels.bottom)}};
}

}  // namespace

void PointerMarks::draw() const {
  const ToolFeedback feedback = canvas.tool().feedback();
  const Pen pen(*this);
  if (feedback.hovered != kNoSlot && document.is_alive(feedback.hovered))
    pen.ring(document.position(feedback.hovered));
  if (document.is_ball_alive(feedback.hovered_ball)) {
    const Disk& disk = document.disk(feedback.hovered_ball);
    pen.circle(disk, 2.0F);
    pen.ring(disk.center);
  }
  if (feedback.ball) {
    pen.circle(*feedback.ball, 1.5F);
    pen.dot(feedback.ball->center);
    if (feedback.marker_px) pen.line(feedback.ball->center, *feedback.marker_px);
  }
  if (feedback.ringed) pen.ring(*feedback.ringed);
  if (feedback.line) pen.segment(feedback.line->first, feedback.line->second);
  if (feedback.snap) pen.snap(*feedback.snap);
  if (feedback.lasso.size() > 1) pen.stroke(feedback.lasso);
  if (feedback.box_px) pen.box(*feedback.box_px);
  if (feedback.marker_px && feedback.ring_px > 0.0) pen.faint_ring(*feedback.marker_px, feedback.ring_px);
}

void PointerMarks::draw_measurement() const {
  const std::vector<Vec2> places = canvas.tool().feedback().measured;
  if (places.empty()) return;
  const Pen pen(*this);
  if (const auto circle = measured_circle(places)) {
    pen.circle(*circle, 1.0F);
    pen.dot(circle->center);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    pen.dot(places[i]);
    if (i > 0) pen.segment(places[i - 1], places[i]);
  }
  const PaperDrawing words = layout_words(measured_words(places), measure_on_canvas(gui), background);
  const float unit = gui.unit();
  const ImVec2 end = free_part(*this).end;
  const ImVec2 at = pen.on_screen(places.back());
  constexpr float kBeside = 16.0F;
  // Uses the other side of the point if there is too little room on this side.
  const auto beside = [&](float from, float size, float last) {
    const float after = from + kBeside * unit;
    return after + size <= last ? after : from - kBeside * unit - size;
  };
  paint_on_canvas(gui, words,
                  {beside(at.x, static_cast<float>(words.width) * unit, end.x),
                   beside(at.y, static_cast<float>(words.height) * unit, end.y)});
}

void PointerMarks::draw_frame() const {
  const auto mark = canvas.tool().feedback().frame;
  if (!mark) return;
  const Pen pen(*this);
  const HandleFrame frame(mark->box, canvas.content_scale() * pane.camera.units_per_pixel());
  const Box2& outline = frame.outline();
  pen.frame(outline.low, outline.high);
  const Vec2 stem{0.5 * (outline.low.x + outline.high.x), outline.high.y};
  pen.hairline(stem, frame.at(Handle::turn));
  for (std::size_t i = 0; i < kHandles; ++i) {
    const auto handle = static_cast<Handle>(i);
    if (frame.has(handle)) pen.handle(frame.at(handle), handle == Handle::turn, mark->taken == handle);
  }
  if (mark->words.empty()) return;
  // The words are below the lower right corner, or as near to it as is visible.
  const float unit = gui.unit();
  const FreePart part = free_part(*this);
  const ImVec2 corner = pen.on_screen({outline.high.x, outline.low.y});
  const ImVec2 size = ImGui::CalcTextSize(mark->words.c_str());
  const auto kept = [&](float place, float length, float begin, float end) {
    const float margin = 6 * unit;
    return std::max(begin + margin, std::min(place, end - margin - length));
  };
  const ImVec2 at(kept(corner.x + 10 * unit, size.x, part.begin.x, part.end.x),
                  kept(corner.y + 6 * unit, size.y, part.begin.y, part.end.y));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float margin = 3 * unit;
  list.AddRectFilled({at.x - margin, at.y}, {at.x + size.x + margin, at.y + size.y},
                     to_imgui(background.value_or(Rgb{255, 255, 255}), 0.8), margin);
  list.AddText(at, to_imgui(color), mark->words.c_str());
}

void PointerMarks::draw_waiting(const UpdateHold& hold) const {
  constexpr std::size_t kMost = 4000;
  const Pen pen(*this);
  std::size_t marks = 0;
  for (const auto& delta : hold.waiting()) {
    for (const SampleEdit& edit : delta->edits) {
      if (++marks > kMost) return;
      if (edit.kind == SampleEdit::Kind::remove)
        pen.saltire(edit.from);
      else if (const SampleSlot slot = document.slot_of(edit.id); slot != kNoSlot)
        pen.dot(document.position(slot));
    }
  }
}

}  // namespace mes
