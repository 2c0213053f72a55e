// SPDX-License-Identifier: GPL-3.0-or-later
// The manual, written from the tables that the program itself uses, so that the two cannot disagree.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/cli/console/interruption.h"
#include "app/cli/manual/command_help.h"
#include "app/cli/requests/requests.h"
#include "core/base/error.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// Markdown with a table of contents. Equal programs give equal bytes: it contains nothing of the user's, and nothing
/// of the machine but the bundles and colour maps in `assets`.
std::string manual_text(const Registry& registry, std::span<const CommandHelp> commands,
                        const std::filesystem::path& assets);

Expected<void> run_manual(const Registry& registry, const ManualRequest& request,
                          std::span<const CommandHelp> commands, Interruption& interruption);

}  // namespace mes::cli
