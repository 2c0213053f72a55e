// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <map>
#include <string>

#include "layers_of_a_test.h"
#include "render/figure/internal/grid.h"
#include "render/figure/writers.h"

using namespace mes;
using namespace mes::figure;
using test::count_of;
using test::Layers;
using test::values_of;

namespace {

Layers some_layers() {
  Layers layers;
  layers.add(0, PrimitiveKind::segment, {10, 20, 30, 40, 0, 30, 40, 50, 20, 0, 100, 10, 120, 90, 0});
  layers.add(0, PrimitiveKind::point, {10, 20, 0, 30, 40, 0});
  layers.add(1, PrimitiveKind::disk, {50, 50, 7, 1, 55, 50, 8, 3, 60, 50, 9, 2});
  layers.add(2, PrimitiveKind::arc, {100, 50, 10, 110, 50, 100, 60, 0});
  layers.add(2, PrimitiveKind::circle, {100, 50, 20, 0});
  layers.show(1).color_map = "grey";
  layers.show(0).color = {0x12, 0xAB, 0xEF};
  LayerStyle& third = layers.show(2);
  third.opacity = 0.25;
  third.flat = true;
  return layers;
}

/// A layer of texts alone: plain, and a formula in two parts that TeX has as one.
Figure some_texts() {
  Figure figure{.width = 200.0, .height = 100.0};
  FigureLayer& layer = figure.layers.emplace_back();
  layer.id = "notes";
  layer.title = "Notes";
  const Rgb ink{1, 2, 3};
  layer.texts.push_back(
      {.start = {10, 20}, .size = 12.0, .width = 40.0, .is_bold = true, .color = ink, .text = "a < b_1 "});
  layer.texts.push_back({.start = {10, 50},
                         .size = 12.0,
                         .width = 8.0,
                         .color = ink,
                         .text = "\xCE\xB1",
                         .is_italic = true,
                         .latex = "$\\alpha_1<2$"});
  layer.texts.push_back(
      {.start = {18, 53}, .size = 8.0, .width = 30.0, .color = ink, .text = "one<2", .continues = true});
  layer.texts.push_back(
      {.start = {10, 80}, .size = 12.0, .width = 30.0, .color = ink, .text = "slanted", .is_italic = true});
  return figure;
}

std::string text_of(const char* extension, const Figure& figure) {
  const Format* const format = format_for(extension);
  REQUIRE(format != nullptr);
  const auto text = format->write(figure);
  REQUIRE(text);
  return *text;
}

}  // namespace

TEST_CASE("numbers are written with as many digits as count, and none that do not") {
  const auto written = [](double value, int decimals) {
    std::string out;
    append_decimal(out, value, decimals);
    return out;
  };
  CHECK(written(0.0, 3) == "0");
  CHECK(written(-0.0001, 3) == "0");
  CHECK(written(12.5, 3) == "12.5");
  CHECK(written(-12.034, 3) == "-12.034");
  CHECK(written(0.0509, 2) == "0.05");
  CHECK(written(-0.5, 2) == "-0.5");
  CHECK(written(1e300, 2) == "1000000000");
  CHECK(decimals_for(1200, 900) == 2);
  CHECK(decimals_for(238, 170) == 2);
  CHECK(decimals_for(150, 170) == 3);
  CHECK(decimals_for(2, 1) == 4);
}

TEST_CASE("an SVG has a named group for each layer, with the shapes that the layer holds") {
  const Figure figure = some_layers().figure();
  const std::string svg = text_of(".svg", figure);
  CHECK(values_of(svg, "id") == std::vector<std::string>{"page", "scalars", "plain", "third"});
  CHECK(values_of(svg, "inkscape:label") ==
        std::vector<std::string>{"Scalars", "Plain &amp; &lt;simple&gt;", "Third"});
  CHECK(values_of(svg, "viewBox") == std::vector<std::string>{"0 0 200 100"});
  CHECK(values_of(svg, "width").front() == "70.5556mm");
  CHECK(values_of(svg, "cx") == std::vector<std::string>{"50", "55", "60", "10", "30", "100"});
  CHECK(values_of(svg, "r") == std::vector<std::string>{"7", "8", "9", "1.88", "1.88", "20"});
  // Two segments that meet are one line; the third one belongs to the same path.
  CHECK(values_of(svg, "d") ==
        std::vector<std::string>{"M10 80L30 60L50 80M100 90L120 10", "M110 50A10 10 0 0 0 100 40"});
  CHECK(count_of(svg, "#12abef") == 2);
  CHECK(values_of(svg, "opacity") == std::vector<std::string>{"0.25"});
  CHECK(count_of(svg, "<g") == count_of(svg, "</g>"));
}

