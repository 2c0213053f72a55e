// SPDX-License-Identifier: GPL-3.0-or-later
// Encodes pictures as PNG files in memory.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "render/image/image.h"

namespace mes::render {

/// Levels of compression: 1 is fast (a 1080p frame in about 30 ms), 12 is small and slow.
inline constexpr int kPngFast = 1;
inline constexpr int kPngSmall = 9;

/// Writes 8-bit RGBA, or RGB if no pixel is transparent. The same picture and level yield the same bytes. `session`:
/// the session, compressed (core/base/carried_session.h); empty: none. Errors: `usage` for no pixels or too many,
/// `out_of_memory`. Any thread.
Expected<std::vector<std::byte>> encode_png(const Image& image, int level = kPngFast, std::string_view session = {});

}  // namespace mes::render
