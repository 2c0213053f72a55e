// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of Netpbm: PBM, PGM and PPM, plain and binary (P1 to P6), and PAM (P7).
// Source: the manual pages pbm(5), pgm(5), ppm(5) and pam(5) of Netpbm.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/raster/picture_decoder.h"

namespace mes {

/// Whether bytes begin as one of these: a plain one with its width and height, for any text may begin with two letters.
bool looks_like_netpbm(std::string_view bytes);

/// The first picture of the file. Values are scaled so that the largest possible one is 255. `name` is that of the file in messages. Error: `bad_input`,
/// also for more than `most_pixels`. Takes no more memory than the file and as many values as it has. O(bytes).
Expected<Pixels> decode_netpbm(std::string_view bytes, const std::string& name, std::size_t most_pixels);

}  // namespace mes
