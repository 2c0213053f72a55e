// SPDX-License-Identifier: GPL-3.0-or-later
// Reads PNG by libpng. Private to core/raster.
#pragma once

#include <cstddef>
#include <string>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/raster/internal/pictures/bytes.h"
#include "core/raster/picture_decoder.h"

namespace mes {

/// The pixels, with 8 bits a channel; of 16 bits the upper 8. Skips all chunks that the pixels do not need. Memory: the
/// pixels and some rows. Error: `bad_input`, with the first damaged chunk. Throws std::bad_alloc, and `Cancelled` at the next row
/// after the job is stopped, if there is one.
Expected<Pixels> read_png(Bytes bytes, const std::string& name, std::size_t most_pixels, const JobControl* job);

}  // namespace mes
