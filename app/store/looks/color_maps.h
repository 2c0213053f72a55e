// SPDX-License-Identifier: GPL-3.0-or-later
// The available colour maps: those of the program, and the user's files.
//
// A `.map` file is a list of triples `red green blue`, numbers from 0 to 1 between white space, two triples at least;
// `#` begins a comment. The name of the map is that of the file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "render/instances/colormap.h"

namespace mes {

/// Reads the bytes of a `.map` file. Error: `bad_input`, with line and column; `file` stands for it in messages.
Expected<render::ColorMap> parse_color_map(std::string_view bytes, std::string name, const std::string& file);

/// Error: also when the file is missing, not a regular file, or larger than any colour map.
Expected<render::ColorMap> read_color_map(const std::filesystem::path& file);

/// $XDG_DATA_HOME/mesecina/colormaps, or ~/.local/share/mesecina/colormaps; empty when no home folder is known.
std::filesystem::path user_color_map_folder();

struct LoadedColorMaps {
  std::vector<render::ColorMap> maps;  ///< those of the program first; no name twice
  std::vector<Error> problems;         ///< one for each file that was left out
};

/// Never fails: files that cannot be read are left out and reported. Either folder may be missing or empty.
LoadedColorMaps load_color_maps(const std::filesystem::path& assets, const std::filesystem::path& user_folder);

}  // namespace mes
