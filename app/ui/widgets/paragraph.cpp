// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/paragraph.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace mes {
namespace {

float width_of(std::string_view text) {
  // Unlike ImGui::CalcTextSize this is not rounded, so that the widths of words can be added.
  return ImGui::GetFont()
      ->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0.0F, text.data(), text.data() + text.size())
      .x;
}

/// The longest beginning of the word that fits, and at least one letter.
std::string_view beginning_of(std::string_view word, float width) {
  const char* end = nullptr;
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), width, 0.0F, word.data(), word.data() + word.size(), &end);
  std::size_t length = static_cast<std::size_t>(end - word.data());
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(word[i]) & 0xC0U) == 0x80U; };
  if (length == 0) do
      ++length;
    while (length < word.size() && continues(length));
  return word.substr(0, length);
}

}  // namespace

std::string broken_lines(std::string_view text, float width) {
  std::string out;
  constexpr float kRounding = 0.01F;  // of sums of widths
  const float space = width_of(" ");
  float used = 0.0F;
  bool begins_line = true;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", from), text.size());
    std::string_view word = text.substr(from, end - from);
    const float length = width_of(word);
    if (!begins_line && used + space + length > width - kRounding) {
      out += '\n';
      begins_line = true;
    } else if (!begins_line) {
      out += ' ';
      used += space;
    }
    if (begins_line) used = 0.0F;
    while (begins_line && width_of(word) > width) {
      const std::string_view part = beginning_of(word, width);
      if (part.size() == word.size()) break;
      out.append(part).append("\n");
      word.remove_prefix(part.size());
    }
    out += word;
    used += width_of(word);
    begins_line = end < text.size() && text[end] == '\n';
    if (begins_line) out += '\n';
    from = end + 1;
  }
  return out;
}

void paragraph(std::string_view text, float width) {
  ImGui::TextUnformatted(broken_lines(text, width > 0.0F ? width : ImGui::GetContentRegionAvail().x).c_str());
}

void quiet_paragraph(std::string_view text, float width) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  paragraph(text, width);
  ImGui::PopStyleColor();
}

ImVec2 paragraph_window_size(std::string_view text, float width) {
  const ImVec2 margin = ImGui::GetStyle().WindowPadding;
  const ImVec2 words = ImGui::CalcTextSize(broken_lines(text, width).c_str());
  return {std::ceil(words.x) + 2 * margin.x, std::ceil(words.y) + 2 * margin.y};
}

}  // namespace mes
