// SPDX-License-Identifier: GPL-3.0-or-later
// How a camera was held: the orientation that Exif data give for a picture. Private to core/raster.
//
// Source: Exif 2.32 (CIPA DC-008), 4.6.4 A; TIFF 6.0; the chunk eXIf of PNG, extension of 2017.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mes {

/// From 1 to 8, as Exif numbers them: where the first row and the first column are seen. 1, the upper edge and the left
/// one, for pictures without Exif data, and where these are cut, broken or say nothing that is an orientation. Of several
/// segments or chunks the first that says one counts. `bytes` are a JPEG or a PNG, or anything else. O(bytes).
int orientation_of(std::span<const std::byte> bytes);

/// Whether rows become columns.
constexpr bool swaps_sides(int orientation) {
  return orientation >= 5;
}

/// Pixels of `channels` bytes as they are to be seen, in rows from the top; `width` and `height` are those of `pixels`.
/// O(pixels).
std::vector<std::uint8_t> upright(const std::uint8_t* pixels, int width, int height, int channels, int orientation);

}  // namespace mes
