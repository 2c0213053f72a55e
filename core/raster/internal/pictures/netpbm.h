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

/// Whether the bytes begin like one of these; a plain one needs width and height, as any text may begin with 2 letters.
bool looks_like_netpbm(std::string_view bytes);

/// Decodes the first picture of the file. Values are scaled so that the largest possible one is 255. `name` stands for
/// the file in messages. Error: `bad_input`, also for more than `most_pixels`. Needs memory only for the file and its
/// values. O(bytes).
Expected<Pixels> decode_netpbm(std::string_view bytes, const std::string& name, std::size_t most_pixels);

}  // namespace mes
