// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a window from its start to its end.
#pragma once

#include <filesystem>

#include "app/settings/settings.h"

namespace mes {

/// Guarantee: `save` writes the changes made here and keeps those that other windows have saved meanwhile, even of
/// windows that end at the same moment. Threads: the window's.
class SettingsFile {
 public:
  SettingsFile(std::filesystem::path path, Settings loaded)
      : path_(std::move(path)), settings_(std::move(loaded)), at_start_(settings_) {}

  Settings& settings() { return settings_; }
  const Settings& settings() const { return settings_; }
  Expected<void> save() const;

 private:
  std::filesystem::path path_;
  Settings settings_;
  Settings at_start_;
};

}  // namespace mes
