// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/files/temporary.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/io/files/file_lock.h"

namespace mes {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kPartBegin = ".mesecina-";
constexpr std::string_view kPartEnd = ".part";
constexpr std::size_t kPartDigits = 16;
constexpr std::string_view kScratchBegin = "mesecina-film-";
constexpr const char* kScratchEnd = "XXXXXX";  // required by mkdtemp
constexpr const char* kOwner = ".mesecina-owner";
constexpr int kAttempts = 100;

/// The temporary files of this process. Never destroyed: threads may outlive `main`.
struct Owned {
  std::timed_mutex mutex;
  bool is_closed = false;
  std::vector<fs::path> parts;
  std::vector<fs::path> folders;
};
Owned& owned() {
  static Owned& out = *new Owned;
  return out;
}

bool is_part_name(std::string_view name) {
  if (name.size() != kPartBegin.size() + kPartDigits + kPartEnd.size()) return false;
  return name.starts_with(kPartBegin) && name.ends_with(kPartEnd) &&
         name.substr(kPartBegin.size(), kPartDigits).find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

bool is_scratch_name(std::string_view name) {
  return name.starts_with(kScratchBegin) &&
         name.size() == kScratchBegin.size() + std::string_view(kScratchEnd).size();
}

std::string part_name() {
  std::uint64_t number = 0;
  // If the system gives no randomness, EEXIST still keeps the names unique.
  if (::getentropy(&number, sizeof number) != 0)
    number = static_cast<std::uint64_t>(Clock::now().time_since_epoch().count()) ^
             (static_cast<std::uint64_t>(::getpid()) << 32U);
  return fmt::format("{}{:0{}x}{}", kPartBegin, number, kPartDigits, kPartEnd);
}

std::vector<std::string> names_in(DIR* folder) {
  std::vector<std::string> out;
  while (const dirent* entry = ::readdir(folder)) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") out.emplace_back(name);
  }
  return out;
}

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};
using Folder = std::unique_ptr<DIR, CloseFolder>;

// Does not follow a link.
Folder open_folder(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  DIR* const folder = ::fdopendir(descriptor);
  if (folder == nullptr) ::close(descriptor);
  return Folder(folder);
}

// Removes the files in it, and then the folder. A folder with subfolders was not made by this program and stays.
void remove_folder(const fs::path& path, Clock::time_point until) {
  const Folder folder = open_folder(path);
  if (!folder) return;
  std::vector<std::string> names = names_in(folder.get());
  // The owner's mark is removed last, so that another process can finish an incomplete removal.
  std::ranges::partition(names, [](const std::string& name) { return name != kOwner; });
  for (const std::string& name : names) {
    if (Clock::now() > until) return;
    ::unlinkat(::dirfd(folder.get()), name.c_str(), 0);
  }
  ::rmdir(path.c_str());
}

/// Opens and locks a regular file of this user that no living process has locked; -1: it is not such a file.
int lock_abandoned(const fs::path& path) {
  struct stat status {};
  // Opening anything else might block or have side effects.
  if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != ::geteuid()) return -1;
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return -1;
  if (try_lock(descriptor) == LockTry::locked && is_named(path, descriptor)) return descriptor;
  ::close(descriptor);
  return -1;
}

void look_once_for_abandoned_parts(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path>& seen = *new std::set<fs::path>;
  constexpr std::size_t kMostRemembered = 1000;
  std::error_code error;
  {
    const std::lock_guard lock(mutex);
    if (seen.size() >= kMostRemembered || !seen.insert(fs::absolute(folder, error)).second) return;
  }
  remove_abandoned_parts(folder);
}

}  // namespace

std::expected<PartFile, int> PartFile::create_beside(const fs::path& target) {
  const fs::path folder = folder_with(target);
  look_once_for_abandoned_parts(folder);
  const std::lock_guard lock(owned().mutex);
  if (owned().is_closed) return std::unexpected(ECANCELED);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    fs::path path = folder / part_name();
    const auto created = create_locked(path, 0666);
    if (created) {
      owned().parts.push_back(path);
      return PartFile(created->descriptor, std::move(path));
    }
    if (created.error() != EEXIST) return std::unexpected(created.error());
  }
  return std::unexpected(EEXIST);
}

