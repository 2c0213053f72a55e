// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/number_field.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

#include "app/ui/widgets/paragraph.h"
#include "core/io/text/text_numbers.h"
#include "imgui.h"
#include "imgui_internal.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

/// The text typed into the field that has the keyboard. When Tab moves the keyboard to a later field, Dear ImGui does
/// not report that this one was left.
struct Typed {
  ImGuiID field = 0;
  int frame = 0;  // frame in which the field was last drawn
  std::string value{};
};
Typed& typed_last() {
  static Typed one;
  return one;
}

/// A refused text, kept until its field has the keyboard again.
struct Refused {
  ImGuiID field = 0;
  int frame = 0;  // frame in which the field was last drawn
  std::string typed{};
};
Refused& refused() {
  static Refused one;
  return one;
}

/// True if a field that is drawn now, and was last drawn in that frame, was missing in between.
bool was_gone(int last_frame) {
  const int frame = ImGui::GetFrameCount();
  return frame < last_frame || frame > last_frame + 1;
}

/// `draw` returns true while the text in the field differs from the given one, and then changes that.
template <class Draw>
bool left_with_another(const char* label, std::string& value, Draw draw) {
  Typed& typed = typed_last();
  const ImGuiID id = ImGui::GetID(label);
  const int frame = ImGui::GetFrameCount();
  // A field that was missing in between was not left, but lost.
  if (typed.field == id && was_gone(typed.frame)) typed = {};
  const bool had_keyboard = ImGui::GetActiveID() == id;
  std::string now = value;
  if (draw(now))
    typed = {id, frame, now};
  else if (had_keyboard && typed.field == id)
    typed = {};  // the old number again, by Esc or by typing
  if (typed.field != id) return false;
  typed.frame = frame;
  if (ImGui::GetActiveID() == id) return false;
  std::string last = std::exchange(typed, {}).value;
  if (last == value) return false;
  value = std::move(last);
  return true;
}

/// Uses as many digits as the next field has room for, so that no exponent is cut off.
std::string fitted(double value, const std::string& exact) {
  const float room = ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x;
  std::string out = exact;
  for (int digits = 16; digits > 0 && ImGui::CalcTextSize(out.c_str()).x > room; --digits)
    out = fmt::format("{:.{}g}", value, digits);
  return out;
}

/// True if the next field has the keyboard, gets it in this frame, or has just lost it.
bool is_edited(const char* label) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiID id = ImGui::GetID(label);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + ImGui::CalcItemWidth(), at.y + ImGui::GetFrameHeight());
  return typed_last().field == id || refused().field == id || context.ActiveId == id || context.NavActivateId == id ||
         context.NavActivateInputId == id || ImGui::IsMouseHoveringRect(at, end);
}

/// A complaint about a number, shown at its field.
struct Complaint {
  ImGuiID field = 0;
  int frame = 0;  // frame in which the field was last drawn
  std::string reason{};
  std::optional<int> left_at{};  // frame in which the user left the field for another item: the old number is back
};
Complaint& complaint() {
  static Complaint one;
  return one;
}

bool is_something_pressed() {
  const ImGuiIO& io = ImGui::GetIO();
  return std::ranges::any_of(io.KeysDownDuration, [](float seconds) { return seconds == 0.0F; }) ||
         std::ranges::any_of(io.MouseClicked, std::identity{});
}

/// Draws a border around the last field, and the reason below it, or above if there is no room.
void show(const std::string& reason) {
  if (!ImGui::IsItemVisible()) return;
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 field = ImGui::GetItemRectMin();
  const ImVec2 field_end = ImGui::GetItemRectMax();
  const ImVec2 padding = style.FramePadding;
  const float wrap = std::min(22.0F * ImGui::GetFontSize(), screen.x - 2 * padding.x);
  const std::string lines = broken_lines(reason, wrap);
  const ImVec2 text = ImGui::CalcTextSize(lines.c_str());
  const ImVec2 size(text.x + 2 * padding.x, text.y + 2 * padding.y);
  const bool is_below = field_end.y + size.y <= screen.y;
  const ImVec2 at(std::max(0.0F, std::min(field.x, screen.x - size.x)), is_below ? field_end.y : field.y - size.y);
  const ImVec2 end(at.x + size.x, at.y + size.y);
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_PlotLinesHovered);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRect(field, field_end, color, style.FrameRounding);
  list.AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_PopupBg), style.FrameRounding);
  list.AddRect(at, end, color, style.FrameRounding);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + padding.x, at.y + padding.y}, color, lines.c_str());
}

