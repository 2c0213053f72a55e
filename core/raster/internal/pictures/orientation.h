// SPDX-License-Identifier: GPL-3.0-or-later
// The orientation of the camera, from the Exif data of a picture. Private to core/raster.
//
// Source: Exif 2.32 (CIPA DC-008), 4.6.4 A; TIFF 6.0; the chunk eXIf of PNG, extension of 2017.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mes {

/// The Exif orientation, from 1 to 8: the visual positions of the first row and the first column. 1 (upper and left
/// edge) for pictures without Exif data, and if these are truncated, broken or have no valid orientation. If several
/// segments or chunks have one, the first counts. `bytes` are a JPEG or a PNG, or anything else. O(bytes).
int orientation_of(std::span<const std::byte> bytes);

/// Whether rows become columns.
constexpr bool swaps_sides(int orientation) {
  return orientation >= 5;
}

/// The pixels, of `channels` bytes each, in upright order, rows from the top; `width` and `height` are those of
/// `pixels`. O(pixels).
std::vector<std::uint8_t> upright(const std::uint8_t* pixels, int width, int height, int channels, int orientation);

}  // namespace mes
