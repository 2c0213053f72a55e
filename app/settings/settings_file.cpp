// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/settings_file.h"

#include "core/io/files/file_lock.h"

namespace mes {

Expected<void> SettingsFile::save() const {
  if (path_.empty()) return {};
  std::error_code error;
  std::filesystem::create_directories(path_.parent_path(), error);
  // The window is ending, so it saves in any case.
  const UpdateLock lock(path_);
  const Settings now = std::filesystem::exists(path_, error) ? load_settings(path_).settings : at_start_;
  return save_settings(merged(settings_, at_start_, now), path_);
}

}  // namespace mes
