// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "app/picture/paper/caption_text.h"

using namespace mes;
using Kind = CaptionBlock::Kind;

namespace {

// Each letter is half as wide as it is high; letters of UTF-8 are counted by their bytes.
double half_each(const std::string& text, double size, Face /*face*/) {
  return 0.5 * size * static_cast<double>(text.size());
}

std::string letters_of(const CaptionDrawing& drawn) {
  std::string out;
  for (const PaperDrawing::Line& line : drawn.drawing.lines) out += line.text + '|';
  return out;
}

double right_end(const PaperDrawing::Line& line) {
  return line.x + half_each(line.text, line.size, line.face);
}

}  // namespace

TEST_CASE("headings, paragraphs and lists are blocks") {
  const CaptionText text = caption_text("# One\nTwo\nthree\r\n\n- four\n  five\n- six\n## Seven\n#eight\n#### nine");
  CHECK(text == CaptionText{{Kind::heading, 1, {{"One"}}},
                            {Kind::paragraph, 1, {{"Two three"}}},
                            {Kind::item, 1, {{"four five"}}},
                            {Kind::item, 1, {{"six"}}},
                            {Kind::heading, 2, {{"Seven"}}},
                            {Kind::paragraph, 1, {{"#eight #### nine"}}}});
  CHECK(caption_text("").empty());
  CHECK(caption_text("\n \n\t\n#\n# \n- \n").size() <= 2);
}

TEST_CASE("emphasis and mathematics are spans, and what is not closed stands as it is") {
  const auto spans = [](const char* text) { return caption_text(text).at(0).spans; };
  using Spans = std::vector<CaptionSpan>;
  CHECK(spans("a **b** c") == Spans{{"a "}, {"b", true}, {" c"}});
  CHECK(spans("*a* b") == Spans{{"a", false, true}, {" b"}});
  CHECK(spans("**a *b* c**") == Spans{{"a ", true}, {"b", true, true}, {" c", true}});
  CHECK(spans("*a **b** c*") == Spans{{"a ", false, true}, {"b", true, true}, {" c", false, true}});
  CHECK(spans("$x_1$ is *$y$*") == Spans{{"x_1", false, false, true}, {" is "}, {"y", false, true, true}});
  CHECK(spans("$a * b$ *c*") == Spans{{"a * b", false, false, true}, {" "}, {"c", false, true}});
  CHECK(spans("2 * 3 * 4") == Spans{{"2 * 3 * 4"}});
  CHECK(spans("a ** b") == Spans{{"a ** b"}});
  CHECK(spans("**a") == Spans{{"**a"}});
  CHECK(spans("*a **b*") == Spans{{"a **b", false, true}});
  CHECK(spans("$a") == Spans{{"$a"}});
  CHECK(spans("$$") == Spans{{"$$"}});
  CHECK(spans(R"(\*a\* \$5 \\ \q)") == Spans{{R"(*a* $5 \ \q)"}});
}

TEST_CASE("a caption is called by its first heading, or by how it begins") {
  CHECK(name_of(caption_text("Words\n\n# The **crust** of $P_1$\n")) == "The crust of P1");
  CHECK(name_of(caption_text("Few words")) == "Few words");
  CHECK(name_of(caption_text("")).empty());
  const std::string name =
      name_of(caption_text(std::string(30, 'a') + ' ' + std::string(30, 'b') + " cccccccccccccc"));
  CHECK(name == std::string(30, 'a') + ' ' + std::string(30, 'b') + " …");
  std::string umlauts;
  for (int i = 0; i < 60; ++i) umlauts += "ä";
  CHECK(name_of(caption_text('a' + umlauts)).size() < umlauts.size());
}

TEST_CASE("lines end where the column does, and words of one look stay one text") {
  const CaptionDrawing drawn =
      layout_caption(caption_text("aaa bbb ccc **ddd** eee"), {.width = 41.0, .letters = 10.0}, half_each);
  // Seven letters and a space are 40 wide.
  CHECK(letters_of(drawn) == "aaa bbb|ccc|ddd|eee|");
  for (const PaperDrawing::Line& line : drawn.drawing.lines) CHECK(right_end(line) <= 41.0);
  CHECK(drawn.drawing.lines[1].top == drawn.drawing.lines[2].top);
  CHECK(drawn.drawing.lines[2].x == 20.0);
  CHECK(drawn.drawing.lines[0].top < drawn.drawing.lines[1].top);
  CHECK(drawn.drawing.lines[2].top < drawn.drawing.lines[3].top);
  CHECK(drawn.drawing.height > drawn.drawing.lines.back().top + 10.0);
}

