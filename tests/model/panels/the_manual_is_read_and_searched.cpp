// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>

#include "app/actions/manual_layout.h"
#include "app/actions/manual_text.h"
#include "core/base/lower_case.h"

using namespace mes;

namespace {

std::string whole_manual() {
  std::ifstream file("docs/manual.md");
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || byte >= 0x80)
      out.back() += c;
    else if (!out.back().empty())
      out.emplace_back();
  }
  if (out.back().empty()) out.pop_back();
  return out;
}

// Every byte is six units wide, and a line is twenty high; titles are twice as large.
ManualMetrics six_a_byte(double width) {
  return {
      .width = width,
      .unit = 1.0,
      .measure = [](std::string_view text,
                    ManualStyle style) { return (style == ManualStyle::title ? 12.0 : 6.0) * double(text.size()); },
      .line = [](ManualStyle style) { return style == ManualStyle::title ? 40.0 : 20.0; }};
}

std::string text_of(const ManualText& manual, const ManualPiece& piece) {
  return manual.blocks[piece.block].cells[piece.cell].text.substr(piece.begin, piece.end - piece.begin);
}

}  // namespace

TEST_CASE("headings, paragraphs, lists, tables and code are blocks, and marks are styles") {
  const ManualText manual = read_manual(
      "# Manual\n\n* [Keys](#keys)\n\n## Keys\n\nThe key `V` selects\n*all* of **it**; 2 * 3 * 4.\n\n* one\n"
      "  * two \\* three\n\n| Key | Use |\n| --- | --- |\n| `A`, `B` | a \\| b |\n\n```sh\n  -o FILE    "
      "Output\n\n```\n");
  REQUIRE(manual.blocks.size() == 9);
  CHECK(manual.headings == std::vector<std::size_t>{0, 1});
  CHECK(manual.blocks[2].cells.front().text == "The key V selects all of it; 2 * 3 * 4.");
  CHECK(manual.blocks[2].cells.front().spans == std::vector<ManualSpan>{{8, 9, ManualStyle::code},
                                                                        {18, 21, ManualStyle::emphasis},
                                                                        {25, 27, ManualStyle::strong}});
  CHECK(manual.blocks[4] == ManualBlock{ManualBlockKind::item, 1, {{.text = "two * three"}}});
  CHECK(manual.blocks[5].kind == ManualBlockKind::head);
  CHECK(manual.blocks[6].cells[0].text == "A, B");
  CHECK(manual.blocks[6].cells[1].text == "a | b");
  CHECK(manual.blocks[7] ==
        ManualBlock{ManualBlockKind::code, 0, {{.text = "-o FILE", .column = 2}, {.text = "Output", .column = 13}}});
  CHECK(manual.blocks[8].cells == std::vector<ManualCell>(1));
  const auto headings = headings_of(manual);
  REQUIRE(headings.size() == 1);
  CHECK(headings.front().name == "Keys");
}

TEST_CASE("every word of the program's own manual is in its blocks, in order, but for the table of contents") {
  const std::string markdown = whole_manual();
  const ManualText manual = read_manual(markdown);
  std::string shown;
  for (const ManualBlock& block : manual.blocks)
    for (const ManualCell& cell : block.cells) shown += cell.text + '\n';
  std::string expected = std::regex_replace(markdown, std::regex(R"(\n *\* \[[^\n]*\]\(#[^\n]*)"), "");
  expected = std::regex_replace(expected, std::regex(R"(\]\([^)\n]*\))"), "");
  expected = std::regex_replace(expected, std::regex("```[a-z]*"), "");
  const std::vector<std::string> words = words_of(expected);
  REQUIRE(words.size() > 10000);
  CHECK(words_of(shown) == words);
  // The list beside the text has the headings of the table of contents.
  const auto entries = std::count(markdown.begin(), markdown.end(), '#');
  REQUIRE(entries > 0);
  std::string contents;
  for (const ManualHeading& heading : headings_of(manual)) contents += heading.name + '\n';
  const std::regex entry(R"(\n *\* \[([^\n]*)\]\(#)");
  std::string listed;
  for (auto at = std::sregex_iterator(markdown.begin(), markdown.end(), entry); at != std::sregex_iterator(); ++at)
    listed += std::regex_replace((*at)[1].str(), std::regex(R"(\\(.))"), "$1") + '\n';
  CHECK(contents == listed);
}

TEST_CASE("words are found in any case, in the order of the text, and none is found twice") {
  const ManualText manual =
      read_manual("# Axis\n\nThe axis; axisaxis.\n\n| A | B |\n| --- | --- |\n| x | The AXIS |\n");
  const auto finds = find_in(manual, " AxIs ");
  REQUIRE(finds.size() == 5);
  CHECK(std::ranges::is_sorted(finds));
  for (const ManualFind& find : finds)
    CHECK(lower_case(manual.blocks[find.block].cells[find.cell].text.substr(find.begin, find.end - find.begin)) ==
          "axis");
  CHECK(finds.back().cell == 1);
  CHECK(find_in(manual, " ").empty());
  CHECK(find_in(manual, "axes").empty());
}

