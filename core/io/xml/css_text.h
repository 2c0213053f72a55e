// SPDX-License-Identifier: GPL-3.0-or-later
// Text of style sheets, in pieces. Private to core/io.
//
// Source: CSS Syntax Module Level 3, as far as sheets of drawings need it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mes {

constexpr bool is_css_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
std::string_view css_trimmed(std::string_view text);
/// Comments become blanks, except in strings.
std::string without_css_comments(std::string_view text);

/// A cursor over text without comments.
class CssText {
 public:
  explicit CssText(std::string_view text) : text_(text) {}

  bool is_at_end() const { return at_ >= text_.size(); }
  char sign(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool take(std::string_view wanted) {
    if (!text_.substr(at_).starts_with(wanted)) return false;
    at_ += wanted.size();
    return true;
  }
  void skip_blanks() {
    while (!is_at_end() && is_css_blank(text_[at_])) ++at_;
  }
  /// Takes a name, with its escapes resolved; empty, and takes nothing, if no name begins here.
  std::string name();
  /// Takes a string in quotation marks, or a name; empty if neither begins here.
  std::string string_or_name();
  /// Takes the text up to the first of these signs outside strings, brackets and blocks; the sign stays.
  std::string_view up_to(std::string_view signs);
  /// Takes the bracket that begins here and returns its content; takes the rest of the text if the bracket is not
  /// closed.
  std::string_view enclosed();

 private:
  void skip_string();
  /// Resolves the escape of the backslash at the cursor.
  void take_escape(std::string& out);

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace mes
