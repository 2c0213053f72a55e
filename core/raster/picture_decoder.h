// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels of PNG, JPEG and BMP files and of those of Netpbm (PBM, PGM, PPM, PAM), as other programs write them.
//
// What it guarantees: for any bytes, a picture or an error of one line. It takes no more memory than the file and what
// its pixels need. Threads: any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/raster/gray_image.h"

namespace mes {

inline constexpr int kLongestPictureSide = 32768;
inline constexpr std::size_t kMostPicturePixels = std::size_t{1} << 27U;  ///< half a gibibyte of four channels

/// What names of such files end in.
inline constexpr std::string_view kPictureExtensions[] = {".png", ".jpg", ".jpeg", ".bmp", ".pbm",
                                                          ".pgm", ".ppm", ".pnm",  ".pam"};

/// Channels one after the other, 8 bits each, rows from the top, no padding; of more bits a channel the upper 8.
struct Pixels {
  int width = 0;
  int height = 0;
  int channels = 0;  ///< 1: grey, 2: grey and alpha, 3: RGB, 4: RGBA; alpha is not multiplied in
  std::vector<std::uint8_t> values{};
  bool lacks_end = false;  ///< a JPEG whose pixels are all there, and the marker that ends it is not
};

/// How a picture is turned: as its Exif data say, in a JPEG or a PNG, or as its pixels are stored.
enum class PictureTurn : std::uint8_t { upright, as_stored };

/// Whether the bytes begin as one of these pictures does.
bool looks_like_picture(std::string_view bytes);

/// Decodes a picture, which its first bytes tell from others, to so many channels; 0: as many as it has. `name` is that
/// of the file in messages. Exif data that are broken are ignored. A JPEG without its last marker is a picture if it has no restart markers, and its pixels do not
/// depend on what would follow. Error: `bad_input`, also for more than `most_pixels`; `out_of_memory`. It is not stopped
/// within: a JPEG of 2^27 pixels in three channels took 1.6 s of processor time, a progressive one 3.7 s.
Expected<Pixels> decode_pixels(std::span<const std::byte> bytes, const std::string& name, int channels = 0,
                               std::size_t most_pixels = kMostPicturePixels, PictureTurn turn = PictureTurn::upright);

/// The alpha of the pixels, if at least one of a hundred is more transparent than opaque; otherwise how light they are
/// on white: luma with the weights of Rec. 709. O(pixels).
GrayImage gray_of(Pixels pixels);

}  // namespace mes
