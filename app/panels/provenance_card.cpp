// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/provenance_card.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/ui/icons.h"
#include "app/ui/theme.h"
#include "app/ui/widgets.h"
#include "core/base/arc.h"
#include "core/draw/layer_descriptor.h"

namespace mes {
namespace {

constexpr double kReachPx = 7.0;
constexpr std::size_t kMostShapes = 4000;
constexpr double kMarginPx = 160.0;  // around what is shown by a click on its row
// ImGui draws circles as polygons of corners all around; a far too large one is left out.
constexpr double kLargestCirclePx = 2.0e4;

struct Look {
  Rgb color;
  float width;
  const char* heading;
};
Look look_of(ProvenanceRole role) {
  switch (role) {
    case ProvenanceRole::itself: return {palette::vermilion, 3.5F, ""};
    case ProvenanceRole::origin: return {palette::orange, 2.5F, "comes from"};
    case ProvenanceRole::product: return {palette::purple, 2.0F, "leads to"};
  }
  return {palette::black, 1.0F, ""};
}

// Of what has no end, its beginning.
Box2 box_of(const ProvenanceShape& shape) {
  const auto& v = shape.values;
  Box2 out;
  switch (shape.kind) {
    case PrimitiveKind::disk:
    case PrimitiveKind::circle: return bounding_box_of(Disk{{v[0], v[1]}, v[2]});
    case PrimitiveKind::arc:
      out.add(Vec2{v[3], v[4]});
      out.add(Vec2{v[5], v[6]});
      return out;
    case PrimitiveKind::triangle: out.add(Vec2{v[4], v[5]}); [[fallthrough]];
    case PrimitiveKind::segment: out.add(Vec2{v[2], v[3]}); [[fallthrough]];
    case PrimitiveKind::point:
    case PrimitiveKind::ray:
    case PrimitiveKind::line: out.add(Vec2{v[0], v[1]});
  }
  return out;
}

/// The part of a + t d, low <= t <= high, within the rectangle from (0, 0) to `size` and somewhat more.
struct Piece {
  Vec2 a, b;
};
std::optional<Piece> clipped(Vec2 a, Vec2 d, double low, double high, Vec2 size) {
  constexpr double kMargin = 20.0;
  const auto cut = [&](double from, double along, double least, double most) {
    if (along == 0.0) return from >= least && from <= most;
    const double t = (least - from) / along;
    const double u = (most - from) / along;
    low = std::max(low, std::min(t, u));
    high = std::min(high, std::max(t, u));
    return low <= high;
  };
  if (!cut(a.x, d.x, -kMargin, size.x + kMargin) || !cut(a.y, d.y, -kMargin, size.y + kMargin)) return std::nullopt;
  return Piece{a + low * d, a + high * d};
}

class Overlay {
 public:
  Overlay(const Gui& gui, const Canvas& canvas, ProvenanceRole role, bool is_dim)
      : camera_(canvas.view().camera()),
        unit_(gui.unit()),
        to_logical_(1.0 / canvas.content_scale()),
        look_(look_of(role)),
        role_(role),
        color_(to_imgui(look_.color, is_dim ? 0.25 : 1.0)),
        size_{static_cast<double>(ImGui::GetIO().DisplaySize.x), static_cast<double>(ImGui::GetIO().DisplaySize.y)},
        list_(*ImGui::GetBackgroundDrawList()) {}

  void draw(const ProvenanceShape& shape) const {
    const auto& v = shape.values;
    const Vec2 a{v[0], v[1]};
    switch (shape.kind) {
      case PrimitiveKind::point: return point(a);
      case PrimitiveKind::disk:
      case PrimitiveKind::circle: return circle(a, v[2]);
      case PrimitiveKind::arc: return arc({a, v[2], {v[3], v[4]}, {v[5], v[6]}});
      case PrimitiveKind::segment: return line(a, {v[2], v[3]});
      case PrimitiveKind::ray: return unbounded(a, {v[2], v[3]}, 0.0);
      case PrimitiveKind::line: return unbounded(a, {v[2], v[3]}, -std::numeric_limits<double>::infinity());
      case PrimitiveKind::triangle:
        line(a, {v[2], v[3]});
        line({v[2], v[3]}, {v[4], v[5]});
        line({v[4], v[5]}, a);
        return;
    }
  }

