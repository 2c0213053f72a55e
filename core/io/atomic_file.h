// SPDX-License-Identifier: GPL-3.0-or-later
// Output files appear complete or not at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// Writes beside the target, fsyncs, renames over it. On any failure the old file, if any, is untouched and nothing
/// is left behind. Error: `cannot_write`, naming the file and the reason.
///
/// A symbolic link stays, and the file it names is replaced; a file keeps its permissions; what is no regular file
/// (a device, a pipe) is written to directly.
Expected<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Whether the above can be expected to succeed, for saying no before long work and not after it.
Expected<void> check_writable(const std::filesystem::path& path);

}  // namespace mes
