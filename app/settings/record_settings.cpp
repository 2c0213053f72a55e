// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/record_settings.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "app/system/data_folder.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

fs::path home() {
  const char* value = std::getenv("HOME");
  return value != nullptr && value[0] == '/' ? value : "";
}

// Reads XDG_PICTURES_DIR="$HOME/Pictures" or ="/absolute", as xdg-user-dirs writes it.
fs::path pictures_by_desktop(const fs::path& file) {
  constexpr std::string_view kKey = "XDG_PICTURES_DIR=\"";
  constexpr std::string_view kHome = "$HOME";
  std::error_code error;
  // Reading a pipe would block.
  if (!fs::is_regular_file(file, error)) return {};
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(kKey)) continue;
    std::string value = line.substr(kKey.size());
    value.resize(std::min(value.size(), value.find('"')));
    if (value.starts_with(kHome)) value = home().string() + value.substr(kHome.size());
    if (value.starts_with('/')) return value;
  }
  return {};
}

}  // namespace

Expected<void> check(const RecordSettings& settings) {
  const auto refuse = [](std::string text) { return std::unexpected(Error{ErrorCode::usage, std::move(text)}); };
  const std::string size = fmt::format("{}x{}", settings.width, settings.height);
  const bool is_window = settings.width == 0 && settings.height == 0;
  if (!is_window && (settings.width < 1 || settings.height < 1))
    return refuse(fmt::format("a frame of {} pixels is too small: each side needs at least 1", size));
  if (std::max(settings.width, settings.height) > kLargestFrameSide)
    return refuse(fmt::format("a frame of {} pixels is too large: a side has at most {}", size, kLargestFrameSide));
  if (static_cast<long long>(settings.width) * settings.height > kMostFramePixels)
    return refuse(fmt::format("a frame of {} pixels is too large: it has at most {} million pixels", size,
                              kMostFramePixels >> 20));
  if (settings.supersampling != 1 && settings.supersampling != 2 && settings.supersampling != 4)
    return refuse("supersampling must be by 1, 2 or 4");
  if (!(settings.fps >= 1.0 && settings.fps <= 120.0)) return refuse("frames per second must be from 1 to 120");
  return {};
}

fs::path pictures_folder() {
  const fs::path config = config_folder();
  std::error_code error;
  if (!config.empty()) {
    const fs::path folder = pictures_by_desktop(config.parent_path() / "user-dirs.dirs");
    if (!folder.empty() && fs::is_directory(folder, error)) return folder;
  }
  return home();
}

fs::path takes_folder() {
  const fs::path pictures = pictures_folder();
  return pictures.empty() ? pictures : pictures / "mesecina";
}

fs::path folder_of(const RecordSettings& settings) {
  return settings.folder.empty() ? takes_folder() : fs::path(settings.folder);
}

}  // namespace mes
