// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/files/read_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{64} * 1024;
constexpr int kLookInterval = 50;  // milliseconds between checks of the stop token

/// A descriptor, closed by the destructor. Opening never blocks, not even for a pipe without a writer.
struct OpenFile {
  int descriptor;
  explicit OpenFile(const fs::path& path) : descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
};

std::unexpected<Error> cannot_read(const std::string& name, int code) {
  return std::unexpected(
      Error{ErrorCode::bad_input, "cannot be read: " + std::generic_category().message(code), name});
}

std::unexpected<Error> not_regular(const std::string& name) {
  return std::unexpected(Error{ErrorCode::bad_input, "cannot be read: not a regular file", name});
}

std::unexpected<Error> too_large(const std::string& name) {
  return std::unexpected(Error{ErrorCode::out_of_memory, "it is too large to read", name});
}

std::unexpected<Error> cancelled(const std::string& name) {
  return std::unexpected(Error{ErrorCode::cancelled, "reading was cancelled", name});
}

bool is_regular(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

bool is_stopped(const JobControl* job) {
  return job != nullptr && job->stop_requested();
}

void note_progress(const ReadOptions& options, std::size_t done, std::size_t all) {
  if (options.job == nullptr || options.share == 0.0 || all == 0) return;
  constexpr std::uint64_t kSteps = std::uint64_t{1} << 20U;
  const double share = std::min(static_cast<double>(done) / static_cast<double>(all), 1.0) * options.share;
  options.job->checkpoint(static_cast<std::uint64_t>(share * static_cast<double>(kSteps)), kSteps);
}

// Waits for data, the end, or a stop.
void wait_for_data(int descriptor, const JobControl* job) {
  pollfd waited{descriptor, POLLIN, 0};
  const int most = job != nullptr ? kLookInterval : -1;
  while (!is_stopped(job) && ::poll(&waited, 1, most) == 0) continue;
}

}  // namespace

Expected<std::string> read_whole(int descriptor, const std::string& name, const ReadOptions& options) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return cannot_read(name, errno);
  if (S_ISDIR(status.st_mode)) return cannot_read(name, EISDIR);
  const bool may_wait = !S_ISREG(status.st_mode);
  if (!may_wait && !options.is_enough &&
      static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0)) > options.most_bytes)
    return too_large(name);
  try {
    std::string bytes;
    std::size_t filled = 0;
    std::size_t next_look = kPiece;
    bool has_room = false;
    for (;;) {
      const std::size_t room = has_room ? bytes.capacity() - filled : 0;
      bytes.resize(filled + (room != 0 ? std::min(room, kPiece) : std::max(kPiece, filled)));
      while (filled < bytes.size()) {
        if (may_wait) wait_for_data(descriptor, options.job);
        if (is_stopped(options.job)) return cancelled(name);
        // A slow disk must not delay a stop for long.
        constexpr std::size_t kMostAtOnce = std::size_t{1} << 20U;
        const ssize_t got = ::read(descriptor, bytes.data() + filled, std::min(bytes.size() - filled, kMostAtOnce));
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got < 0) return cannot_read(name, errno);
        filled += static_cast<std::size_t>(got);
        if (!may_wait) note_progress(options, filled, static_cast<std::size_t>(status.st_size));
        if (filled > options.most_bytes) return too_large(name);
        if (got == 0) {
          bytes.resize(filled);
          return bytes;
        }
      }
      if (filled < next_look) continue;
      next_look = 2 * filled;
      if (options.is_enough && options.is_enough(bytes)) return bytes;
      // The size from the system is a hint: devices and pipes have none, and files grow. If there is one, memory is
      // reserved once, because each reallocation would touch as much again; a piece that is zero-filled just before it
      // is read is still in a cache.
      const auto expected =
          S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0)) : 0;
      if (has_room || expected < filled || expected > options.most_bytes) continue;
      bytes.reserve(static_cast<std::size_t>(expected) + 1);
      has_room = true;
    }
  } catch (const Cancelled&) {
    return cancelled(name);
  } catch (const std::bad_alloc&) {
    return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory to read it", name});
  } catch (const std::length_error&) {
    return too_large(name);
  }
}

Expected<std::string> read_whole(const fs::path& path, const ReadOptions& options) {
  const OpenFile file(path);
  if (file.descriptor < 0) return cannot_read(path.string(), errno);
  return read_whole(file.descriptor, path.string(), options);
}

Expected<std::string> read_regular_file(const fs::path& path, const ReadOptions& options) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return cannot_read(path.string(), errno);
  if (!S_ISREG(status.st_mode)) return not_regular(path.string());
  const OpenFile file(path);
  if (file.descriptor < 0) return cannot_read(path.string(), errno);
  if (!is_regular(file.descriptor)) return not_regular(path.string());
  return read_whole(file.descriptor, path.string(), options);
}

}  // namespace mes