TEST_CASE("translucent shapes of an SVG are elements of their own") {
  Layers layers;
  layers.add(0, PrimitiveKind::segment, {10, 20, 30, 40, 0, 30, 40, 50, 20, 0, 100, 10, 120, 90, 0});
  layers.show(0).opacity = 0.5;
  const std::string svg = text_of(".svg", layers.figure());
  CHECK(values_of(svg, "d").size() == 3);
  CHECK(values_of(svg, "stroke-opacity") == std::vector<std::string>{"0.5"});
}

TEST_CASE("long arcs of an SVG are given in pieces that do not hang on the last digit") {
  Layers layers;
  layers.add(0, PrimitiveKind::arc, {100, 50, 40, 140, 50, 100, 10, 0});
  layers.show(0);
  const std::string path = values_of(text_of(".svg", layers.figure()), "d").at(0);
  CHECK(count_of(path, "A40 40 0 0 0 ") == 3);
  CHECK(path.ends_with(" 100 90"));
}

TEST_CASE("parabolas are quadratic curves of an SVG and exact cubic ones elsewhere, in one path with segments") {
  Layers layers;
  // From (10, 20) straight to (40, 50), on by a curve to (100, 50), and back by a segment, given against that order.
  layers.add(0, PrimitiveKind::segment, {40, 50, 10, 20, 0, 10, 20, 100, 50, 0});
  layers.add(0, PrimitiveKind::parabola, {100, 50, 70, 80, 40, 50, 0});
  layers.show(0);
  const Figure figure = layers.figure();
  CHECK(values_of(text_of(".svg", figure), "d") == std::vector<std::string>{"M10 80L100 50Q70 20 40 50L10 80Z"});
  CHECK(count_of(text_of(".ipe", figure), "70 80 40 50 q\n") == 1);
  // 100 + 2/3 (70 - 100) and 40 + 2/3 (70 - 40), and two thirds of the way from 50 to 80.
  CHECK(count_of(text_of(".tex", figure), "(100,50) .. controls (80,70) and (60,70) .. (40,50) -- cycle") == 1);
}

TEST_CASE("a parabola that is straight to the grid is a segment, and of a huge one the part in view is kept") {
  Layers layers;
  layers.add(0, PrimitiveKind::parabola, {10, 20, 50, 20.0001, 90, 20, 0});
  layers.show(0);
  CHECK(values_of(text_of(".svg", layers.figure()), "d") == std::vector<std::string>{"M10 80L90 80"});
  Layers huge;
  // y = x^2 / 100 from x = -10^6 to 10^6.
  huge.add(0, PrimitiveKind::parabola, {-1e6, 1e10, 0, -1e10, 1e6, 1e10, 0});
  huge.show(0);
  const Figure figure = huge.figure();
  REQUIRE(shape_count(figure) > 0);
  for (const Shape& shape : test::shapes_of(figure.layers[0]))
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(std::abs(shape.p[i].x) < 2000.0);
      CHECK(100.0 - shape.p[i].y == Approx(0.01 * shape.p[i].x * shape.p[i].x).margin(0.02));
    }
}

