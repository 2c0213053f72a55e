// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "core/io/session/session.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

/// A window that asks about two works, "second" first.
struct LeftWorks {
  DrivenProgram window;

  LeftWorks() {
    fs::create_directories(journals());
    leave("first");
    leave("second");
    std::ofstream(window.folder / "a.poff") << "POFF 3 0 0\n0 0\n4 0\n4 3\n";
    window.start("a.poff");
    REQUIRE(eventually([&] { return has_question(); }));
  }
  fs::path journals() const { return window.folder / "data" / "mesecina" / "autosave"; }
  std::size_t journal_count() const {
    std::size_t out = 0;
    for (const auto& entry : fs::directory_iterator(journals()))
      out += entry.path().extension() == ".journal" ? 1U : 0U;
    return out;
  }
  void leave(const std::string& title) const {
    const SampleData data{.positions = {{0, 0}, {4, 0}, {4, 3}}};
    const Session session{.title = title, .data = std::make_shared<const SampleData>(data)};
    std::ofstream(journals() / (title + ".journal"))
        << write_journal_head(session) << write_journal_line(TimelineEdit{.name = "more", .inserted = {{2, 5}}});
  }
  /// What lies behind a dialog is dimmed.
  bool has_question() const { return !window.screen.shoot().is_white(90, 700); }
  /// The buttons lie side by side at the foot of the question.
  void answer(int button) const {
    const PixelBox box = window.screen.settled().box_of({0, 0, 1280, 800},
                                                        [](Color c) { return c.r > 230 && c.g > 230 && c.b > 230; });
    window.screen.click({box.left + 80 + 128 * button, box.bottom - 28});
  }
};

}  // namespace

TEST_CASE("of several works that were left one after the other is recovered, and none goes before it is kept") {
  constexpr int kRecover = 0;
  constexpr int kDoNotSave = 1;
  const LeftWorks works;
  const DrivenProgram& window = works.window;
  works.answer(kRecover);
  REQUIRE(eventually([&] { return window.title().starts_with("* second"); }));
  // Its own journal takes the place of the one that was left.
  REQUIRE(eventually([&] { return !fs::exists(works.journals() / "second.journal"); }));
  CHECK(works.journal_count() == 2);
  REQUIRE(eventually([&] { return works.has_question(); }));
  const Screenshot about_first = window.screen.settled();
  works.answer(kRecover);
  // What was recovered is not saved, which is asked about above the question about what was left.
  REQUIRE(eventually([&] { return window.screen.settled().differences(about_first, 30) > 500; }));
  works.answer(kDoNotSave);
  REQUIRE(eventually([&] { return window.title().starts_with("* first"); }));
  REQUIRE(eventually([&] { return !works.has_question() && !fs::exists(works.journals() / "first.journal"); }));
  CHECK(works.journal_count() == 1);
  window.press("ctrl+q");
  REQUIRE(eventually([&] { return works.has_question(); }));
  works.answer(kDoNotSave);
  REQUIRE(eventually([&] { return works.journal_count() == 0; }));
}
