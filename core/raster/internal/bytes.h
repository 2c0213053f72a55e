// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes of picture files. Private to core/raster.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace mes {

using Bytes = std::span<const std::byte>;

inline Bytes without_first(Bytes bytes, std::size_t count) {
  return bytes.subspan(std::min(count, bytes.size()));
}

}  // namespace mes