TEST_CASE("a PDF has an optional content group for each layer, and a table of where its objects are") {
  const std::string pdf = text_of(".pdf", some_layers().figure());
  CHECK(count_of(pdf, "/Type/OCG/") == 3);
  // "Third", in UTF-16.
  CHECK(count_of(pdf, "/Name<FEFF00540068006900720064>") == 1);
  CHECK(count_of(pdf, "/MediaBox[0 0 200 100 ]") == 1);
  CHECK(count_of(pdf, "/S/Transparency/I true") == 1);
  CHECK(count_of(pdf, "<</ca 0.25/CA 0.25>>") == 1);
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
  REQUIRE(pdf.substr(table, 5) == "xref\n");
  const std::size_t entries = pdf.find("0000000000 65535 f", table);
  for (std::size_t number = 1; number < count_of(pdf, " obj\n"); ++number) {
    const std::size_t offset = std::stoul(pdf.substr(entries + 20 * number, 10));
    const std::string head = std::to_string(number) + " 0 obj\n";
    CHECK(pdf.substr(offset, head.size()) == head);
  }
}

TEST_CASE("an Ipe file has a layer for each layer, with the shapes that it holds") {
  const std::string ipe = text_of(".ipe", some_layers().figure());
  CHECK(values_of(ipe, "name") == std::vector<std::string>{"mesecina", "opacity-0.25", "scalars", "plain", "third"});
  CHECK(values_of(ipe, "layers") == std::vector<std::string>{"scalars plain third"});
  CHECK(values_of(ipe, "layer") == std::vector<std::string>{"scalars", "plain", "third"});
  CHECK(values_of(ipe, "paper") == std::vector<std::string>{"200 100"});
  // Three disks, two points, a circle.
  CHECK(count_of(ipe, " e\n") == 6);
  CHECK(count_of(ipe, "10 80 m\n") == 0);
  CHECK(count_of(ipe, "10 20 m\n30 40 l\n50 20 l\n") == 1);
  CHECK(count_of(ipe, "110 50 m\n10 0 0 10 100 50 100 60 a\n") == 1);
  CHECK(count_of(ipe, "<path") == count_of(ipe, "</path>"));
  CHECK(count_of(ipe, "<group") == count_of(ipe, "</group>"));
}

TEST_CASE("a flat layer of several colours is a picture in Ipe, and one of one colour is not") {
  Figure figure = some_layers().figure();
  const std::string before = text_of(".ipe", figure);
  CHECK(count_of(before, "<image") == 0);
  Group* flat = nullptr;
  for (FigureLayer& layer : figure.layers)
    for (Group& group : layer.groups)
      if (group.opacity < 1.0) flat = &group;
  REQUIRE(flat != nullptr);
  Run other = flat->runs.front();
  other.color = {1, 2, 3};
  flat->runs.push_back(other);
  const std::string after = text_of(".ipe", figure);
  CHECK(count_of(after, "<image") == 1);
  CHECK(count_of(after, "<layer name=") == count_of(before, "<layer name="));
}

TEST_CASE("a figure that would be too large is refused, before it takes memory") {
  const Figure figure = some_layers().figure();
  for (const Format& format : formats()) {
    INFO(format.name);
    const auto whole = bytes_of(figure, format);
    REQUIRE(whole);
    CHECK(bytes_of(figure, format, whole->size()));
    for (const std::size_t most : {std::size_t{0}, std::size_t{8}, whole->size() - 1}) {
      const auto refused = bytes_of(figure, format, most);
      REQUIRE_FALSE(refused);
      CHECK(refused.error().code == ErrorCode::usage);
    }
  }
}

TEST_CASE("the size of a figure of many shapes is known about without writing it") {
  Figure figure = some_layers().figure();
  Run chain;
  Run dots;
  Vec2 last{10, 10};
  for (int i = 0; i < 150'000; ++i) {
    const Vec2 next{10.0 + std::fmod(0.37 * i, 90.0), 10.0 + std::fmod(0.11 * i, 60.0)};
    chain.shapes.push_back({ShapeKind::segment, {last, next}});
    if (i % 3 == 0) dots.shapes.push_back({ShapeKind::disk, {next}, 0.5});
    last = next;
  }
  chain.is_filled = false;
  dots.opacity = 0.5;
  figure.layers.push_back({.id = "many", .title = "Many", .groups = {{.runs = {chain, dots}}}});
  for (const Format& format : formats()) {
    if (!format.grows) continue;
    INFO(format.name);
    const auto estimated = estimated_bytes(figure, format);
    const auto written = bytes_of(figure, format);
    REQUIRE(estimated);
    REQUIRE(written);
    CHECK(static_cast<double>(*estimated) == Approx(static_cast<double>(written->size())).epsilon(0.1));
    const auto refused = bytes_of(figure, format, written->size() / 2);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::usage);
  }
}

