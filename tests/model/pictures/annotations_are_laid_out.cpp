// SPDX-License-Identifier: GPL-3.0-or-later
// What annotations look like: their words, what dimensions measure, where lines end, and what is hit by a click.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "app/picture/annotations/annotation_drawing.h"
#include "app/picture/paper/rich_text.h"
#include "app/store/sample_shapes.h"
#include "core/base/rng.h"
#include "core/document/commands.h"
#include "tests/model/pictures/letters_of_one_width.h"

using namespace mes;
using mes::test::half_size_a_byte;

namespace {

RichText words(std::string_view source) {
  return rich_text(source, "7.5", 10.0, half_size_a_byte);
}

std::string text_shown(const RichText& text) {
  std::string out;
  for (const RichLine& line : text.lines)
    for (const RichPiece& piece : line.pieces) out += piece.text;
  return out;
}

bool is_balanced(const std::string& latex) {
  int depth = 0;
  int dollars = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (latex[i] == '\\')
      ++i;
    else if (latex[i] == '{')
      ++depth;
    else if (latex[i] == '}' && --depth < 0)
      return false;
    else if (latex[i] == '$')
      ++dollars;
  }
  return depth == 0 && dollars % 2 == 0;
}

Document document_with(std::vector<Vec2> samples, Annotations annotations) {
  Document document;
  const auto all = replace_all(document, {.positions = std::move(samples), .annotations = std::move(annotations)});
  REQUIRE(all.has_value());
  document.apply(*all);
  return document;
}

// 100 pixels a unit, the origin at the lower left corner.
constexpr SeenPlane kPlane{.center = {4.0, 3.0}, .units_per_pixel = 0.01, .width = 800.0, .height = 600.0};

AnnotationDrawing drawing_of(const Annotation& annotation, std::vector<Vec2> samples = {}) {
  return layout_annotations(place(document_with(std::move(samples), {annotation})), kPlane, half_size_a_byte,
                            Rgb{255, 255, 255});
}

Annotation of_kind(AnnotationKind kind, std::vector<Vec2> places, std::string text = {}) {
  Annotation out{.kind = kind, .text = std::move(text)};
  for (const Vec2 p : places) out.anchors.push_back({.at = p});
  return out;
}

std::string text_drawn(const AnnotationDrawing& drawing) {
  std::string out;
  for (const PaperDrawing::Line& line : drawing.drawing.lines) out += line.text;
  return out;
}

}  // namespace

TEST_CASE("words are plain, bold, italic, raised and lowered, as a small part of LaTeX says") {
  const RichText plain = words("crust & co, 5% of_it");
  REQUIRE(plain.lines.size() == 1);
  REQUIRE(plain.lines[0].pieces.size() == 1);
  CHECK(plain.complaint.empty());
  CHECK(plain.lines[0].latex == "crust \\& co, 5\\% of\\_it");
  CHECK(plain.lines[0].width == half_size_a_byte("crust & co, 5% of_it", 10.0, Face::plain));

  const RichText radius = words("ball $r_i^2 = 3$");
  REQUIRE(radius.lines.size() == 1);
  CHECK(radius.complaint.empty());
  const std::vector<RichPiece>& pieces = radius.lines[0].pieces;
  REQUIRE(pieces.size() == 6);
  CHECK(pieces[1].text == "r");
  CHECK(pieces[1].face == Face::italic);
  CHECK(pieces[2].text == "i");
  CHECK(pieces[2].raise < 0.0);
  CHECK(pieces[3].text == "2");
  CHECK(pieces[3].face == Face::plain);
  CHECK(pieces[3].raise > 0.0);
  CHECK(pieces[3].size < pieces[1].size);
  // One above the other, and what follows begins after both.
  CHECK(pieces[2].x == pieces[3].x);
  CHECK(pieces[4].x >= pieces[3].x + half_size_a_byte("2", pieces[3].size, Face::plain));
  CHECK(radius.lines[0].latex == "ball $r_{i}^{2} = 3$");

  CHECK(text_shown(words("\\alpha and $\\Omega$, $90^\\circ$")) == "αand Ω, 90°");
  CHECK(words("$-x$").lines[0].pieces[0].text == "−");
  CHECK(words("\\textbf{b} \\emph{i}").lines[0].pieces.front().face == Face::bold);
  CHECK(words("\\textbf{b} \\emph{i}").lines[0].pieces.back().face == Face::italic);
  CHECK(words("$d = \\value$ mm").lines[0].latex == "$d = \\mbox{7.5}$ mm");
  CHECK(words("one\ntwo\\\\three").lines.size() == 3);
  CHECK(words("one\n\ntwo").lines.size() == 3);
  CHECK(words("").lines.empty());
  CHECK(words("$ $\n").lines.empty());
}

