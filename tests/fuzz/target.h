// SPDX-License-Identifier: GPL-3.0-or-later
// What a fuzz target is: one function of some bytes, under the name that libFuzzer and AFL know as well.
//
// A target takes any bytes, does the same each time, and ends the process when a promise is broken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace mes::fuzz {

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "broken promise: %s\n", what.c_str());
  std::abort();
}

/// A promise; ends the process when it is broken.
inline void require(bool is_kept, const std::string& promise) {
  if (!is_kept) fail(promise);
}

}  // namespace mes::fuzz
