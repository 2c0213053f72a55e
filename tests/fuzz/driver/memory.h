// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory a run takes. Known in builds with the address sanitizer, whose allocator can be listened to.
#pragma once

#include <cstddef>

namespace mes::fuzz {

/// From now on allocations are counted, where that is possible. Elsewhere the data segment is limited instead.
void watch_memory();
void begin_measuring();
/// The most bytes that were allocated at one time since, what was there before left out; 0 where that is unknown.
std::size_t peak_bytes();

}  // namespace mes::fuzz
