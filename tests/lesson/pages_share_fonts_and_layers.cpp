// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "app/export/lessons/lesson_pages.h"
#include "core/builtins/builtins.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using mes::test::run;
using mes::test::TemporaryFolder;

namespace {

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++out;
  return out;
}

figure::FigureLayer layer(const char* id) {
  return {.id = id, .title = std::string("Title of ") + id};
}

std::string said_by(const std::string& program, const std::vector<std::string>& arguments) {
  const auto result = run(arguments, {.program = program});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  return result.out;
}

Session two_steps() {
  Session session;
  session.title = "Session";
  session.data = std::make_shared<const SampleData>(SampleData{.positions = {{0, 0}, {4, 0}, {4, 3}, {0, 3}}});
  const LayerStyle style;
  session.lesson = {"Äpfel (a) \\ b",
                    {{.caption = "# First ä $\\alpha$\n\nWords", .layers = {{{"points", true, style}}, {}}},
                     {.caption = "No heading", .layers = {{{"voronoi", true, style}, {"points", true, style}}, {}}},
                     {.layers = {{{"points", true, style}}, {}}}}};
  return session;
}

}  // namespace

TEST_CASE("a layer is one group for all pages, and each new one lies where its page has it") {
  const figure::Figure first{.width = 100, .height = 50, .layers = {layer("b"), layer("d")}};
  const figure::Figure second{.width = 60, .height = 50, .layers = {layer("a"), layer("b"), layer("c"), layer("d")}};
  figure::PdfBook book({});
  book.add({.width = 100, .height = 50, .figures = {{&first, {}}}});
  book.add({.width = 100, .height = 50, .figures = {{&second, {40, 0}}}});
  const std::string pdf = std::move(book).file();
  CHECK(count_of(pdf, "/Type/Page/") == 2);
  CHECK(count_of(pdf, "/Type/OCG/") == 4);
  CHECK(count_of(pdf, "/ListMode/VisiblePages") == 1);
  CHECK(count_of(pdf, "/Outlines") == 0);
  // Objects are numbered as they are met: b and d, then a and c. The order is from the top.
  std::vector<std::size_t> numbers;
  for (const char letter : {'d', 'c', 'b', 'a'}) {
    std::string title = "<FEFF";
    for (const char c : std::string("Title of ") + letter) {
      constexpr std::string_view kDigits = "0123456789ABCDEF";
      title += "00";
      title += kDigits[static_cast<unsigned char>(c) / 16U];
      title += kDigits[static_cast<unsigned char>(c) % 16U];
    }
    const std::size_t at = pdf.find(title);
    REQUIRE(at != std::string::npos);
    const std::size_t line = pdf.rfind('\n', pdf.rfind(" 0 obj", at)) + 1;
    numbers.push_back(std::stoul(pdf.substr(line)));
  }
  std::string order = "/Order[";
  for (const std::size_t number : numbers) order += std::to_string(number) + " 0 R ";
  CHECK_THAT(pdf, Catch::Contains(order + ']'));
}

TEST_CASE("a lesson is a page a step, with its words, an outline and one set of fonts") {
  const Session session = two_steps();
  auto printer = LessonPrinter::make(builtins(), session, {});
  REQUIRE(printer);
  figure::PdfBook book(printer->info());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto page = printer->page(i);
    REQUIRE(page);
    CHECK(page->remarks.empty());
    names.push_back(page->name);
    book.add(sheet_of(*page));
  }
  CHECK(names == std::vector<std::string>{"First ä α", "No heading", "Step 3"});
  const TemporaryFolder folder;
  const std::string file = folder / "lesson.pdf";
  std::ofstream(file, std::ios::binary) << std::move(book).file();
  CHECK_THAT(said_by("pdfinfo", {file}), Catch::Contains("Pages:           3") && Catch::Contains("960 x 540 pts") &&
                                             Catch::Contains("Äpfel (a) \\ b"));
  CHECK_THAT(said_by("pdftotext", {"-f", "1", "-l", "1", file, "-"}),
             Catch::Contains("First ä α") && Catch::Contains("Words") && Catch::Contains("Äpfel (a) \\ b"));
  CHECK_THAT(said_by("pdftotext", {"-f", "2", "-l", "2", file, "-"}), Catch::Contains("No heading"));
  const std::string fonts = said_by("pdffonts", {file});
  CHECK(count_of(fonts, "Inter-Regular") == 1);
  const std::string pdf = mes::test::contents_of(file);
  CHECK(count_of(pdf, "/Type/Outlines") == 1);
  CHECK(count_of(pdf, "/Dest[") == 3);
}

