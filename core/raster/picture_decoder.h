// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes PNG, JPEG and BMP files and those of Netpbm (PBM, PGM, PPM, PAM), as other programs write them.
//
// Guarantees: any bytes give either a picture or a one-line error. Memory: the file, and its pixels three times.
// Threads: any. libpng and libjpeg decode PNG and JPEG, stb_image BMP.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/raster/gray_image.h"

namespace mes {

inline constexpr int kLongestPictureSide = 32768;
inline constexpr std::size_t kMostPicturePixels = std::size_t{1} << 27U;  ///< half a gibibyte of four channels

/// File extensions of these pictures.
inline constexpr std::string_view kPictureExtensions[] = {".png", ".jpg", ".jpeg", ".bmp", ".pbm",
                                                          ".pgm", ".ppm", ".pnm",  ".pam"};

/// Interleaved channels of 8 bits, rows from the top, no padding; wider channels keep their upper 8 bits.
struct Pixels {
  int width = 0;
  int height = 0;
  int channels = 0;  ///< 1: grey, 2: grey and alpha, 3: RGB, 4: RGBA; alpha is not premultiplied
  std::vector<std::uint8_t> values{};
  bool lacks_end = false;  ///< a JPEG with all pixels but without its end marker
};

/// Orientation of a picture: upright by the Exif data of a JPEG or PNG, or as its pixels are stored.
enum class PictureTurn : std::uint8_t { upright, as_stored };

/// Whether the bytes begin like one of these pictures.
bool looks_like_picture(std::string_view bytes);

/// Decodes a picture, recognised by its first bytes, to `channels` channels; 0: as many as it has. `name` stands for
/// the file in messages. Broken Exif data are ignored. A JPEG that lacks nothing but its end marker is accepted. Error:
/// `bad_input`, also for more than `most_pixels`; `out_of_memory`. Throws `Cancelled` soon after the job is stopped, if there
/// is one and libpng or libjpeg decodes; other formats take as long as a copy.
Expected<Pixels> decode_pixels(std::span<const std::byte> bytes, const std::string& name, int channels = 0,
                               std::size_t most_pixels = kMostPicturePixels, PictureTurn turn = PictureTurn::upright,
                               const JobControl* job = nullptr);

/// The alpha of the pixels, if at least one of a hundred is more transparent than opaque; otherwise their lightness on
/// white: luma with the weights of Rec. 709. O(pixels).
GrayImage gray_of(Pixels pixels);

}  // namespace mes
