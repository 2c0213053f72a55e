// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/settings_source.h"

namespace mes {

void SettingsSource::rebuild(JobControl& job) {
  update(job);
}

bool SettingsSource::update(JobControl&) {
  if (pending_) current_ = *pending_;
  pending_.reset();
  touched_ = 1;
  return true;
}

StatList SettingsSource::statistics() const {
  return {{"precision", std::string(id_of(current_.precision))}};
}

}  // namespace mes
