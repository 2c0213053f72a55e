// SPDX-License-Identifier: GPL-3.0-or-later
// Runs work in a child process: whatever the work does to itself, this process only receives bytes or an error.
//
// Use it for arithmetic that may loop for ever or corrupt its own data (predicates in plain doubles), and for calls
// that cannot be interrupted (a single sign of nested roots may take minutes). The child starts as a copy of this
// process, so the work sees all data without any passing. It must not start threads or wait for others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <type_traits>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/base/table.h"

namespace mes {

/// False under the address sanitizer: its allocator stays locked in the child if another thread allocates during the
/// fork. The allocator of the C library does not.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kForksBesideThreads = false;
#else
inline constexpr bool kForksBesideThreads = true;
#endif

struct IsolationLimits {
  double seconds = 0.0;     ///< wall-clock time; 0 = no limit
  std::uint64_t bytes = 0;  ///< memory beyond the memory of this process; 0 = no limit
  const char* what = "it";  ///< subject of error messages, e.g. "naive arithmetic"
};

/// Returns the result of `work`. Throws `Cancelled` within about 20 ms when the job is stopped, and `GeometryError`
/// with a reason when the work throws, crashes, or exceeds a limit. Costs a few milliseconds.
std::vector<std::byte> run_isolated(const std::function<std::vector<std::byte>()>& work,
                                    const IsolationLimits& limits, JobControl& job);

/// Writes plain tables as bytes, in order.
class TableWriter {
 public:
  template <class T>
  void operator()(const std::vector<T>& table) {
    (*this)(table.size());
    append(table.data(), table.size() * sizeof(T));
  }
  template <class Row, class T>
  void operator()(const Table<Row, T>& table) {
    (*this)(table.values());
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) { append(&value, sizeof value); }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }
  std::vector<std::byte> bytes_;
};

/// Reads what a `TableWriter` wrote. Throws `GeometryError` if bytes are missing.
class TableReader {
 public:
  explicit TableReader(const std::vector<std::byte>& bytes) : bytes_(bytes) {}
  template <class T>
  void operator()(std::vector<T>& table) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::size_t count = 0;
    (*this)(count);
    if (count > (bytes_.size() - at_) / sizeof(T)) throw GeometryError("an isolated computation gave broken data");
    table.resize(count);
    take(table.data(), count * sizeof(T));
  }
  template <class Row, class T>
  void operator()(Table<Row, T>& table) {
    (*this)(table.values());
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) { take(&value, sizeof value); }

 private:
  void take(void* to, std::size_t size) {
    if (size > bytes_.size() - at_) throw GeometryError("an isolated computation gave broken data");
    if (size != 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  const std::vector<std::byte>& bytes_;
  std::size_t at_ = 0;
};

}  // namespace mes
