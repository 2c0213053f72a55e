// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text/line_words.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "core/io/text/ascii_text.h"
#include "core/io/text/line_end.h"

namespace mes {
namespace {

void append_words(std::string_view text, std::vector<std::string_view>& out) {
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    while (at != end && is_blank(*at)) ++at;
    if (at == end) return;
    const char* const begin = at;
    while (at != end && !is_blank(*at)) ++at;
    out.emplace_back(begin, at);
  }
}

}  // namespace

LineWords::LineWords(std::string_view bytes, const std::string& name, ReadJob* job, Lines lines)
    : rest_(without_bom(bytes)), name_(name), job_(job), lines_(lines) {}

bool LineWords::next() {
  words_.clear();
  const char* begin = nullptr;  // start of a continued line
  while (!rest_.empty()) {
    if (job_ != nullptr) job_->passed(rest_.data());
    const std::size_t end = end_of_line(rest_);
    std::string_view own = rest_.substr(0, end);
    if (begin == nullptr) begin = own.data();
    text_ = {begin, own.data() + own.size()};
    ++line_;
    const std::size_t ending = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
    rest_.remove_prefix(std::min(end + ending, rest_.size()));
    own = own.substr(0, own.find('#'));
    const bool goes_on = lines_ == Lines::continued && own.ends_with('\\');
    if (goes_on) own.remove_suffix(1);
    append_words(own, words_);
    if (goes_on) continue;
    if (!words_.empty()) return true;
    begin = nullptr;
  }
  line_ = std::max<std::uint64_t>(line_, 1);
  return !words_.empty();
}

std::unexpected<Error> LineWords::refuse(std::size_t i, std::string text) const {
  std::string_view before = text_;
  if (i < words_.size()) before = {text_.data(), words_[i].data()};
  // A continued line has line ends within.
  std::uint64_t line = line_;
  for (std::string_view after = text_.substr(before.size()); end_of_line(after) < after.size(); --line)
    after.remove_prefix(end_of_line(after) + (after.substr(end_of_line(after)).starts_with("\r\n") ? 2 : 1));
  const std::size_t last_end = before.find_last_of("\r\n");
  const std::size_t start = last_end == std::string_view::npos ? 0 : last_end + 1;
  return bad_input(std::move(text), name_, line, before.size() - start + 1);
}

Expected<std::uint64_t> LineWords::whole(std::size_t i, std::string_view what) const {
  if (i >= count()) return refuse(i, fmt::format("expected {}, found the end of the line", what));
  if (const auto value = parse_count(words_[i])) return *value;
  return refuse(i, fmt::format("expected {}, found {}", what, in_quotes(words_[i])));
}

Expected<double> LineWords::number(std::size_t i, std::string_view what) const {
  if (i >= count()) return refuse(i, fmt::format("expected {}, found the end of the line", what));
  if (const auto value = parse_number(words_[i])) return *value;
  return refuse(i, fmt::format("expected {}, found {}", what, in_quotes(words_[i])));
}

Expected<Vec2> LineWords::position(std::size_t i) {
  Vec2 out;
  double* const parts[]{&out.x, &out.y};
  for (std::size_t k = 0; k < 2; ++k) {
    if (i + k >= count()) return refuse(i + k, "expected a coordinate, found the end of the line");
    auto value = coordinates_.read(words_[i + k]);
    if (!value) return refuse(i + k, std::move(value.error()));
    *parts[k] = *value;
  }
  return out;
}

}  // namespace mes
