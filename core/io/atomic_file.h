// SPDX-License-Identifier: GPL-3.0-or-later
// Output files appear complete or not at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// Writes beside the target, fsyncs, renames over it. On any failure the old file, if any, is untouched and nothing is
/// left behind. Error: `cannot_write`, naming the file and the reason.
Expected<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace mes
