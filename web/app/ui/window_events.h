// SPDX-License-Identifier: GPL-3.0-or-later
// In a browser the loop of the window is called once a frame and never waits.
#pragma once

namespace mes {

/// True once after `GlfwWindow::wake`.
bool take_wake();

}  // namespace mes
