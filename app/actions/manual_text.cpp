// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/manual_text.h"

#include <algorithm>
#include <utility>

#include "core/base/lower_case.h"

namespace mes {
namespace {

constexpr std::string_view kFence = "```";

std::string_view without_spaces(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

bool is_sign(char c) {
  return c > ' ' && c <= '~' && (c < '0' || c > '9') && (c < 'A' || c > 'Z') && (c < 'a' || c > 'z');
}

/// Reads one line of text with its markup.
class InlineReader {
 public:
  explicit InlineReader(std::string_view source) : source_(source) {}

  ManualCell read() {
    while (at_ < source_.size()) step();
    return std::move(out_);
  }

 private:
  void step() {
    const char c = source_[at_];
    if (c == '\\' && at_ + 1 < source_.size() && is_sign(source_[at_ + 1])) {
      out_.text += source_[at_ + 1];
      at_ += 2;
    } else if (c == '`') {
      take_between("`", ManualStyle::code);
    } else if (source_.substr(at_, 2) == "**") {
      take_between("**", ManualStyle::strong);
    } else if (c == '*') {
      take_between("*", ManualStyle::emphasis);
    } else if (c == '[') {
      take_link();
    } else {
      take_letter();
    }
  }

  void take_letter() { out_.text += source_[at_++]; }

  /// The mark is a letter like any other where no second one follows, or where a space is beside it.
  void take_between(std::string_view mark, ManualStyle style) {
    const std::size_t begin = at_ + mark.size();
    const std::size_t end = source_.find(mark, begin);
    if (end == std::string_view::npos || end == begin || source_[begin] == ' ' || source_[end - 1] == ' ')
      return take_letter();
    const std::size_t before = out_.text.size();
    const std::string_view inside = source_.substr(begin, end - begin);
    // Code is literal; in other styles signs may be escaped.
    out_.text += style == ManualStyle::code ? std::string(inside) : InlineReader(inside).read().text;
    out_.spans.push_back({before, out_.text.size(), style});
    at_ = end + mark.size();
  }

  // The window has no pages to go to, so only the words of a link are shown.
  void take_link() {
    const std::size_t middle = source_.find("](", at_);
    const std::size_t end = middle == std::string_view::npos ? middle : source_.find(')', middle);
    if (end == std::string_view::npos) return take_letter();
    out_.text += InlineReader(source_.substr(at_ + 1, middle - at_ - 1)).read().text;
    at_ = end + 1;
  }

  std::string_view source_;
  std::size_t at_ = 0;
  ManualCell out_;
};

ManualCell read_inline(std::string_view source) {
  return InlineReader(source).read();
}

std::vector<ManualCell> cells_of_row(std::string_view line) {
  std::vector<ManualCell> out;
  std::size_t begin = 1;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '|') {
      out.push_back(read_inline(without_spaces(line.substr(begin, i - begin))));
      begin = i + 1;
    }
  }
  return out;
}

// Help pages and examples align words by spaces, which letters of different widths would not keep aligned.
std::vector<ManualCell> cells_of_code(std::string_view line) {
  std::vector<ManualCell> out;
  std::size_t at = line.find_first_not_of(' ');
  while (at < line.size()) {
    const std::size_t end = std::min(line.find("  ", at), line.size());
    out.push_back({.text = std::string(line.substr(at, end - at)), .column = at});
    at = line.find_first_not_of(' ', end);
  }
  if (out.empty()) out.emplace_back();
  return out;
}

class ManualReader {
 public:
  ManualText read(std::string_view markdown) {
    while (!markdown.empty()) {
      const std::size_t end = std::min(markdown.find('\n'), markdown.size());
      read_line(markdown.substr(0, end));
      markdown.remove_prefix(std::min(end + 1, markdown.size()));
    }
    end_paragraph();
    return std::move(out_);
  }

 private:
  void add(ManualBlockKind kind, std::size_t level, std::vector<ManualCell> cells) {
    out_.blocks.push_back({kind, level, std::move(cells)});
  }

  void end_paragraph() {
    if (!paragraph_.empty()) add(ManualBlockKind::paragraph, 0, {read_inline(paragraph_)});
    paragraph_.clear();
  }

  void read_line(std::string_view line) {
    if (line.starts_with(kFence)) {
      end_paragraph();
      is_in_code_ = !is_in_code_;
    } else if (is_in_code_) {
      add(ManualBlockKind::code, 0, cells_of_code(line));
    } else if (line.starts_with('|')) {
      end_paragraph();
      read_row(line);
    } else if (const std::size_t level = line.find_first_not_of('#');
               level > 0 && level < line.size() && line[level] == ' ') {
      end_paragraph();
      out_.headings.push_back(out_.blocks.size());
      add(ManualBlockKind::heading, level, {read_inline(line.substr(level + 1))});
    } else if (const std::size_t mark = line.find_first_not_of(' ');
               mark != std::string_view::npos && line.substr(mark, 2) == "* ") {
      end_paragraph();
      read_item(line.substr(mark + 2), mark / 2);
    } else if (mark == std::string_view::npos) {
      end_paragraph();
      is_in_table_ = false;
    } else {
      paragraph_.append(paragraph_.empty() ? "" : " ").append(line.substr(mark));
    }
  }

  void read_row(std::string_view line) {
    if (line.starts_with("| ---")) return;
    add(is_in_table_ ? ManualBlockKind::row : ManualBlockKind::head, 0, cells_of_row(line));
    is_in_table_ = true;
  }

  void read_item(std::string_view text, std::size_t level) {
    const bool is_of_contents = text.starts_with('[') && text.find("](#") != std::string_view::npos;
    if (!is_of_contents) add(ManualBlockKind::item, level, {read_inline(text)});
  }

  ManualText out_;
  std::string paragraph_;
  bool is_in_code_ = false;
  bool is_in_table_ = false;
};

}  // namespace

ManualStyle ManualBlock::style() const {
  if (kind == ManualBlockKind::heading) return level <= 2 ? ManualStyle::title : ManualStyle::subtitle;
  return kind == ManualBlockKind::head ? ManualStyle::strong : ManualStyle::plain;
}

ManualText read_manual(std::string_view markdown) {
  return ManualReader().read(markdown);
}

std::vector<ManualFind> find_in(const ManualText& manual, std::string_view query) {
  const std::string wanted = lower_case(without_spaces(query));
  std::vector<ManualFind> out;
  if (wanted.empty()) return out;
  for (std::size_t block = 0; block < manual.blocks.size(); ++block)
    for (std::size_t cell = 0; cell < manual.blocks[block].cells.size(); ++cell) {
      const std::string text = lower_case(manual.blocks[block].cells[cell].text);
      for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + wanted.size()))
        out.push_back({block, cell, at, at + wanted.size()});
    }
  return out;
}

std::vector<ManualHeading> headings_of(const ManualText& manual) {
  std::vector<ManualHeading> out;
  std::string section;
  for (const std::size_t block : manual.headings) {
    const ManualBlock& heading = manual.blocks[block];
    if (heading.level < 2) continue;
    const std::string& name = heading.cells.front().text;
    if (heading.level == 2) section = name;
    out.push_back({name, heading.level == 2 ? std::string() : section, block});
  }
  return out;
}

}  // namespace mes
