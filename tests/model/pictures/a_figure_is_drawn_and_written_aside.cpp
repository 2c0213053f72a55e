// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>
#include <string>

#include "app/export/latest_figure.h"
#include "core/builtins/builtins.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using test::TemporaryFolder;

namespace {

SampleData samples_of_circle(int n) {
  SampleData out;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    out.positions.push_back({10.0 + 3.0 * std::cos(angle), 20.0 + 3.0 * std::sin(angle)});
  }
  return out;
}

/// What a window of 800 x 600 logical pixels shows, 0.01 units each.
FigureSubject subject_of(SampleData data) {
  FigureSubject out;
  out.data = std::move(data);
  out.shown.descriptors = layer_descriptors();
  for (const LayerDescriptor& layer : layer_descriptors()) out.shown.styles.push_back(layer.style);
  out.shown.layers = {find_layer("delaunay"), find_layer("points")};
  out.shown.background = Rgb{27, 30, 34};
  out.maps = render::builtin_color_maps();
  out.view = {.center = {10.0, 20.0}, .units_per_point = 0.01 / 0.75, .width = 600.0, .height = 450.0};
  out.canvas_width = 800.0;
  return out;
}

/// Waits as the window does, frame by frame.
struct FigureBench {
  std::atomic<int> wakes = 0;
  LatestFigure latest{builtins(), [this] {
                        ++wakes;
                        wakes.notify_all();
                      }};

  template <class Condition>
  void until(Condition condition) {
    for (;;) {
      const int seen = wakes;
      latest.follow();
      if (condition()) return;
      wakes.wait(seen);
    }
  }
  void until_written() {
    until([this] { return latest.bytes() != nullptr || latest.problem(); });
  }
};

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("a figure is previewed as it is written, with the size asked for") {
  FigureBench test;
  test.latest.begin(subject_of(samples_of_circle(60)));
  const FigureSettings settings{.extension = ".svg", .width_mm = 254.0};
  test.latest.want(settings, {}, 400);
  CHECK(test.latest.is_drawing());
  test.until_written();
  REQUIRE(test.latest.preview() != nullptr);
  REQUIRE(test.latest.bytes() != nullptr);
  CHECK_FALSE(test.latest.is_drawing());
  const FigurePreview& preview = *test.latest.preview();
  CHECK(preview.width == Approx(720.0));
  CHECK(preview.height == Approx(540.0));
  CHECK(preview.image.width == 400);
  CHECK(preview.image.height == 300);
  REQUIRE(preview.layers.size() == 2);
  CHECK(preview.layers[0].id == "delaunay");
  // 2n - 3 edges of points in convex position; all are in view.
  CHECK(preview.layers[0].shapes == 117);
  CHECK(preview.layers[1].shapes == 60);
  CHECK(preview.shapes == 177);
  CHECK(test.latest.bytes()->find("width=\"254mm\"") != std::string::npos);
}

TEST_CASE("everything is seen where the view shows a part, and paper and lines are as chosen") {
  FigureBench test;
  FigureSubject subject = subject_of(samples_of_circle(60));
  subject.view.units_per_point = 0.001;
  test.latest.begin(std::move(subject));
  test.latest.want({.extension = ".svg"}, {}, 200);
  test.until_written();
  CHECK(test.latest.preview()->layers[1].shapes == 0);
  test.latest.want({.extension = ".svg", .extent = FigureExtent::everything, .paper = FigurePaper::transparent}, {},
                   200);
  test.until_written();
  CHECK(test.latest.preview()->layers[1].shapes == 60);
  CHECK(test.latest.preview()->image.rgba[3] == 0);
  const std::string usual = *test.latest.bytes();
  test.latest.want({.extension = ".svg", .extent = FigureExtent::everything, .letters_pt = 19.5 * figure::kEmOfSize},
                   {}, 200);
  test.until_written();
  // A line one pixel wide is three quarters of a point where letters of 13 pixels are. Points are no lines.
  CHECK(test.latest.preview()->finest == Approx(1.5));
  CHECK(test.latest.preview()->widest == Approx(1.5));
  CHECK(test.latest.preview()->image.rgba[3] == 255);
  CHECK(*test.latest.bytes() != usual);
}

