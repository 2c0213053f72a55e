// SPDX-License-Identifier: GPL-3.0-or-later
// Puts pictures on the clipboard of the desktop.
#pragma once

#include <cstddef>
#include <span>
#include <stop_token>

#include "core/base/error.h"

namespace mes {

/// Puts a PNG file on the clipboard through `xclip`, which also serves it after this program has ended. Waits for
/// `xclip`. Error: `cannot_write` if it is missing or fails; errors of `ScratchFolder` and of writing. Threads: any.
Expected<void> copy_png(std::span<const std::byte> png, const std::stop_token& stop);

}  // namespace mes
