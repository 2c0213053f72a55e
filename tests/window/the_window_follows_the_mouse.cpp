// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <thread>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

constexpr int kDraggedSamples = 60;
constexpr double kRadius = 100.0;
// "Fit" shows the circle with 40 pixels of margin on a screen 800 pixels high.
constexpr double kPxPerUnit = (800.0 - 2 * 40.0) / (2 * kRadius);

Vec2 sample(int i) {
  const double t = 2.0 * 3.14159265358979323846 * i / kDraggedSamples;
  // Rounded, so that what is written is what is meant, and the box is symmetric.
  return {std::round(kRadius * std::cos(t) * 1024) / 1024, std::round(kRadius * std::sin(t) * 1024) / 1024};
}
int screen_x(double x) {
  return static_cast<int>(std::lround(640 + kPxPerUnit * x));
}
int screen_y(double y) {
  return static_cast<int>(std::lround(400 - kPxPerUnit * y));
}

std::vector<Vec2> saved_samples(const fs::path& file) {
  const auto loaded = read_sample_file(file);
  return loaded ? loaded->data.positions : std::vector<Vec2>{};
}

/// The program with the circle open.
struct Visit : DrivenProgram {
  fs::path file = folder / "circle.poff";

  Visit() {
    std::ofstream out(file);
    out << std::setprecision(17) << "POFF " << kDraggedSamples << " 0 0\n";
    for (int i = 0; i < kDraggedSamples; ++i) out << sample(i).x << ' ' << sample(i).y << '\n';
    out.close();
    start("circle.poff");
  }
  void show_only_the_drawing() {
    screen.xdotool("mousemove 640 400");
    press("Tab");
    press("f");
    screen.xdotool("mousemove 3 3");
    // Fitted: there is a sample where the sample is, in the four directions.
    INFO("the fitted drawing did not appear");
    REQUIRE(eventually([&] {
      const Screenshot shot = screen.settled();
      return shot.is_dark(screen_x(kRadius), 400) && shot.is_dark(screen_x(-kRadius), 400) &&
             shot.is_dark(640, screen_y(kRadius)) && shot.is_dark(640, screen_y(-kRadius)) && shot.is_white(3, 3);
    }));
  }
  /// Saves and gives the bytes of the file, which appears complete or not at all.
  std::string save() {
    fs::remove(file);
    press("ctrl+s");
    REQUIRE(eventually([&] { return fs::exists(file); }));
    return bytes_of(file);
  }
};

}  // namespace

TEST_CASE("spray, drag, undo and save: the document and the picture follow") {
  Visit session;
  const VirtualScreen& screen = session.screen;
  session.show_only_the_drawing();
  const std::string untouched = session.save();

  // A stroke at the left rim: 600 pixels down, a sample each 12 pixels.
  session.press("s");
  screen.drag({100, 100}, {100, 700}, 12);
  INFO("the stroke is not on screen while it is drawn");
  REQUIRE(eventually([&] { return screen.shoot().is_dark(100, 100) && screen.shoot().is_dark(100, 676); }));
  screen.xdotool("mouseup 1");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  session.save();
  std::vector<Vec2> samples = saved_samples(session.file);
  REQUIRE(samples.size() == kDraggedSamples + 51);
  for (int i = 0; i < kDraggedSamples; ++i) CHECK(samples[static_cast<std::size_t>(i)] == sample(i));
  for (int i = 0; i <= 50; ++i) {
    const Vec2 p = samples[static_cast<std::size_t>(kDraggedSamples + i)];
    CHECK(p.x == Approx((100 - 640) / kPxPerUnit).margin(1e-6));
    CHECK(p.y == Approx((400 - 100 - 12 * i) / kPxPerUnit).margin(1e-6));
  }

  // The whole stroke is one step.
  session.press("ctrl+z");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  CHECK(eventually([&] { return screen.shoot().is_white(100, 100) && screen.shoot().is_white(100, 676); }));
  CHECK(session.save() == untouched);

  // The sample at the right moves 60 pixels to the right and 30 up; the crust stretches after it at once.
  const auto is_curve = [](Color c) { return c.b > 120 && c.r < 60 && c.g < 140 && c.b > c.g + 20; };
  session.press("v");
  screen.xdotool("mousemove 500 400");
  screen.drag({screen_x(kRadius), 400}, {screen_x(kRadius) + 60, 370}, 10);
  INFO("the sample does not follow the pointer");
  REQUIRE(eventually([&] {
    const Screenshot shot = screen.shoot();
    return shot.count(is_curve) > 0 && !shot.is_dark(screen_x(kRadius), 400);
  }));
  screen.xdotool("mouseup 1");
  session.press("Escape");
  screen.xdotool("mousemove 3 3");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  CHECK(eventually([&] { return screen.shoot().is_dark(screen_x(kRadius) + 60, 370); }));
  const std::string dragged = session.save();
  samples = saved_samples(session.file);
  REQUIRE(samples.size() == kDraggedSamples);
  CHECK(samples[0].x == Approx(kRadius + 60 / kPxPerUnit).margin(1e-6));
  CHECK(samples[0].y == Approx(30 / kPxPerUnit).margin(1e-6));
  for (int i = 1; i < kDraggedSamples; ++i) CHECK(samples[static_cast<std::size_t>(i)] == sample(i));

  // What was updated piece by piece on screen is what a new program draws of the saved file.
  const fs::path reference = session.folder / "reference.png";
  std::string view;
  for (const double value : {-640 / kPxPerUnit, -400 / kPxPerUnit, 640 / kPxPerUnit, 400 / kPxPerUnit})
    view += (view.empty() ? "" : ",") + std::to_string(value);
  Child render({MESECINA_BINARY, "render", session.file.string(), "--layers",
                "interior-voronoi-disks,curve,medial-axis,points", "--size", "1280x800", "--view=" + view, "-o",
                reference.string()},
               {}, session.folder / "render-errors");
  REQUIRE(render.wait() == 0);
  const Screenshot expected = read_picture(reference);
  REQUIRE_FALSE(expected.is_empty());
  INFO(expected.differences(screen.shoot(), 60) << " pixels differ");
  CHECK(eventually([&] { return expected.differences(screen.shoot(), 60) < 40; }));

  session.press("ctrl+z");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  CHECK(session.save() == untouched);
  session.press("ctrl+shift+z");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  CHECK(session.save() == dragged);

  session.press("ctrl+q");
  CHECK(eventually([&] { return !session.program.is_running(); }));
  CHECK(session.program.wait() == 0);
  CHECK(bytes_of(session.folder / "errors").empty());
}

