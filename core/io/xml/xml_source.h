// SPDX-License-Identifier: GPL-3.0-or-later
// XML of a file, with positions of elements and values. Private to core/io.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/io/text/counted_remarks.h"
#include "core/io/text/read_job.h"
#include "core/io/xml/xml_long_values.h"

namespace mes {

/// The name of the root element without its prefix; empty if there is none. Reads only up to it.
std::string_view xml_root_name(std::string_view bytes);

/// The name without its prefix.
inline std::string_view local_name(std::string_view name) {
  return name.substr(name.find(':') + 1);
}

/// The next node within `root` in document order, for a walk without recursion; none at the end.
pugi::xml_node next_in_document(pugi::xml_node node, pugi::xml_node root);

/// Only the entities of XML are expanded. Positions are those of bytes of the file.
///
/// Smallest use:
///     XmlSource source(bytes, name);
///     const auto root = source.parse(job);
class XmlSource {
 public:
  /// Both arguments must outlive the source.
  XmlSource(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}
  XmlSource(const XmlSource&) = delete;
  XmlSource& operator=(const XmlSource&) = delete;

  std::string_view bytes() const { return bytes_; }
  /// The root element. Error: `bad_input` for text that is not XML. `value` returns the values of the attributes named
  /// in `bulky`; values of others are in their nodes too. `job` already follows the bytes.
  ///
  /// Throws `Cancelled`: the library is stopped when it allocates memory for more elements and attributes. Text without
  /// these, such as a comment, is parsed to its end: a gibibyte took 0.3 s of processor time, and 1.4 s with CR LF
  /// after each third byte.
  Expected<pugi::xml_node> parse(ReadJob& job, std::initializer_list<std::string_view> bulky = {});
  /// The value of an attribute; empty if there is none.
  std::string_view value(pugi::xml_node node, const char* attribute) const;

  /// An error with line and column of a byte.
  Error error_at(std::size_t place, std::string text) const;
  std::unexpected<Error> refuse(std::size_t place, std::string text) const {
    return std::unexpected(error_at(place, std::move(text)));
  }

  /// Position of its "<".
  std::size_t place_of(pugi::xml_node node) const;
  /// Position in an attribute value or text; for an empty one, which has no position, that of the element.
  std::size_t place_of(pugi::xml_node node, std::string_view value, std::size_t within) const;

  /// Remarks, one for all elements of a kind.
  CountedRemarks remarks{};
  /// One line each, ordered by position.
  std::vector<std::string> messages() const;

 private:
  std::size_t place_in_bytes(std::size_t place) const;

  std::string_view bytes_;
  std::string buffer_;                  // the parsed text; contains the attribute values except
  std::vector<LongValue> long_values_;  // these, which are pieces of the bytes, in order
  const std::string& name_;
  pugi::xml_document document_;
};

}  // namespace mes
