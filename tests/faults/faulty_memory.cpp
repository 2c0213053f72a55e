// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/faulty_memory.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> peak{0};
std::atomic<bool> is_failing{false};
std::atomic<bool> fails_on{false};
std::atomic<long> calls_left{0};

void* allocate(std::size_t size, std::size_t alignment) {
  if (is_failing) {
    const long left = calls_left--;
    if (left == 0 || (left < 0 && fails_on)) throw std::bad_alloc();
  }
  void* const out = alignment <= alignof(std::max_align_t)
                        ? std::malloc(size)
                        : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (out == nullptr) throw std::bad_alloc();
  const std::size_t now = in_use += ::malloc_usable_size(out);
  for (std::size_t most = peak; now > most && !peak.compare_exchange_weak(most, now);) {
  }
  return out;
}

void release(void* block) {
  if (block == nullptr) return;
  in_use -= ::malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept {
  release(block);
}
void operator delete(void* block, std::size_t /*size*/) noexcept {
  release(block);
}
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept {
  release(block);
}
void operator delete(void* block, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  release(block);
}

namespace mes::test {

std::size_t memory_in_use() {
  return in_use;
}
std::size_t peak_of_memory() {
  return peak;
}
void watch_memory() {
  peak = in_use.load();
}

FailingMemory::FailingMemory(long call, bool and_later) {
  calls_left = call;
  fails_on = and_later;
  is_failing = true;
}
FailingMemory::~FailingMemory() {
  is_failing = false;
}
bool FailingMemory::has_failed() const {
  return calls_left < 0;
}

}  // namespace mes::test
