// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/presenter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/ui/screen/theme.h"

namespace mes {
namespace {

struct Span {
  double full;   // seconds
  double fades;  // seconds after that
};
constexpr Span kPointer{1.5, 0.5};
constexpr Span kKey{2.5, 0.6};

// Fades from 1 to 0.
double strength(const std::optional<double>& at, Span span, double now) {
  return at ? std::clamp(1.0 - (now - *at - span.full) / span.fades, 0.0, 1.0) : 0.0;
}

std::optional<double> due(const std::optional<double>& at, Span span, double now) {
  if (!at || now >= *at + span.full + span.fades) return std::nullopt;
  return std::max(0.0, *at + span.full - now);
}

ImU32 faded(ImU32 color, double strength) {
  const auto alpha = static_cast<ImU32>(std::lround(strength * static_cast<double>(color >> IM_COL32_A_SHIFT)));
  return (color & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

}  // namespace

void Presenter::set_on(bool on) {
  is_on_ = on;
  end_marks();
}

void Presenter::end_marks() {
  key_at_.reset();
  pointer_at_.reset();
}

void Presenter::note_key(std::string key, std::string meaning, bool leads_to_slide) {
  shows_slide_ = leads_to_slide;
  key_ = std::move(key);
  meaning_ = std::move(meaning);
  has_pressed_ = true;
}

bool Presenter::hides_pointer(double now) const {
  return is_on_ && strength(pointer_at_, kPointer, now) <= 0.0;
}

std::optional<double> Presenter::next_due(double now) const {
  if (!is_on_) return std::nullopt;
  const auto pointer = due(pointer_at_, kPointer, now);
  const auto key = due(key_at_, kKey, now);
  if (!pointer || !key) return pointer ? pointer : key;
  return std::min(*pointer, *key);
}

void Presenter::draw(const Gui& gui, const std::string& bundle, const NoteRoom& room, double now) {
  if (std::exchange(has_pressed_, false)) {
    key_at_ = now;
    place_.reset();
  }
  if (std::exchange(has_moved_, false)) pointer_at_ = now;
  if (!is_on_) return;
  const float unit = gui.unit();
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  // The arrow would lie within the circle, and stay after it has faded. Dialogs and menus keep their pointer.
  if (!ImGui::GetIO().WantCaptureMouse) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  if (const double shown = strength(pointer_at_, kPointer, now); shown > 0.0) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    list.AddCircleFilled(at, 22 * unit, to_imgui(palette::vermilion, 0.3 * shown), 48);
    list.AddCircle(at, 22 * unit, to_imgui(palette::vermilion, 0.9 * shown), 48, 3 * unit);
  }
  const double shown = strength(key_at_, kKey, now);
  if (shown <= 0.0) return;
  const float size = 1.5F * ImGui::GetFontSize();
  const std::string text = bundle.empty() ? meaning_ : bundle;
  const ImVec2 key = gui.bold()->CalcTextSizeA(size, 1e9F, 0.0F, key_.c_str());
  const ImVec2 words = ImGui::GetFont()->CalcTextSizeA(size, 1e9F, 0.0F, text.c_str());
  const float pad = 12 * unit;
  const ImVec2 box(key.x + words.x + 4 * pad, key.y + 2 * pad);
  if (!place_)
    place_ = least_hiding(room, {box.x, box.y},
                          {{0.5F, 1.0F}, {0.0F, 1.0F}, {1.0F, 1.0F}, {0.5F, 0.0F}, {0.0F, 0.0F}, {1.0F, 0.0F}});
  const Vec2 corner = place_->corner(room.area, {box.x, box.y});
  const ImVec2 low(static_cast<float>(corner.x), static_cast<float>(corner.y));
  const ImVec2 high(low.x + box.x, low.y + box.y);
  const ThemeColors& colors = gui.colors();
  list.AddRectFilled(low, high, faded(colors.raised, shown), 8 * unit);
  list.AddRect(low, high, faded(colors.border, shown), 8 * unit);
  list.AddText(gui.bold(), size, {low.x + pad, low.y + pad}, faded(colors.accent, shown), key_.c_str());
  list.AddText(ImGui::GetFont(), size, {low.x + 3 * pad + key.x, low.y + pad}, faded(colors.text, shown),
               text.c_str());
}

}  // namespace mes
