// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/empty_hint.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/actions/actions.h"
#include "app/picture/paper/canvas_look.h"
#include "app/ui/screen/theme.h"

namespace mes {
namespace {

struct Offer {
  ActionId action;
  std::string_view text;
};
constexpr std::array kOffers{Offer{ActionId::tool_spray, "Draw a curve"}, Offer{ActionId::tool_insert, "Add samples"},
                             Offer{ActionId::tool_ball, "Draw balls"},
                             Offer{ActionId::open, "Open a file, or drop one here"}};

}  // namespace

void EmptyHint::draw(ImVec2 middle) const {
  const bool has_picture = picture.background_aspect() > 0.0;
  if (!document.is_empty() || has_picture || files.is_reading() || canvas.has_pointer()) return;
  const float unit = gui.unit();
  const float size = ImGui::GetFontSize();
  const float line = 1.7F * size;
  // The gap between the keys on the left and the text on the right.
  const float gap = 14.0F * unit;
  const ImU32 color = to_imgui(mark_color(picture.canvas()));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  float y = middle.y - 0.5F * line * static_cast<float>(kOffers.size());
  for (const Offer& offer : kOffers) {
    if (const std::string key = actions.keymap().key_of(offer.action); !key.empty()) {
      const float width = gui.bold()->CalcTextSizeA(size, 1e9F, 0.0F, key.c_str()).x;
      list.AddText(gui.bold(), size, {middle.x - 60 * unit - gap - width, y}, color, key.c_str());
    }
    const std::string text(offer.text);
    list.AddText(ImGui::GetFont(), size, {middle.x - 60 * unit, y}, color, text.c_str());
    y += line;
  }
}

}  // namespace mes