TEST_CASE("a TikZ picture has a scope for each layer, with the shapes that it holds") {
  const std::string tex = text_of(".tex", some_layers().figure());
  for (const char* const layer : {"% layer scalars:", "% layer plain:", "% layer third:"})
    CHECK(count_of(tex, layer) == 1);
  // And one for the flat group.
  CHECK(count_of(tex, "\\begin{scope}") == 4);
  CHECK(count_of(tex, "\\end{scope}") == 4);
  CHECK(count_of(tex, " circle[radius=") == 6);
  CHECK(count_of(tex, " (10,20) -- (30,40) -- (50,20)") == 1);
  CHECK(count_of(tex, " (110,50) arc[start angle=0,delta angle=90,radius=10bp]") == 1);
  CHECK(count_of(tex, "{HTML}{12ABEF}") == 1);
  CHECK(count_of(tex, "transparency group,opacity=0.25") == 1);
}

TEST_CASE("many shapes are in parts of a TikZ picture, which TeX writes out one by one") {
  Figure figure = some_layers().figure();
  Run run;
  run.color = {1, 2, 3};
  for (int i = 0; i < 3000; ++i) run.shapes.push_back({ShapeKind::disk, {Vec2{1.0 + 0.01 * i, 2.0}}, 1.0});
  Run translucent = run;
  translucent.opacity = 0.5;
  figure.layers.push_back({.id = "many", .title = "Many", .groups = {{.runs = {run, translucent}}}});
  const std::string before = text_of(".tex", some_layers().figure());
  const std::string tex = text_of(".tex", figure);
  const std::string form = "\\def\\pdfxform{\\immediate";
  CHECK(count_of(before, form) == 0);
  CHECK(count_of(tex, form) == 1);
  // 2000, 1000 and 1000, 2000.
  CHECK(count_of(tex, "\\begin{scope}[transparency group]\n") == 3);
  CHECK(count_of(tex, " circle[radius=") == count_of(before, " circle[radius=") + 6000);
  CHECK(count_of(tex, "\\begin{scope}") == count_of(tex, "\\end{scope}"));
}

TEST_CASE("every colour of a TikZ picture is defined above it") {
  Figure figure = some_layers().figure();
  figure.background = Rgb{1, 2, 3};
  figure.legend.boxes.push_back({{0, 0}, 10, 10, {4, 5, 6}});
  const std::string tex = text_of(".tex", figure);
  const std::size_t begin = tex.find("\\begin{tikzpicture}");
  const std::string definitions = tex.substr(0, begin);
  std::size_t used = 0;
  for (std::size_t at = tex.find("mesecina", begin); at != std::string::npos; at = tex.find("mesecina", at + 1)) {
    const std::string name = tex.substr(at, tex.find_first_of(",]", at) - at);
    CHECK(count_of(definitions, '{' + name + '}') == 1);
    ++used;
  }
  CHECK(used >= 7);
}

