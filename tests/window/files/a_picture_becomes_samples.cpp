// SPDX-License-Identifier: GPL-3.0-or-later
// A silhouette is opened, asked about, and traced with one key; what it becomes is a document of its own.
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

std::string disk() {
  std::string out = "P5 200 200 255\n";
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) out += static_cast<char>(std::hypot(x - 99.5, y - 99.5) <= 80.0 ? 20 : 240);
  return out;
}

}  // namespace

TEST_CASE("a picture is traced into a document of its own, and the file that was open stays as it is") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write("disk.pgm", disk());
  window.folder.write("house.poff", kHouse);
  window.start("house.poff");
  const Screenshot house = window.drawn();
  // What lies behind a dialog is dimmed.
  const auto is_dimmed = [&] { return !screen.shoot().is_white(90, 700); };
  REQUIRE_FALSE(is_dimmed());
  // The preview is a dark disk with its outline around it.
  const auto is_outline = [](Color c) { return c.r > 200 && c.g < 120 && c.b < 80; };
  const auto choose_disk = [&] {
    window.press("ctrl+o");
    REQUIRE(eventually(is_dimmed));
    static_cast<void>(screen.settled());
    screen.xdotool("type --delay 20 disk");
    static_cast<void>(screen.settled());
    window.press("Return");
    REQUIRE(eventually([&] { return screen.shoot().count(is_outline) > 500; }));
    static_cast<void>(screen.settled());
  };
  choose_disk();
  window.press("Escape");
  CHECK(window.shows(house));
  choose_disk();
  window.press("Return");
  REQUIRE(eventually([&] { return !is_dimmed(); }));
  const Screenshot traced = window.drawn();
  REQUIRE(traced.changes(kCanvas, house) > 1000);
  CHECK(eventually([&] { return window.title().starts_with("* disk.pgm"); }));
  // No file holds it: a name is asked for.
  window.press("ctrl+s");
  REQUIRE(eventually(is_dimmed));
  window.press("Escape");
  REQUIRE(eventually([&] { return !is_dimmed(); }));
  CHECK(bytes_of(window.folder / "house.poff") == kHouse);
  // Nor is it a step in what was open before.
  window.press("ctrl+z");
  CHECK(window.nearly_shows(traced));

  window.save_as("disk.poff");
  const auto file = read_sample_file(window.folder / "disk.poff");
  REQUIRE(file.has_value());
  CHECK(file->data.contours.size() == 1);
  REQUIRE(file->data.positions.size() >= 400);
  for (const Vec2 p : file->data.positions) CHECK(std::abs(distance(p, {100.0, 100.0}) - 80.0) < 0.3);
}

TEST_CASE("unsaved work is asked about before a picture is traced, and stays where the question is cancelled") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write("disk.pgm", disk());
  window.folder.write("house.poff", kHouse);
  window.start("house.poff");
  static_cast<void>(window.drawn());
  window.press("i");
  screen.click({500, 400});
  REQUIRE(eventually([&] { return window.title().starts_with("* house.poff"); }));
  // Asked about when Open is pressed, and given up.
  const Screenshot edited = screen.settled();
  const auto outlines = [&] {
    return screen.shoot().count([](Color c) { return c.r > 200 && c.g < 120 && c.b < 80; });
  };
  window.press("ctrl+shift+p");
  static_cast<void>(screen.settled());
  screen.xdotool("type --delay 20 trace-into");
  static_cast<void>(screen.settled());
  window.press("Return");
  static_cast<void>(screen.settled());
  screen.xdotool("type --delay 20 disk");
  static_cast<void>(screen.settled());
  window.press("Return");
  REQUIRE(eventually([&] { return outlines() > 500; }));
  window.press("Return");
  static_cast<void>(screen.settled());
  // The question takes its place; without an answer the picture is there again, and then the house.
  CHECK(eventually([&] { return outlines() < 100; }));
  window.press("Escape");
  CHECK(eventually([&] { return outlines() > 500; }));
  window.press("Escape");
  CHECK(window.shows(edited));
  CHECK(window.title().starts_with("* house.poff"));
}

TEST_CASE("a file chosen by Open is asked about once, a picture when it is traced") {
  const bool is_picture = GENERATE(true, false);
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write("disk.pgm", disk());
  window.folder.write("square.poff", "POFF 4 0 0\n0 0\n4 0\n4 4\n0 4\n");
  window.folder.write("house.poff", kHouse);
  window.start("house.poff");
  static_cast<void>(window.drawn());
  window.press("i");
  screen.click({500, 400});
  REQUIRE(eventually([&] { return window.title().starts_with("* house.poff"); }));
  static_cast<void>(screen.settled());
  const auto is_dimmed = [&] { return !screen.shoot().is_white(90, 700); };
  window.press("ctrl+o");
  REQUIRE(eventually(is_dimmed));
  static_cast<void>(screen.settled());
  screen.xdotool(std::string("type --delay 20 ") + (is_picture ? "disk" : "square"));
  static_cast<void>(screen.settled());
  window.press("Return");
  if (is_picture) {
    const auto is_outline = [](Color c) { return c.r > 200 && c.g < 120 && c.b < 80; };
    REQUIRE(eventually([&] { return screen.shoot().count(is_outline) > 500; }));
    static_cast<void>(screen.settled());
    window.press("Return");
  }
  // The question covers little more than the middle of the window.
  REQUIRE(eventually([&] { return is_dimmed() && !screen.shoot().is_white(640, 150); }));
  static_cast<void>(screen.settled());
  CHECK(window.title().starts_with("* house.poff"));
  window.press("Right");
  window.press("Return");  // "Don't save"
  CHECK(eventually([&] { return window.title().starts_with(is_picture ? "* disk.pgm" : "square.poff"); }));
  CHECK(eventually([&] { return !is_dimmed(); }));
  CHECK(bytes_of(window.folder / "house.poff") == kHouse);
}

TEST_CASE("a picture to be traced waits until the question about work that was left is answered") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write("disk.pgm", disk());
  window.folder.write("house.poff", kHouse);
  window.start("house.poff");
  static_cast<void>(window.drawn());
  window.press("i");
  screen.click({500, 400});
  REQUIRE(eventually([&] { return window.title().starts_with("* "); }));
  static_cast<void>(screen.settled());
  kill(window.program.pid(), SIGTERM);
  REQUIRE(eventually([&] { return !window.program.is_running(); }));

  window.begin("disk.pgm");
  // Until there is a window the screen is black, and a key goes nowhere.
  REQUIRE(eventually([&] {
    const Screenshot shot = screen.shoot();
    return !shot.is_white(90, 700) && !shot.is_dark(90, 700);
  }));
  const auto outlines = [](const Screenshot& shot) {
    return shot.count([](Color c) { return c.r > 200 && c.g < 120 && c.b < 80; });
  };
  CHECK(outlines(screen.settled()) < 100);
  window.press("Escape");
  CHECK(eventually([&] { return outlines(screen.shoot()) > 500; }));
}