bool text_field(const char* label, const char* hint, std::string& text, ImGuiInputTextFlags flags) {
  const ImGuiID id = ImGui::GetID(label);
  const int frame = ImGui::GetFrameCount();
  Refused& last = refused();
  if (last.field == id && was_gone(last.frame)) last = {};
  if (last.field == id && ImGui::GetActiveID() != id) {
    // The field gets the keyboard in this frame or the next one.
    last.frame = frame;
    std::string now = last.typed;
    ImGui::InputTextWithHint(label, hint, &now, flags);
    return false;
  }
  std::string left = text;
  const bool is_left = left_with_another(label, left, [&](std::string& now) {
    ImGui::InputTextWithHint(label, hint, &now, flags);
    return now != text;
  });
  // Esc would return the refused text, with which the editing began.
  if (!is_left || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) return false;
  text = std::move(left);
  return true;
}

/// A field that shows `shown`; `read` parses a text.
template <class T, class Read>
bool value_field(const char* label, T& value, const std::string& shown, Read read) {
  const ImGuiID id = ImGui::GetID(label);
  const int frame = ImGui::GetFrameCount();
  Complaint& said = complaint();
  if (said.field == id && was_gone(said.frame)) said = {};
  std::string text = shown;
  const bool is_left = text_field(label, "", text, ImGuiInputTextFlags_AutoSelectAll);
  bool is_new = false;
  if (is_left) {
    if (const Expected<T> number = read(text)) {
      if (said.field == id) said = {};
      is_new = value != *number;
      value = *number;
    } else {
      said = {id, frame, number.error().message()};
      stay_in_field(text);
      if (refused().field != id) said.left_at = frame;
    }
  } else if (said.field == id) {
    const bool has_keyboard = ImGui::GetActiveID() == id || refused().field == id;
    if (said.left_at) {
      if (has_keyboard || (frame > *said.left_at && is_something_pressed())) said = {};
    } else if (!has_keyboard) {
      said = {};  // given up
    } else if (ImGui::GetActiveID() == id) {
      // While the user corrects the number, the complaint is about the present text.
      const Expected<T> number = read(typed_last().field == id ? typed_last().value : text);
      said.reason = number ? std::string() : number.error().message();
    }
  }
  if (said.field == id) {
    said.frame = frame;
    if (!said.reason.empty()) show(said.reason);
  }
  return is_new;
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
  return text_field(label, hint, text, ImGuiInputTextFlags_None);
}

bool number_field(const char* label, double& value, const char* format) {
  return number_field(label, value, format, [](double) { return std::nullopt; });
}

bool number_field(const char* label, double& value, const char* format,
                  const std::function<std::optional<std::string>(double)>& fault) {
  constexpr std::size_t kLongest = 64;
  std::array<char, kLongest> shown{};
  std::snprintf(shown.data(), shown.size(), format, value);
  const std::string unit = unit_in(format);
  return value_field(label, value, shown.data(), [&](const std::string& text) -> Expected<double> {
    const auto number = typed_number(text, unit);
    if (!number) return number;
    if (const auto words = fault(*number)) return std::unexpected(Error{ErrorCode::bad_input, *words});
    return number;
  });
}

bool number_field(const char* label, double& value, const char* format, const NumberRange& range) {
  return number_field(label, value, format, [&range](double number) { return range_fault(number, range); });
}

bool number_field(const char* label, std::uint64_t& value, std::uint64_t low, std::uint64_t high) {
  return value_field(label, value, std::to_string(value),
                     [=](const std::string& text) { return typed_count(text, low, high); });
}

bool number_field(const char* label, int& value, int low, int high) {
  std::uint64_t count = value < 0 ? 0U : static_cast<std::uint64_t>(value);
  if (!number_field(label, count, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high))) return false;
  value = static_cast<int>(count);
  return true;
}

const std::string& refused_number() {
  static const std::string none;
  const int frame = ImGui::GetFrameCount();
  return complaint().field != 0 && complaint().frame >= frame - 1 ? complaint().reason : none;
}

void stay_in_field(const std::string& typed) {
  const auto is_pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  if (!is_pressed(ImGuiKey_Enter) && !is_pressed(ImGuiKey_KeyPadEnter)) return;
  ImGui::SetKeyboardFocusHere(-1);
  refused() = {ImGui::GetItemID(), ImGui::GetFrameCount(), typed};
}

}  // namespace mes