TEST_CASE("the manual stays within every width, loses nothing, and its blocks do not overlap") {
  const ManualText manual = read_manual(whole_manual());
  for (const double width : {150.0, 420.0, 900.0}) {
    const ManualLayout page = lay_out(manual, six_a_byte(width));
    REQUIRE(page.blocks.size() == manual.blocks.size() + 1);
    double bottom = 0.0;
    for (std::size_t block = 0; block < manual.blocks.size(); ++block) {
      INFO(width << ", block " << block);
      CHECK(page.blocks[block].top >= bottom);
      bottom = page.blocks[block].bottom;
      std::string shown;
      std::string written;
      for (const ManualCell& cell : manual.blocks[block].cells) written += cell.text;
      for (std::size_t i = page.blocks[block].first_piece; i < page.blocks[block + 1].first_piece; ++i) {
        const ManualPiece& piece = page.pieces[i];
        if (piece.block == block) shown += text_of(manual, piece);
        const bool is_one_letter = piece.end - piece.begin == 1;
        CHECK((piece.x + piece.width <= width + 1e-3 || is_one_letter));
        CHECK(piece.x >= 0.0);
        CHECK(piece.y >= page.blocks[block].top);
        CHECK(piece.y + 20.0 <= bottom);
      }
      std::erase(shown, ' ');
      std::erase(written, ' ');
      CHECK(shown == written);
    }
    CHECK(page.height >= bottom);
  }
}

TEST_CASE("cells of a table begin below each other, and so do words of code") {
  const ManualText manual = read_manual(
      "| A | B |\n| --- | --- |\n| one two three | x |\n| 1 | a long explanation that takes several lines |\n\n"
      "```\n-o FILE    Output\n-x         Other\n--a-very-long-option=VALUE  Third\n```\n");
  ManualLayout page = lay_out(manual, six_a_byte(200.0));
  const auto first_of = [&](std::size_t block, std::size_t cell) {
    return page.piece_of({.block = block, .cell = cell, .begin = 0, .end = 1});
  };
  CHECK(first_of(1, 1).x == first_of(2, 1).x);
  CHECK(first_of(0, 1).x == first_of(2, 1).x);
  CHECK(first_of(2, 1).x > first_of(1, 0).x + first_of(1, 0).width);
  CHECK(first_of(2, 0).y == first_of(2, 1).y);
  CHECK(first_of(3, 1).x == first_of(4, 1).x);
  CHECK(first_of(3, 1).y > first_of(3, 0).y);  // the option reaches into the column of the explanations
  page = lay_out(manual, six_a_byte(500.0));
  CHECK(first_of(3, 1).x == first_of(4, 1).x);
  CHECK(first_of(3, 1).y == first_of(3, 0).y);
  CHECK(first_of(5, 1).x > first_of(4, 1).x);
}

TEST_CASE("cells of a table that is wider than the page lie below each other, with their titles") {
  const ManualText manual = read_manual(
      "| Name | Meaning | Number |\n| --- | --- | --- |\n| something | somewhere | |\n| one | extraordinary | 3 |\n");
  const ManualLayout page = lay_out(manual, six_a_byte(150.0));
  std::vector<std::string> shown;
  double y = -1.0;
  for (std::size_t i = page.blocks[1].first_piece; i < page.pieces.size(); ++i) {
    const ManualPiece& piece = page.pieces[i];
    if (piece.y > y) shown.emplace_back();
    y = piece.y;
    shown.back() += text_of(manual, piece) + ';';
  }
  CHECK(shown ==
        std::vector<std::string>{"something;", "Meaning;somewhere;", "one;", "Meaning;extraordinary;", "Number;3;"});
  // The titles above are found in their own row, not in those that show them again.
  CHECK(page.piece_of({.block = 0, .cell = 1, .begin = 0, .end = 1}).y < page.blocks[1].top);
}

TEST_CASE("what lies in view is found, and where a find begins") {
  const ManualText manual = read_manual(whole_manual());
  const ManualLayout page = lay_out(manual, six_a_byte(400.0));
  for (const double top : {0.0, 0.3 * page.height, page.height - 100.0}) {
    const auto [first, last] = page.blocks_between(top, top + 500.0);
    for (std::size_t block = 0; block < manual.blocks.size(); ++block) {
      const bool is_seen = page.blocks[block].bottom >= top && page.blocks[block].top <= top + 500.0;
      CHECK(is_seen == (first <= block && block < last));
    }
  }
  const auto finds = find_in(manual, "medial axis");
  REQUIRE(finds.size() > 10);
  for (const ManualFind& find : finds) {
    const ManualPiece& piece = page.piece_of(find);
    CHECK(piece.block == find.block);
    CHECK(piece.cell == find.cell);
    CHECK(piece.begin <= find.begin);
    CHECK(find.begin < piece.end);
  }
}
