// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/json_text.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

using nlohmann::json;

constexpr int kDeepestJson = 64;

// Offset of the first value nested too deep, or the end. Checked before parsing: a parser that asks at each value looks
// at all siblings each time, which takes hours for a long list.
std::size_t too_deep(std::string_view text, const ReadJob* job) {
  constexpr std::size_t kOften = std::size_t{1} << 20U;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i % kOften == 0 && job != nullptr) job->checkpoint();
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepestJson) return i;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return text.size();
}

/// Listens to the parser and keeps only the position of the first fault.
struct Listener {
  std::size_t bytes_read = 0;
  bool is_syntax = true;

  static bool null() { return true; }
  static bool boolean(bool /*value*/) { return true; }
  static bool number_integer(std::int64_t /*value*/) { return true; }
  static bool number_unsigned(std::uint64_t /*value*/) { return true; }
  static bool number_float(double /*value*/, const std::string& /*token*/) { return true; }
  static bool string(const std::string& /*value*/) { return true; }
  static bool binary(const json::binary_t& /*value*/) { return true; }
  static bool start_object(std::size_t /*size*/) { return true; }
  static bool key(const std::string& /*value*/) { return true; }
  static bool end_object() { return true; }
  static bool start_array(std::size_t /*size*/) { return true; }
  static bool end_array() { return true; }
  bool parse_error(std::size_t position, const std::string& /*token*/, const json::exception& error) {
    bytes_read = position;
    is_syntax = dynamic_cast<const json::parse_error*>(&error) != nullptr;
    return false;
  }
};

/// An iterator of bytes for the parser; reports progress now and then.
class Watched {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Watched(const char* at, const char* end, ReadJob* job) : at_(at), end_(end), job_(job) { watch(); }
  reference operator*() const { return *at_; }
  Watched& operator++() {
    if (++at_ == watched_) watch();
    return *this;
  }
  bool operator==(const Watched& other) const { return at_ == other.at_; }

 private:
  void watch() {
    constexpr std::ptrdiff_t kOften = std::ptrdiff_t{1} << 16U;
    if (job_ != nullptr) job_->passed(at_);
    watched_ = at_ + std::min(kOften, end_ - at_);
  }

  const char* at_;
  const char* end_;
  const char* watched_ = nullptr;  // next position of a progress report
  ReadJob* job_;
};

}  // namespace

std::unexpected<Error> bad_json(std::string_view text, std::size_t offset, std::string what,
                                const std::string& file) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = static_cast<std::uint64_t>(std::ranges::count(before, '\n')) + 1;
  const std::size_t newline = before.rfind('\n');
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  return bad_input(std::move(what), file, line, before.size() - start + 1);
}

Expected<void> check_json(std::string_view text, const std::string& file, ReadJob* job) {
  if (const std::size_t at = too_deep(text, job); at < text.size())
    return bad_json(text, at, "this JSON is nested too deeply", file);
  Listener listener;
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  if (json::sax_parse(Watched(begin, end, job), Watched(end, end, nullptr), &listener)) return {};
  if (!listener.is_syntax) {
    // The parser stops right after the number.
    std::size_t at = std::min(listener.bytes_read, text.size());
    while (at > 0 && std::string_view("+-.0123456789Ee").contains(text[at - 1])) --at;
    return bad_json(text, at, "a number in this JSON is too large", file);
  }
  // Number of bytes read, including the offending one.
  return bad_json(text, listener.bytes_read == 0 ? 0 : listener.bytes_read - 1, "this is not JSON", file);
}

nlohmann::json parse_json(std::string_view text) {
  return json::parse(text, nullptr, false);
}

std::string json_text(const nlohmann::json& value, int indent) {
  return value.dump(indent, ' ', false, json::error_handler_t::replace);
}

std::string json_text(const nlohmann::ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, json::error_handler_t::replace);
}

std::string_view take_json_text(std::string_view& rest) {
  constexpr std::string_view kBetween = " \t\r\n\x1e";
  rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
  std::size_t depth = 0;
  std::size_t at = 0;
  while (at < rest.size()) {
    const char c = rest[at++];
    if (c == '"') {
      while (at < rest.size() && rest[at] != '"') at += rest[at] == '\\' ? 2U : 1U;
      at = std::min(at + 1, rest.size());
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if ((c == '}' || c == ']') && (depth == 0 || --depth == 0)) {
      break;
    }
  }
  const std::string_view out = rest.substr(0, at);
  rest.remove_prefix(at);
  return out;
}

}  // namespace mes
