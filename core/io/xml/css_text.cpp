// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/xml/css_text.h"

#include <cstdint>

namespace mes {
namespace {

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

void add_utf8(std::string& out, std::uint32_t code) {
  if (code == 0 || code > 0x10FFFFU || (code >= 0xD800U && code < 0xE000U)) code = 0xFFFDU;
  const auto add = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80U) return add(code);
  if (code < 0x800U) {
    add(0xC0U | code >> 6U);
  } else {
    if (code < 0x10000U) {
      add(0xE0U | code >> 12U);
    } else {
      add(0xF0U | code >> 18U);
      add(0x80U | (code >> 12U & 0x3FU));
    }
    add(0x80U | (code >> 6U & 0x3FU));
  }
  add(0x80U | (code & 0x3FU));
}

}  // namespace

std::string_view css_trimmed(std::string_view text) {
  while (!text.empty() && is_css_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_css_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string without_css_comments(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  char quote = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote == '\0' && c == '/' && i + 1 < text.size() && text[i + 1] == '*') {
      const std::size_t end = text.find("*/", i + 2);
      out += ' ';
      if (end == std::string_view::npos) break;
      i = end + 1;
      continue;
    }
    out += c;
    if (c == '\\' && i + 1 < text.size()) {
      out += text[++i];
    } else if (quote != '\0') {
      if (c == quote || c == '\n') quote = '\0';  // a string ends at the end of its line
    } else if (c == '"' || c == '\'') {
      quote = c;
    }
  }
  return out;
}

void CssText::take_escape(std::string& out) {
  constexpr int kMostDigits = 6;
  ++at_;
  if (is_at_end()) return;
  std::uint32_t code = 0;
  int digits = 0;
  for (int digit = hex_digit(sign()); digit >= 0 && digits < kMostDigits; digit = hex_digit(sign()), ++digits) {
    code = 16U * code + static_cast<std::uint32_t>(digit);
    ++at_;
  }
  if (digits == 0) {
    out += text_[at_++];
    return;
  }
  add_utf8(out, code);
  if (is_css_blank(sign())) ++at_;
}

std::string CssText::name() {
  std::string out;
  const char first = sign() == '-' ? sign(1) : sign();
  if (first >= '0' && first <= '9') return out;
  while (!is_at_end()) {
    if (is_of_name(sign())) {
      out += text_[at_++];
    } else if (sign() == '\\' && sign(1) != '\n' && sign(1) != '\0') {
      take_escape(out);
    } else {
      break;
    }
  }
  return out;
}

std::string CssText::string_or_name() {
  const char quote = sign();
  if (quote != '"' && quote != '\'') return name();
  std::string out;
  for (++at_; !is_at_end() && sign() != quote && sign() != '\n';) {
    if (sign() == '\\')
      take_escape(out);
    else
      out += text_[at_++];
  }
  if (sign() == quote) ++at_;
  return out;
}

void CssText::skip_string() {
  const char quote = sign();
  for (++at_; !is_at_end() && sign() != quote && sign() != '\n'; ++at_)
    if (sign() == '\\') ++at_;
  if (!is_at_end()) ++at_;
}

std::string_view CssText::up_to(std::string_view signs) {
  const std::size_t begin = at_;
  std::string open;  // closing signs of the open brackets
  while (!is_at_end()) {
    const char c = sign();
    if (open.empty() && signs.find(c) != std::string_view::npos) break;
    if (c == '"' || c == '\'') {
      skip_string();
      continue;
    }
    if (c == '(') open += ')';
    if (c == '[') open += ']';
    if (c == '{') open += '}';
    if (!open.empty() && c == open.back()) open.pop_back();
    at_ += c == '\\' ? 2 : 1;
  }
  if (at_ > text_.size()) at_ = text_.size();
  return text_.substr(begin, at_ - begin);
}

std::string_view CssText::enclosed() {
  const char begin = sign();
  ++at_;
  const std::string_view out = up_to(begin == '(' ? ")" : begin == '[' ? "]" : "}");
  if (!is_at_end()) ++at_;
  return out;
}

}  // namespace mes
