// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "app/cli/command_line.h"
#include "app/cli/console/messages.h"
#include "app/window/run_window.h"
#include "core/base/jobs/keep_memory.h"
#include "core/builtins/builtins.h"

namespace {

/// Ends the program with one line, not a core dump, after an exception that no boundary caught, on any thread. It
/// allocates nothing: lack of memory is the likeliest reason to be here.
[[noreturn]] void end_in_one_line() noexcept {
  const auto print = [](std::string_view text) {
    static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
  };
  print("mesecina: ");
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    print("ended without a reason");
  } catch (const std::bad_alloc&) {
    print("there is not enough memory");
  } catch (const std::exception& error) {
    print(error.what());
  } catch (...) {
    print("ended by an unknown exception");
  }
  print("\n");
  std::_Exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  mes::keep_freed_memory();
  std::set_terminate(end_in_one_line);
  // A reader that closes the pipe and a file that grows too large are errors of a write, not reasons to die in
  // silence.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // If it were ignored, as some parents leave it, we would not get the exit codes of children.
  std::signal(SIGCHLD, SIG_DFL);
  return mes::cli::run_command_line(mes::builtins(), argc, argv, [argv](mes::cli::WindowRequest request) {
    return mes::run_window(mes::builtins(), {.files = std::move(request.files),
                                             .presents = request.presents,
                                             .experiments = std::move(request.experiments),
                                             .link = request.link,
                                             .executable = argv[0],
                                             .manual = mes::cli::complete_manual});
  });
}
