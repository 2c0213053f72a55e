// SPDX-License-Identifier: GPL-3.0-or-later
// A window as large as a text is said to need shows all of it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cfloat>
#include <string>

#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/rng.h"
#include "imgui_internal.h"

using namespace mes;

namespace {

/// Dear ImGui without a window.
class ExplainedFrames {
 public:
  ExplainedFrames() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1200, 900};
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~ExplainedFrames() { ImGui::DestroyContext(); }
  ExplainedFrames(const ExplainedFrames&) = delete;
  ExplainedFrames& operator=(const ExplainedFrames&) = delete;

  struct Seen {
    ImVec2 room;   ///< within the margins
    ImVec2 words;  ///< what was drawn
    bool is_scrolled = false;
  };
  Seen show(const std::string& text, float width) {
    Seen out;
    // The library knows in the second frame whether the first one needed a scrollbar.
    for (int frame = 0; frame < 3; ++frame) {
      ImGui::NewFrame();
      ImGui::SetNextWindowSize(paragraph_window_size(text, width));
      ImGui::SetNextWindowPos({20, 30});
      ImGui::BeginTooltip();
      paragraph(text, width);
      const ImGuiWindow* const window = ImGui::GetCurrentWindow();
      out = {window->WorkRect.GetSize(), ImGui::GetItemRectSize(), window->ScrollbarX || window->ScrollbarY};
      ImGui::EndTooltip();
      ImGui::EndFrame();
    }
    return out;
  }
};

}  // namespace

TEST_CASE("an explanation is beside its control, in panels and dialogs, wherever there is room") {
  Rng rng(7);
  const ImVec2 screen{1280, 800};
  constexpr float kGap = 6;
  const auto random = [&](float low, float high) { return low + (high - low) * static_cast<float>(rng.uniform()); };
  int placed = 0;
  for (int i = 0; i < 4000; ++i) {
    const PanelArea panel{{random(0, 700), random(0, 500)}, {random(40, 580), random(20, 300)}};
    const ImVec2 item_size{random(10, panel.size.x), random(10, panel.size.y)};
    const PanelArea item{{random(panel.at.x, panel.at.x + panel.size.x - item_size.x),
                          random(panel.at.y, panel.at.y + panel.size.y - item_size.y)},
                         item_size};
    const ImVec2 size{random(60, 370), random(30, 120)};
    const bool is_dialog = i % 2 == 0;
    const auto at = tooltip_place({item, panel, is_dialog, size, screen, kGap});
    REQUIRE(at);
    const bool is_inside = at->x >= 0 && at->y >= 0 && at->x + size.x <= screen.x && at->y + size.y <= screen.y;
    const bool is_clear = at->x >= item.at.x + item.size.x || at->x + size.x <= item.at.x ||
                          at->y >= item.at.y + item.size.y || at->y + size.y <= item.at.y;
    REQUIRE(is_inside);
    REQUIRE(is_clear);
    if (!is_dialog) continue;
    // In a dialog it touches the control, but for the gap.
    const float dx = std::max({item.at.x - at->x - size.x, at->x - item.at.x - item.size.x, 0.0F});
    const float dy = std::max({item.at.y - at->y - size.y, at->y - item.at.y - item.size.y, 0.0F});
    REQUIRE(std::max(dx, dy) <= kGap + 0.01F);
    ++placed;
  }
  CHECK(placed == 2000);
  // No side has room.
  const PanelArea all{{0, 0}, screen};
  CHECK_FALSE(tooltip_place({all, all, true, {100, 50}, screen, kGap}));
}

TEST_CASE("an explanation has room for all of its words, however wide it may be") {
  ExplainedFrames frames;
  std::string text;
  for (const char* const word : {"Compute", "what", "is", "shown", "for", "each", "of", "these", "values,", "and",
                                 "write", "its", "counts", "and", "measures", "to", "a", "file"}) {
    text += text.empty() ? word : ' ' + std::string(word);
    for (const float margin : {0.0F, 8.0F, 12.0F, 30.0F}) {
      ImGui::GetStyle().WindowPadding = {margin, 8.0F};
      for (float width = 80.0F; width < 500.0F; width += 7.0F) {
        INFO(text << " in " << width << " with a margin of " << margin);
        const ExplainedFrames::Seen seen = frames.show(text, width);
        REQUIRE(seen.words.x <= seen.room.x);
        REQUIRE(seen.words.y <= seen.room.y);
        REQUIRE_FALSE(seen.is_scrolled);
      }
    }
  }
}

TEST_CASE("lines break between words, never within a number, and keep every word") {
  const ExplainedFrames frames;
  const std::string text =
      "Radius 12.25: born at 0.51234, dead at 1234.5678, scores 3.14.\nA_word_that_is_wider_than_most_lines.txt ends "
      "it";
  const auto without_spaces = [](std::string words) {
    std::erase_if(words, [](char c) { return c == ' ' || c == '\n'; });
    return words;
  };
  ImGui::NewFrame();
  const float word = ImGui::CalcTextSize("1234.5678,").x;
  for (float width = 10.0F; width < 700.0F; width += 3.0F) {
    const std::string lines = broken_lines(text, width);
    INFO(lines);
    CHECK(without_spaces(lines) == without_spaces(text));
    if (width < word) continue;
    for (const char* const number : {"12.25:", "0.51234,", "1234.5678,", "3.14."})
      CHECK(lines.find(number) != std::string::npos);
    // ImGui::CalcTextSize may round a width of whole pixels up by one.
    CHECK(ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0.0F, lines.c_str()).x <= width);
  }
  CHECK(broken_lines(text, 5000.0F) == text);
  CHECK(broken_lines("", 100.0F).empty());
  CHECK(broken_lines("a", 0.5F) == "a");
  CHECK(broken_lines("  indented", 500.0F) == "  indented");
  // The letters of a word that is cut stay whole.
  CHECK(broken_lines("\u00e4\u00f6", 1.0F) == "\u00e4\n\u00f6");
  ImGui::EndFrame();
}
