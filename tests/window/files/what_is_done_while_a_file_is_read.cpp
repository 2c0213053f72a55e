// SPDX-License-Identifier: GPL-3.0-or-later
// A pipe is a file that is read for as long as one likes.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

/// A window with a sample that was set while a file is being read, and the question about it.
struct Question {
  DrivenProgram window;

  Question() {
    const auto pipe = window.folder / "pipe.poff";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    window.begin("pipe.poff");
    REQUIRE(eventually(
        [&] { return window.title().starts_with("Untitled") && window.screen.shoot().is_white(90, 700); }));
    window.screen.xdotool("mousemove 500 400");
    window.press("i");
    window.screen.click({500, 400});
    REQUIRE(eventually([&] { return window.title().starts_with("* Untitled"); }));
    std::ofstream(pipe) << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
    REQUIRE(eventually([&] { return is_open(); }));
  }
  /// What lies behind a dialog is dimmed.
  bool is_open() const { return !window.screen.shoot().is_white(90, 700); }
  /// The buttons lie side by side at the foot of the question.
  void answer(int button) const {
    const PixelBox box = window.screen.settled().box_of({0, 0, 1280, 800},
                                                        [](Color c) { return c.r > 230 && c.g > 230 && c.b > 230; });
    window.screen.click({box.left + 80 + 128 * button, box.bottom - 28});
    CHECK(eventually([&] { return !is_open(); }));
  }
};

}  // namespace

TEST_CASE("a file that was read while the document was edited is dropped where the question is cancelled") {
  const Question question;
  const DrivenProgram& window = question.window;
  static_cast<void>(window.screen.settled());
  CHECK(window.title().starts_with("* Untitled"));
  window.press("Escape");
  CHECK(eventually([&] { return !question.is_open(); }));
  static_cast<void>(window.screen.settled());
  CHECK_FALSE(question.is_open());
  CHECK(window.title().starts_with("* Untitled"));
  // What was edited can be undone, and nothing is read any more.
  window.press("ctrl+z");
  CHECK(eventually([&] { return window.title().starts_with("Untitled"); }));
}

TEST_CASE("a file that was read while the document was edited takes its place where that is wanted") {
  const Question question;
  question.answer(1);
  CHECK(eventually([&] { return question.window.title().starts_with("pipe.poff"); }));
}
