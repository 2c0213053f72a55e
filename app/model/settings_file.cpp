// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/settings_file.h"

namespace mes {

Expected<void> SettingsFile::save() const {
  std::error_code error;
  const Settings now = std::filesystem::exists(path_, error) ? load_settings(path_).settings : at_start_;
  return save_settings(merged(settings_, at_start_, now), path_);
}

}  // namespace mes
