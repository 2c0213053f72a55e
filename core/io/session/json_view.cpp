// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/json_view.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "core/io/session/json_text.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

// Characters that may separate values. Their correct order was checked before.
bool is_between(char c) {
  return c == ' ' || c == ',' || c == ':' || c == '\n' || c == '\t' || c == '\r';
}

std::size_t end_of_text(std::string_view rest, std::size_t at) {
  for (++at; at < rest.size() && rest[at] != '"'; ++at)
    if (rest[at] == '\\') ++at;
  return at + 1;
}

std::size_t end_of_nest(std::string_view rest) {
  std::size_t depth = 0;
  for (std::size_t at = 0; at < rest.size(); ++at) {
    switch (rest[at]) {
      case '"': at = end_of_text(rest, at) - 1; break;
      case '[':
      case '{': ++depth; break;
      case ']':
      case '}':
        if (--depth == 0) return at + 1;
        break;
      default: break;
    }
  }
  return rest.size() + 1;
}

std::size_t end_of_value(std::string_view rest) {
  switch (rest.front()) {
    case '"': return end_of_text(rest, 0);
    case '[':
    case '{': return end_of_nest(rest);
    default: break;
  }
  std::size_t at = 0;
  while (at < rest.size() && !is_between(rest[at]) && rest[at] != ']' && rest[at] != '}') ++at;
  return at;
}

}  // namespace

JsonView JsonCursor::next() {
  std::size_t begin = 0;
  while (begin < rest_.size() && is_between(rest_[begin])) ++begin;
  rest_.remove_prefix(begin);
  if (rest_.empty()) return {};
  const std::size_t end = end_of_value(rest_);
  MES_ASSERT(end > 0 && end <= rest_.size());
  const JsonView out(rest_.substr(0, end));
  rest_.remove_prefix(end);
  return out;
}

JsonView JsonView::whole(std::string_view text) {
  return JsonCursor(without_bom(text)).next();
}

double JsonView::number() const {
  return parse_number(text_).value_or(0.0);
}

std::optional<std::uint64_t> JsonView::count() const {
  const auto out = parse_count(text_);
  return out ? std::optional(*out) : std::nullopt;
}

std::string JsonView::text() const {
  if (text_.find('\\') != std::string_view::npos) return parse_json(text_).get<std::string>();
  return std::string(text_.substr(1, text_.size() - 2));
}

bool JsonView::is_text(std::string_view wanted) const {
  const std::string_view inner = text_.substr(1, text_.size() - 2);
  if (inner.find('\\') == std::string_view::npos) return inner == wanted;
  // A character takes at most six bytes: a longer text need not be resolved.
  return inner.size() <= 6 * wanted.size() && text() == wanted;
}

JsonView::Elements JsonView::elements() const {
  return Elements(is_list() ? text_.substr(1, text_.size() - 2) : std::string_view());
}

JsonView::Members JsonView::members() const {
  return Members(is_object() ? text_.substr(1, text_.size() - 2) : std::string_view());
}

std::size_t JsonView::size() const {
  std::size_t out = 0;
  for (const JsonView element : elements()) out += element ? 1U : 0U;
  return out;
}

}  // namespace mes
