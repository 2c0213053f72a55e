// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manual/markdown.h"

#include <fmt/core.h>
#include <cctype>

#include "core/base/lower_case.h"

namespace mes::cli {
namespace {

// The anchor that GitHub gives to a heading.
std::string anchor_of(std::string_view title) {
  std::string out;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '_' || byte >= 0x80)
      out += lower_case(c);
    else if (c == ' ' || c == '-')
      out += '-';
  }
  return out;
}

}  // namespace

std::string plain(std::string_view text) {
  constexpr std::string_view kMarkup = "\\`*_[]<>|#";
  std::string out;
  for (const char c : text) {
    if (kMarkup.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string code(std::string_view word) {
  return fmt::format("`{}`", word);
}

std::string code(std::span<const std::string_view> words) {
  std::string out;
  for (const std::string_view word : words) out += (out.empty() ? "" : ", ") + code(word);
  return out.empty() ? "-" : out;
}

void Markdown::heading(std::string_view mark, std::string_view title) {
  body_.append(mark).append(" ").append(plain(title)).append("\n\n");
  contents_.append(mark == "##" ? "" : "  ").append("* [").append(plain(title)).append("](#");
  contents_ += anchor_of(title) + ")\n";
}

void Markdown::paragraph(std::string_view text) {
  body_.append(text).append("\n\n");
}

void Markdown::row(const std::vector<std::string>& cells) {
  body_ += '|';
  for (const std::string& cell : cells) body_ += ' ' + cell + " |";
  body_ += '\n';
}

void Markdown::table(const std::vector<std::string>& titles, const std::vector<std::vector<std::string>>& rows) {
  row(titles);
  row(std::vector<std::string>(titles.size(), "---"));
  for (const std::vector<std::string>& cells : rows) row(cells);
  body_ += '\n';
}

void Markdown::block(std::string_view text, std::string_view language) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  body_.append("```").append(language).append("\n").append(text).append("\n```\n\n");
}

std::string Markdown::text() const {
  std::string out = fmt::format("# {}\n\n{}\n\n{}\n{}", title_, introduction_, contents_, body_);
  out.pop_back();  // the empty line after the last paragraph
  return out;
}

}  // namespace mes::cli
