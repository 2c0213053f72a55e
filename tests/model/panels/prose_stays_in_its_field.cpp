// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a field for prose end at its edge, and the text has the line breaks that were typed and no others.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "app/ui/widgets/wrapped_field.h"
#include "core/base/rng.h"
#include "imgui_internal.h"

using namespace mes;

namespace {

constexpr const char* kProse = "the medial axis is the set of centres of the disks that no larger disk holds";

/// Dear ImGui without a window, with a field of prose and nothing else.
struct ProseField {
  WrappedField field;
  std::string text;
  float width = 200.0F;
  int changes = 0;
  std::string clipboard;

  explicit ProseField(std::string words) : text(std::move(words)) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {800, 600};
    for (const ImGuiKey key :
         {ImGuiKey_Enter, ImGuiKey_Escape, ImGuiKey_Backspace, ImGuiKey_Delete, ImGuiKey_LeftArrow,
          ImGuiKey_RightArrow, ImGuiKey_UpArrow, ImGuiKey_DownArrow, ImGuiKey_Home, ImGuiKey_End, ImGuiKey_A,
          ImGuiKey_C, ImGuiKey_X, ImGuiKey_Y, ImGuiKey_Z})
      io.KeyMap[key] = key;
    io.ClipboardUserData = &clipboard;
    io.GetClipboardTextFn = [](void* kept) { return static_cast<std::string*>(kept)->c_str(); };
    io.SetClipboardTextFn = [](void* kept, const char* words) { *static_cast<std::string*>(kept) = words; };
    unsigned char* pixels = nullptr;
    int atlas_width = 0;
    int atlas_height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &atlas_width, &atlas_height);
    frames(2);
    io.MousePos = {15, 290};
    frames(2);
    for (const bool is_down : {true, false}) {
      io.MouseDown[0] = is_down;
      frames(1);
    }
    press_with_ctrl(ImGuiKey_End);
  }
  ~ProseField() { ImGui::DestroyContext(); }
  ProseField(const ProseField&) = delete;
  ProseField& operator=(const ProseField&) = delete;

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({800, 600});
      ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
      if (field.draw("##prose", text, {width, 300})) ++changes;
      ImGui::End();
      ImGui::EndFrame();
    }
  }
  void press(ImGuiKey key, int times = 1) {
    for (int i = 0; i < 2 * times; ++i) {
      ImGui::GetIO().KeysDown[key] = i % 2 == 0;
      frames(1);
    }
  }
  void press_with_ctrl(ImGuiKey key) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = true;
    io.KeyMods = ImGuiKeyModFlags_Ctrl;
    press(key);
    io.KeyCtrl = false;
    io.KeyMods = ImGuiKeyModFlags_None;
    frames(1);
  }
  void type(const std::string& letters) {
    for (const char letter : letters) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
      frames(1);
    }
  }
  /// The lines that the field shows, while it has the keyboard.
  std::vector<std::string> lines() const {
    const ImGuiInputTextState& state = ImGui::GetCurrentContext()->InputTextState;
    std::vector<std::string> out{{}};
    for (int i = 0; i < state.CurLenW; ++i) {
      const ImWchar letter = state.TextW[i];
      if (letter == '\n')
        out.emplace_back();
      else if (letter != '\r')
        out.back() += static_cast<char>(letter);
    }
    return out;
  }
  bool fits() const {
    return std::ranges::all_of(lines(), [&](std::string line) {
      while (line.ends_with(' ')) line.pop_back();
      return ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, line.c_str()).x <= width;
    });
  }
};

}  // namespace

TEST_CASE("prose is broken where it would leave the field, and the text is as it was") {
  ProseField prose(kProse);
  CHECK(prose.text == kProse);
  CHECK(prose.changes == 0);
  CHECK(prose.lines().size() > 2);
  CHECK(prose.fits());
  prose.width = 320.0F;
  const std::size_t before = prose.lines().size();
  prose.frames(2);
  CHECK(prose.lines().size() < before);
  CHECK(prose.fits());
  CHECK(prose.text == kProse);
  CHECK(prose.changes == 0);
}

TEST_CASE("what is typed into prose is broken while it is typed, and Enter begins a line of the text") {
  ProseField prose("");
  prose.type(kProse);
  CHECK(prose.text == kProse);
  CHECK(prose.fits());
  prose.press(ImGuiKey_Enter);
  prose.type("and more");
  CHECK(prose.text == std::string(kProse) + "\nand more");
  prose.type(std::string(80, 'x'));
  CHECK(prose.text == std::string(kProse) + "\nand more" + std::string(80, 'x'));
  CHECK(prose.fits());
}

