// SPDX-License-Identifier: GPL-3.0-or-later
// Where samples are so dense that dots and lines are drawn finer, `mesecina render` draws what the window shows.
#include <fmt/core.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

void write_ellipse(const fs::path& file, int samples) {
  std::ofstream out(file);
  out << "POFF " << samples << " 0 0\n";
  for (int i = 0; i < samples; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / samples;
    out << 500.0 * std::cos(angle) << ' ' << 300.0 * std::sin(angle) << '\n';
  }
}

std::optional<fs::path> snapshot_in(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".png" && !read_picture(entry.path()).is_empty()) return entry.path();
  return std::nullopt;
}

}  // namespace

TEST_CASE("a snapshot of dense samples and the picture that render makes of it are the same but for rounding") {
  // A third of a pixel apart: all lines are thin. Some four pixels apart: dots are as wide as they are at first, or kept
  // apart.
  for (const int samples : {6000, 600}) {
    DrivenProgram window;
    const TemporaryFolder& folder = window.folder;
    write_ellipse(folder / "ellipse.poff", samples);
    window.start("ellipse.poff", {{"HOME", folder.path().string()}});
    static_cast<void>(window.drawn());
    window.press("Tab");
    static_cast<void>(window.screen.settled());
    window.press("F3");
    std::optional<fs::path> taken;
    REQUIRE(eventually([&] { return (taken = snapshot_in(folder / "mesecina")).has_value(); }));
    const Screenshot snapshot = read_picture(*taken);
    const std::string drawn = (folder / "drawn.png").string();
    const auto render = [&](const std::string& more) {
      output_of(fmt::format("'{}' render '{}' --size {}x{} {} --force -o '{}'", MESECINA_BINARY, taken->string(),
                            snapshot.width(), snapshot.height(), more, drawn));
      return read_picture(drawn);
    };
    INFO(samples << " samples");
    // The view is a box in the session, and in the window what is equal on a fine grid is merged.
    CHECK(snapshot.differences(render(""), 2) == 0);
    CHECK(snapshot.differences(render("--set-style points:thin-when-dense=off"), 2) > 500);
    if (samples == 6000) CHECK(snapshot.differences(render("--set-style curve:thin-when-dense=off"), 2) > 500);
  }
}
