// SPDX-License-Identifier: GPL-3.0-or-later
// The man page, made from the same tables as the manual.
#pragma once

#include <span>
#include <string>

#include "app/cli/manual/command_help.h"

namespace mes::cli {

/// Uses the macros of man(7). The page contains no date, so equal programs give equal bytes.
std::string man_page(std::span<const CommandHelp> commands);

}  // namespace mes::cli