TEST_CASE("what is not understood is shown, and said") {
  for (const char* source :
       {"$x", "\\unknown", "\\textbf{open", "$x^$", "$a_b_c$", "\\textbf", "${x$", "$\\frac$", "$\\$", "$x_{$"}) {
    INFO(source);
    const RichText text = words(source);
    CHECK_FALSE(text.complaint.empty());
    CHECK(text.complaint.find('\n') == std::string::npos);
    for (const RichLine& line : text.lines) CHECK(is_balanced(line.latex));
  }
  CHECK(text_shown(words("\\unknown")) == "\\unknown");
  // Nothing reaches TeX but what is listed: a command stands there as its letters.
  CHECK(words("\\input{/etc/passwd}").lines[0].latex.find("\\input") == std::string::npos);
  CHECK(words("$\\write18{x}$").lines[0].latex.find("\\write") == std::string::npos);
}

TEST_CASE("any bytes give words, in time and with closed braces") {
  Rng random(3);
  const std::string_view kAlphabet = "$${}{}__^^\\\\\\ab 1+-=,\n.%&#~'\"\xc3\xb1\xff";
  for (int round = 0; round < 20'000; ++round) {
    std::string source(random.below(30), ' ');
    for (char& c : source) c = kAlphabet[random.below(kAlphabet.size())];
    if (random.below(4) == 0) source.insert(random.below(source.size() + 1), "\\textbf{\\emph{");
    if (random.below(4) == 0) source.insert(random.below(source.size() + 1), "\\mathrm{");
    const RichText text = words(source);
    for (const RichLine& line : text.lines) {
      INFO(source << " -> " << line.latex);
      REQUIRE(is_balanced(line.latex));
      REQUIRE(std::isfinite(line.width));
    }
  }
  CHECK(text_shown(words("a\xff\xc3z\x01\xed\xa0\x80")) == "a??z ???");
  CHECK(words(std::string(4000, '{')).lines.size() == 1);
  CHECK_FALSE(words("$" + std::string(4000, '{')).complaint.empty());
}

TEST_CASE("the fonts have every sign that has a command") {
  const auto fonts = PaperFonts::read(find_assets({}));
  REQUIRE(fonts.has_value());
  for (const RichSign& sign : rich_text_signs()) {
    INFO(sign.command);
    for (const bool is_italic : {false, true}) {
      const std::vector<render::Glyph> glyphs = fonts->of(false, is_italic).glyphs(sign.sign);
      REQUIRE(glyphs.size() == 1);
      CHECK(glyphs[0].index != 0);
    }
  }
}

TEST_CASE("dimensions measure what their places are") {
  CHECK(measured_value(AnnotationKind::distance, {{0, 0}, {3, 4}}) == "5");
  CHECK(measured_value(AnnotationKind::angle, {{1, 0}, {0, 0}, {0, 2}}) == "90°");
  CHECK(measured_value(AnnotationKind::angle, {{1, 0}, {1, 0}, {0, 2}}).empty());
  CHECK(measured_value(AnnotationKind::radius, {{1, 0}, {0, 1}, {-1, 0}}) == "1");
  CHECK(measured_value(AnnotationKind::radius, {{1, 0}, {2, 0}, {3, 0}}).empty());
  CHECK(text_drawn(drawing_of(of_kind(AnnotationKind::distance, {{1, 1}, {4, 5}}))) == "5");
  CHECK(text_drawn(drawing_of(of_kind(AnnotationKind::distance, {{1, 1}, {4, 5}}, "d = \\value m"))) == "d = 5 m");
  CHECK(text_drawn(drawing_of(of_kind(AnnotationKind::distance, {{1, 1}, {4, 5}}, "long"))) == "long");

  const AnnotationDrawing angle = drawing_of(of_kind(AnnotationKind::angle, {{3, 1}, {1, 1}, {1, 3}}));
  REQUIRE(angle.drawing.arcs.size() == 1);
  CHECK(std::abs(angle.drawing.arcs[0].sweep - 0.5 * std::numbers::pi) < 1e-12);
  CHECK(angle.drawing.arcs[0].center == Vec2{100, 500});
  // The words lie within the angle.
  const Vec2 words = 0.5 * (angle.words[0].low + angle.words[0].high);
  CHECK(words.x > 100.0);
  CHECK(words.y < 500.0);

  const AnnotationDrawing circle = drawing_of(of_kind(AnnotationKind::radius, {{3, 2}, {2, 3}, {1, 2}}));
  REQUIRE(circle.drawing.arcs.size() == 1);
  CHECK(circle.drawing.arcs[0].center == Vec2{200, 400});
  CHECK(std::abs(circle.drawing.arcs[0].radius - 100.0) < 1e-9);
}