PartFile::PartFile(PartFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::exchange(other.path_, {})) {}

PartFile::~PartFile() {
  if (!path_.empty()) {
    const std::lock_guard lock(owned().mutex);
    if (!owned().is_closed) ::unlink(path_.c_str());
    std::erase(owned().parts, path_);
  }
  if (descriptor_ >= 0) ::close(descriptor_);
}

int PartFile::sync() {
  if (::fsync(descriptor_) != 0) return errno;
  // Some file systems report write errors only when a descriptor is closed. The other descriptor keeps the lock.
  const int twin = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  if (twin < 0) return errno;
  return ::close(twin) == 0 ? 0 : errno;
}

int PartFile::rename_to(const fs::path& target) {
  const std::lock_guard lock(owned().mutex);
  if (owned().is_closed) return ECANCELED;
  if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
  std::erase(owned().parts, path_);
  path_.clear();
  return 0;
}

Expected<ScratchFolder> ScratchFolder::make() {
  remove_abandoned_scratch();
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  const auto failed = [](const fs::path& path, int code) {
    return std::unexpected(Error{ErrorCode::cannot_write,
                                 "no folder for temporary files: " + std::generic_category().message(code),
                                 path.string()});
  };
  if (error) return failed(parent, error.value());
  const std::lock_guard lock(owned().mutex);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (owned().is_closed) return failed(parent, ECANCELED);
    std::string pattern = (parent / (std::string(kScratchBegin) + kScratchEnd)).string();
    if (::mkdtemp(pattern.data()) == nullptr) return failed(parent, errno);
    const auto owner = create_locked(fs::path(pattern) / kOwner, 0600);
    if (owner) {
      owned().folders.emplace_back(pattern);
      return ScratchFolder(owner->descriptor, pattern);
    }
    ::rmdir(pattern.c_str());
    if (owner.error() != EEXIST && owner.error() != ENOENT) return failed(pattern, owner.error());
  }
  return failed(parent, EEXIST);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : owner_(std::exchange(other.owner_, -1)), path_(std::exchange(other.path_, {})) {}

ScratchFolder::~ScratchFolder() {
  if (!path_.empty()) {
    remove_folder(path_, Clock::time_point::max());
    const std::lock_guard lock(owned().mutex);
    std::erase(owned().folders, path_);
  }
  if (owner_ >= 0) ::close(owner_);
}

void remove_abandoned_parts(const fs::path& folder) {
  const Folder opened(::opendir(folder.c_str()));
  if (!opened) return;
  for (const std::string& name : names_in(opened.get())) {
    if (!is_part_name(name)) continue;
    const int abandoned = lock_abandoned(folder / name);
    if (abandoned < 0) continue;
    ::unlink((folder / name).c_str());
    ::close(abandoned);
  }
}

void remove_abandoned_scratch() {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  if (error) return;
  const Folder opened(::opendir(parent.c_str()));
  if (!opened) return;
  for (const std::string& name : names_in(opened.get())) {
    struct stat status {};
    const fs::path folder = parent / name;
    if (!is_scratch_name(name) || ::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
        status.st_uid != ::geteuid())
      continue;
    const int abandoned = lock_abandoned(folder / kOwner);
    if (abandoned < 0) continue;
    remove_folder(folder, Clock::time_point::max());
    ::close(abandoned);
  }
}

void remove_own_temporaries(Clock::time_point until) {
  const std::unique_lock lock(owned().mutex, until);
  if (!lock) return;
  owned().is_closed = true;
  for (const fs::path& part : owned().parts) ::unlink(part.c_str());
  for (const fs::path& folder : owned().folders) remove_folder(folder, until);
}

}  // namespace mes