TEST_CASE("a figure fits for print: letters of seven to eight points, lines of half a point at least") {
  for (const int samples : {60, 20'000}) {
    FigureBench test;
    FigureSubject subject = subject_of(samples_of_circle(samples));
    for (LayerStyle& style : subject.shown.styles) style.line_width_px = 0.25;
    test.latest.begin(std::move(subject));
    FigureSettings settings{.extension = ".svg", .extent = FigureExtent::everything};
    settings.with_key = settings.marks.bar = settings.marks.axes = true;
    test.latest.want(settings, {}, 200);
    test.until_written();
    REQUIRE(test.latest.preview());
    CHECK(test.latest.preview()->finest == Approx(0.5));
    std::size_t texts = 0;
    const std::string& svg = *test.latest.bytes();
    constexpr std::string_view kSize = "font-size=\"";
    for (std::size_t at = svg.find(kSize); at != std::string::npos; at = svg.find(kSize, at + 1), ++texts) {
      const double points = std::stod(svg.substr(at + kSize.size()));
      CHECK(points == Approx(7.5).margin(0.01));
    }
    CHECK(texts > 3);
  }
}

TEST_CASE("a layer that is to be a picture is one, in formats that hold pictures") {
  FigureBench test;
  test.latest.begin(subject_of(samples_of_circle(60)));
  test.latest.want({.extension = ".pdf"}, {"delaunay"}, 200);
  test.until_written();
  REQUIRE(test.latest.preview() != nullptr);
  CHECK(test.latest.preview()->layers[0].is_picture);
  CHECK(test.latest.preview()->layers[0].shapes == 0);
  test.latest.want({.extension = ".tex"}, {"delaunay"}, 200);
  test.until_written();
  CHECK_FALSE(test.latest.preview()->layers[0].is_picture);
}

TEST_CASE("a file has the bytes that were shown, and what cannot be written is said") {
  TemporaryFolder folder;
  FigureBench test;
  test.latest.begin(subject_of(samples_of_circle(30)));
  test.latest.want({.extension = ".svg"}, {}, 100);
  // Asked for before it is drawn.
  test.latest.save(folder / "a.svg");
  std::optional<LatestFigure::Saved> saved;
  const auto is_saved = [&] {
    saved = test.latest.take_saved();
    return saved.has_value();
  };
  test.until(is_saved);
  CHECK(saved->outcome);
  REQUIRE(test.latest.bytes() != nullptr);
  CHECK(content(folder / "a.svg") == *test.latest.bytes());
  test.latest.save(folder / "missing" / "a.svg");
  test.until(is_saved);
  REQUIRE_FALSE(saved->outcome);
  CHECK(saved->outcome.error().code == ErrorCode::cannot_write);
  CHECK_FALSE(test.latest.is_saving());
}

TEST_CASE("what a figure cannot be is said, and the next settings are tried") {
  FigureBench test;
  FigureSubject subject = subject_of(samples_of_circle(30));
  test.latest.begin(subject);
  test.latest.want({.extension = ".gif"}, {}, 100);
  test.until_written();
  REQUIRE(test.latest.problem());
  CHECK(test.latest.problem()->code == ErrorCode::usage);
  test.latest.want({.extension = ".pdf"}, {}, 100);
  test.until_written();
  CHECK_FALSE(test.latest.problem());
  // A picture of a page 5 metres wide at 2400 dots an inch.
  test.latest.want({.extension = ".pdf", .width_mm = 5080.0, .dots_per_inch = 2400.0}, {"delaunay"}, 100);
  test.until_written();
  REQUIRE(test.latest.problem());
  CHECK(test.latest.problem()->code == ErrorCode::usage);
}

TEST_CASE("a figure of nothing is an empty page") {
  for (const int n : {0, 1, 2}) {
    FigureBench test;
    test.latest.begin(subject_of(samples_of_circle(n)));
    for (const FigureExtent extent : {FigureExtent::view, FigureExtent::everything, FigureExtent::ink})
      for (const figure::Format& format : figure::formats()) {
        test.latest.want({.extension = std::string(format.extension), .extent = extent}, {"points"}, 64);
        test.until_written();
        INFO(n << " samples, " << format.name);
        CHECK_FALSE(test.latest.problem());
        CHECK(test.latest.bytes() != nullptr);
      }
  }
}

TEST_CASE("what is given up leaves nothing behind, and the next one is another") {
  FigureBench test;
  test.latest.begin(subject_of(samples_of_circle(2000)));
  test.latest.want({.extension = ".svg"}, {}, 100);
  test.latest.end();
  CHECK_FALSE(test.latest.is_open());
  CHECK(test.latest.preview() == nullptr);
  test.latest.begin(subject_of(samples_of_circle(7)));
  test.until_written();
  CHECK(test.latest.preview()->layers[1].shapes == 7);
}

namespace {

/// The same samples, the first of them somewhere else.
std::shared_ptr<const SampleData> with_first_at(SampleData data, Vec2 place) {
  data.positions.front() = place;
  return std::make_shared<const SampleData>(std::move(data));
}

FigureSubject subject_of_panes(int n) {
  FigureSubject out = subject_of(samples_of_circle(n));
  out.shown.layers = {find_layer("points")};
  const auto data = std::make_shared<const SampleData>(out.data);
  out.panes = {{"here", out.shown, out.settings, data},
               {"there", out.shown, out.settings, with_first_at(out.data, {10.0, 20.0})}};
  return out;
}

/// The text of a group, up to the next one.
std::string group_of(const std::string& svg, const std::string& id) {
  const std::size_t begin = svg.find("<g id=\"" + id + "\"");
  if (begin == std::string::npos) return {};
  return svg.substr(begin, svg.find("inkscape:groupmode", svg.find('>', begin)) - begin);
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t out = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++out;
  return out;
}

}  // namespace

TEST_CASE("a figure of panes has all of them beside each other, or the main one as it is alone") {
  FigureBench test;
  const FigureSettings settings{.extension = ".svg", .width_mm = 254.0, .as_on_screen = true, .with_source = false};
  test.latest.begin(subject_of_panes(60));
  CHECK(test.latest.has_panes());
  test.latest.want(settings, {}, 400);
  test.until_written();
  REQUIRE(test.latest.bytes() != nullptr);
  const FigurePreview& preview = *test.latest.preview();
  // As wide as two canvases of 800 pixels with 16 between them; each as high as the canvas, with a label of 30.
  CHECK(preview.width == Approx(720.0));
  CHECK(preview.height == Approx(720.0 * 630.0 / 1616.0));
  REQUIRE(preview.layers.size() == 1);
  CHECK(preview.layers[0].id == "points");
  CHECK(preview.layers[0].title == "Points");
  CHECK(preview.layers[0].shapes == 120);
  const std::string all = *test.latest.bytes();
  CHECK(occurrences(group_of(all, "pane-a-points"), "<circle") == 60);
  CHECK(occurrences(group_of(all, "pane-b-points"), "<circle") == 60);
  CHECK(occurrences(all, ">(a) here</text>") == 1);
  CHECK(occurrences(all, ">(b) there</text>") == 1);

  FigureSettings main = settings;
  main.all_panes = false;
  test.latest.want(main, {}, 400);
  test.until_written();
  const std::string one = *test.latest.bytes();
  FigureSubject alone = subject_of_panes(60);
  alone.panes.clear();
  test.latest.begin(std::move(alone));
  CHECK_FALSE(test.latest.has_panes());
  test.latest.want(settings, {}, 400);
  test.until_written();
  CHECK(*test.latest.bytes() == one);
}

TEST_CASE("what only some of the panes have is marked where that is wanted") {
  FigureBench test;
  test.latest.begin(subject_of_panes(60));
  FigureSettings settings{.extension = ".svg", .width_mm = 254.0, .with_source = false};
  test.latest.want(settings, {}, 100);
  test.until_written();
  CHECK(test.latest.bytes()->find("only-here") == std::string::npos);
  settings.with_differences = true;
  test.latest.want(settings, {}, 100);
  test.until_written();
  for (const std::string pane : {"pane-a-", "pane-b-"})
    CHECK(occurrences(group_of(*test.latest.bytes(), pane + "points-only-here"), "<circle") == 1);
}

TEST_CASE("a layer of all panes becomes a picture in each of them") {
  FigureBench test;
  test.latest.begin(subject_of_panes(60));
  test.latest.want({.extension = ".svg", .with_source = false}, {"points"}, 100);
  test.until_written();
  REQUIRE(test.latest.preview()->layers.size() == 1);
  CHECK(test.latest.preview()->layers[0].is_picture);
  CHECK(occurrences(*test.latest.bytes(), "<image") == 2);
}

TEST_CASE("panes that a page has no room for are refused, and panes of nothing are empty") {
  FigureBench test;
  test.latest.begin(subject_of_panes(60));
  test.latest.want({.extension = ".svg", .width_mm = 5.0}, {}, 100);
  test.until_written();
  REQUIRE(test.latest.problem());
  CHECK(test.latest.problem()->code == ErrorCode::usage);
  CHECK(test.latest.problem()->text == "the picture is too small for 2 panes");
  FigureSubject nothing = subject_of(samples_of_circle(0));
  const auto data = std::make_shared<const SampleData>();
  nothing.panes = {{"a", nothing.shown, nothing.settings, data}, {"b", nothing.shown, nothing.settings, data}};
  test.latest.begin(std::move(nothing));
  test.latest.want({.extension = ".pdf", .extent = FigureExtent::everything, .with_differences = true}, {}, 100);
  test.until_written();
  CHECK_FALSE(test.latest.problem());
  CHECK(test.latest.bytes() != nullptr);
}

TEST_CASE("a figure that TeX is slow with is warned of, with its number of shapes and the time") {
  CHECK(tex_warning(kMostTexShapes, ".tex").empty());
  CHECK(tex_warning(10 * kMostTexShapes, ".pdf").empty());
  const std::string warning = tex_warning(123'456, ".tex");
  CHECK(warning.find("123456 shapes") != std::string::npos);
  CHECK(warning.find("2 minutes") != std::string::npos);
  CHECK(warning.find('\n') == std::string::npos);
}