 private:
  Vec2 on_screen(Vec2 world) const { return (to_logical_ * static_cast<double>(unit_)) * camera_.to_screen(world); }
  static ImVec2 to_im(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
  // A dot, a ring, a square: distinguishable without colours.
  void point(Vec2 world) const {
    const Vec2 p = on_screen(world);
    if (!(std::abs(p.x) < 1e5 && std::abs(p.y) < 1e5)) return;
    const ImVec2 at = to_im(p);
    const float r = 5.0F * unit_;
    switch (role_) {
      case ProvenanceRole::itself: list_.AddCircleFilled(at, r, color_); break;
      case ProvenanceRole::origin: list_.AddCircle(at, r + unit_, color_, 0, look_.width * unit_); break;
      case ProvenanceRole::product:
        list_.AddRect({at.x - r, at.y - r}, {at.x + r, at.y + r}, color_, 0.0F, 0, look_.width * unit_);
        break;
    }
  }
  void circle(Vec2 center, double radius) const {
    const double r = radius / camera_.units_per_pixel() * to_logical_ * static_cast<double>(unit_);
    const int corners = static_cast<int>(std::clamp(r, 48.0, 720.0));
    if (r < kLargestCirclePx)
      list_.AddCircle(to_im(on_screen(center)), static_cast<float>(r), color_, corners, look_.width * unit_);
  }
  void stroke(const std::optional<Piece>& piece) const {
    if (piece) list_.AddLine(to_im(piece->a), to_im(piece->b), color_, look_.width * unit_);
  }
  void arc(const Arc& arc) const {
    const double r = arc.radius / camera_.units_per_pixel() * to_logical_ * static_cast<double>(unit_);
    if (!(r < kLargestCirclePx)) return line(arc.from, arc.to);
    // Angles of the screen run the other way.
    const Vec2 start = arc.from - arc.center;
    const auto from = static_cast<float>(-std::atan2(start.y, start.x));
    list_.PathArcTo(to_im(on_screen(arc.center)), static_cast<float>(r), from - static_cast<float>(sweep_of(arc)),
                    from, static_cast<int>(std::clamp(r, 24.0, 360.0)));
    list_.PathStroke(color_, 0, look_.width * unit_);
  }
  void line(Vec2 a, Vec2 b) const {
    const Vec2 from = on_screen(a);
    stroke(clipped(from, on_screen(b) - from, 0.0, 1.0, size_));
  }
  void unbounded(Vec2 a, Vec2 d, double low) const {
    stroke(clipped(on_screen(a), {d.x, -d.y}, low, std::numeric_limits<double>::infinity(), size_));
  }

  const render::Camera& camera_;
  float unit_;
  double to_logical_;
  Look look_;
  ProvenanceRole role_;
  ImU32 color_;
  Vec2 size_;
  ImDrawList& list_;
};

}  // namespace

void ProvenanceCard::ask(Engine& engine, const LayerStack& layers, const Pointer& pointer, const Editor& editor) {
  ProvenanceQuestion question{++ticket_, pointer.world, kReachPx * pointer.units_per_px, layers.visible_layers()};
  std::ranges::reverse(question.layers);
  document_revision_ = editor.document().revision();
  selection_revision_ = editor.selection().revision();
  answer_.reset();
  engine.ask(std::move(question));
}

void ProvenanceCard::take(std::unique_ptr<Provenance> answer) {
  if (!answer || answer->ticket != ticket_) return;
  answer_ = answer->lines.empty() ? nullptr : std::move(answer);
  pointed_at_ = 0;
}

bool ProvenanceCard::clear() {
  ++ticket_;  // an answer on its way comes too late
  return std::exchange(answer_, nullptr) != nullptr;
}

void ProvenanceCard::draw_shapes(const Gui& gui, const Canvas& canvas) const {
  std::size_t shapes = 0;
  // The thing itself last, on top of the others.
  for (std::size_t i = answer_->lines.size(); i-- > 0;) {
    const ProvenanceLine& line = answer_->lines[i];
    const Overlay overlay(gui, canvas, line.role, pointed_at_ != 0 && pointed_at_ != i + 1);
    for (const ProvenanceShape& shape : line.shapes)
      if (++shapes <= kMostShapes) overlay.draw(shape);
  }
}

bool ProvenanceCard::draw_head(const Gui& gui, float width) {
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::InvisibleButton("head", {width - 40 * unit, ImGui::GetTextLineHeight()});
  if (ImGui::IsItemActive()) {
    moved_.x += ImGui::GetIO().MouseDelta.x;
    moved_.y += ImGui::GetIO().MouseDelta.y;
  }
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  tooltip(gui, "Drag to move this card");
  ImGui::SetCursorPos(at);
  ImGui::TextDisabled("%s", std::string(layer_descriptors()[answer_->layer].name).c_str());
  ImGui::SameLine(width - 30 * unit);
  const bool is_closed = icon_button("close", Icon::close, ImGui::GetTextLineHeight());
  tooltip(gui, "Close (Esc)");
  return is_closed;
}

const ProvenanceLine* ProvenanceCard::draw_lines(const Gui& gui, float width) {
  const float unit = gui.unit();
  const ProvenanceLine* clicked = nullptr;
  std::size_t pointed_at = 0;
  ProvenanceRole heading = ProvenanceRole::itself;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < answer_->lines.size(); ++i) {
    const ProvenanceLine& line = answer_->lines[i];
    const Look look = look_of(line.role);
    if (line.role != heading) {
      heading = line.role;
      ImGui::Dummy({0, 2 * unit});
      ImGui::TextDisabled("%s", look.heading);
    }
    const float wrap = width - 40 * unit;
    const float height = ImGui::CalcTextSize(line.text.c_str(), nullptr, false, wrap).y;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(i));
    const bool is_clicked = ImGui::InvisibleButton("line", {width - 20 * unit, height});
    ImGui::PopID();
    if (ImGui::IsItemHovered()) {
      pointed_at = i + 1;
      if (!line.shapes.empty())
        list.AddRectFilled({at.x, at.y - 1 * unit}, {at.x + width - 20 * unit, at.y + height + 1 * unit},
                           gui.colors().accent_faint, 3 * unit);
    }
    if (!line.shapes.empty()) tooltip(gui, "Click to show where it is");
    if (is_clicked && !line.shapes.empty()) clicked = &line;
    const float r = 4.0F * unit;
    const ImVec2 mark{at.x + 6 * unit, at.y + 0.5F * ImGui::GetTextLineHeight()};
    const ImU32 color = to_imgui(look.color);
    if (line.role == ProvenanceRole::itself) list.AddCircleFilled(mark, r, color);
    if (line.role == ProvenanceRole::origin) list.AddCircle(mark, r, color, 0, 2 * unit);
    if (line.role == ProvenanceRole::product)
      list.AddRect({mark.x - r, mark.y - r}, {mark.x + r, mark.y + r}, color, 0.0F, 0, 2 * unit);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + 18 * unit, at.y}, gui.colors().text,
                 line.text.c_str(), nullptr, wrap);
  }
  pointed_at_ = pointed_at;
  return clicked;
}