TEST_CASE("a page does not depend on those drawn before it") {
  const Session session = two_steps();
  auto printer = LessonPrinter::make(builtins(), session, {});
  auto other = LessonPrinter::make(builtins(), session, {});
  REQUIRE(printer);
  REQUIRE(other);
  REQUIRE(printer->page(2));
  REQUIRE(printer->page(0));
  const auto after = printer->page(1);
  const auto alone = other->page(1);
  REQUIRE(after);
  REQUIRE(alone);
  const auto pdf_with = [&](const LessonPage& page) {
    figure::PdfBook book(printer->info());
    book.add(sheet_of(page));
    return std::move(book).file();
  };
  CHECK(pdf_with(*after) == pdf_with(*alone));
}

TEST_CASE("a caption that is too long becomes smaller, and then ends with its page") {
  Session session = two_steps();
  std::string words;
  while (words.size() < 9'000) words += "words and more ";
  session.lesson.steps = {{.caption = words.substr(0, 1500)}, {.caption = words}, {.caption = "$\\nonsense$"}};
  auto printer = LessonPrinter::make(builtins(), session, {});
  REQUIRE(printer);
  const auto smaller = printer->page(0);
  const auto cut = printer->page(1);
  const auto odd = printer->page(2);
  REQUIRE(smaller);
  REQUIRE(cut);
  REQUIRE(odd);
  CHECK(smaller->remarks.empty());
  REQUIRE(cut->remarks.size() == 1);
  CHECK_THAT(cut->remarks[0], Catch::StartsWith("step 2: ") && Catch::Contains("longer than its page"));
  REQUIRE(odd->remarks.size() == 1);
  CHECK_THAT(odd->remarks[0], Catch::StartsWith("step 3: ") && Catch::Contains("nonsense"));
  for (const LessonPage* page : {&*smaller, &*cut})
    for (const figure::Text& text : page->paper.legend.texts) {
      CHECK(text.start.x + text.width <= page->corner.x);
      CHECK(text.start.y <= page->paper.height);
    }
}

TEST_CASE("drawing and caption share the page, whatever its shape") {
  for (const auto& [width, height] :
       std::vector<std::pair<double, double>>{{960, 540}, {540, 960}, {300, 300}, {1000, 200}, {200, 1000}}) {
    const LessonLayout layout = lesson_layout(width, height);
    INFO(width << 'x' << height);
    for (const Box2& box : {layout.drawing, layout.caption}) {
      CHECK(box.width() > 0.2 * width);
      CHECK(box.height() > 0.2 * height);
      CHECK(box.low.x >= 0.0);
      CHECK(box.low.y >= 0.0);
      CHECK(box.high.x <= width);
      CHECK(box.high.y <= height);
    }
    CHECK((layout.caption.high.x <= layout.drawing.low.x || layout.caption.low.y >= layout.drawing.high.y));
    CHECK(layout.number.y >= layout.caption.high.y);
    CHECK(layout.number.y + 0.62 * layout.letters <= height);
  }
}

TEST_CASE("a page in pixels has its drawing beside its caption") {
  const Session session = two_steps();
  auto printer = LessonPrinter::make(builtins(), session, {});
  REQUIRE(printer);
  const auto page = printer->page(1);
  REQUIRE(page);
  const auto image = picture_of(*page, 0.5);
  REQUIRE(image);
  CHECK(image->width == 480);
  CHECK(image->height == 270);
  const auto inks = [&](int left, int right) {
    std::size_t out = 0;
    for (int y = 0; y < image->height; ++y)
      for (int x = left; x < right; ++x) out += image->rgba[image->offset(x, y)] < 200 ? 1U : 0U;
    return out;
  };
  const int border = static_cast<int>(0.5 * page->corner.x);
  CHECK(inks(0, border) > 20);
  CHECK(inks(border, image->width) > 20);
}
