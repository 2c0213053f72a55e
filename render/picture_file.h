// SPDX-License-Identifier: GPL-3.0-or-later
// Reads pictures from PNG and JPEG files, as other programs write them.
//
// What it guarantees: for any bytes, a picture or an error of one line. It takes no more memory than the file and
// kMostPicturePixels pixels. Threads: any.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "core/base/error.h"
#include "render/image.h"

namespace mes::render {

inline constexpr int kLongestPictureSide = 32768;
inline constexpr std::size_t kMostPicturePixels = std::size_t{1} << 27U;  ///< half a gibibyte

/// Decodes PNG or JPEG, which the first bytes tell apart; `name` is that of the file in messages. Error: `bad_input`,
/// also for more than `most_pixels`.
Expected<Image> decode_picture(std::span<const std::byte> bytes, const std::string& name,
                               std::size_t most_pixels = kMostPicturePixels);
Expected<Image> read_picture(const std::filesystem::path& file);

/// True if the extension of the name is that of PNG or JPEG.
bool is_picture_file(const std::filesystem::path& file);

/// Halves width and height until neither is larger than `limit`. Each pixel is the mean of the pixels it replaces,
/// weighted by their alpha.
Image reduced(Image image, int limit);

}  // namespace mes::render
