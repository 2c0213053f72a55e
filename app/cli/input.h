// SPDX-License-Identifier: GPL-3.0-or-later
// The FILE argument of the commands.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/io/format.h"

namespace mes::cli {

/// Reads a file, or standard input when its name is "-". What is odd but bearable in it is said on stderr.
Expected<LoadedFile> read_input(const std::string& file, const std::string& format);

}  // namespace mes::cli
