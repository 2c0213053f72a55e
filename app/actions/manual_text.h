// SPDX-License-Identifier: GPL-3.0-or-later
// The manual as blocks of text, read from the Markdown that `mesecina manual` writes, and the places of a word in it.
//
// Guarantees: every letter that a reader of the Markdown sees is in a block, in the same order. The table of contents
// is left out, because the headings are listed beside the text.
//
// Smallest use:
//     const ManualText manual = read_manual("# Keys\n\nThe key `V` selects.\n");
//     const std::vector<ManualFind> finds = find_in(manual, "select");
//     // finds[0].block == 1
//
// Cost: linear in the text. Threads: none.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mes {

enum class ManualStyle : std::uint8_t { plain, code, strong, emphasis, title, subtitle };

/// A part of a text in another style than the rest.
struct ManualSpan {
  std::size_t begin = 0;  ///< bytes of the text
  std::size_t end = 0;
  ManualStyle style = ManualStyle::plain;
  friend bool operator==(const ManualSpan&, const ManualSpan&) = default;
};

struct ManualCell {
  std::string text{};
  std::vector<ManualSpan> spans{};  ///< in order, disjoint
  std::size_t column = 0;           ///< characters to the left of it in a line of code
  friend bool operator==(const ManualCell&, const ManualCell&) = default;
};

enum class ManualBlockKind : std::uint8_t {
  heading,
  paragraph,
  item,  ///< of a list
  code,  ///< one line of code; its cells are the words that two or more spaces separate
  head,  ///< the titles of a table, whose rows follow
  row,
};

struct ManualBlock {
  ManualBlockKind kind = ManualBlockKind::paragraph;
  std::size_t level = 0;  ///< of a heading, from 1; of an item, from 0
  std::vector<ManualCell> cells{};
  /// The style of its text outside the spans.
  ManualStyle style() const;
  friend bool operator==(const ManualBlock&, const ManualBlock&) = default;
};

struct ManualText {
  std::vector<ManualBlock> blocks{};
  std::vector<std::size_t> headings{};  ///< blocks
};

/// Reads the subset of Markdown that the program writes: headings, paragraphs, lists, tables, blocks of code and,
/// within a line, code, bold, italics, links and escaped signs. Everything else is text.
ManualText read_manual(std::string_view markdown);

/// A stretch of text that equals the words searched for.
struct ManualFind {
  std::size_t block = 0;
  std::size_t cell = 0;
  std::size_t begin = 0;  ///< bytes of the text of the cell
  std::size_t end = 0;
  friend auto operator<=>(const ManualFind&, const ManualFind&) = default;
};

/// All stretches that equal the query, in any case, in the order of the text. Spaces around the query do not count.
std::vector<ManualFind> find_in(const ManualText& manual, std::string_view query);

/// A heading, with the heading of the section that it is in, which is empty for a section.
struct ManualHeading {
  std::string name{};
  std::string section{};
  std::size_t block = 0;
};
/// The headings of sections and their parts, without the title of the manual.
std::vector<ManualHeading> headings_of(const ManualText& manual);

}  // namespace mes
