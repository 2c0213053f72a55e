// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/xml/xml_source.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>

#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

/// Takes white space, declarations, comments and document types off the front.
std::string_view without_prolog(std::string_view text) {
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    std::string_view end;
    if (text.starts_with("<?")) {
      end = "?>";
    } else if (text.starts_with("<!--")) {
      end = "-->";
    } else if (text.starts_with("<!DOCTYPE")) {
      const std::size_t bracket = text.find_first_of("[>");
      end = bracket != std::string_view::npos && text[bracket] == '[' ? "]>" : ">";
    } else {
      return text;
    }
    const std::size_t at = text.find(end);
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at + end.size());
  }
}

/// The job whose parsing runs on this thread; null: none that can be stopped.
thread_local const JobControl* parsing = nullptr;

/// A null result makes the parser stop with an error and free its memory; so a request to stop returns null.
void* memory_for_xml(std::size_t size) {
  if (parsing != nullptr && parsing->stop_requested()) return nullptr;
  return std::malloc(size);
}

pugi::xml_parse_result parse_in_place(pugi::xml_document& document, std::string& text, const JobControl* control) {
  [[maybe_unused]] static const bool is_set = [] {
    pugi::set_memory_management_functions(memory_for_xml, std::free);
    return true;
  }();
  parsing = control;
  // Parses in place, so that values know their positions.
  const pugi::xml_parse_result parsed =
      document.load_buffer_inplace(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  parsing = nullptr;
  return parsed;
}

std::string_view in_words(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_end_element_mismatch: return "an element ends that is not open, or the end is missing";
    case pugi::status_no_document_element: return "it has no element";
    case pugi::status_bad_attribute: return "an attribute is broken";
    case pugi::status_bad_start_element:
    case pugi::status_bad_end_element: return "the tag of an element is broken";
    case pugi::status_bad_doctype: return "its document type is broken";
    default: return "it is broken or cut off here";
  }
}

}  // namespace

std::string_view xml_root_name(std::string_view bytes) {
  const std::string_view text = without_prolog(without_bom(bytes));
  if (!text.starts_with('<')) return {};
  return local_name(text.substr(1, text.find_first_of(" \t\r\n/>", 1) - 1));
}

pugi::xml_node next_in_document(pugi::xml_node node, pugi::xml_node root) {
  if (const pugi::xml_node child = node.first_child()) return child;
  while (node != root && !node.next_sibling()) node = node.parent();
  return node == root ? pugi::xml_node() : node.next_sibling();
}

Expected<pugi::xml_node> XmlSource::parse(ReadJob& job, std::initializer_list<std::string_view> bulky) {
  long_values_ = take_long_values(bytes_, bulky, buffer_, job);
  job.checkpoint();
  const pugi::xml_parse_result parsed = parse_in_place(document_, buffer_, job.control());
  job.checkpoint();
  if (parsed.status == pugi::status_out_of_memory)
    return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory to read it", name_});
  if (!parsed)
    return refuse(place_in_bytes(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0))),
                  fmt::format("this is not XML: {}", in_words(parsed.status)));
  return document_.document_element();
}

std::string_view XmlSource::value(pugi::xml_node node, const char* attribute) const {
  const char* const value = node.attribute(attribute).value();
  if (long_values_.empty() || *value == '\0') return value;
  const auto place = static_cast<std::size_t>(value - buffer_.data());
  const auto found = std::ranges::lower_bound(long_values_, place, {}, &LongValue::place);
  return found != long_values_.end() && found->place == place ? found->value : value;
}

/// Maps a position in the buffer to one in the file.
std::size_t XmlSource::place_in_bytes(std::size_t place) const {
  const auto next = std::ranges::lower_bound(long_values_, place, {}, &LongValue::place);
  if (next == long_values_.begin()) return place;
  const LongValue& before = *(next - 1);
  const auto end = static_cast<std::size_t>(before.value.data() - bytes_.data()) + before.value.size();
  return end + (place - before.place - 1);
}

Error XmlSource::error_at(std::size_t place, std::string text) const {
  const std::string_view before = bytes_.substr(0, std::min(place, bytes_.size()));
  const auto line = static_cast<std::uint64_t>(std::ranges::count(before, '\n')) + 1;
  const std::size_t newline = before.rfind('\n');
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  return {ErrorCode::bad_input, std::move(text), name_, line, before.size() - start + 1};
}

std::size_t XmlSource::place_of(pugi::xml_node node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  return offset > 0 ? place_in_bytes(static_cast<std::size_t>(offset) - 1) : 0;
}

std::size_t XmlSource::place_of(pugi::xml_node node, std::string_view value, std::size_t within) const {
  const auto place_within = [&](std::string_view text) -> std::optional<std::size_t> {
    const char* const begin = text.data();
    const bool is_inside =
        std::less_equal<>()(begin, value.data()) && std::less<>()(value.data(), begin + text.size());
    return is_inside ? std::optional(static_cast<std::size_t>(value.data() - begin)) : std::nullopt;
  };
  if (const auto place = place_within(bytes_)) return *place + within;
  if (const auto place = place_within(buffer_)) return place_in_bytes(*place) + within;
  return place_of(node);
}

std::vector<std::string> XmlSource::messages() const {
  std::vector<std::pair<std::size_t, std::string>> all;
  remarks.for_each([&](const std::string& text, std::size_t place) { all.emplace_back(place, text); });
  std::ranges::stable_sort(all, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> out;
  for (auto& [place, text] : all) out.push_back(error_at(place, std::move(text)).message());
  return out;
}

}  // namespace mes
