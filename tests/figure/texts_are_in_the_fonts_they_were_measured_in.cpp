// SPDX-License-Identifier: GPL-3.0-or-later
// Text of figures, as other programs read and draw it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <thread>

#include "layers_of_a_test.h"
#include "render/figure/raster.h"
#include "render/figure/writers.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/golden_image.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

using namespace mes;
using namespace mes::figure;
using test::count_of;
using test::TemporaryFolder;

namespace {

constexpr const char* kFormula = "αβ → Γ ≤ 5°";
constexpr double kPageWidth = 240.0;
constexpr double kPageHeight = 120.0;

std::shared_ptr<const Fonts> fonts() {
  const auto read = [](const std::string& name) {
    auto font = render::Font::read("assets/fonts/Inter-" + name + ".otf");
    REQUIRE(font);
    return std::move(*font);
  };
  static const auto kept = std::make_shared<const Fonts>(read("Regular"), read("SemiBold"), read("Italic"));
  return kept;
}

Text text_at(Vec2 start, double size, const std::string& text, bool is_bold = false, bool is_italic = false) {
  return {.start = start,
          .size = size,
          .width = render::text_width(fonts()->of(is_bold, is_italic), size, text),
          .is_bold = is_bold,
          .text = text,
          .is_italic = is_italic};
}

Figure figure_of_texts(std::vector<Text> texts) {
  Figure figure{.width = kPageWidth, .height = kPageHeight, .background = Rgb{255, 255, 255}};
  figure.layers.push_back({.id = "notes", .title = "Notes", .texts = std::move(texts)});
  figure.fonts = fonts();
  return figure;
}

Figure page_of_texts() {
  return figure_of_texts({text_at({10, 30}, 24.0, kFormula), text_at({10, 65}, 24.0, "AVATAR, Tofu", true),
                          text_at({10, 100}, 24.0, "∞ ∂ √ ϑ ϕ ϵ ℓ ∅ x′", false, true)});
}

/// While there is one, what is lost is not reported: cairo 1.16 does not free 810 bytes of fonts that it puts into
/// PostScript.
struct LossesOfCairo {
#ifdef __SANITIZE_ADDRESS__
  LossesOfCairo() {
    __lsan_disable();
  }
  ~LossesOfCairo() {
    __lsan_enable();
  }
  LossesOfCairo(const LossesOfCairo&) = delete;
  LossesOfCairo& operator=(const LossesOfCairo&) = delete;
#endif
};

std::string output_of(const std::string& program, const std::vector<std::string>& arguments) {
  const test::RunResult result = test::run(arguments, {.program = program});
  INFO(program << ": " << result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  return result.out;
}

std::string pdf_file(const TemporaryFolder& folder, const Figure& figure) {
  const auto pdf = pdf_of(figure);
  REQUIRE(pdf);
  return folder.write("figure.pdf", *pdf).string();
}

bool is_dark(const render::Image& image, int x, int y) {
  return image.rgba[image.offset(x, y)] < 128;
}

/// The last column in which something dark is.
int last_dark_column(const render::Image& image) {
  for (int x = image.width; x-- > 0;)
    for (int y = 0; y < image.height; ++y)
      if (is_dark(image, x, y)) return x;
  return -1;
}

}  // namespace

TEST_CASE("a PDF carries the fonts that occur, and its text can be searched and copied") {
  const TemporaryFolder folder;
  const std::string file = pdf_file(folder, figure_of_texts({text_at({10, 30}, 24.0, kFormula)}));
  CHECK(output_of("pdftotext", {file, "-"}) == std::string(kFormula) + "\n\n\f");
  const std::string one = output_of("pdffonts", {file});
  CHECK(count_of(one, "+Inter-Regular") == 1);
  CHECK(count_of(one, "Identity-H       yes yes yes") == 1);
  CHECK(count_of(one, "Inter-") == 1);
  CHECK(count_of(output_of("pdffonts", {pdf_file(folder, page_of_texts())}), "yes yes yes") == 3);
}

TEST_CASE("a PDF looks as the picture of its figure") {
  const TemporaryFolder folder;
  const Figure figure = page_of_texts();
  const std::string file = pdf_file(folder, figure);
  output_of("pdftocairo", {"-singlefile", "-png", "-r", "288", file, file});
  const render::Image there = test::read_png(file + ".png");
  const auto here = picture_of(figure, 4.0);
  REQUIRE(here);
  REQUIRE(there.width == here->width);
  REQUIRE(there.height == here->height);
  double sum = 0.0;
  double ink = 0.0;
  for (std::size_t i = 0; i < there.rgba.size(); i += 4) {
    sum += std::abs(int{there.rgba[i]} - int{here->rgba[i]});
    ink += 255 - int{here->rgba[i]};
  }
  CHECK(ink > 0.0);
  CHECK(sum < 0.05 * ink);
}

TEST_CASE("letters are as wide as measured, kerning included") {
  // Each "A" and "V" overlap.
  for (const char* const letters : {"AVAVAVAVAV", "MMMMMM", "ToToToTo"}) {
    const Text text = text_at({10, 60}, 24.0, letters);
    const Figure figure = figure_of_texts({text});
    const TemporaryFolder folder;
    const std::string file = pdf_file(folder, figure);
    output_of("pdftocairo", {"-singlefile", "-png", "-r", "288", file, file});
    const auto here = picture_of(figure, 4.0);
    REQUIRE(here);
    // From the last letter to its end there is some room.
    constexpr double kMostRoom = 2.5;
    for (const render::Image& image : {test::read_png(file + ".png"), *here}) {
      const double end = (last_dark_column(image) + 1) / 4.0;
      CHECK(end <= text.start.x + text.width + 0.25);
      CHECK(end >= text.start.x + text.width - kMostRoom);
    }
  }
}

TEST_CASE("text that is wider than it was measured becomes narrower in pictures") {
  Text text = text_at({10, 60}, 24.0, "MMMMMM");
  text.width *= 0.5;
  const auto picture = picture_of(figure_of_texts({text}), 4.0);
  REQUIRE(picture);
  CHECK(last_dark_column(*picture) / 4.0 <= text.start.x + text.width);
}

TEST_CASE("letters that a font lacks, and bytes that are none, are shown as its empty box") {
  const Figure figure = figure_of_texts({text_at({10, 60}, 24.0, "\xE4\xB8\xAD\xFF")});
  const TemporaryFolder folder;
  const std::string file = pdf_file(folder, figure);
  output_of("pdftocairo", {"-singlefile", "-png", "-r", "288", file, file});
  const auto here = picture_of(figure, 4.0);
  REQUIRE(here);
  CHECK(last_dark_column(*here) > 60);
  CHECK(std::abs(last_dark_column(test::read_png(file + ".png")) - last_dark_column(*here)) <= 1);
  [[maybe_unused]] const LossesOfCairo losses;
  for (const Format& format : formats()) CHECK(format.write(figure));
}

TEST_CASE("a figure without fonts names Helvetica") {
  Figure figure = page_of_texts();
  figure.fonts.reset();
  const auto pdf = pdf_of(figure);
  REQUIRE(pdf);
  for (const char* const look : {"/Helvetica/", "/Helvetica-Bold/", "/Helvetica-Oblique/"})
    CHECK(count_of(*pdf, "/BaseFont" + std::string(look)) == 1);
  CHECK(count_of(*pdf, "/FontFile3") == 0);
  CHECK(picture_of(figure, 1.0));
}

TEST_CASE("PostScript carries its letters") {
  const Figure figure = page_of_texts();
  [[maybe_unused]] const LossesOfCairo losses;
  const auto eps = eps_of(figure);
  REQUIRE(eps);
  CHECK(count_of(*eps, "Helvetica") == 0);
  CHECK(count_of(*eps, "%%BeginResource: font") >= 3);
  CHECK(*eps_of(figure) == *eps);
}

TEST_CASE("several threads paint text at the same time") {
  const Figure figure = page_of_texts();
  const auto expected = picture_of(figure, 2.0);
  REQUIRE(expected);
  std::vector<int> good(4);
  {
    std::vector<std::jthread> threads;
    for (int& count : good)
      threads.emplace_back([&] {
        for (int i = 0; i < 20; ++i) {
          const auto picture = picture_of(figure, 2.0);
          count += picture && picture->rgba == expected->rgba ? 1 : 0;
        }
      });
  }
  for (const int count : good) CHECK(count == 20);
}
