// SPDX-License-Identifier: GPL-3.0-or-later
// The manual, written from the tables that the program itself uses, so that the two cannot disagree.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/cli/command_help.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// Markdown with a table of contents. Equal programs give equal bytes: it contains nothing of the user's, and nothing
/// of the machine but the bundles and colour maps in `assets`.
std::string manual_text(const Registry& registry, std::span<const CommandHelp> commands,
                        const std::filesystem::path& assets);

}  // namespace mes::cli
