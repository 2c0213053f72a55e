// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "core/io/files/file_lock.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

std::unexpected<Error> cannot_write(const fs::path& path, int code) {
  return std::unexpected(
      Error{ErrorCode::cannot_write, "cannot be written: " + std::generic_category().message(code), path.string()});
}

// Returns 0 or errno.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

Expected<void> write_directly(const fs::path& path, std::string_view bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return cannot_write(path, errno);
  const int reason = write_all(descriptor, bytes);
  const int closed = ::close(descriptor) == 0 ? 0 : errno;
  if (reason != 0 || closed != 0) return cannot_write(path, reason != 0 ? reason : closed);
  return {};
}

/// The file that is at the target path now.
struct Target {
  fs::path path;  ///< links followed
  bool exists = false;
  bool is_regular = false;
  mode_t mode = 0;
};

Expected<Target> found_target(const fs::path& path) {
  Target target{path};
  if (path.empty()) return cannot_write(path, ENOENT);
  std::error_code error;
  // Follows even a chain of links that ends at no file yet; the limit is the system's usual one.
  for (int links = 0; fs::is_symlink(target.path, error); ++links) {
    if (links == 40) return cannot_write(path, ELOOP);
    const fs::path next = fs::read_symlink(target.path, error);
    if (error) return cannot_write(path, error.value());
    target.path = next.is_absolute() ? next : folder_with(target.path) / next;
  }
  struct stat status {};
  if (::stat(target.path.c_str(), &status) != 0) {
    if (errno != ENOENT) return cannot_write(path, errno);
    if (!target.path.has_filename()) return cannot_write(path, EISDIR);
    return target;
  }
  target.exists = true;
  target.is_regular = S_ISREG(status.st_mode);
  target.mode = status.st_mode & 07777U;
  if (S_ISDIR(status.st_mode)) return cannot_write(path, EISDIR);
  if (::access(target.path.c_str(), W_OK) != 0) return cannot_write(path, errno);
  return target;
}

/// Identity of the file that a path names, and its last modification.
struct Identity {
  bool exists = false;
  dev_t device = 0;
  ino_t number = 0;
  off_t size = 0;
  timespec modified{};
  timespec changed{};

  static Identity of(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {true, status.st_dev, status.st_ino, status.st_size, status.st_mtim, status.st_ctim};
  }
  friend bool operator==(const Identity& a, const Identity& b) {
    const auto same = [](const timespec& s, const timespec& t) {
      return s.tv_sec == t.tv_sec && s.tv_nsec == t.tv_nsec;
    };
    return a.exists == b.exists && a.device == b.device && a.number == b.number && a.size == b.size &&
           same(a.modified, b.modified) && same(a.changed, b.changed);
  }
};

/// Checks that a file still has the expected content.
class Expectation {
 public:
  /// A null fingerprint expects nothing: any content is fine.
  Expectation(fs::path path, const FileFingerprint* fingerprint)
      : path_(std::move(path)), fingerprint_(fingerprint) {}

  /// Reads the file only if its identity has changed since the last read.
  bool holds() {
    if (fingerprint_ == nullptr) return true;
    const Identity now = Identity::of(path_);
    if (!now.exists || (seen_ && *seen_ == now)) return true;
    if (fingerprint_of_file(path_) != *fingerprint_) return false;
    seen_ = now;
    return true;
  }

 private:
  fs::path path_;
  const FileFingerprint* fingerprint_;
  std::optional<Identity> seen_;
};

int keep_mode(const PartFile& part, const Target& target) {
  return !target.exists || ::fchmod(part.descriptor(), target.mode) == 0 ? 0 : errno;
}

// Makes the new name as durable as the folder. Some file systems cannot sync a folder; that is not an error.
void sync_folder(const fs::path& path) {
  const int folder = ::open(folder_with(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  static_cast<void>(::fsync(folder));
  ::close(folder);
}

Expected<Replaced> write(const fs::path& path, std::string_view bytes, const FileFingerprint* expected) {
  const auto target = found_target(path);
  if (!target) return std::unexpected(target.error());
  if (target->exists && !target->is_regular) {
    if (expected != nullptr) return Replaced::changed;
    if (auto written = write_directly(path, bytes); !written) return std::unexpected(written.error());
    return Replaced::done;
  }
  Expectation expectation(target->path, expected);
  if (!expectation.holds()) return Replaced::changed;
  auto part = PartFile::create_beside(target->path);
  if (!part) return cannot_write(path, part.error());
  if (const int reason = keep_mode(*part, *target); reason != 0) return cannot_write(path, reason);
  if (const int reason = write_all(part->descriptor(), bytes); reason != 0) return cannot_write(path, reason);
  if (const int reason = part->sync(); reason != 0) return cannot_write(path, reason);
  if (!expectation.holds()) return Replaced::changed;
  if (const int reason = part->rename_to(target->path); reason != 0) return cannot_write(path, reason);
  sync_folder(target->path);
  return Replaced::done;
}

}  // namespace

Expected<void> check_writable(const fs::path& path) {
  const auto target = found_target(path);
  if (!target) return std::unexpected(target.error());
  if (target->exists && !target->is_regular) return {};
  if (const auto part = PartFile::create_beside(target->path); !part) return cannot_write(path, part.error());
  return {};
}

Expected<void> write_file_atomically(const fs::path& path, std::string_view bytes) {
  const auto written = write(path, bytes, nullptr);
  if (!written) return std::unexpected(written.error());
  return {};
}

bool is_as_expected(const fs::path& path, const FileFingerprint& expected) {
  return Expectation(path, &expected).holds();
}

Expected<Replaced> replace_file(const fs::path& path, std::string_view bytes, const FileFingerprint& expected) {
  return write(path, bytes, &expected);
}

Expected<OutsideWriting> OutsideWriting::begin(const fs::path& path) {
  const auto target = found_target(path);
  if (!target) return std::unexpected(target.error());
  if (target->exists && !target->is_regular)
    return std::unexpected(Error{ErrorCode::cannot_write, "cannot be written: not a regular file", path.string()});
  auto part = PartFile::create_beside(target->path);
  if (!part) return cannot_write(path, part.error());
  if (const int reason = keep_mode(*part, *target); reason != 0) return cannot_write(path, reason);
  return OutsideWriting(path, target->path, std::move(*part));
}

Expected<void> OutsideWriting::finish() {
  // The outside program may have replaced the file under this name; only the locked file is trusted.
  if (!is_named(part_.path(), part_.descriptor())) return cannot_write(path_, ENOENT);
  if (const int reason = part_.sync(); reason != 0) return cannot_write(path_, reason);
  if (const int reason = part_.rename_to(target_); reason != 0) return cannot_write(path_, reason);
  sync_folder(target_);
  return {};
}

}  // namespace mes
