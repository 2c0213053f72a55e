// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace mes {
namespace {

namespace fs = std::filesystem;

std::unexpected<Error> cannot_write(const fs::path& path, int code) {
  return std::unexpected(
      Error{ErrorCode::cannot_write, "cannot be written: " + std::generic_category().message(code), path.string()});
}

/// Closes and, unless told to keep it, removes the file again.
class NewFile {
 public:
  NewFile(int descriptor, fs::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  ~NewFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  int descriptor() const { return descriptor_; }
  const fs::path& path() const { return path_; }
  /// 0 or the reason.
  int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }
  void keep() { path_.clear(); }

 private:
  int descriptor_;
  fs::path path_;
};

// 0 or the reason.
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
  NewFile file(descriptor, {});
  if (const int reason = write_all(descriptor, bytes); reason != 0) return cannot_write(path, reason);
  if (const int reason = file.close(); reason != 0) return cannot_write(path, reason);
  return {};
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// What stands at the target now.
struct Target {
  fs::path path;  ///< links followed
  bool exists = false;
  bool is_regular = false;
  mode_t mode = 0;
};

Expected<Target> look_at(const fs::path& path) {
  Target target{path};
  if (path.empty()) return cannot_write(path, ENOENT);
  std::error_code error;
  // A chain of links that leads nowhere yet is followed as well; the limit is the system's usual one.
  for (int links = 0; fs::is_symlink(target.path, error); ++links) {
    if (links == 40) return cannot_write(path, ELOOP);
    const fs::path next = fs::read_symlink(target.path, error);
    if (error) return cannot_write(path, error.value());
    target.path = next.is_absolute() ? next : folder_of(target.path) / next;
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

// A new file in the folder of the target, under a short name that nobody uses.
std::expected<std::pair<int, fs::path>, int> create_beside(const fs::path& target) {
  constexpr int kAttempts = 100;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    fs::path path =
        folder_of(target) / (".mesecina-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part");
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) return std::pair(descriptor, std::move(path));
    if (errno != EEXIST) return std::unexpected(errno);
  }
  return std::unexpected(EEXIST);
}

}  // namespace

Expected<void> check_writable(const fs::path& path) {
  const auto target = look_at(path);
  if (!target) return std::unexpected(target.error());
  if (target->exists && !target->is_regular) return {};
  if (::access(folder_of(target->path).c_str(), W_OK | X_OK) != 0) return cannot_write(path, errno);
  return {};
}

Expected<void> write_file_atomically(const fs::path& path, std::string_view bytes) {
  const auto target = look_at(path);
  if (!target) return std::unexpected(target.error());
  if (target->exists && !target->is_regular) return write_directly(path, bytes);

  auto created = create_beside(target->path);
  if (!created) return cannot_write(path, created.error());
  NewFile file(created->first, std::move(created->second));
  if (target->exists && ::fchmod(file.descriptor(), target->mode) != 0) return cannot_write(path, errno);
  if (const int reason = write_all(file.descriptor(), bytes); reason != 0) return cannot_write(path, reason);
  if (::fsync(file.descriptor()) != 0) return cannot_write(path, errno);
  if (const int reason = file.close(); reason != 0) return cannot_write(path, reason);
  if (::rename(file.path().c_str(), target->path.c_str()) != 0) return cannot_write(path, errno);
  file.keep();

  // The new name is as durable as the folder; some file systems cannot sync one, which is no failure of ours.
  const int folder = ::open(folder_of(target->path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0) {
    static_cast<void>(::fsync(folder));
    ::close(folder);
  }
  return {};
}

}  // namespace mes
