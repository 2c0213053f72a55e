// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/driver/memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cstdint>

extern "C" {
// The address sanitizer has them; other builds do not.
[[gnu::weak]] int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                            void (*on_free)(const volatile void*));
[[gnu::weak]] std::size_t __sanitizer_get_allocated_size(const volatile void* place);
// More than any input may take, and well below what the machine may take amiss.
[[gnu::visibility("default")]] const char* __asan_default_options();
const char* __asan_default_options() {
  return "detect_leaks=0:max_allocation_size_mb=2048:hard_rss_limit_mb=6144";
}
}

namespace mes::fuzz {
namespace {

constexpr rlim_t kMostData = rlim_t{4} << 30U;

std::atomic<std::int64_t> live = 0;
std::atomic<std::int64_t> peak = 0;

void on_malloc(const volatile void* /*place*/, std::size_t size) {
  const std::int64_t now = live += static_cast<std::int64_t>(size);
  std::int64_t before = peak;
  while (before < now && !peak.compare_exchange_weak(before, now)) {
  }
}

void on_free(const volatile void* place) {
  if (place != nullptr) live -= static_cast<std::int64_t>(__sanitizer_get_allocated_size(place));
}

}  // namespace

void watch_memory() {
  if (__sanitizer_install_malloc_and_free_hooks != nullptr) {
    __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free);
  } else {
    const rlimit limit{kMostData, kMostData};
    ::setrlimit(RLIMIT_DATA, &limit);
  }
}

void begin_measuring() {
  live = 0;
  peak = 0;
}

std::size_t peak_bytes() {
  return static_cast<std::size_t>(std::max<std::int64_t>(peak, 0));
}

}  // namespace mes::fuzz
