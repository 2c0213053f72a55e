// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "core/io/files/atomic_file.h"

namespace mes::cli {
namespace {

namespace fs = std::filesystem;

std::unexpected<Error> cannot_print(int code) {
  return std::unexpected(Error{ErrorCode::cannot_write, "cannot be written: " + std::generic_category().message(code),
                               "standard output"});
}

/// True for two names of one file, even if one is a link or the file was replaced by another one of the same name.
bool are_same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error) && !error;
}

Expected<void> write_file(const std::string& file, std::string_view bytes, const Overwriting& overwriting) {
  const auto source =
      std::ranges::find_if(overwriting.sources, [&](const SourceFile& each) { return are_same(each.path, file); });
  if (overwriting.force || source == overwriting.sources.end()) return write_file_atomically(file, bytes);
  if (!overwriting.is_of_its_kind)
    return std::unexpected(
        Error{ErrorCode::cannot_write, "cannot be written: it is an input; --force overwrites it", file});
  const auto written = replace_file(file, bytes, source->fingerprint);
  if (!written) return std::unexpected(written.error());
  if (*written == Replaced::done) return {};
  return std::unexpected(Error{ErrorCode::cannot_write,
                               "cannot be written: it has changed since it was read; --force overwrites it", file});
}

}  // namespace

bool is_standard_output(const std::string& file) {
  return file.empty() || file == "-";
}

Expected<void> check_output(const std::string& file) {
  if (!is_standard_output(file)) return check_writable(file);
  if (::fcntl(STDOUT_FILENO, F_GETFD) < 0) return cannot_print(errno);
  return {};
}

Expected<void> write_output(const std::string& file, std::string_view bytes, Interruption& interruption,
                            const Overwriting& overwriting) {
  if (!is_standard_output(file))
    return interruption.uninterrupted([&] { return write_file(file, bytes, overwriting); });
  while (!bytes.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) {
      // The reader has closed the pipe, as in "| head". This is not a failure and needs no message; end as other
      // programs do.
      std::signal(SIGPIPE, SIG_DFL);
      static_cast<void>(std::raise(SIGPIPE));
    }
    if (written < 0) return cannot_print(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace mes::cli
