// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots and figures of the window show all panes, or the main one.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <vector>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> snapshots(const TemporaryFolder& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "mesecina", error))
    if (entry.path().extension() == ".png" && fs::file_size(entry.path(), error) > 0) out.push_back(entry.path());
  return out;
}

bool is_ink(Color color) {
  return color.r < 100 && color.g < 100 && color.b < 100;
}

/// Dark pixels in a part of a picture.
int ink_in(const Screenshot& picture, const PixelBox& box) {
  int out = 0;
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x) out += is_ink(picture.at(x, y)) ? 1 : 0;
  return out;
}

}  // namespace

TEST_CASE("a snapshot and a figure of two panes show both, each with its letter") {
  DrivenProgram window;
  const TemporaryFolder& folder = window.folder;
  std::ofstream(folder / "house.poff") << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
  window.start("house.poff", {{"HOME", folder.path().string()}});
  static_cast<void>(window.drawn());
  window.press("Tab");
  window.press("F6");
  window.press("f");
  static_cast<void>(window.screen.settled());
  window.press("F3");
  REQUIRE(eventually([&] { return snapshots(folder).size() == 1; }));
  Screenshot picture{0, 0, {}};
  REQUIRE(eventually([&] {
    picture = read_picture(snapshots(folder).front());
    return !picture.is_empty();
  }));
  // Two panes of 639 pixels, 16 between them, and labels of 30 below.
  REQUIRE(picture.width() == 2 * 639 + 16);
  REQUIRE(picture.height() > 700);
  const int height = picture.height() - 30;
  const int left = ink_in(picture, {5, 5, 634, height - 5});
  CHECK(left > 50);
  // The exact crust of these is the rounded one.
  CHECK(ink_in(picture, {655 + 5, 5, 655 + 634, height - 5}) == left);
  CHECK(ink_in(picture, {642, 0, 653, height}) == 0);
  CHECK(ink_in(picture, {200, height + 3, 440, picture.height()}) > 20);
  CHECK(ink_in(picture, {855, height + 3, 1095, picture.height()}) > 20);

  window.press("ctrl+e");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  CHECK(eventually([&] { return bytes_of(folder / "house.pdf").starts_with("%PDF-1.5"); }));
  const std::string words = output_of("pdftotext '" + (folder / "house.pdf").string() + "' -");
  CHECK(words.find("(a) Fast") != std::string::npos);
  CHECK(words.find("(b) Exact") != std::string::npos);

  window.press("shift+F6");
  static_cast<void>(window.screen.settled());
  window.press("F3");
  REQUIRE(eventually([&] { return snapshots(folder).size() == 2; }));
  CHECK(eventually([&] {
    for (const fs::path& file : snapshots(folder))
      if (read_picture(file).width() == 1280) return true;
    return false;
  }));
}

TEST_CASE("a pane shows the document before the last edit, with the differences, and comes back with its session") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  std::ofstream(window.folder / "house.poff") << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
  window.start("house.poff");
  static_cast<void>(window.drawn());
  window.press("Tab");
  window.press("F6");
  window.press("f");
  static_cast<void>(screen.settled());
  // Two panes of 639 pixels with a gap of 2; the roof is at the margin of 50 in both.
  constexpr int kMiddle = 319;
  constexpr int kBeside = 641;
  const auto has_roofs_at = [&](int here, int there) {
    const Screenshot shot = screen.shoot();
    return shot.is_dark(kMiddle, here) && shot.is_dark(kBeside + kMiddle, there) &&
           (here == there || (!shot.is_dark(kMiddle, there) && !shot.is_dark(kBeside + kMiddle, here)));
  };
  REQUIRE(eventually([&] { return has_roofs_at(50, 50); }));
  screen.click({690, 780});
  static_cast<void>(screen.settled());
  screen.click({730, 735});  // "Document"
  static_cast<void>(screen.settled());
  screen.click({895, 682});  // "Before the last edit"
  const auto move_roof = [&](int from, int to) {
    screen.xdotool("mousemove " + std::to_string(kMiddle) + " " + std::to_string(from + 40));
    screen.drag({kMiddle, from}, {kMiddle, to}, 10);
    screen.xdotool("mouseup 1");
    window.press("Escape");
    screen.xdotool("mousemove 3 3");
  };
  move_roof(50, 150);
  CHECK(eventually([&] { return has_roofs_at(150, 50); }));
  // What only one of them has is marked, also after the next edit.
  const auto is_marked = [&](int x, int y) {
    const Color color = screen.shoot().at(x, y);
    return color.r > 200 && color.g < 60 && color.b > 100 && color.b < 180;
  };
  REQUIRE_FALSE(is_marked(kBeside + kMiddle, 50));
  window.press("ctrl+F6");
  CHECK(eventually([&] { return is_marked(kMiddle, 150) && is_marked(kBeside + kMiddle, 50); }));
  move_roof(150, 100);
  CHECK(eventually([&] { return is_marked(kMiddle, 100) && is_marked(kBeside + kMiddle, 150); }));
  CHECK_FALSE(is_marked(kBeside + kMiddle, 50));
  window.press("ctrl+F6");
  CHECK(eventually([&] { return has_roofs_at(100, 150); }));
  window.press("ctrl+z");
  CHECK(eventually([&] { return has_roofs_at(150, 50); }));

  // Where it was, so that the view that is fitted again is this one.
  move_roof(150, 50);
  REQUIRE(eventually([&] { return has_roofs_at(50, 150); }));
  // The panes are in the session, and come back with it.
  window.save_as("panes.json");
  window.start("panes.json");
  static_cast<void>(window.drawn());
  window.press("Tab");
  window.press("f");
  CHECK(eventually([&] { return has_roofs_at(50, 150); }));
}