TEST_CASE("words with a line are put on a sample, follow it, are undone, and count as unsaved") {
  Visit session;
  const VirtualScreen& screen = session.screen;
  session.show_only_the_drawing();
  session.press("a");
  // The sample at the right, and room for words at its upper right.
  const Screenshot before = screen.shoot();
  screen.drag({1000, 400}, {1100, 300}, 4);
  screen.xdotool("mouseup 1");
  const PixelBox card{1180, 340, 1280, 470};
  INFO("the card did not appear");
  REQUIRE(eventually([&] { return !screen.shoot().box_of_changes(card, before).is_empty(); }));
  const auto are_words_at = [&](int x, int y) {
    const Screenshot shot = screen.shoot();
    int dark = 0;
    for (int row = y - 14; row < y + 4; ++row)
      for (int column = x; column < x + 60; ++column) dark += shot.is_dark(column, row) ? 1 : 0;
    return dark > 30;
  };
  // A field takes letters from the second frame on.
  REQUIRE(eventually([&] {
    if (are_words_at(1100, 300)) return true;
    screen.xdotool("type MM");
    return are_words_at(1100, 300);
  }));
  // Esc closes the card, as Enter does, and what was written stays.
  session.press("Escape");
  REQUIRE(eventually([&] { return screen.shoot().box_of_changes(card, before).is_empty(); }));
  CHECK(are_words_at(1100, 300));
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  session.press("ctrl+z");
  CHECK(eventually([&] { return !are_words_at(1100, 300); }));
  CHECK(eventually([&] { return session.title().starts_with("circle.poff"); }));
  session.press("ctrl+shift+z");
  REQUIRE(eventually([&] { return are_words_at(1100, 300); }));

  session.press("v");
  screen.drag({1000, 400}, {1000, 460}, 4);
  screen.xdotool("mouseup 1");
  REQUIRE(eventually([&] { return are_words_at(1100, 360); }));

  // A file of samples cannot hold them.
  session.save();
  CHECK(saved_samples(session.file)[0].y < -15.0);
  CHECK(eventually([&] { return session.title().starts_with("* circle.poff"); }));
}