TEST_CASE("a word that is wider than the column is broken, wherever it stands") {
  for (const char* text : {"aaaaaaaaaaaaaaaaaaaa", "a bbbbbbbbbbbbbbbbbbbb", "**a**bbbbbbbbbbbbbbbbbbbbb",
                           "- aaaaaaaaaaaaaaaaaaaaa", "# aaaaaaaaaaaaaaaaaaaaaaaaa"}) {
    INFO(text);
    const CaptionDrawing drawn = layout_caption(caption_text(text), {.width = 40.0, .letters = 10.0}, half_each);
    std::size_t letters = 0;
    for (const PaperDrawing::Line& line : drawn.drawing.lines) {
      CHECK(right_end(line) <= 40.0);
      letters +=
          static_cast<std::size_t>(std::ranges::count_if(line.text, [](char c) { return c == 'a' || c == 'b'; }));
    }
    const std::string whole = text;
    CHECK(letters ==
          static_cast<std::size_t>(std::ranges::count_if(whole, [](char c) { return c == 'a' || c == 'b'; })));
  }
  // Also where a column has no room for a letter, it ends.
  CHECK(layout_caption(caption_text("abc def"), {.width = 1.0, .letters = 10.0}, half_each).drawing.lines.size() ==
        6);
}

TEST_CASE("captions of a lesson have the letters in which the longest of them fits") {
  const CaptionLook look{.width = 100.0, .letters = 10.0};
  std::string words;
  for (int i = 0; i < 30; ++i) words += "abc ";
  const std::vector<CaptionText> all{caption_text("abc"), caption_text(words), caption_text("abc def")};
  const auto size_of = [](const FittedCaption& fitted) { return fitted.drawing.lines.front().size; };
  // The longest alone; in a line of the largest letters there are five words.
  const FittedCaption longest = fit_caption(all[1], look, 60.0, half_each);
  CHECK(longest.is_whole);
  CHECK(size_of(longest) < 10.0);
  CHECK(size_of(fit_caption(all[0], look, 60.0, half_each)) == 10.0);
  for (const CaptionText& one : all) CHECK(size_of(fit_caption(one, look, 60.0, half_each, all)) == size_of(longest));
  // One that is too long even in the smallest letters does not make the others smaller than that.
  for (int i = 0; i < 6; ++i) words += words;
  const std::vector<CaptionText> too_long{caption_text(words), all[0]};
  CHECK_FALSE(fit_caption(too_long[0], look, 60.0, half_each, too_long).is_whole);
  CHECK(size_of(fit_caption(too_long[1], look, 60.0, half_each, too_long)) > 4.0);
}

TEST_CASE("mathematics has its scripts, and complains once") {
  const CaptionDrawing drawn = layout_caption(caption_text("$x_1$ and $\\nonsense$ and $\\other$"), {}, half_each);
  REQUIRE(drawn.drawing.lines.size() > 2);
  CHECK(drawn.drawing.lines[0].text == "x");
  CHECK(drawn.drawing.lines[0].face == Face::italic);
  CHECK(drawn.drawing.lines[1].text == "1");
  CHECK(drawn.drawing.lines[1].size < drawn.drawing.lines[0].size);
  CHECK_THAT(drawn.complaint, Catch::Contains("nonsense") && !Catch::Contains("other"));
}

TEST_CASE("HTML has nothing in it but what was understood") {
  CHECK(html_of(caption_text("# <b>A</b> & \"c\"\n\nIt's **d** *e*\n\n- f\n- $x_1^2$\n\n### g")) ==
        "<h2>&lt;b&gt;A&lt;/b&gt; &amp; &quot;c&quot;</h2>\n"
        "<p>It&#39;s <strong>d</strong> <em>e</em></p>\n"
        "<ul>\n<li>f</li>\n"
        "<li><span class=\"math\"><i>x</i><sub>1</sub><sup>2</sup></span></li>\n</ul>\n"
        "<h4>g</h4>\n");
  CHECK_THAT(html_of(caption_text("$<script>$ <script>alert(1)</script> $\\textbf{</p>}$")),
             !Catch::Contains("<script") && !Catch::Contains("</p>}"));
  CHECK(html_of(caption_text("a\x01\xff\x7f")).find('\x01') == std::string::npos);
}
