// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/number_field.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "core/formula/formula.h"
#include "core/io/text_numbers.h"
#include "imgui.h"
#include "imgui_internal.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

/// What was typed into the field that has the keyboard. When Tab takes the keyboard on to a later field the library does
/// not report that this one was left.
template <class T>
struct Typed {
  ImGuiID field = 0;
  int frame = 0;  // in which the field was last drawn
  T value{};
};
template <class T>
Typed<T>& typed_last() {
  static Typed<T> one;
  return one;
}

/// What was refused, until its field has the keyboard again.
struct Refused {
  ImGuiID field = 0;
  int frame = 0;  // in which the field was last drawn
  std::string typed{};
};
Refused& refused() {
  static Refused one;
  return one;
}

bool is_usable(double value) {
  return std::isfinite(value);
}
bool is_usable(std::uint64_t) {
  return true;
}
bool is_usable(const std::string&) {
  return true;
}

/// `draw` returns true while the text of the field is another number than the one it was given, which it changes.
template <class T, class Draw>
bool left_with_another(const char* label, T& value, Draw draw) {
  Typed<T>& typed = typed_last<T>();
  const ImGuiID id = ImGui::GetID(label);
  const int frame = ImGui::GetFrameCount();
  // A field that was gone in between was not left, but lost.
  if (typed.field == id && frame > typed.frame + 1) typed = {};
  const bool had_keyboard = ImGui::GetActiveID() == id;
  T now = value;
  if (draw(now))
    typed = {id, frame, now};
  else if (had_keyboard && typed.field == id)
    typed = {};  // the old number again, by Esc or by hand
  if (typed.field != id) return false;
  typed.frame = frame;
  if (ImGui::GetActiveID() == id) return false;
  const T last = typed.value;
  typed = {};
  if (!is_usable(last) || last == value) return false;
  value = last;
  return true;
}

}  // namespace

bool number_field(const char* label, double& value, const char* format) {
  return left_with_another(label, value,
                           [&](double& now) { return ImGui::InputDouble(label, &now, 0.0, 0.0, format); });
}

bool number_field(const char* label, std::uint64_t& value) {
  return left_with_another(label, value,
                           [&](std::uint64_t& now) { return ImGui::InputScalar(label, ImGuiDataType_U64, &now); });
}

namespace {

/// With as many digits as the next field has room for, so that no exponent is cut off.
std::string fitted(double value, const std::string& exact) {
  const float room = ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x;
  std::string out = exact;
  for (int digits = 16; digits > 0 && ImGui::CalcTextSize(out.c_str()).x > room; --digits)
    out = fmt::format("{:.{}g}", value, digits);
  return out;
}

/// The next field has the keyboard, gets it with this frame, or has just lost it.
bool is_edited(const char* label) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiID id = ImGui::GetID(label);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + ImGui::CalcItemWidth(), at.y + ImGui::GetFrameHeight());
  return typed_last<std::string>().field == id || refused().field == id || context.ActiveId == id ||
         context.NavActivateId == id || context.NavActivateInputId == id || ImGui::IsMouseHoveringRect(at, end);
}

}  // namespace

bool exact_field(const char* label, double value, std::string& text) {
  text.clear();
  append_number(text, value);
  if (is_edited(label)) return formula_field(label, "", text);
  std::string shown = fitted(value, text);
  if (shown == text) return formula_field(label, "", text);
  ImGui::InputText(label, &shown);
  return false;
}

bool formula_field(const char* label, const char* hint, std::string& text) {
  const ImGuiID id = ImGui::GetID(label);
  const int frame = ImGui::GetFrameCount();
  Refused& last = refused();
  if (last.field == id && frame > last.frame + 1) last = {};
  if (last.field == id && ImGui::GetActiveID() != id) {
    // The keyboard comes with this frame or the next one.
    last.frame = frame;
    std::string now = last.typed;
    ImGui::InputTextWithHint(label, hint, &now);
    return false;
  }
  std::string left = text;
  const bool is_left = left_with_another(label, left, [&](std::string& now) {
    ImGui::InputTextWithHint(label, hint, &now);
    return now != text;
  });
  // Esc would leave what was refused, from which the editing began.
  if (!is_left || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) return false;
  text = std::move(left);
  return true;
}

bool number_field(const char* label, double& value, const char* format, std::string& refusal) {
  constexpr std::size_t kLongest = 64;
  std::array<char, kLongest> shown{};
  std::snprintf(shown.data(), shown.size(), format, value);
  std::string text = shown.data();
  if (!formula_field(label, "", text)) {
    if (ImGui::IsItemDeactivated()) refusal.clear();
    return false;
  }
  const auto number = number_of(text);
  if (!number) {
    refusal = number.error().message();
    stay_in_field(text);
    return false;
  }
  refusal.clear();
  value = *number;
  return true;
}

void stay_in_field(const std::string& typed) {
  const auto is_pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  if (!is_pressed(ImGuiKey_Enter) && !is_pressed(ImGuiKey_KeyPadEnter)) return;
  ImGui::SetKeyboardFocusHere(-1);
  refused() = {ImGui::GetItemID(), ImGui::GetFrameCount(), typed};
}

}  // namespace mes
