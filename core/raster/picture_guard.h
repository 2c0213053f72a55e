// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the sizes that a picture file announces before a decoder relies on them.
//
// stb_image 2.27 does not check some numbers of a file: a Huffman table of JPEG may announce up to 4080 symbols, which
// it writes into a table of 256; it allocates the announced length of a PNG chunk, up to a gibibyte, before it notices
// that the file is shorter; and it takes values of 16 bits in PGM for values of 8, and a PGM or BMP that is cut for one
// whose rest is black.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace mes {

/// Why a picture is unsafe to decode, in words; empty for all other bytes, which need not be a picture. O(bytes).
std::string_view decoding_hazard(std::span<const std::byte> bytes);

}  // namespace mes
