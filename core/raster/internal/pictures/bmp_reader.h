// SPDX-License-Identifier: GPL-3.0-or-later
// Reads BMP by stb_image. Private to core/raster.
#pragma once

#include <cstddef>
#include <string>

#include "core/base/error.h"
#include "core/raster/internal/pictures/bytes.h"
#include "core/raster/picture_decoder.h"

namespace mes {

/// The pixels. stb_image 2.27 fills a truncated picture with black, and reads colours beyond the end of a palette from
/// uninitialized memory; both are refused before. Memory: twice the pixels. Error: `bad_input`, with the byte or row.
/// Throws std::bad_alloc.
Expected<Pixels> read_bmp(Bytes bytes, const std::string& name, std::size_t most_pixels);

}  // namespace mes
