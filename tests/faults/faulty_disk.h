// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of the system that write files, as this executable has them: they fail on demand.
#pragma once

#include <cerrno>
#include <cstdint>

namespace mes::test {

enum class DiskCall : std::uint8_t { open, write, sync, rename };

/// While it lives, the call of the kind number `call` (0: the first) of all threads fails with `error`, and with
/// `and_later` all after it. A failing write takes the first half of the bytes before.
class FailingDisk {
 public:
  FailingDisk(DiskCall kind, int call, bool and_later = false, int error = ENOSPC);
  ~FailingDisk();
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;
  bool has_failed() const;
};

}  // namespace mes::test