TEST_CASE("each arrow key goes over one letter of prose, and Backspace and Delete remove one") {
  const std::string words(kProse);
  for (std::size_t steps = 0; steps <= words.size(); ++steps) {
    INFO(steps);
    const std::size_t at = words.size() - steps;
    {
      ProseField prose(kProse);
      prose.press(ImGuiKey_LeftArrow, static_cast<int>(steps));
      prose.press(ImGuiKey_Backspace);
      std::string expected = words;
      if (at > 0) expected.erase(at - 1, 1);
      CHECK(prose.text == expected);
      prose.press_with_ctrl(ImGuiKey_Z);
      CHECK(prose.text == words);
    }
    {
      ProseField prose(kProse);
      prose.press_with_ctrl(ImGuiKey_Home);
      prose.press(ImGuiKey_RightArrow, static_cast<int>(at));
      prose.press(ImGuiKey_Delete);
      std::string expected = words;
      if (at < words.size()) expected.erase(at, 1);
      CHECK(prose.text == expected);
      prose.type("Z");
      expected.insert(at, 1, 'Z');
      CHECK(prose.text == expected);
    }
  }
}

TEST_CASE("the keys End, Home, Up and Down of prose are those of the lines that are seen") {
  ProseField prose(kProse);
  prose.press_with_ctrl(ImGuiKey_Home);
  const std::string first = prose.lines()[0];
  const std::string second = prose.lines()[1];
  prose.press(ImGuiKey_End);
  prose.press(ImGuiKey_End);
  prose.type("#");
  CHECK(prose.text == first + "#" + std::string(kProse).substr(first.size()));
  prose.press(ImGuiKey_Backspace);
  prose.press_with_ctrl(ImGuiKey_Home);
  prose.press(ImGuiKey_DownArrow);
  prose.type("#");
  CHECK(prose.text == first + "#" + std::string(kProse).substr(first.size()));
  prose.press(ImGuiKey_Backspace);
  prose.press(ImGuiKey_UpArrow);
  prose.type("#");
  CHECK(prose.text == "#" + std::string(kProse));
}

TEST_CASE("prose is undone word by word and redone, and copied without the breaks of the field") {
  ProseField prose("");
  prose.type("one two");
  prose.press_with_ctrl(ImGuiKey_Z);
  CHECK(prose.text == "one ");
  prose.press_with_ctrl(ImGuiKey_Z);
  CHECK(prose.text.empty());
  prose.press_with_ctrl(ImGuiKey_Y);
  prose.press_with_ctrl(ImGuiKey_Y);
  CHECK(prose.text == "one two");
  prose.press_with_ctrl(ImGuiKey_A);
  prose.type(kProse);
  prose.press_with_ctrl(ImGuiKey_A);
  prose.press_with_ctrl(ImGuiKey_C);
  CHECK(prose.clipboard == kProse);
  prose.press_with_ctrl(ImGuiKey_X);
  CHECK(prose.text.empty());
  CHECK(prose.clipboard == kProse);
}

TEST_CASE("random keys do to prose what they do to a text of one line") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng(seed);
    ProseField prose("");
    std::string expected;
    std::size_t at = 0;
    for (int step = 0; step < 150; ++step) {
      switch (rng.below(8)) {
        case 0:
          prose.press(ImGuiKey_LeftArrow);
          if (at > 0) --at;
          break;
        case 1:
          prose.press(ImGuiKey_RightArrow);
          if (at < expected.size()) ++at;
          break;
        case 2:
          prose.press(ImGuiKey_Backspace);
          if (at > 0) expected.erase(--at, 1);
          break;
        case 3:
          prose.press(ImGuiKey_Delete);
          if (at < expected.size()) expected.erase(at, 1);
          break;
        default: {
          const std::string letters = rng.below(3) == 0 ? " " : std::string(rng.below(9) + 1, 'm');
          prose.type(letters);
          expected.insert(at, letters);
          at += letters.size();
        }
      }
      INFO("seed " << seed << ", step " << step);
      REQUIRE(prose.text == expected);
      REQUIRE(prose.fits());
    }
  }
}
