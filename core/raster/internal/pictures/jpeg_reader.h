// SPDX-License-Identifier: GPL-3.0-or-later
// Reads JPEG by libjpeg. Private to core/raster.
#pragma once

#include <cstddef>
#include <string>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/raster/internal/pictures/bytes.h"
#include "core/raster/picture_decoder.h"

namespace mes {

/// The pixels, grey or RGB; CMYK becomes RGB. A file that lacks nothing but the marker that ends it is a picture
/// (`Pixels::lacks_end`). Memory: the pixels, and for a progressive picture two bytes for each of their channels. Error:
/// `bad_input` where pixels are missing or damaged, with the byte up to which the file was read, and for more than 64
/// scans, which could take minutes for a file of some kilobytes. Throws std::bad_alloc, and `Cancelled` at the next row
/// after the job is stopped, if there is one.
Expected<Pixels> read_jpeg(Bytes bytes, const std::string& name, std::size_t most_pixels, const JobControl* job);

}  // namespace mes