TEST_CASE("unsaved work is asked for, and the window sleeps when nothing happens") {
  Visit session;
  session.show_only_the_drawing();
  session.press("ctrl+a");
  session.press("Right");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  session.press("ctrl+q");
  // The question dims the white canvas.
  REQUIRE(eventually([&] { return !session.screen.shoot().is_white(3, 3); }));
  CHECK(session.program.is_running());
  session.press("Escape");
  REQUIRE(eventually([&] { return session.screen.shoot().is_white(3, 3); }));

  const auto ticks = [&] {
    std::ifstream stat("/proc/" + std::to_string(session.program.pid()) + "/stat");
    std::string word;
    long sum = 0;
    for (int field = 1; stat >> word && field <= 15; ++field)
      if (field >= 14) sum += std::stol(word);
    return sum;
  };
  // Some second must pass in which it uses no processor time at all.
  CHECK(eventually([&] {
    const long before = ticks();
    std::this_thread::sleep_for(std::chrono::seconds(1));
    return ticks() == before;
  }));
}

TEST_CASE("a ball is drawn, resized with the wheel, and saved to a file of its own") {
  Visit session;
  const VirtualScreen& screen = session.screen;
  session.show_only_the_drawing();
  // In the corner, where no ball of the circle is.
  const auto is_ball = [](Color c) { return c.r > 240 && c.g > 220 && c.b > 170 && c.b < 235; };
  REQUIRE_FALSE(is_ball(screen.shoot().at(110, 120)));
  session.press("b");
  screen.drag({100, 120}, {160, 120}, 6);
  INFO("the ball is not on screen while it is drawn");
  REQUIRE(eventually([&] { return is_ball(screen.shoot().at(110, 150)); }));
  screen.xdotool("mouseup 1");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));

  // Three turns of the wheel on its centre are one step.
  session.press("v");
  screen.xdotool("mousemove 100 120 click 1");
  screen.xdotool("click 4 click 4 click 4");
  REQUIRE(eventually([&] { return is_ball(screen.shoot().at(170, 120)); }));
  session.press("ctrl+z");
  REQUIRE(eventually([&] { return !is_ball(screen.shoot().at(170, 120)); }));
  CHECK(is_ball(screen.shoot().at(110, 150)));
  session.press("ctrl+shift+z");
  REQUIRE(eventually([&] { return is_ball(screen.shoot().at(170, 120)); }));

  // The samples have a file, the ball has none: saving says so, and the work counts as unsaved.
  session.save();
  CHECK(saved_samples(session.file).size() == kDraggedSamples);
  const auto is_banner = [](Color c) {
    return std::abs(c.r - 0xFD) < 4 && std::abs(c.g - 0xF1) < 4 && std::abs(c.b - 0xE7) < 4;
  };
  CHECK(eventually([&] { return screen.shoot().count(is_banner) > 3000; }));
  CHECK(session.title().starts_with("* circle.poff"));

  session.press("ctrl+shift+s");
  REQUIRE(eventually([&] { return !screen.shoot().is_white(3, 300); }));
  session.press("Return");
  const fs::path balls = session.folder / "circle.wpoff";
  REQUIRE(eventually([&] { return fs::exists(balls); }));
  CHECK(eventually([&] { return session.title().starts_with("circle.wpoff"); }));
  const auto loaded = read_sample_file(balls);
  REQUIRE(loaded);
  REQUIRE(loaded->data.balls.size() == 1);
  const Disk& ball = loaded->data.balls.front();
  CHECK(ball.center.x == Approx((100 - 640) / kPxPerUnit).margin(1e-6));
  CHECK(ball.center.y == Approx((400 - 120) / kPxPerUnit).margin(1e-6));
  CHECK(ball.radius == Approx(60 / kPxPerUnit * 1.1 * 1.1 * 1.1).margin(1e-6));
}

TEST_CASE("what is clicked says where it comes from, until Esc or an edit") {
  Visit session;
  session.show_only_the_drawing();
  const VirtualScreen& screen = session.screen;
  const auto is_card = [](Color c) { return c.r == 0xF7 && c.g == 0xF8 && c.b == 0xF9; };
  const auto has_card = [&] { return screen.shoot().count(is_card) > 10000; };
  REQUIRE_FALSE(has_card());
  const auto click = [&](int x, int y) {
    screen.xdotool("mousemove " + std::to_string(x) + " " + std::to_string(y));
    screen.xdotool("click 1");
  };
  // Within all inner disks, off the axis.
  click(700, 300);
  CHECK(eventually(has_card));
  session.press("Escape");
  CHECK(eventually([&] { return !has_card(); }));
  click(700, 300);
  CHECK(eventually(has_card));
  // Outside there is nothing.
  click(1200, 60);
  CHECK(eventually([&] { return !has_card(); }));
  click(700, 300);
  CHECK(eventually(has_card));
  session.press("i");
  click(1200, 60);
  CHECK(eventually([&] { return !has_card(); }));
}