TEST_CASE("texts of a layer are in it, above its shapes, in all formats") {
  Figure figure = some_texts();
  const std::string svg = text_of(".svg", figure);
  CHECK(values_of(svg, "id") == std::vector<std::string>{"page", "notes"});
  CHECK(count_of(svg, "<text") == 4);
  CHECK(count_of(svg, "xml:space=\"preserve\">a &lt; b_1 </text>") == 1);
  CHECK(count_of(svg, "font-style=\"italic\"") == 2);
  CHECK(values_of(svg, "font-weight") == std::vector<std::string>{"600"});
  CHECK(values_of(svg, "textLength") == std::vector<std::string>{"40", "8", "30", "30"});
  CHECK(count_of(text_of(".pdf", figure), "/Type/OCG/") == 1);
  const std::string ipe = text_of(".ipe", figure);
  CHECK(count_of(ipe, "<group layer=\"notes\" clip=") == 1);
  CHECK(count_of(ipe, ">\\textsf{\\bfseries a &lt; b\\_1 }</text>") == 1);
  CHECK(count_of(ipe, "pos=\"10 50\"") == 1);
  CHECK(count_of(ipe, ">\\textsf{$\\alpha_1&lt;2$}</text>") == 1);
  CHECK(count_of(ipe, ">\\textsf{\\itshape slanted}</text>") == 1);
  CHECK(count_of(ipe, "<text") == 3);
  const std::string tex = text_of(".tex", figure);
  CHECK(count_of(tex, "\\sffamily\\bfseries\\fontsize") == 1);
  CHECK(count_of(tex, "\\sffamily\\itshape\\fontsize") == 1);
  CHECK(count_of(tex, "at (10,50) {$\\alpha_1<2$};\n") == 1);
  CHECK(count_of(tex, "\\node") == 3);
  CHECK(tex.find("\\node") > tex.find("\\begin{scope}"));
  CHECK(tex.rfind("\\node") < tex.find("\\end{scope}"));
  // TeX of its own says itself what is bold in it.
  figure.layers[0].texts[1].is_bold = true;
  CHECK(count_of(text_of(".tex", figure), "\\sffamily\\bfseries\\fontsize") == 1);
  CHECK(count_of(text_of(".ipe", figure), ">\\textsf{$\\alpha_1&lt;2$}</text>") == 1);
  // What continues a text that TeX has no own words for is written by itself.
  figure.layers[0].texts[1].latex.clear();
  CHECK(count_of(text_of(".tex", figure), "\\node") == 4);
  figure.layers[0].texts.clear();
  for (const Format& format : formats()) {
    INFO(format.name);
    CHECK(text_of(format.extension.data(), some_texts()).size() >
          text_of(format.extension.data(), figure).size() + 100);
  }
}

TEST_CASE("every format paints the dots of a legend") {
  Figure figure = some_layers().figure();
  std::map<std::string, std::string> without;
  for (const Format& format : formats())
    without[std::string(format.extension)] = text_of(format.extension.data(), figure);
  Run dot{.color = {7, 8, 9}, .opacity = 1.0, .is_filled = true, .dashes = {}, .shapes = {}};
  dot.shapes.push_back({.kind = ShapeKind::disk, .p = {Vec2{50.0, 50.0}}, .radius = 3.0, .sweep = 0.0});
  figure.legend.runs.push_back(dot);
  for (const Format& format : formats()) {
    INFO(format.name);
    CHECK(text_of(format.extension.data(), figure).size() > without[std::string(format.extension)].size());
  }
  CHECK(count_of(text_of(".svg", figure), "<circle fill=\"#070809\" cx=\"50\" cy=\"50\" r=\"3\"/>") == 1);
  CHECK(count_of(text_of(".ipe", figure), "3 0 0 3 50 50 e\n") == 1);
  CHECK(count_of(text_of(".tex", figure), " (50,50) circle[radius=3bp]") == 1);
}

TEST_CASE("PostScript says its size, and nothing that changes from run to run") {
  const Figure figure = some_layers().figure();
  const std::string eps = text_of(".eps", figure);
  CHECK(eps.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
  CHECK(count_of(eps, "CreationDate") == 0);
  CHECK(text_of(".ps", figure).starts_with("%!PS-Adobe-3.0\n"));
}

TEST_CASE("the bytes depend on the figure alone, not on the locale") {
  const Figure figure = some_layers().figure();
  for (const Format& format : formats()) {
    INFO(format.name);
    const std::string before = text_of(format.extension.data(), figure);
    // Where it is installed, numbers have a comma.
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    const std::string after = text_of(format.extension.data(), figure);
    std::setlocale(LC_ALL, "C");
    CHECK(before == after);
    CHECK_FALSE(before.empty());
  }
}
