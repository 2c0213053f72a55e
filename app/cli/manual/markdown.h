// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Markdown for GitHub: headings with a table of contents, paragraphs, tables, code blocks.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mes::cli {

/// Escapes markup in text for a cell or a paragraph.
std::string plain(std::string_view text);
/// The words as code, separated by commas; `-` if there are no words.
std::string code(std::span<const std::string_view> words);
std::string code(std::string_view word);

/// Smallest use:
///     Markdown page("Manual");
///     page.section("Keys");
///     page.table({"Key", "What it does"}, {{code("Ctrl+S"), "Saves"}});
///     out = page.text();
class Markdown {
 public:
  explicit Markdown(std::string_view title) : title_(title) {}

  /// Sets the text before the table of contents.
  void introduction(std::string_view text) { introduction_ = text; }
  void section(std::string_view title) { heading("##", title); }
  void subsection(std::string_view title) { heading("###", title); }
  void paragraph(std::string_view text);
  void table(const std::vector<std::string>& titles, const std::vector<std::vector<std::string>>& rows);
  void block(std::string_view text, std::string_view language = {});

  std::string text() const;

 private:
  void heading(std::string_view mark, std::string_view title);
  void row(const std::vector<std::string>& cells);

  std::string title_;
  std::string introduction_;
  std::string contents_;
  std::string body_;
};

}  // namespace mes::cli
