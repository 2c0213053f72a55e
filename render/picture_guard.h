// SPDX-License-Identifier: GPL-3.0-or-later
// A look at what a picture announces, before a decoder believes it.
//
// stb_image 2.27 takes two numbers of a file at their word: a Huffman table of JPEG may announce up to 4080 symbols,
// which are written into a table of 256; and memory for a chunk of PNG is taken by the length that it announces, up
// to a gibibyte, before the file turns out to be shorter.
#pragma once

#include <cstddef>
#include <span>

namespace mes::render {

/// False when no decoder may be trusted with the bytes, which then are no sound picture. True for all other bytes;
/// they need not be a picture. O(bytes).
bool is_safe_to_decode(std::span<const std::byte> bytes);

}  // namespace mes::render
