// SPDX-License-Identifier: GPL-3.0-or-later
// Legend, scale bar and title stand in the same places of a picture in pixels and of vector graphics, and apart.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/geometry/box2.h"
#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/golden_image.h"

using mes::Box2;
using mes::Vec2;
using mes::render::Image;
using mes::test::contents_of;
using mes::test::kDude;
using mes::test::read_png;
using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;
using mes::test::with;

namespace {

class Pictures {
 public:
  /// In pixels; what is said goes to `said`.
  Image drawn(const std::vector<std::string>& arguments, const std::string& extension) {
    const std::string file = (folder_.path() / ("x" + extension)).string();
    const RunResult result = run(with(with({"render"}, arguments), {"--no-source", "--force", "-o", file}),
                                 {.environment = {"DISPLAY=", "WAYLAND_DISPLAY="}});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    said = result.err;
    if (extension == ".png") return read_png(file);
    const RunResult other = run({file, "--output", file + ".png"}, {.program = "rsvg-convert"});
    INFO(other.err);
    REQUIRE(other.exit_code == 0);
    return read_png(file + ".png");
  }

  /// The box of the pixels that an option changes.
  Box2 changed(const std::vector<std::string>& arguments, const std::vector<std::string>& off,
               const std::vector<std::string>& on, const std::string& extension) {
    const Image before = drawn(with(arguments, off), extension);
    const Image after = drawn(with(arguments, on), extension);
    REQUIRE(before.width == after.width);
    REQUIRE(before.height == after.height);
    Box2 out;
    for (int y = 0; y < after.height; ++y)
      for (int x = 0; x < after.width; ++x)
        if (!std::equal(&after.rgba[after.offset(x, y)], &after.rgba[after.offset(x, y)] + 4,
                        &before.rgba[before.offset(x, y)]))
          out.add(Box2{{1.0 * x, 1.0 * y}, {x + 1.0, y + 1.0}});
    return out;
  }

  std::string said;

 private:
  TemporaryFolder folder_;
};

/// The box of the frame of a legend: between the first and the last row with so many grey pixels beside each other.
Box2 frame_in(const Image& image) {
  constexpr int kLeastWidth = 100;
  const auto is_frame = [&](int x, int y) {
    const std::uint8_t* const pixel = &image.rgba[image.offset(x, y)];
    return pixel[0] < 250 &&
           std::max({pixel[0], pixel[1], pixel[2]}) - std::min({pixel[0], pixel[1], pixel[2]}) < 16 && pixel[0] > 150;
  };
  Box2 out;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0, run = 0; x < image.width; ++x) {
      run = is_frame(x, y) ? run + 1 : 0;
      if (run >= kLeastWidth) out.add(Box2{{x + 1.0 - run, 1.0 * y}, {x + 1.0, y + 1.0}});
    }
  return out;
}

/// Pixels that are neither grey nor pale within five pixels around a box.
int colored_around(const Image& image, const Box2& box) {
  const Box2 near{box.low - Vec2{5.0, 5.0}, box.high + Vec2{5.0, 5.0}};
  int out = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Vec2 middle{x + 0.5, y + 0.5};
      const std::uint8_t* const pixel = &image.rgba[image.offset(x, y)];
      const int color = std::max({pixel[0], pixel[1], pixel[2]}) - std::min({pixel[0], pixel[1], pixel[2]});
      if (color >= 30 && near.contains(middle) && !box.contains(middle)) ++out;
    }
  return out;
}

bool share_area(const Box2& a, const Box2& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

}  // namespace

TEST_CASE("the key is at one place in pixels and in vectors, clear of scale bar, axes and title") {
  Pictures pictures;
  struct Case {
    std::vector<std::string> base;
    std::vector<std::string> bar;
  };
  const std::vector<Case> cases{
      {{kDude, "--size", "330x433", "--layers", "curve,medial-axis,points"}, {"--scale-bar"}},
      {{kDude, "--size", "330x433", "--layers", "curve,medial-axis,points", "--axes"}, {"--scale-bar"}},
      {{kDude, "--size", "700x300", "--layers", "curve,medial-axis,points"}, {"--scale-bar"}},
      {{kDude, "--size", "500x500", "--layers", "delaunay,points,interior-voronoi-disks"}, {"--scale-bar"}},
      {{"assets/shapes/bean.poff", "--size", "400x300", "--layers", "medial-axis,points", "--title", "A bean"},
       {"--scale-bar"}},
      {{"assets/shapes/lizard.poff", "--size", "600x600", "--axes", "--grid"}, {"--scale-bar-at", "top-left"}},
      {{"assets/shapes/lizard.poff", "--size", "300x600", "--scale", "0.7", "--legend-at", "bottom-left"},
       {"--scale-bar"}},
      {{kDude, "--size", "450x450", "--legend-at", "bottom-right:1,1"}, {"--scale-bar-at", "bottom-right"}}};
  for (const Case& one : cases) {
    CAPTURE(one.base[0], one.base[2], one.base.size());
    std::vector<Box2> keys;
    for (const char* extension : {".png", ".svg"}) {
      const Box2 key = pictures.changed(with(one.base, one.bar), {"--no-legend"}, {"--key"}, extension);
      const Box2 bar = pictures.changed(one.base, {"--no-legend"}, with({"--no-legend"}, one.bar), extension);
      REQUIRE_FALSE(key.is_empty());
      REQUIRE_FALSE(bar.is_empty());
      CHECK_FALSE(share_area(key, bar));
      keys.push_back(key);
    }
    CHECK(keys[0].low.x == Approx(keys[1].low.x).margin(2.0));
    CHECK(keys[0].low.y == Approx(keys[1].low.y).margin(2.0));
    CHECK(keys[0].high.x == Approx(keys[1].high.x).margin(2.0));
    CHECK(keys[0].high.y == Approx(keys[1].high.y).margin(2.0));
  }
}

