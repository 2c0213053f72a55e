// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in sample shapes, and the folder of things that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mes {

/// The first that exists of $MESECINA_ASSETS, `assets` and `share/mesecina` near the executable, and the source
/// tree; empty when there is none. Everything works without it, only plainer.
std::filesystem::path find_assets(const std::filesystem::path& executable);

struct SampleShape {
  std::filesystem::path file;
  std::string name;
  std::string description;
};

/// As `shapes/index.json` lists them; entries whose file is missing are left out.
std::vector<SampleShape> read_sample_shapes(const std::filesystem::path& assets);

}  // namespace mes
