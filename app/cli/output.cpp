// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "core/io/atomic_file.h"

namespace mes::cli {
namespace {

std::unexpected<Error> cannot_print(int code) {
  return std::unexpected(Error{ErrorCode::cannot_write, "cannot be written: " + std::generic_category().message(code),
                               "standard output"});
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

Expected<void> write_output(const std::string& file, std::string_view bytes, Interruption& interruption) {
  if (!is_standard_output(file))
    return interruption.uninterrupted([&] { return write_file_atomically(file, bytes); });
  while (!bytes.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) {
      // Whoever read has had enough, as in "| head": no failure, and nothing to say. End as other programs do.
      std::signal(SIGPIPE, SIG_DFL);
      static_cast<void>(std::raise(SIGPIPE));
    }
    if (written < 0) return cannot_print(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace mes::cli
