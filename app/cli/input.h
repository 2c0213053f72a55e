// SPDX-License-Identifier: GPL-3.0-or-later
// The FILE argument of the commands.
#pragma once

#include <string>
#include <vector>

#include "app/cli/requests.h"
#include "core/base/error.h"
#include "core/io/format.h"

namespace mes::cli {

/// Reads a file, or standard input when its name is "-". What is odd but bearable in it is said on stderr. Error: also
/// `usage` for options of tracing that contradict each other, before anything is read, or that are given for a file
/// that is not a picture, and for degrees to keep of a file that is not a map.
Expected<LoadedFile> read_input(const Registry& registry, const std::string& file, const std::string& format,
                                const ReadingOptions& options = {});

/// The values of `--figure-side`.
std::vector<std::string> figure_sides();

}  // namespace mes::cli
