// SPDX-License-Identifier: GPL-3.0-or-later
// How pictures and figures hold the session that made them, for those who write it in and those who take it out.
//
// It is the text of a session file, compressed (core/base/zlib.h):
//   PNG   an iTXt chunk with this keyword, compressed
//   SVG   an element `mesecina-session` of `metadata`, base64
//   Ipe   the data of the first layer, which Ipe keeps without looking at it: this name, a colon, base64
//   PDF   an embedded file, whose stream's dictionary has a key of this name and the value true
//   JSON  of recorded frames: a key of this name, base64
#pragma once

#include <cstddef>
#include <string_view>

namespace mes {

inline constexpr std::string_view kCarriedSession = "mesecina-session";

/// The longest text that is written into a picture, and that is read from one: a small file of unknown origin must not
/// expand without limit.
inline constexpr std::size_t kMostCarriedBytes = std::size_t{128} << 20U;

}  // namespace mes
