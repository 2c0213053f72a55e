// SPDX-License-Identifier: GPL-3.0-or-later
// A window as large as a text is said to need shows all of it.
#include <catch2/catch.hpp>
#include <string>

#include "app/ui/note.h"
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
      ImGui::SetNextWindowSize(note_size(text, width));
      ImGui::SetNextWindowPos({20, 30});
      ImGui::BeginTooltip();
      note(text, width);
      const ImGuiWindow* const window = ImGui::GetCurrentWindow();
      out = {window->WorkRect.GetSize(), ImGui::GetItemRectSize(), window->ScrollbarX || window->ScrollbarY};
      ImGui::EndTooltip();
      ImGui::EndFrame();
    }
    return out;
  }
};

}  // namespace

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
