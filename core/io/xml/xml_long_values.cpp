// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/xml/xml_long_values.h"

#include <algorithm>

namespace mes {
namespace {

constexpr bool is_xml_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

class Finder {
 public:
  Finder(std::string_view bytes, std::initializer_list<std::string_view> attributes, std::string& rest, ReadJob& job)
      : bytes_(bytes), attributes_(attributes), rest_(rest), job_(job) {}

  std::vector<LongValue> find() {
    while (go_to("<")) {
      job_.passed(bytes_.data() + at_);
      const std::string_view here = bytes_.substr(at_);
      const bool goes_on = here.starts_with("<!--")        ? go_past("-->", 4)
                           : here.starts_with("<![CDATA[") ? go_past("]]>", 9)
                           : here.starts_with("<?")        ? go_past("?>", 2)
                           : here.starts_with("<!")        ? go_past_document_type()
                                                           : go_past_tag();
      if (!goes_on) break;
    }
    rest_ += bytes_.substr(copied_);
    return std::move(found_);
  }

 private:
  bool go_to(std::string_view mark) {
    at_ = bytes_.find(mark, at_);
    return at_ != std::string_view::npos;
  }
  bool go_past(std::string_view mark, std::size_t beginning) {
    at_ += beginning;
    if (!go_to(mark)) return false;
    at_ += mark.size();
    return true;
  }

  /// Document types with declarations have their own grammar.
  bool go_past_document_type() {
    for (; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      if (c == '>') return true;
      if (c == '[') return false;
      if ((c == '"' || c == '\'') && (at_ = bytes_.find(c, at_ + 1)) == std::string_view::npos) return false;
    }
    return false;
  }

  bool go_past_tag() {
    const std::size_t tag = at_;
    for (++at_; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      if (c == '>') return true;
      if (c != '"' && c != '\'') continue;
      const std::size_t begin = at_ + 1;
      at_ = bytes_.find(c, begin);
      if (at_ == std::string_view::npos) return false;
      if (at_ - begin >= kLong) consider(tag, begin);
    }
    return false;
  }

  /// Considers the value from `begin` to the current position.
  void consider(std::size_t tag, std::size_t begin) {
    const std::string_view value = bytes_.substr(begin, at_ - begin);
    job_.passed(bytes_.data() + at_);
    if (std::ranges::find(attributes_, name_before(tag, begin - 1)) == attributes_.end()) return;
    if (value.find('&') != value.npos || value.find('\0') != value.npos) return;
    rest_ += bytes_.substr(copied_, begin - copied_);
    found_.push_back({rest_.size(), value});
    rest_ += '-';
    copied_ = at_;
  }

  /// Name of the attribute whose value has this quotation mark; empty if there is none.
  std::string_view name_before(std::size_t tag, std::size_t quote) const {
    const auto skip_blanks = [&](std::size_t at) {
      while (at > tag && is_xml_blank(bytes_[at - 1])) --at;
      return at;
    };
    std::size_t end = skip_blanks(quote);
    if (end <= tag || bytes_[end - 1] != '=') return {};
    end = skip_blanks(end - 1);
    std::size_t begin = end;
    for (; begin > tag && !is_xml_blank(bytes_[begin - 1]); --begin)
      if (bytes_[begin - 1] == '"' || bytes_[begin - 1] == '\'') return {};  // no blank after the previous value
    return bytes_.substr(begin, end - begin);
  }

  static constexpr std::size_t kLong = 2048;

  std::string_view bytes_;
  std::initializer_list<std::string_view> attributes_;
  std::string& rest_;
  ReadJob& job_;
  std::vector<LongValue> found_;
  std::size_t at_ = 0;
  std::size_t copied_ = 0;  // end of the part already copied to the rest, except long values
};

}  // namespace

std::vector<LongValue> take_long_values(std::string_view bytes, std::initializer_list<std::string_view> attributes,
                                        std::string& rest, ReadJob& job) {
  rest.clear();
  if (attributes.size() == 0) {
    rest = bytes;
    return {};
  }
  return Finder(bytes, attributes, rest, job).find();
}

}  // namespace mes
