// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/drawings/dxf_pairs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/io/text/line_end.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr int kComment = 999;

std::string_view trimmed_line(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\v\f\r";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::size_t last = text.find_last_not_of(kBlanks);
  return last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1);
}

/// Iterates over all lines, including empty ones.
class DxfLines {
 public:
  explicit DxfLines(std::string_view bytes) : rest_(bytes) {}
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = end_of_line(rest_);
    text_ = rest_.substr(0, end);
    ++number_;
    rest_.remove_prefix(std::min(end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1), rest_.size()));
    return true;
  }
  std::string_view text() const { return text_; }
  std::uint32_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::string_view text_;
  std::uint32_t number_ = 0;
};

}  // namespace

Expected<std::vector<DxfPair>> read_dxf_pairs(std::string_view bytes, const std::string& name, ReadJob* job) {
  std::vector<DxfPair> out;
  DxfLines lines(bytes);
  while (lines.next()) {
    if (job != nullptr) job->passed(lines.text().data());
    const std::string_view word = trimmed_line(lines.text());
    int code = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), code);
    if (fault != std::errc{} || end != word.data() + word.size()) {
      const std::uint32_t line = lines.number();
      // An empty line at the end of the file does not begin a pair.
      if (word.empty() && !lines.next()) break;
      return bad_input("expected a group code, found " + in_quotes(word), name, line, 1);
    }
    if (!lines.next()) return bad_input("the file ends within a pair", name, lines.number(), lines.text().size() + 1);
    if (code != kComment) out.push_back({code, trimmed_line(lines.text()), lines.number()});
    if (code == 0 && out.back().value == "EOF") break;
  }
  return out;
}

std::optional<std::string_view> dxf_text(DxfEntity entity, int code) {
  const auto found = std::ranges::find(entity, code, &DxfPair::code);
  if (found == entity.end()) return std::nullopt;
  return found->value;
}

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kDxfUnits{{{"1", "in"},
                                                                                   {"2", "ft"},
                                                                                   {"3", "mi"},
                                                                                   {"4", "mm"},
                                                                                   {"5", "cm"},
                                                                                   {"6", "m"},
                                                                                   {"7", "km"},
                                                                                   {"10", "yd"},
                                                                                   {"13", "um"},
                                                                                   {"14", "dm"}}};

}  // namespace

std::string_view unit_of_dxf_number(std::string_view number) {
  const auto found = std::ranges::find(kDxfUnits, number, [](const auto& pair) { return pair.first; });
  return found == kDxfUnits.end() ? std::string_view() : found->second;
}

std::string_view dxf_number_of_unit(std::string_view unit) {
  const auto found = std::ranges::find(kDxfUnits, unit, [](const auto& pair) { return pair.second; });
  return found == kDxfUnits.end() ? std::string_view() : found->first;
}

}  // namespace mes
