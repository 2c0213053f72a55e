// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/data_folder.h"

#include <cstdlib>

namespace mes {
namespace {

namespace fs = std::filesystem;

// The specification calls relative values invalid, so they are ignored.
fs::path folder(const char* variable, const char* below_home) {
  if (const char* value = std::getenv(variable); value != nullptr && value[0] == '/')
    return fs::path(value) / "mesecina";
  if (const char* home = std::getenv("HOME"); home != nullptr && home[0] == '/')
    return fs::path(home) / below_home / "mesecina";
  return {};
}

}  // namespace

fs::path data_folder() {
  return folder("XDG_DATA_HOME", ".local/share");
}

fs::path config_folder() {
  return folder("XDG_CONFIG_HOME", ".config");
}

fs::path cache_folder() {
  return folder("XDG_CACHE_HOME", ".cache");
}

}  // namespace mes
