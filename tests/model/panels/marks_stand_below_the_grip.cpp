// SPDX-License-Identifier: GPL-3.0-or-later
// Where a mark below a slider is for a value, the grip is at that value: a click there gives it.
#include <catch2/catch.hpp>

#include "app/ui/widgets/slider.h"
#include "imgui.h"

using namespace mes;

namespace {

/// Dear ImGui without a window.
class Frames {
 public:
  Frames() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {800, 600};
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~Frames() { ImGui::DestroyContext(); }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  /// A slider from 0 to 1 at `left`; what it says after a press of the mouse at `x`.
  double pressed(float left, float width, double value, float x) {
    ImGuiIO& io = ImGui::GetIO();
    for (const bool is_down : {false, true, false}) {
      io.MousePos = {x, 120.0F};
      io.MouseDown[0] = is_down;
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({800, 600});
      ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
      ImGui::SetCursorScreenPos({left, 112.0F});
      ImGui::SetNextItemWidth(width);
      constexpr double kLeast = 0.0;
      constexpr double kMost = 1.0;
      ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &kLeast, &kMost, "");
      ImGui::End();
      ImGui::EndFrame();
    }
    return value;
  }
};

}  // namespace

TEST_CASE("a click where a mark stands gives the value of the mark") {
  Frames frames;
  for (const float grab : {4.0F, 10.0F, 24.0F}) {
    ImGui::GetStyle().GrabMinSize = grab;
    for (const float width : {60.0F, 187.0F, 500.0F}) {
      const SliderTrack track(33.0F, width);
      // Dear ImGui has the mouse on whole pixels.
      const double pixel = 1.01 / static_cast<double>(track.at(1.0) - track.at(0.0));
      for (const double part : {0.0, 0.125, 0.5, 0.75, 1.0}) {
        INFO("grip of " << grab << ", slider of " << width << ", at " << part);
        CHECK(frames.pressed(33.0F, width, 0.3, track.at(part)) == Approx(part).margin(pixel));
        CHECK(track.part_at(track.at(part)) == Approx(part).margin(1e-6));
      }
      CHECK(track.part_at(0.0F) == 0.0);
      CHECK(track.part_at(800.0F) == 1.0);
    }
  }
  // No wider than its grip: all values are at one place.
  const SliderTrack narrow(33.0F, 6.0F);
  CHECK(narrow.at(0.0) == narrow.at(1.0));
  CHECK(narrow.part_at(40.0F) == 0.0);
}
