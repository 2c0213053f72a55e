// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a last line when code of others crashes the program.
#pragma once

#include <string>

namespace mes {

/// From now on a crash of the process prints "mesecina: crashed (Segmentation fault) with TEXT" before the process
/// ends as usual. A later text replaces an earlier one; an empty one prints nothing. Threads: one at a time.
void say_at_crash(const std::string& text);

}  // namespace mes
