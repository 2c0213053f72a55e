// SPDX-License-Identifier: GPL-3.0-or-later
// The page Curves: other samples of a drawing that was opened.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr PixelBox kPanels{935, 40, 1238, 760};
constexpr std::array<int, 2> kNumberField{1180, 515};  // the field, in the panel at the lower right

/// Of the samples of a file that holds a circle about (5, 5) with a radius of 4.
std::size_t samples_in(const DrivenProgram& window, const std::string& name) {
  const auto file = read_sample_file(window.folder / name);
  REQUIRE(file.has_value());
  for (const Vec2 p : file->data.positions) CHECK(distance(p, {5, 5}) == Approx(4).epsilon(1e-12));
  return file->data.positions.size();
}

}  // namespace

TEST_CASE("other samples are taken of a drawing on the page Curves, as one step of undo") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write(
      "ring.svg",
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><circle cx="5" cy="5" r="4"/></svg>)");
  window.start("ring.svg");
  const Screenshot dense = window.drawn();
  window.press("shift+n");
  const Screenshot page = screen.settled();
  REQUIRE(page.changes(kPanels, dense) > 1000);
  CHECK(page.changes(kCanvas, dense) == 0);

  screen.click(kNumberField);
  static_cast<void>(screen.settled());
  screen.type_over("60");
  window.press("Return");
  screen.xdotool("mousemove 500 400");
  const Screenshot sparse = window.other_than(dense);
  window.save_as("sparse.poff");
  CHECK(samples_in(window, "sparse.poff") == 60);

  window.press("ctrl+z");
  static_cast<void>(window.other_than(sparse));
  window.save_as("dense.poff");
  CHECK(samples_in(window, "dense.poff") == 400);
  window.press("ctrl+shift+z");
  CHECK(window.nearly_shows(sparse));

  // The page goes as it came.
  window.press("shift+n");
  CHECK(screen.settled().changes(kPanels, page) > 1000);
}
