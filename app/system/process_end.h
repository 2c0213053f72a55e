// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a process without waiting for its threads.
#pragma once

namespace mes {

/// Kills the children, removes temporary files, and ends without destructors, because other threads are still
/// working. Takes a few tenths of a second at most; a later start removes what is left. Threads: any.
[[noreturn]] void end_process(int code);

}  // namespace mes
