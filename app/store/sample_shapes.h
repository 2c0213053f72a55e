// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in sample shapes, and the folder of files that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mes {

/// The first existing one of $MESECINA_ASSETS, `assets` beside the executable (a link, in a build folder) and
/// `../share/mesecina` (if installed); empty if there is none. Everything works without it, but looks plainer.
std::filesystem::path find_assets(const std::filesystem::path& executable);

struct SampleShape {
  std::filesystem::path file;
  std::string name;
  std::string description;
};

/// The shapes in `shapes/index.json`; entries whose file is missing are left out.
std::vector<SampleShape> read_sample_shapes(const std::filesystem::path& assets);

}  // namespace mes
