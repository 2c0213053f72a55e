// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the interface that lie outside the window and cannot be scrolled into it.
#pragma once

#include <string>
#include <vector>

namespace mes {

/// Names each panel, popup and dialog of the last frame that leaves the window, or whose contents are larger than itself
/// without a scrollbar, with the missing pixels. Tooltips are left out. Call it after `Gui::end_frame`. Threads: the
/// window's.
std::vector<std::string> parts_out_of_reach();

/// For tests of the window: if MESECINA_SHOWS_REACH is set, writes these parts to standard error, a line each.
void tell_parts_out_of_reach();

}  // namespace mes
