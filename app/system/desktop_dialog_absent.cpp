// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces desktop_dialog.cpp where GIO, which speaks D-Bus, was not found.
#include "app/system/desktop_dialog.h"

namespace mes {

bool may_have_desktop_dialog() {
  return false;
}

DesktopAnswer ask_desktop(const DesktopQuestion& /*question*/, const std::stop_token& /*stop*/) {
  return {};
}

}  // namespace mes
