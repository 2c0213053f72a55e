// SPDX-License-Identifier: GPL-3.0-or-later
// Typed values from the JSON of sessions: texts, numbers, and lists of numbers as points and balls.
//
// A value of any other type throws `Nonsense`, with its position and the reason. So the reader of a session is a list
// of its fields, and converts the exception into an error in one place.
//
// Smallest use:
//     std::vector<Vec2> samples;
//     read_flat(object.find("samples"), "samples", samples, "data");
//     require_together(samples, object.find("samples"), "samples", "data", seen);
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/geometry/coordinate_range.h"
#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"
#include "core/io/session/json_view.h"

namespace mes {

/// Why something in a session is invalid, beginning with its name.
struct Nonsense {
  std::string text;
  JsonView at{};  ///< the invalid value; none: its position in the text is unknown
};
/// Throws "where: what", without a position in the text.
[[noreturn]] void complain(const std::string& where, const std::string& what);

/// The text of a value; empty if there is no value.
std::string text_from(JsonView value, const char* key, const std::string& where);
/// The same with at most `longest` bytes; the exception has the position.
std::string short_text_from(JsonView value, const char* key, std::size_t longest, const std::string& where);
double number_of(JsonView value, const std::string& where);
/// A whole number of 32 bits.
std::uint32_t count_of(JsonView value, const std::string& where);
/// A list of points, two numbers each, possibly out of the range of documents.
std::vector<Vec2> places_of(JsonView list, const std::string& where);

/// Reads the things of a flat list of numbers: counts, points (2), balls (3), or a count with one of these. Does
/// nothing without a list. Throws, with the position, at the first number that no document can hold. Counts the numbers
/// first, so that a list takes no more memory than needed.
template <class T>
void read_flat(JsonView list, const char* key, std::vector<T>& out, const std::string& where);
extern template void read_flat(JsonView, const char*, std::vector<std::uint32_t>&, const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<Vec2>&, const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<Disk>&, const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<std::pair<std::uint32_t, Vec2>>&,
                               const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<std::pair<std::uint32_t, Disk>>&,
                               const std::string&);

/// Throws, with the position, at the first number of `things`, read from `list`, that no document can hold together
/// with the earlier ones and those in `seen`; adds all of them to `seen`.
template <class T>
void require_together(const std::vector<T>& things, JsonView list, const char* key, const std::string& where,
                      Magnitudes& seen);
extern template void require_together(const std::vector<Vec2>&, JsonView, const char*, const std::string&,
                                      Magnitudes&);
extern template void require_together(const std::vector<Disk>&, JsonView, const char*, const std::string&,
                                      Magnitudes&);

/// The result of `read` for the value. Puts `where` before its exception, and adds `value` as a missing position.
template <class Read>
auto read_at(JsonView value, const std::string& where, Read read) {
  try {
    return read(value);
  } catch (Nonsense& nonsense) {
    nonsense.text = where + ": " + nonsense.text;
    if (!nonsense.at) nonsense.at = value;
    throw;
  }
}

}  // namespace mes
