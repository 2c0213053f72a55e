// SPDX-License-Identifier: GPL-3.0-or-later
// The FILE argument of the commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/requests/requests.h"
#include "core/base/error.h"
#include "core/io/format.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// Reads a file, or standard input if its name is "-". Reports tolerable faults on stderr. Error: also `usage` for
/// contradictory tracing options, before anything is read; for tracing options with a file that is not a picture; and
/// for keeping the degrees of a file that is not a map.
Expected<LoadedFile> read_input(const Registry& registry, const std::string& file, const std::string& format,
                                const ReadingOptions& options = {});

/// The same for bytes in memory, without reports; `name` stands for the file in messages.
Expected<LoadedFile> read_input_bytes(const Registry& registry, std::string_view bytes, const std::string& name,
                                      const std::string& format, const ReadingOptions& options);

/// The values of `--figure-side`.
std::vector<std::string> figure_sides();

}  // namespace mes::cli
