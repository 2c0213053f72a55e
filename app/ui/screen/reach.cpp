// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/screen/reach.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "imgui.h"
#include "imgui_internal.h"

namespace mes {
namespace {

/// Lengths in screen coordinates of what cannot be reached.
struct OutOfReach {
  float x = 0.0F;
  float y = 0.0F;
};

OutOfReach out_of_reach(const ImGuiWindow& window) {
  constexpr float kRounding = 1.0F;
  const auto counted = [](float length) { return length > kRounding ? length : 0.0F; };
  OutOfReach out{window.ScrollbarX ? 0.0F : window.ScrollMax.x - window.WindowPadding.x,
                 window.ScrollbarY ? 0.0F : window.ScrollMax.y - window.WindowPadding.y};
  if ((window.Flags & ImGuiWindowFlags_MenuBar) != 0) out = {window.DC.MenuBarOffset.x - window.Size.x, 0.0F};
  if (window.ParentWindow == nullptr || (window.Flags & ImGuiWindowFlags_Popup) != 0) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const auto beyond = [](float from, float length, float end) { return std::max(-from, from + length - end); };
    out.x = std::max(out.x, beyond(window.Pos.x, window.Size.x, screen.x));
    out.y = std::max(out.y, beyond(window.Pos.y, window.Size.y, screen.y));
  }
  return {counted(out.x), counted(out.y)};
}

}  // namespace

std::vector<std::string> parts_out_of_reach() {
  std::vector<std::string> out;
  constexpr int kNotControls = ImGuiWindowFlags_Tooltip;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    if (!window->Active || window->Hidden || window->IsFallbackWindow || (window->Flags & kNotControls) != 0)
      continue;
    // A field of several lines follows its cursor.
    if (ImGui::GetInputTextState(window->ChildId) != nullptr) continue;
    const OutOfReach missing = out_of_reach(*window);
    if (missing.x > 0.0F || missing.y > 0.0F)
      out.push_back(fmt::format("{} lacks {:.0f} x {:.0f} pixels", window->Name, missing.x, missing.y));
  }
  return out;
}

void tell_parts_out_of_reach() {
  static const bool is_wanted = std::getenv("MESECINA_SHOWS_REACH") != nullptr;
  if (!is_wanted) return;
  for (const std::string& part : parts_out_of_reach()) std::fprintf(stderr, "out of reach: %s\n", part.c_str());
}

}  // namespace mes
