// SPDX-License-Identifier: GPL-3.0-or-later
// The form in which pictures and figures carry their session; shared by the writers and the readers.
//
// The carried data is the text of a session file, compressed (core/base/zlib.h):
//   PNG   an iTXt chunk with this keyword, compressed
//   SVG   an element `mesecina-session` of `metadata`, base64
//   Ipe   the data of the first layer, which Ipe keeps but ignores: this name, a colon, base64
//   PDF   an embedded file; the dictionary of its stream has this name as a key, with the value true
//   JSON  recorded frames have this name as a key; its value is base64
#pragma once

#include <cstddef>
#include <string_view>

namespace mes {

inline constexpr std::string_view kCarriedSession = "mesecina-session";

/// The longest session text that is written into a picture or read from one: a small file of unknown origin must not
/// expand without limit.
inline constexpr std::size_t kMostCarriedBytes = std::size_t{128} << 20U;

}  // namespace mes
