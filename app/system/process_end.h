// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a process that does not wait for its threads.
#pragma once

namespace mes {

/// Kills the children, removes what was temporary, and ends without destructors: other threads are in the middle of
/// their work. It takes a few tenths of a second at most; what is left then is removed by a later start. Any thread.
[[noreturn]] void end_process(int code);

}  // namespace mes
