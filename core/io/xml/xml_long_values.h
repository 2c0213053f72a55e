// SPDX-License-Identifier: GPL-3.0-or-later
// Takes long attribute values out of XML before parsing. Private to core/io.
//
// A parser reads every byte of the outline of a coast to find its closing quotation mark, and needs it in a copy of the
// file. Here the mark is found about ten times as fast, and the value is not copied.
//
// Smallest use:
//     std::string rest;
//     const auto values = take_long_values(bytes, {"d", "points"}, rest, job);
//     // In `rest`, at values[0].place, one character stands for values[0].value.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/text/read_job.h"

namespace mes {

struct LongValue {
  std::size_t place = 0;     ///< position in the rest of the character that replaces it
  std::string_view value{};  ///< a piece of the bytes, without its quotation marks
};

/// `rest` becomes the bytes, with one character in place of each long value of these attributes that has no reference
/// ("&") in it. Comments, CDATA sections and processing instructions stay, and so does everything after a document type
/// with its own declarations. If the bytes are not XML, a parser finds the same fault in the rest. Throws `Cancelled`.
/// Cost: linear, for long values a fraction of a nanosecond a byte.
std::vector<LongValue> take_long_values(std::string_view bytes, std::initializer_list<std::string_view> attributes,
                                        std::string& rest, ReadJob& job);

}  // namespace mes
