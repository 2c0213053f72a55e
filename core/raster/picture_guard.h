// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the sizes that a picture file announces before a decoder relies on them, and says where one is damaged.
//
// stb_image 2.27 does not check some numbers of a file: a Huffman table of JPEG may announce up to 4080 symbols, which
// it writes into a table of 256; it allocates the announced length of a PNG chunk, up to a gibibyte, before it notices
// that the file is shorter; and it takes a JPEG or BMP that is cut for one whose rest is gray or black.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace mes {

/// Why a picture is unsafe to decode, in words, with the byte or row where; empty for all other bytes, which need not be
/// a picture. O(bytes).
std::string decoding_hazard(std::span<const std::byte> bytes);

/// Whether a JPEG ends without the marker that ends a picture, and with all of its scans at least begun: each coefficient
/// of each component to its last bit. Whether the last scan is there to its end, its pixels say, which then do not depend
/// on what would follow. False where there is a hazard. O(bytes).
bool may_lack_only_end(std::span<const std::byte> bytes);

/// Where a picture that the decoder refused differs from what was once written, in words; empty where that cannot be
/// known. O(bytes).
std::string place_of_damage(std::span<const std::byte> bytes);

}  // namespace mes