TEST_CASE("a key for which no corner is free has a strip beside the drawing, in pixels and in vectors") {
  const auto shown = [](const char* shape, const std::vector<std::string>& more) {
    return with(
        {"assets/shapes/" + std::string(shape), "--layers", "interior-voronoi-disks,medial-axis", "--scale-bar"},
        more);
  };
  const std::vector<std::vector<std::string>> cases{
      shown("rounded-rectangle.poff", {"--size", "420x300"}),
      shown("rounded-rectangle.poff", {"--size", "420x330", "--title", "A rectangle", "--axes"}),
      shown("rounded-rectangle.poff", {"--size", "560x240"}),
      shown("plate.poff", {"--size", "500x330"}),
      {kDude, "--size", "330x433", "--scale-bar"},
      // The legend does not fit beside the scale bar.
      {"assets/shapes/elephant.poff", "--size", "330x433", "--scale-bar", "--layers",
       "points,curve,lambda-medial-axis"}};
  Pictures pictures;
  for (const std::vector<std::string>& one : cases) {
    std::vector<Box2> keys;
    for (const char* extension : {".png", ".svg"}) {
      CAPTURE(one, extension);
      CHECK(frame_in(pictures.drawn(with(one, {"--no-legend"}), extension)).is_empty());
      const Image image = pictures.drawn(with(one, {"--key"}), extension);
      CHECK(pictures.said.empty());
      const Box2 key = frame_in(image);
      REQUIRE(key.width() > 100.0);
      REQUIRE(key.height() > 20.0);
      CHECK(colored_around(image, key) == 0);
      keys.push_back(key);
    }
    CHECK(keys[0].low.x == Approx(keys[1].low.x).margin(2.0));
    CHECK(keys[0].high.y == Approx(keys[1].high.y).margin(2.0));
  }
}

TEST_CASE("where there is no room for all, the key has fewer layers, and none where not even one has") {
  Pictures pictures;
  for (const char* extension : {".png", ".svg"}) {
    CAPTURE(extension);
    const std::vector<std::string> low{kDude, "--layers", "all", "--scale-bar", "--size", "330x200"};
    const Box2 key = pictures.changed(low, {"--no-legend"}, {"--key"}, extension);
    CHECK(pictures.said.empty());
    CHECK(key.height() > 30.0);
    CHECK(key.high.y <= 200.0);
    static_cast<void>(pictures.drawn({kDude, "--scale-bar", "--key", "--size", "100x60"}, extension));
    CHECK_THAT(pictures.said,
               Catch::Contains("the legend is left out: there is no room for it beside the scale bar"));
    CHECK(std::ranges::count(pictures.said, '\n') == 1);
    // Without a bar it is there.
    static_cast<void>(pictures.drawn({kDude, "--key", "--size", "100x60"}, extension));
    CHECK(pictures.said.empty());
  }
}

TEST_CASE("a layer that draws nothing has no legend, in any format") {
  const TemporaryFolder folder;
  // Two samples have no axis, and no ball.
  const std::string file = folder.write("two.poff", "POFF 2 0 0\n0 0\n1 1\n").string();
  Pictures pictures;
  for (const char* extension : {".png", ".svg"}) {
    for (const char* layer : {"lambda-medial-axis", "lambda-medial-disks", "medial-axis", "cover-medial-axis"}) {
      CAPTURE(extension, layer);
      const std::vector<std::string> arguments{file,
                                               "--layers",
                                               std::string("points,") + layer,
                                               "--set-style",
                                               std::string(layer) + ":color-map=viridis",
                                               "--size",
                                               "300x200"};
      CHECK(pictures.changed(arguments, {"--no-legend"}, {}, extension).is_empty());
      CHECK_FALSE(pictures.changed(arguments, {"--no-legend"}, {"--key"}, extension).is_empty());
    }
  }
  for (const std::string name : {"x.svg", "x.pdf", "x.tex", "x.ipe", "x.eps"}) {
    const std::string to = (folder.path() / name).string();
    REQUIRE(run({"render", file, "--layers", "lambda-medial-axis", "-o", to}).exit_code == 0);
    CHECK_THAT(contents_of(to), !Catch::Contains("no number is finite"));
  }
}

TEST_CASE("a line of the legend is as wide as those of the layer, where samples are dense as well") {
  const TemporaryFolder folder;
  for (const int samples : {40, 4000}) {
    INFO(samples << " samples");
    std::string circle;
    for (int i = 0; i < samples; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / samples;
      circle += std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + '\n';
    }
    const std::string file = folder.write("circle.xyz", circle).string();
    const std::string figure = (folder / "circle.svg").string();
    REQUIRE(run({"render", file, "--layers", "curve", "--key", "--size", "1200x900", "--no-source", "--force", "-o",
                 figure})
                .exit_code == 0);
    const std::string text = contents_of(figure);
    const auto number_after = [&](const std::string& mark, std::size_t from) {
      const std::size_t at = text.find(mark, from);
      REQUIRE(at != std::string::npos);
      return std::stod(text.substr(at + mark.size()));
    };
    const std::size_t legend = text.find("id=\"legend\"");
    REQUIRE(legend != std::string::npos);
    // The frame, the paper within it, and the line.
    std::size_t line = legend;
    for (int i = 0; i < 3; ++i) line = text.find("<rect", line + 1);
    CHECK(number_after(" height=\"", line) ==
          Approx(number_after("stroke-width=\"", text.find("id=\"curve\""))).epsilon(0.05));
  }
}
