// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/line_words.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "core/io/line_end.h"

namespace mes {
namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

void split_at_blanks(std::string_view text, std::vector<std::string_view>& out) {
  out.clear();
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

LineWords::LineWords(std::string_view bytes, const std::string& name, ReadJob* job)
    : rest_(without_bom(bytes)), name_(name), job_(job) {}

bool LineWords::next() {
  while (!rest_.empty()) {
    if (job_ != nullptr) job_->passed(rest_.data());
    const std::size_t end = end_of_line(rest_);
    text_ = rest_.substr(0, end);
    ++line_;
    const std::size_t ending = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
    rest_.remove_prefix(std::min(end + ending, rest_.size()));
    split_at_blanks(text_.substr(0, text_.find('#')), words_);
    if (!words_.empty()) return true;
  }
  words_.clear();
  line_ = std::max<std::uint64_t>(line_, 1);
  return false;
}

std::unexpected<Error> LineWords::refuse(std::size_t i, std::string text) const {
  const std::size_t offset =
      i < words_.size() ? static_cast<std::size_t>(words_[i].data() - text_.data()) : text_.size();
  return bad_input(std::move(text), name_, line_, offset + 1);
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
