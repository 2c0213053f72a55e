// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures read from PNG and JPEG files, as other programs write them.
//
// What it guarantees: whatever the bytes are, a picture or an error of one line, and no more memory than kMostPixels
// pixels and the file take. Any thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "core/base/error.h"
#include "render/image.h"

namespace mes::render {

inline constexpr int kLongestPictureSide = 32768;
inline constexpr std::size_t kMostPicturePixels = std::size_t{1} << 27U;  ///< half a gibibyte

/// PNG or JPEG, known by its first bytes; `name` stands for the file in messages. Error: `bad_input`, also for more
/// than `most_pixels`.
Expected<Image> decode_picture(std::span<const std::byte> bytes, const std::string& name,
                               std::size_t most_pixels = kMostPicturePixels);
Expected<Image> read_picture(const std::filesystem::path& file);

/// By the extension of its name.
bool is_picture_file(const std::filesystem::path& file);

/// The picture half as wide and high until neither side is longer than `limit`; each pixel the mean of those it
/// replaces, weighted by their alpha.
Image reduced(Image image, int limit);

}  // namespace mes::render
