// SPDX-License-Identifier: GPL-3.0-or-later
// XML of a file, whose elements and values know where they stand. Private to core/io.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/io/counted_remarks.h"
#include "core/io/read_job.h"
#include "core/io/xml_long_values.h"

namespace mes {

/// The name of the root element without its prefix; empty where none begins. A look at what stands before it.
std::string_view xml_root_name(std::string_view bytes);

/// The word after the colon of a prefix.
inline std::string_view local_name(std::string_view name) {
  return name.substr(name.find(':') + 1);
}

/// Entities other than those of XML are not expanded. Places are those of bytes of the file.
///
/// Smallest use:
///     XmlSource source(bytes, name);
///     const auto root = source.parse(job);
class XmlSource {
 public:
  /// Both outlive the source.
  XmlSource(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}
  XmlSource(const XmlSource&) = delete;
  XmlSource& operator=(const XmlSource&) = delete;

  std::string_view bytes() const { return bytes_; }
  /// The root element. Error: `bad_input` for text that is not XML. Values of the attributes named in `bulky` are to be
  /// had by `value`, others from their nodes too. `job` goes through the bytes already.
  ///
  /// Throws `Cancelled`: the library is stopped where it wants memory for more elements and attributes. Text without
  /// any, as a comment, it goes through to its end: a gibibyte took 0.3 s of processor time, and 1.4 s with CR LF after
  /// each third byte.
  Expected<pugi::xml_node> parse(ReadJob& job, std::initializer_list<std::string_view> bulky = {});
  /// Of an attribute; empty where there is none.
  std::string_view value(pugi::xml_node node, const char* attribute) const;

  /// With line and column of a byte.
  Error error_at(std::size_t place, std::string text) const;
  std::unexpected<Error> refuse(std::size_t place, std::string text) const {
    return std::unexpected(error_at(place, std::move(text)));
  }

  /// Of its "<".
  std::size_t place_of(pugi::xml_node node) const;
  /// Of the value of an attribute or of text; of the element for an empty one, which stands nowhere.
  std::size_t place_of(pugi::xml_node node, std::string_view value, std::size_t within) const;

  /// What is said once about all elements of a kind.
  CountedRemarks remarks{};
  /// One line each, in the order of their places.
  std::vector<std::string> messages() const;

 private:
  std::size_t place_in_bytes(std::size_t place) const;

  std::string_view bytes_;
  std::string buffer_;                  // what is parsed; values of attributes are pieces of it, but for
  std::vector<LongValue> long_values_;  // those that are pieces of the bytes, in order
  const std::string& name_;
  pugi::xml_document document_;
};

}  // namespace mes
