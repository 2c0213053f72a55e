// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader of sessions takes out of JSON values: texts, numbers, and lists of numbers as places and balls.
//
// Whatever a value holds instead of what is asked for, `Nonsense` is thrown, which says where and why. So the reader
// of a session is a list of what it wants, and turns what is thrown into an error in one place.
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

#include "core/base/coordinate_range.h"
#include "core/base/disk.h"
#include "core/base/vec2.h"
#include "core/io/json_view.h"

namespace mes {

/// Why something in a session makes no sense, beginning with where it stands.
struct Nonsense {
  std::string text;
  JsonView at{};  ///< the value at fault; none: its place in the text is not known
};
/// Throws "where: what", without a place in the text.
[[noreturn]] void complain(const std::string& where, const std::string& what);

/// Of no value: empty.
std::string text_from(JsonView value, const char* key, const std::string& where);
/// The same of at most so many bytes; what is thrown has its place.
std::string short_text_from(JsonView value, const char* key, std::size_t longest, const std::string& where);
double number_of(JsonView value, const std::string& where);
/// Of a whole number of 32 bits.
std::uint32_t count_of(JsonView value, const std::string& where);
/// Of a list with two numbers for each place, which may be out of the range of documents.
std::vector<Vec2> places_of(JsonView list, const std::string& where);

/// The things of a list that has the numbers of one after those of the other: a count, a place (2), a ball (3), or a
/// count with one of these. Nothing is done without a list. Throws, with its place, at the first number that no
/// document can hold. It is counted before it is read, so that a list takes no more room than what it says.
template <class T>
void read_flat(JsonView list, const char* key, std::vector<T>& out, const std::string& where);
extern template void read_flat(JsonView, const char*, std::vector<std::uint32_t>&, const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<Vec2>&, const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<Disk>&, const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<std::pair<std::uint32_t, Vec2>>&,
                               const std::string&);
extern template void read_flat(JsonView, const char*, std::vector<std::pair<std::uint32_t, Disk>>&,
                               const std::string&);

/// Throws, with its place, at the first number of `things`, read from `list`, that no document can hold together with
/// those before it and those in `seen`, to which all are added.
template <class T>
void require_together(const std::vector<T>& things, JsonView list, const char* key, const std::string& where,
                      Magnitudes& seen);
extern template void require_together(const std::vector<Vec2>&, JsonView, const char*, const std::string&,
                                      Magnitudes&);
extern template void require_together(const std::vector<Disk>&, JsonView, const char*, const std::string&,
                                      Magnitudes&);

/// What `read` makes of the value. What it throws gets `where` before it, and `value` for a place if it has none.
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
