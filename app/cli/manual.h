// SPDX-License-Identifier: GPL-3.0-or-later
// The manual, written from the tables that the program itself works with, so that the two cannot disagree.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/cli/command_help.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// Markdown, with a table of contents. Equal programs give equal bytes: nothing of the user's is in it, and of the
/// machine nothing but the bundles and colour maps in `assets`.
std::string manual_text(const Registry& registry, std::span<const CommandHelp> commands,
                        const std::filesystem::path& assets);

}  // namespace mes::cli
