// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/session_link.h"

namespace mes {

bool may_share() {
  return false;
}

SharedLink share_by_link(const std::string& /*session*/) {
  return {};
}

}  // namespace mes
