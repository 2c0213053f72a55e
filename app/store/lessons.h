// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mes {

struct ShippedLesson {
  std::filesystem::path file;
  std::string name;  ///< of the file, without its extension
  std::string title;
};

/// As `lessons/index.json` lists them; those whose file is missing are left out.
std::vector<ShippedLesson> read_shipped_lessons(const std::filesystem::path& assets);

}  // namespace mes
