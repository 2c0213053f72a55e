// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/dialogs/name_field.h"

#include <array>
#include <utility>

#include "imgui.h"
#include "imgui_internal.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

int place_cursor_at_end(ImGuiInputTextCallbackData* data) {
  data->ClearSelection();
  data->CursorPos = data->BufTextLen;
  return 0;
}

/// Takes the text typed since the last frame, before a field does.
std::string take_typed_text() {
  ImVector<ImWchar>& typed = ImGui::GetIO().InputQueueCharacters;
  std::string out;
  for (const ImWchar character : typed) {
    std::array<char, 5> bytes{};
    if (character >= ' ' && character != 0x7F) out += ImTextCharToUtf8(bytes.data(), character);
  }
  typed.resize(0);
  return out;
}

}  // namespace

void NameField::focus() {
  wants_focus_ = true;
  waits_ = true;
  early_.clear();
}

bool NameField::draw(const char* label, const char* hint, std::string& name) {
  ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  ImGuiInputTextCallback callback = nullptr;
  if (waits_) {
    early_ += take_typed_text();
    if (!early_.empty()) {
      name = early_;
      flags |= ImGuiInputTextFlags_CallbackAlways;
      callback = place_cursor_at_end;
    }
  }
  // While the field has the keyboard, it keeps its own copy of the text.
  if (std::exchange(is_replaced_, false) && ImGui::GetActiveID() == ImGui::GetID(label)) ImGui::ClearActiveID();
  if (wants_focus_) ImGui::SetKeyboardFocusHere();
  wants_focus_ = false;
  const bool entered = ImGui::InputTextWithHint(label, hint, &name, flags, callback);
  if (ImGui::IsItemActive()) waits_ = false;
  return entered;
}

}  // namespace mes
