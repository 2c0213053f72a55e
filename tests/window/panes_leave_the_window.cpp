// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots, figures and recorded frames of the window show all panes, or the main one.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/recording/take.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
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

TEST_CASE("recorded frames show all panes, as a snapshot does, and the manifest has them") {
  DrivenProgram window;
  const TemporaryFolder& folder = window.folder;
  std::ofstream(folder / "house.poff") << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
  window.start("house.poff", {{"HOME", folder.path().string()}});
  static_cast<void>(window.drawn());
  window.press("Tab");
  window.press("F6");
  window.press("f");
  static_cast<void>(window.screen.settled());
  window.press("F4");
  const auto take = [&]() -> fs::path {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder / "mesecina", error))
      if (entry.is_directory()) return entry.path();
    return {};
  };
  REQUIRE(eventually([&] { return !take().empty(); }));
  const auto frames = [&] {
    const auto read = read_take(take());
    return read ? read->frames.size() : std::size_t{0};
  };
  window.press("i");
  window.screen.click({319, 400});
  REQUIRE(eventually([&] { return frames() == 1; }));
  // What is shown is fitted again where panes come and go, which gives frames of its own.
  window.press("F6");
  static_cast<void>(window.screen.settled());
  REQUIRE(eventually([&] { return frames() >= 2; }));
  window.press("shift+F6");
  static_cast<void>(window.screen.settled());
  REQUIRE(eventually([&] { return frames() >= 3; }));
  window.press("F4");
  REQUIRE(eventually([&] {
    const auto read = read_take(take());
    return read && read->complete;
  }));
  const auto read = read_take(take());
  REQUIRE(read);
  const std::size_t last = read->frames.size();
  REQUIRE(last >= 3);
  CHECK(read->frames[0].what == "Insert sample");
  CHECK(read->frames[1].what == "Panes");
  CHECK(std::ranges::count(read->frames, "Panes", &FrameInfo::what) == 2);
  const auto frame = [&](std::size_t number) { return read_picture(take() / frame_name(number)); };
  const Screenshot two = frame(1);
  // As large as a snapshot of two panes; all others have the size of the first.
  REQUIRE(two.width() == 2 * 639 + 16);
  const int height = two.height() - 30;
  const int left = ink_in(two, {5, 5, 634, height - 5});
  CHECK(left > 50);
  CHECK(ink_in(two, {655 + 5, 5, 655 + 634, height - 5}) == left);
  CHECK(ink_in(two, {200, height + 3, 440, two.height()}) > 20);
  for (std::size_t number = 2; number <= last; ++number) {
    CHECK(frame(number).width() == two.width());
    CHECK(frame(number).height() == two.height());
  }
  CHECK(frame(2).differences(two, 60) > 100);
  CHECK(frame(last).differences(frame(2), 60) > 100);
  const auto source = read_sample_file(take() / kManifestName);
  REQUIRE(source);
  REQUIRE(source->session);
  CHECK(source->data.positions.size() == 6);
}

TEST_CASE("a pane with a camera of its own is zoomed alone, and comes back with its session") {
  DrivenProgram window;
  const TemporaryFolder& folder = window.folder;
  const VirtualScreen& screen = window.screen;
  std::ofstream(folder / "house.poff") << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
  window.start("house.poff", {{"HOME", folder.path().string()}});
  static_cast<void>(window.drawn());
  window.press("Tab");
  window.press("F6");
  window.press("f");
  // The roof is at the margin of 50 in both panes.
  constexpr int kMiddle = 319;
  constexpr int kBeside = 641;
  const auto has_roofs = [&](bool here, bool there) {
    const Screenshot shot = screen.shoot();
    return shot.is_dark(kMiddle, 50) == here && shot.is_dark(kBeside + kMiddle, 50) == there;
  };
  REQUIRE(eventually([&] { return has_roofs(true, true); }));
  window.press("alt+F6");
  static_cast<void>(screen.settled());
  screen.xdotool("mousemove " + std::to_string(kBeside + kMiddle) + " 500 click 4 click 4 click 4");
  REQUIRE(eventually([&] { return has_roofs(true, false); }));
  static_cast<void>(screen.settled());  // the view glides
  // A sample that is inserted there lies where that pane shows it: near to the middle, in the other one.
  window.press("i");
  screen.click({kBeside + kMiddle + 60, 500});
  window.press("v");
  screen.xdotool("mousemove 3 3");
  const Screenshot settled = screen.settled();
  CHECK(settled.is_dark(kBeside + kMiddle + 60, 500));
  CHECK_FALSE(settled.is_dark(kMiddle + 60, 500));
  window.save_as("free.json");
  const auto saved = read_session(bytes_of(folder / "free.json"), "free.json");
  REQUIRE(saved);
  REQUIRE(saved->pane_views.size() == 1);
  CHECK(saved->pane_views[0].width() < 0.8 * saved->view.width());

  // The snapshot has the views of both.
  window.press("F3");
  REQUIRE(eventually([&] { return snapshots(folder).size() == 1; }));
  Screenshot picture{0, 0, {}};
  REQUIRE(eventually([&] {
    picture = read_picture(snapshots(folder).front());
    return !picture.is_empty();
  }));
  REQUIRE(picture.width() == 2 * 639 + 16);
  CHECK(picture.is_dark(kMiddle, 50));
  CHECK(ink_in(picture, {655 + kMiddle - 12, 40, 655 + kMiddle + 12, 62}) == 0);

  window.start("free.json");
  static_cast<void>(window.drawn());
  window.save_as("again.json");
  const auto again = read_session(bytes_of(folder / "again.json"), "again.json");
  REQUIRE(again);
  REQUIRE(again->pane_views.size() == 1);
  // What was seen is seen again, in panes of other proportions, to a pixel.
  const auto middle = [](const Box2& box) { return 0.5 * (box.low + box.high); };
  CHECK(distance(middle(again->pane_views[0]), middle(saved->pane_views[0])) < 0.02);
  CHECK(again->pane_views[0].width() > 0.98 * saved->pane_views[0].width());
  window.press("Tab");
  screen.xdotool("mousemove 20 20");
  window.press("f");
  CHECK(eventually([&] { return has_roofs(true, false); }));
  window.press("alt+F6");
  CHECK(eventually([&] { return has_roofs(true, true); }));
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
