// SPDX-License-Identifier: GPL-3.0-or-later
// Reads pictures that lie under a drawing, in all formats of core/raster/picture_decoder.h.
//
// Guarantees: any bytes give either a picture or a one-line error. Needs memory only for the file and
// kMostPicturePixels pixels. Threads: any.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "core/base/error.h"
#include "core/raster/picture_decoder.h"
#include "render/image/image.h"

namespace mes::render {

/// Decodes a picture in the requested orientation; `name` stands for the file in messages. Error: `bad_input`, also for
/// more than `most_pixels`.
Expected<Image> decode_picture(std::span<const std::byte> bytes, const std::string& name,
                               std::size_t most_pixels = kMostPicturePixels, PictureTurn turn = PictureTurn::upright);
Expected<Image> read_picture(const std::filesystem::path& file, PictureTurn turn = PictureTurn::upright);

/// Whether the name has the extension of a picture.
bool is_picture_file(const std::filesystem::path& file);

/// Halves width and height until neither is larger than `limit`. Each pixel is the mean of the pixels it replaces,
/// weighted by their alpha.
Image reduced(Image image, int limit);

}  // namespace mes::render
