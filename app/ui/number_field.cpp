// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/number_field.h"

#include <cmath>

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
  static Typed<T> typed;
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

bool formula_field(const char* label, const char* hint, std::string& text) {
  return left_with_another(label, text, [&](std::string& now) {
    ImGui::InputTextWithHint(label, hint, &now);
    return now != text;
  });
}

}  // namespace mes
