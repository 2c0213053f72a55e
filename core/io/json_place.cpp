// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json_place.h"

#include <algorithm>

namespace mes {
namespace {

class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  std::size_t offset() const { return at_; }
  /// To the part, from the beginning of a value; false leaves the place as it was.
  bool enter(const JsonStep& step) {
    const std::size_t before = at_;
    const bool found = std::holds_alternative<std::string>(step) ? enter_key(std::get<std::string>(step))
                                                                 : enter_index(std::get<std::size_t>(step));
    if (!found) at_ = before;
    return found;
  }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

 private:
  bool take(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    skip_blanks();
    return true;
  }
  bool enter_key(const std::string& key) {
    if (!take('{')) return false;
    do {
      const std::size_t begin = at_;
      skip_value();
      const std::string_view name = text_.substr(begin, at_ - begin);
      if (!take(':')) return false;
      if (name.size() == key.size() + 2 && name.substr(1, key.size()) == key) return true;
      skip_value();
    } while (take(','));
    return false;
  }
  bool enter_index(std::size_t index) {
    if (!take('[')) return false;
    for (; index > 0; --index) {
      skip_value();
      if (!take(',')) return false;
    }
    return true;
  }
  void skip_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    at_ = std::min(at_ + 1, text_.size());
  }
  void skip_value() {
    int depth = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') {
        skip_string();
        if (depth == 0) return;
        continue;
      }
      if (depth == 0 && (c == ',' || c == ']' || c == '}')) return;
      if (c == '[' || c == '{') ++depth;
      if ((c == ']' || c == '}') && --depth == 0) {
        ++at_;
        return;
      }
      ++at_;
      if (depth == 0 && at_ < text_.size() && std::string_view(" \t\r\n").contains(text_[at_])) return;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::size_t offset_in_json(std::string_view text, std::span<const JsonStep> steps) {
  Walk walk(text);
  walk.skip_blanks();
  for (const JsonStep& step : steps)
    if (!walk.enter(step)) break;
  return walk.offset();
}

}  // namespace mes
