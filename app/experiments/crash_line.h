// SPDX-License-Identifier: GPL-3.0-or-later
// A last line of a program that code of others ends.
#pragma once

#include <string>

namespace mes {

/// From now on a crash of the process prints "mesecina: crashed (Segmentation fault) with TEXT" before it ends it as it
/// would have. A later text takes the place of an earlier one; an empty one prints nothing. Threads: one at a time.
void say_at_crash(const std::string& text);

}  // namespace mes
