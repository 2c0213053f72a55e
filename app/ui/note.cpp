// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/note.h"

#include <cmath>

namespace mes {

ImVec2 note_size(const std::string& text, float width) {
  const ImVec2 margin = ImGui::GetStyle().WindowPadding;
  const ImVec2 words = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  return {std::ceil(words.x) + 2 * margin.x, std::ceil(words.y) + 2 * margin.y};
}

void note(const std::string& text, float width) {
  // Dear ImGui counts from the edge of the window, not from the beginning of the text.
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace mes