void ProvenanceCard::draw(const Gui& gui, Canvas& canvas, const Editor& editor, ImVec2 corner, ImVec2 room) {
  const bool is_of_now =
      editor.document().revision() == document_revision_ && editor.selection().revision() == selection_revision_;
  if (answer_ && !is_of_now) clear();
  if (!answer_) return;
  draw_shapes(gui, canvas);
  const float unit = gui.unit();
  const float width = std::min(390 * unit, room.x);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  // Its head stays in the window.
  moved_.x = std::clamp(moved_.x, -corner.x, std::max(-corner.x, screen.x - width - corner.x));
  moved_.y = std::clamp(moved_.y, 60 * unit - corner.y, std::max(60 * unit - corner.y, screen.y - corner.y));
  ImGui::SetNextWindowPos({corner.x + moved_.x, corner.y + moved_.y}, ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, room.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 8 * unit});
  ImGui::Begin("##provenance", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const bool is_closed = draw_head(gui, width);
  const ProvenanceLine* const followed = draw_lines(gui, width);
  ImGui::End();
  ImGui::PopStyleVar();
  if (followed != nullptr) {
    Box2 box;
    for (const ProvenanceShape& shape : followed->shapes) box.add(box_of(shape));
    canvas.view().fit(box, kMarginPx * canvas.content_scale());
  }
  if (is_closed) clear();
}

}  // namespace mes
