// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the sizes in a picture file before a decoder relies on them, and locates damage.
//
// stb_image 2.27 does not check some numbers of a file: a Huffman table of JPEG may announce up to 4080 symbols, which
// it writes into a table of 256; it allocates the announced length of a PNG chunk, up to a gibibyte, before it notices
// that the file is shorter; and it accepts a truncated JPEG or BMP and fills the rest with gray or black.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace mes {

/// Tells in words why a picture is unsafe to decode, with the byte or row; empty for all other bytes, which need not be
/// a picture. O(bytes).
std::string decoding_hazard(std::span<const std::byte> bytes);

/// Whether a JPEG lacks only the end marker, with all of its scans at least begun: each coefficient of each component
/// to its last bit. The pixels tell whether the last scan is complete: they then do not depend on the missing bytes.
/// False if there is a hazard. O(bytes).
bool may_lack_only_end(std::span<const std::byte> bytes);

/// Locates, in words, the damage in a picture that the decoder refused; empty if the damage cannot be located.
/// O(bytes).
std::string place_of_damage(std::span<const std::byte> bytes);

}  // namespace mes
