// SPDX-License-Identifier: GPL-3.0-or-later
// Reads pictures to lay under a drawing, from files of the kinds that core/raster/picture_decoder.h knows.
//
// What it guarantees: for any bytes, a picture or an error of one line. It takes no more memory than the file and
// kMostPicturePixels pixels. Threads: any.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "core/base/error.h"
#include "core/raster/picture_decoder.h"
#include "render/image.h"

namespace mes::render {

/// Decodes a picture, turned as asked; `name` is that of the file in messages. Error: `bad_input`, also for more than `most_pixels`.
Expected<Image> decode_picture(std::span<const std::byte> bytes, const std::string& name,
                               std::size_t most_pixels = kMostPicturePixels, PictureTurn turn = PictureTurn::upright);
Expected<Image> read_picture(const std::filesystem::path& file, PictureTurn turn = PictureTurn::upright);

/// True if the extension of the name is that of a picture.
bool is_picture_file(const std::filesystem::path& file);

/// Halves width and height until neither is larger than `limit`. Each pixel is the mean of the pixels it replaces,
/// weighted by their alpha.
Image reduced(Image image, int limit);

}  // namespace mes::render
