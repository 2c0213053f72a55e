// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/icons.h"

#include <cmath>
#include <span>
#include <utility>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

// Icons are designed on a 24 x 24 grid.
class Pen {
 public:
  Pen(ImDrawList& list, ImVec2 at, float size, ImU32 color)
      : list_(list), at_(at), unit_(size / 24.0F), color_(color), width_(std::max(1.0F, 1.7F * unit_)) {}

  ImVec2 p(float x, float y) const { return {at_.x + x * unit_, at_.y + y * unit_}; }
  void line(float x1, float y1, float x2, float y2) { list_.AddLine(p(x1, y1), p(x2, y2), color_, width_); }
  void dot(float x, float y, float r) { list_.AddCircleFilled(p(x, y), r * unit_, color_); }
  void ring(float x, float y, float r) { list_.AddCircle(p(x, y), r * unit_, color_, 0, width_); }
  void arc(float x, float y, float r, float from, float to) {
    list_.PathArcTo(p(x, y), r * unit_, from, to);
    list_.PathStroke(color_, 0, width_);
  }
  void curve(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d) { list_.AddBezierCubic(a, b, c, d, color_, width_); }
  void outline(std::span<const ImVec2> points) {
    list_.AddPolyline(points.data(), static_cast<int>(points.size()), color_, ImDrawFlags_Closed, width_);
  }
  void fill(std::span<const ImVec2> points) {
    list_.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), color_);
  }

 private:
  ImDrawList& list_;
  ImVec2 at_;
  float unit_;
  ImU32 color_;
  float width_;
};

