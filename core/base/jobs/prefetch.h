// SPDX-License-Identifier: GPL-3.0-or-later
// A hint that memory will be needed soon. An edit reads a handful of cold cache lines in each of a dozen arrays;
// requested together they arrive together, which halves the time of an edit among a million samples.
#pragma once

namespace mes {

inline void prefetch(const void* address) {
  __builtin_prefetch(address, 1);
}

}  // namespace mes
