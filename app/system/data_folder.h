// SPDX-License-Identifier: GPL-3.0-or-later
// The folders for the program's own files, by the XDG base directory specification.
#pragma once

#include <filesystem>

namespace mes {

/// $XDG_DATA_HOME/mesecina or ~/.local/share/mesecina; empty when no home folder is known.
std::filesystem::path data_folder();
/// $XDG_CONFIG_HOME/mesecina or ~/.config/mesecina; empty when no home folder is known.
std::filesystem::path config_folder();
/// $XDG_CACHE_HOME/mesecina or ~/.cache/mesecina; empty when no home folder is known.
std::filesystem::path cache_folder();

}  // namespace mes