void draw_turn(Pen& pen, bool backwards) {
  const auto x = [backwards](float value) { return backwards ? value : 24.0F - value; };
  const float pi = 3.14159265F;
  // The shaft ends where the head begins, because both may be translucent.
  pen.arc(12.0F, 13.5F, 6.0F, backwards ? -pi * 0.72F : -pi * 0.28F, backwards ? pi * 0.55F : -pi * 1.55F);
  ImVec2 head[] = {pen.p(x(3.6F), 12.6F), pen.p(x(4.6F), 5.2F), pen.p(x(10.2F), 10.2F)};
  // Dear ImGui smooths the edges of clockwise polygons only.
  if (!backwards) std::swap(head[0], head[1]);
  pen.fill(head);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 color) {
  Pen pen(list, at, size, color);
  switch (icon) {
    case Icon::select: {
      const ImVec2 arrow[] = {pen.p(6, 3.5F),   pen.p(6, 18.5F),     pen.p(9.8F, 15.2F), pen.p(12.4F, 20.8F),
                              pen.p(15, 19.6F), pen.p(12.5F, 14.2F), pen.p(17.6F, 13.8F)};
      pen.outline(arrow);
      break;
    }
    case Icon::insert:
      pen.dot(9, 14, 3.4F);
      pen.line(17, 4, 17, 12);
      pen.line(13, 8, 21, 8);
      break;
    case Icon::spray:
      pen.dot(4.5F, 17.5F, 1.9F);
      pen.dot(8.2F, 13.4F, 1.9F);
      pen.dot(12.6F, 12.6F, 1.9F);
      pen.dot(16.6F, 10.6F, 1.9F);
      pen.dot(19.6F, 6.6F, 1.9F);
      break;
    case Icon::brush:
      pen.ring(14.5F, 14.5F, 6.0F);
      pen.dot(4.5F, 8.5F, 1.9F);
      pen.dot(9.5F, 4.5F, 1.9F);
      pen.line(12.2F, 14.5F, 16.8F, 14.5F);
      break;
    case Icon::ball:
      // The plus of `insert`, beside a disk with its centre.
      pen.ring(9.5F, 14.5F, 7);
      pen.dot(9.5F, 14.5F, 1.7F);
      pen.line(19, 2.5F, 19, 9.5F);
      pen.line(15.5F, 6, 22.5F, 6);
      break;
    case Icon::annotate:
      // The letter T, and a line that leads to it.
      pen.line(9, 4, 20.5F, 4);
      pen.line(14.75F, 4, 14.75F, 15);
      pen.line(4, 20, 10.5F, 13.5F);
      pen.dot(4.5F, 19.5F, 2.0F);
      break;
    case Icon::measure:
      pen.line(4, 20, 20, 4);
      pen.line(2, 16, 8, 22);
      pen.line(16, 2, 22, 8);
      pen.line(9, 12, 12, 15);
      break;
    case Icon::fit:
      for (const float sx : {0.0F, 1.0F}) {
        for (const float sy : {0.0F, 1.0F}) {
          const auto x = [sx](float v) { return sx == 0.0F ? v : 24.0F - v; };
          const auto y = [sy](float v) { return sy == 0.0F ? v : 24.0F - v; };
          pen.line(x(4), y(4), x(9), y(4));
          pen.line(x(4), y(4), x(4), y(9));
        }
      }
      pen.ring(12, 12, 3.2F);
      break;
    case Icon::undo: draw_turn(pen, true); break;
    case Icon::redo: draw_turn(pen, false); break;
    case Icon::eye:
      pen.curve(pen.p(2.5F, 12), pen.p(7, 4.5F), pen.p(17, 4.5F), pen.p(21.5F, 12));
      pen.curve(pen.p(2.5F, 12), pen.p(7, 19.5F), pen.p(17, 19.5F), pen.p(21.5F, 12));
      pen.dot(12, 12, 3.2F);
      break;
    case Icon::eye_closed: pen.curve(pen.p(2.5F, 11), pen.p(7, 17.5F), pen.p(17, 17.5F), pen.p(21.5F, 11)); break;
    case Icon::close:
      pen.line(6.5F, 6.5F, 17.5F, 17.5F);
      pen.line(17.5F, 6.5F, 6.5F, 17.5F);
      break;
    case Icon::grip:
      for (const float x : {9.5F, 14.5F})
        for (const float y : {6.5F, 12.0F, 17.5F}) pen.dot(x, y, 1.3F);
      break;
    case Icon::help: {
      pen.arc(12, 9, 4, -3.3F, 0.9F);
      pen.line(14.4F, 12.2F, 12, 15);
      pen.dot(12, 19, 1.4F);
      break;
    }
    case Icon::layers: {
      const ImVec2 top[] = {pen.p(12, 4), pen.p(21, 9), pen.p(12, 14), pen.p(3, 9)};
      pen.outline(top);
      pen.line(3, 13.5F, 12, 18.5F);
      pen.line(12, 18.5F, 21, 13.5F);
      break;
    }
    case Icon::play: {
      const ImVec2 head[] = {pen.p(8, 5.5F), pen.p(18.5F, 12), pen.p(8, 18.5F)};
      pen.fill(head);
      break;
    }
    case Icon::pause:
      for (const float x : {7.5F, 13.5F}) {
        const ImVec2 bar[] = {pen.p(x, 6), pen.p(x + 3, 6), pen.p(x + 3, 18), pen.p(x, 18)};
        pen.fill(bar);
      }
      break;
    case Icon::record:
      pen.ring(12, 12, 8.5F);
      pen.dot(12, 12, 4.6F);
      break;
    case Icon::snapshot: {
      const ImVec2 body[] = {pen.p(3.5F, 7.5F), pen.p(8, 7.5F),     pen.p(9.5F, 5),   pen.p(14.5F, 5),
                             pen.p(16, 7.5F),   pen.p(20.5F, 7.5F), pen.p(20.5F, 19), pen.p(3.5F, 19)};
      pen.outline(body);
      pen.ring(12, 13, 3.4F);
      break;
    }
    case Icon::more:
      for (const float x : {6.0F, 12.0F, 18.0F}) pen.dot(x, 12, 1.7F);
      break;
    case Icon::parameters:
      for (const auto& [y, x] : {std::pair{6.5F, 15.0F}, std::pair{12.0F, 8.5F}, std::pair{17.5F, 13.0F}}) {
        pen.line(4, y, x - 2.4F, y);
        pen.line(x + 2.4F, y, 20, y);
        pen.ring(x, y, 2.4F);
      }
      break;
    case Icon::play_back: {
      const ImVec2 head[] = {pen.p(18, 5), pen.p(18, 19), pen.p(6, 12)};
      pen.fill(head);
      break;
    }
    case Icon::step_forward: {
      pen.line(17.5F, 6, 17.5F, 18);
      const ImVec2 head[] = {pen.p(7, 6), pen.p(15, 12), pen.p(7, 18)};
      pen.fill(head);
      break;
    }
    case Icon::step_back: {
      pen.line(6.5F, 6, 6.5F, 18);
      const ImVec2 head[] = {pen.p(17, 18), pen.p(9, 12), pen.p(17, 6)};
      pen.fill(head);
      break;
    }
    case Icon::to_start: {
      pen.line(4.5F, 6, 4.5F, 18);
      const ImVec2 first[] = {pen.p(12.5F, 18), pen.p(6, 12), pen.p(12.5F, 6)};
      const ImVec2 second[] = {pen.p(20, 18), pen.p(13.5F, 12), pen.p(20, 6)};
      pen.fill(first);
      pen.fill(second);
      break;
    }
    case Icon::stop: {
      const ImVec2 square[] = {pen.p(7, 7), pen.p(17, 7), pen.p(17, 17), pen.p(7, 17)};
      pen.fill(square);
      break;
    }
    case Icon::evolution: {
      // A rough curve that becomes a smooth one.
      const std::array<std::pair<float, float>, 7> rough{
          {{3, 8}, {6, 3.5F}, {9, 7.5F}, {12, 3.5F}, {15, 7.5F}, {18, 3.5F}, {21, 8}}};
      for (std::size_t i = 1; i < rough.size(); ++i)
        pen.line(rough[i - 1].first, rough[i - 1].second, rough[i].first, rough[i].second);
      const ImVec2 head[] = {pen.p(8.8F, 11.5F), pen.p(15.2F, 11.5F), pen.p(12, 15.2F)};
      pen.fill(head);
      pen.curve(pen.p(3, 21), pen.p(9, 16.5F), pen.p(15, 16.5F), pen.p(21, 21));
      break;
    }
    case Icon::bundles: {
      // Cards, one behind the other.
      const ImVec2 card[] = {pen.p(3.5F, 9), pen.p(16, 9), pen.p(16, 20), pen.p(3.5F, 20)};
      pen.outline(card);
      pen.line(7.5F, 4.5F, 20.5F, 4.5F);
      pen.line(20.5F, 4.5F, 20.5F, 15.5F);
      break;
    }
    case Icon::selection: {
      // A frame with handles.
      const ImVec2 frame[] = {pen.p(5, 5), pen.p(19, 5), pen.p(19, 19), pen.p(5, 19)};
      pen.outline(frame);
      for (const float x : {5.0F, 19.0F})
        for (const float y : {5.0F, 19.0F}) pen.dot(x, y, 2.5F);
      pen.dot(12, 12, 1.9F);
      break;
    }
    case Icon::curves:
      pen.curve(pen.p(3.5F, 17), pen.p(7.5F, -1), pen.p(16.5F, 25), pen.p(20.5F, 7));
      pen.dot(3.8F, 16.8F, 2.2F);
      pen.dot(20.2F, 7.2F, 2.2F);
      break;
    case Icon::sampling:
      // A curve through samples that are closer in the bend.
      pen.arc(12, 16, 8.5F, 3.14159265F, 6.2831853F);
      for (const auto& [x, y] : {std::pair{3.5F, 16.0F}, std::pair{7.1F, 9.1F}, std::pair{12.0F, 7.5F},
                                 std::pair{16.9F, 9.1F}, std::pair{20.5F, 16.0F}})
        pen.dot(x, y, 2.2F);
      break;
    case Icon::branches:
      pen.line(12, 20.5F, 12, 13);
      pen.line(12, 13, 5, 6);
      pen.line(12, 13, 19, 6);
      pen.dot(12, 13, 2.2F);
      pen.ring(4.5F, 5.5F, 2.0F);
      pen.ring(19.5F, 5.5F, 2.0F);
      break;
    case Icon::persistence:
      // Births to the right, deaths upwards, above the diagonal.
      pen.line(4, 3.5F, 4, 20);
      pen.line(4, 20, 20.5F, 20);
      pen.line(4, 20, 20, 4);
      pen.dot(8, 6.5F, 2.0F);
      pen.dot(12.5F, 5.5F, 2.0F);
      pen.dot(8, 12, 2.0F);
      break;
    case Icon::experiments:
      // A flask with a liquid.
      pen.line(9.5F, 3.5F, 9.5F, 9.5F);
      pen.line(14.5F, 3.5F, 14.5F, 9.5F);
      pen.line(8, 3.5F, 16, 3.5F);
      pen.line(9.5F, 9.5F, 4.5F, 20);
      pen.line(14.5F, 9.5F, 19.5F, 20);
      pen.line(4.5F, 20, 19.5F, 20);
      pen.line(7, 15.5F, 17, 15.5F);
      break;
    case Icon::lesson: {
      // A slide on a stand, with a line of text and a list.
      const ImVec2 slide[] = {pen.p(3, 4.5F), pen.p(21, 4.5F), pen.p(21, 16), pen.p(3, 16)};
      pen.outline(slide);
      pen.line(6.5F, 8.5F, 14, 8.5F);
      pen.line(6.5F, 12, 17.5F, 12);
      pen.line(12, 16, 8.5F, 20.5F);
      pen.line(12, 16, 15.5F, 20.5F);
      break;
    }
    case Icon::log:
      for (const auto& [y, end] : {std::pair{6.0F, 20.0F}, std::pair{12.0F, 17.0F}, std::pair{18.0F, 19.0F}}) {
        pen.dot(4.8F, y, 1.5F);
        pen.line(9, y, end, y);
      }
      break;
    case Icon::pin:
    case Icon::pinned: {
      const ImVec2 head[] = {pen.p(8.5F, 4), pen.p(15.5F, 4), pen.p(15.5F, 12.5F), pen.p(8.5F, 12.5F)};
      if (icon == Icon::pinned)
        pen.fill(head);
      else
        pen.outline(head);
      pen.line(5.5F, 13, 18.5F, 13);
      pen.line(12, 13, 12, 20.5F);
      break;
    }
    case Icon::star:
    case Icon::star_on: {
      ImVec2 points[10];
      for (int i = 0; i < 10; ++i) {
        const float turn = 3.14159265F * (0.2F * static_cast<float>(i) - 0.5F);
        const float away = i % 2 == 0 ? 9.5F : 4.2F;
        points[i] = pen.p(12 + away * std::cos(turn), 12.6F + away * std::sin(turn));
      }
      if (icon == Icon::star) {
        pen.outline(points);
        break;
      }
      // A star is not convex: five kites from its middle are.
      for (int i = 0; i < 10; i += 2) {
        const ImVec2 kite[] = {pen.p(12, 12.6F), points[(i + 9) % 10], points[i], points[i + 1]};
        pen.fill(kite);
      }
      break;
    }
    case Icon::enlarge:
      // Two arrows to opposite corners.
      pen.line(13.5F, 10.5F, 19.5F, 4.5F);
      pen.line(14, 4.5F, 19.5F, 4.5F);
      pen.line(19.5F, 4.5F, 19.5F, 10);
      pen.line(10.5F, 13.5F, 4.5F, 19.5F);
      pen.line(4.5F, 14, 4.5F, 19.5F);
      pen.line(4.5F, 19.5F, 10, 19.5F);
      break;
    case Icon::statistics:
      pen.line(4, 20, 20.5F, 20);
      for (const auto& [x, y] : {std::pair{7.0F, 12.0F}, std::pair{12.0F, 5.0F}, std::pair{17.0F, 9.0F}}) {
        pen.line(x - 1, 19, x - 1, y);
        pen.line(x + 1, 19, x + 1, y);
        pen.line(x - 1, y, x + 1, y);
      }
      break;
  }
}

