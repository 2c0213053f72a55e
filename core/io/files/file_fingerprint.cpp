// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/files/file_fingerprint.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace mes {
namespace {

constexpr std::size_t kHashWord = sizeof(std::uint64_t);

/// Each step is a bijection of the state for a fixed word, and of the word for a fixed state.
class Hash {
 public:
  /// The size must be a multiple of eight bytes, except in the last call.
  void add(std::string_view bytes) {
    size_ += bytes.size();
    for (; bytes.size() >= kHashWord; bytes.remove_prefix(kHashWord)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data(), kHashWord);
      step(word);
    }
    if (bytes.empty()) return;
    std::uint64_t rest = 0;
    for (const char c : bytes) rest = (rest << 8U) | static_cast<unsigned char>(c);
    step(rest);
  }
  FileFingerprint fingerprint() const { return {size_, state_}; }

 private:
  void step(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x9E3779B97F4A7C15U;
    state_ ^= state_ >> 32U;
  }
  std::uint64_t size_ = 0;
  std::uint64_t state_ = 0x243F6A8885A308D3U;
};

}  // namespace

FileFingerprint fingerprint_of(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.fingerprint();
}

std::optional<FileFingerprint> fingerprint_of_file(const std::filesystem::path& path) {
  struct stat status {};
  // Opening anything but a regular file might block or have side effects.
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  Hash hash;
  std::vector<char> piece(std::size_t{1} << 18U);
  std::size_t filled = 0;
  bool is_good = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  while (is_good) {
    const ssize_t got = ::read(descriptor, piece.data() + filled, piece.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    is_good = got >= 0;
    if (got <= 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled < piece.size()) continue;
    hash.add({piece.data(), filled});
    filled = 0;
  }
  ::close(descriptor);
  if (!is_good) return std::nullopt;
  hash.add({piece.data(), filled});
  return hash.fingerprint();
}

}  // namespace mes
