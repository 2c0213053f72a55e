// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as PNG files in memory.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/error.h"
#include "render/image.h"

namespace mes::render {

/// 1 is fast (a 1080p frame in about 30 ms), 12 is small and slow.
inline constexpr int kPngFast = 1;
inline constexpr int kPngSmall = 9;

/// 8-bit RGBA, or RGB when no pixel is transparent. Same picture, same level: same bytes. Any thread.
Expected<std::vector<std::byte>> encode_png(const Image& image, int level = kPngFast);

}  // namespace mes::render
