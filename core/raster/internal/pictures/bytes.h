// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes and sizes of picture files. Private to core/raster.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/base/error.h"

namespace mes {

using Bytes = std::span<const std::byte>;

inline Bytes without_first(Bytes bytes, std::size_t count) {
  return bytes.subspan(count < bytes.size() ? count : bytes.size());
}

/// Why a picture of so many pixels is not decoded: it has none, a side is too long, or there are more than
/// `most_pixels`.
std::optional<Error> refused_size(std::size_t width, std::size_t height, std::size_t most_pixels,
                                  const std::string& name);

/// The refusal of damaged data.
Error broken_picture(const std::string& why, const std::string& name);

}  // namespace mes
