// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in sample shapes, and the folder of things that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mes {

/// The first that exists of $MESECINA_ASSETS, `assets` beside the executable (a link, in a build folder) and
/// `../share/mesecina` (where it is installed); empty when there is none. Everything works without it, only plainer.
std::filesystem::path find_assets(const std::filesystem::path& executable);

struct SampleShape {
  std::filesystem::path file;
  std::string name;
  std::string description;
};

/// As `shapes/index.json` lists them; entries whose file is missing are left out.
std::vector<SampleShape> read_sample_shapes(const std::filesystem::path& assets);

}  // namespace mes
