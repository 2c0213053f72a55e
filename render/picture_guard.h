// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the sizes that a picture file announces before a decoder relies on them.
//
// stb_image 2.27 does not check two numbers of a file: a Huffman table of JPEG may announce up to 4080 symbols, which
// it writes into a table of 256; and it allocates the announced length of a PNG chunk, up to a gibibyte, before it
// notices that the file is shorter.
#pragma once

#include <cstddef>
#include <span>

namespace mes::render {

/// False for broken pictures that are unsafe to decode. True for all other bytes, which need not be a picture.
/// O(bytes).
bool is_safe_to_decode(std::span<const std::byte> bytes);

}  // namespace mes::render