void draw_fold(ImDrawList& list, ImVec2 middle, float size, bool is_unfolded, ImU32 color) {
  if (is_unfolded)
    list.AddTriangleFilled({middle.x - size, middle.y - 0.5F * size}, {middle.x + size, middle.y - 0.5F * size},
                           {middle.x, middle.y + 0.7F * size}, color);
  else
    list.AddTriangleFilled({middle.x - 0.5F * size, middle.y - size}, {middle.x + 0.7F * size, middle.y},
                           {middle.x - 0.5F * size, middle.y + size}, color);
}

bool icon_button(const char* id, Icon icon, float size, ButtonLook look, bool enabled) {
  ImGui::BeginDisabled(!enabled);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = hit_area(id, {size, size});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  if (look == ButtonLook::chosen)
    list.AddRectFilled(at, {at.x + size, at.y + size}, ImGui::GetColorU32(ImGuiCol_CheckMark), rounding);
  else if (look == ButtonLook::on || ImGui::IsItemHovered())
    list.AddRectFilled(at, {at.x + size, at.y + size}, ImGui::GetColorU32(ImGuiCol_Header), rounding);
  const float inset = 0.16F * size;
  ImGuiCol color = ImGuiCol_Text;
  if (look == ButtonLook::chosen) color = ImGuiCol_WindowBg;
  if (look == ButtonLook::on) color = ImGuiCol_CheckMark;
  draw_icon(list, icon, {at.x + inset, at.y + inset}, size - 2 * inset, ImGui::GetColorU32(color));
  ImGui::EndDisabled();
  return clicked;
}

bool choice_button(const char* label, bool chosen, float width) {
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::PushStyleColor(ImGuiCol_Button, chosen ? style.Colors[ImGuiCol_Header] : ImVec4());
  ImGui::PushStyleColor(ImGuiCol_Text, style.Colors[chosen ? ImGuiCol_CheckMark : ImGuiCol_TextDisabled]);
  const bool clicked = ImGui::Button(label, {width, 0.0F});
  ImGui::PopStyleColor(2);
  return clicked;
}

}  // namespace mes