TEST_CASE("lines end where they lead to") {
  const AnnotationDrawing arrow = drawing_of(of_kind(AnnotationKind::arrow, {{1, 1}, {5, 1}}, "tail"));
  REQUIRE(arrow.drawing.triangles.size() == 1);
  CHECK(arrow.drawing.triangles[0].corners[0] == Vec2{500, 500});
  CHECK(arrow.words[0].high.x < 100.0);

  // A leader stops short of its sample, and follows it.
  Annotation leader = of_kind(AnnotationKind::leader, {{1, 1}}, "here");
  leader.anchors[0].samples = {1};
  leader.shift = {60, -80};
  const AnnotationDrawing led = drawing_of(leader, {{0, 0}, {2, 2}});
  REQUIRE(led.drawing.triangles.size() == 1);
  const double gap = distance(led.drawing.triangles[0].corners[0], {200, 400});
  CHECK(gap > 2.0);
  CHECK(gap < 12.0);
  CHECK(led.words[0].low.x == 260.0);
  // Words over the element need no line.
  leader.shift = {};
  CHECK(drawing_of(leader, {{0, 0}, {2, 2}}).drawing.triangles.empty());
}

TEST_CASE("whatever the places and the view, what is drawn has a place near the picture") {
  Rng random(11);
  const auto any_place = [&]() -> Vec2 {
    const double size = std::exp2(random.uniform(-60.0, 30.0));
    const Vec2 center = random.below(2) == 0 ? Vec2{} : kPlane.center;
    return center + size * Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  };
  for (int round = 0; round < 5000; ++round) {
    const auto kind = static_cast<AnnotationKind>(random.below(kAnnotationKinds));
    HighlightedElement element{kAllPrimitiveKinds[random.below(kPrimitiveKinds)],
                               static_cast<ProvenanceRole>(random.below(3))};
    if (element.kind == PrimitiveKind::circle || element.kind == PrimitiveKind::disk)
      element.radius = std::exp2(random.uniform(-60.0, 30.0));
    const bool is_highlight = kind == AnnotationKind::highlight;
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < (is_highlight ? anchor_count(element.kind) : anchor_count(kind)); ++i)
      places.push_back(i > 0 && random.below(8) == 0 ? places.back() : any_place());
    Annotation annotation = of_kind(kind, places, random.below(2) == 0 ? "" : "words");
    if (is_highlight) annotation.elements = {element};
    annotation.shift = 200.0 * Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    SeenPlane plane = kPlane;
    plane.units_per_pixel = std::exp2(random.uniform(-50.0, 20.0));
    const AnnotationDrawing out =
        layout_annotations(place(document_with({}, {annotation})), plane, half_size_a_byte, std::nullopt);
    const auto is_near = [](Vec2 p) { return std::abs(p.x) < 1e5 && std::abs(p.y) < 1e5; };
    for (const PaperDrawing* const each : {&out.drawing, &out.highlights}) {
      for (const PaperDrawing::Stroke& stroke : each->strokes)
        for (const Vec2 p : stroke.points) REQUIRE(is_near(p));
      for (const PaperDrawing::Arc& arc : each->arcs) REQUIRE((is_near(arc.center) && arc.radius < 1e5));
    }
    for (const PaperDrawing::Triangle& triangle : out.drawing.triangles)
      for (const Vec2 p : triangle.corners) REQUIRE(is_near(p));
    for (const PaperDrawing::Line& line : out.drawing.lines) REQUIRE(is_near({line.x, line.top}));
  }
}

TEST_CASE("an annotation is hit by its words and by its line, the topmost first") {
  Annotation low = of_kind(AnnotationKind::text, {{1, 1}}, "below");
  Annotation high = of_kind(AnnotationKind::distance, {{1, 1}, {5, 1}});
  const AnnotationDrawing both =
      layout_annotations(place(document_with({}, {low, high})), kPlane, half_size_a_byte, Rgb{255, 255, 255});
  CHECK(annotation_at(both, {300, 503}, 5.0) == 1);
  CHECK(annotation_at(both, {110, 495}, 5.0) == 1);
  CHECK(annotation_at(both, {110, 490}, 5.0) == 0);
  CHECK_FALSE(annotation_at(both, {300, 300}, 5.0).has_value());
  // Only the ends of a centre line are its own: what lies between belongs to the drawing.
  const Annotation ends = of_kind(AnnotationKind::center_line, {{1, 1}, {5, 1}});
  const AnnotationDrawing line =
      layout_annotations(place(document_with({}, {ends})), kPlane, half_size_a_byte, Rgb{255, 255, 255});
  CHECK(line.drawing.arcs.size() + line.drawing.strokes.size() >= 2);
  CHECK(annotation_at(line, line.places[0][0], 5.0) == 0);
  CHECK(annotation_at(line, line.places[0][1] + Vec2{3, 3}, 5.0) == 0);
  CHECK_FALSE(annotation_at(line, 0.5 * (line.places[0][0] + line.places[0][1]), 5.0).has_value());
}