TEST_CASE("what a clicked sample highlights is kept, undone, and lost with the sample") {
  Visit session;
  session.show_only_the_drawing();
  const VirtualScreen& screen = session.screen;
  const auto is_of_a_product = [](Color c) { return c.r == 0xCC && c.g == 0x79 && c.b == 0xA7; };
  const auto highlighted = [&] { return screen.shoot().count(is_of_a_product); };
  REQUIRE(highlighted() == 0);
  // The sample at the right: with Alt it is asked about, as anything else is without.
  screen.xdotool("mousemove 1000 400 keydown alt click 1 keyup alt");
  REQUIRE(eventually([&] { return highlighted() > 200; }));
  session.press("shift+k");
  static_cast<void>(screen.settled());
  session.press("Escape");
  session.press("v");
  screen.xdotool("mousemove 3 3");
  static_cast<void>(screen.settled());
  CHECK(highlighted() > 200);
  CHECK(session.title().starts_with("* circle.poff"));
  session.press("ctrl+z");
  CHECK(eventually([&] { return highlighted() == 0; }));
  session.press("ctrl+shift+z");
  REQUIRE(eventually([&] { return highlighted() > 200; }));
  screen.click({1000, 400});
  session.press("Delete");
  session.press("Escape");
  screen.xdotool("mousemove 3 3");
  CHECK(eventually([&] { return highlighted() == 0; }));
  session.press("ctrl+z");
  CHECK(eventually([&] { return highlighted() > 200; }));
}

TEST_CASE("a file that cannot be read is a message, and the document stays") {
  Visit session;
  session.show_only_the_drawing();
  std::ofstream(session.folder / "bad.poff") << "POFF 3 0 0\n1 2\n3 x\n5 6\n";
  session.begin("bad.poff");
  const auto is_banner = [](Color c) {
    return std::abs(c.r - 0xFD) < 4 && std::abs(c.g - 0xF1) < 4 && std::abs(c.b - 0xE7) < 4;
  };
  CHECK(eventually([&] { return session.screen.shoot().count(is_banner) > 3000; }));
  CHECK(session.program.is_running());
}

TEST_CASE("without a display there is one line that names the way without, and exit code 4") {
  const TemporaryFolder folder;
  Child program({MESECINA_BINARY},
                {{"DISPLAY", ""},
                 {"WAYLAND_DISPLAY", ""},
                 {"XDG_CONFIG_HOME", folder.path().string()},
                 {"XDG_DATA_HOME", folder.path().string()}},
                folder / "errors");
  CHECK(program.wait() == 4);
  const std::string errors = bytes_of(folder / "errors");
  CHECK(errors.find("mesecina render") != std::string::npos);
  CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
}

TEST_CASE("a sample that is dragged in a pane beside moves in all, and panes close again") {
  Visit session;
  const VirtualScreen& screen = session.screen;
  session.show_only_the_drawing();
  session.press("F6");
  // Two panes of 639 pixels with a gap of 2, fitted with the margin of 40.
  constexpr double kMiddle = 319.5;
  constexpr int kBeside = 641;
  constexpr double kScale = (639.0 - 2 * 40.0) / (2 * kRadius);
  const int right = static_cast<int>(std::lround(kMiddle + kScale * kRadius));
  INFO("the panes did not appear");
  REQUIRE(eventually([&] {
    const Screenshot shot = screen.shoot();
    return shot.is_dark(right, 400) && shot.is_dark(kBeside + right, 400) && shot.is_white(640, 100);
  }));
  screen.xdotool("mousemove 1000 400");
  screen.drag({kBeside + right, 400}, {kBeside + right - 50, 380}, 10);
  screen.xdotool("mouseup 1");
  session.press("Escape");
  screen.xdotool("mousemove 3 3");
  REQUIRE(eventually([&] { return session.title().starts_with("* circle.poff"); }));
  CHECK(eventually([&] {
    const Screenshot shot = screen.shoot();
    return shot.is_dark(right - 50, 380) && shot.is_dark(kBeside + right - 50, 380);
  }));
  session.save();
  const std::vector<Vec2> samples = saved_samples(session.file);
  REQUIRE(samples.size() == kDraggedSamples);
  // The pointer took the sample up to a pixel beside its middle.
  CHECK(samples[0].x == Approx(kRadius - 50 / kScale).margin(1.0 / kScale));
  CHECK(samples[0].y == Approx(20 / kScale).margin(1.0 / kScale));

  session.press("shift+F6");
  screen.xdotool("mousemove 640 400");
  session.press("f");
  screen.xdotool("mousemove 3 3");
  CHECK(eventually([&] {
    const Screenshot shot = screen.shoot();
    return shot.is_dark(640, screen_y(kRadius)) && shot.is_dark(640, screen_y(-kRadius));
  }));
}
