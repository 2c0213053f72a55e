// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>

#include "app/cli/command_line.h"
#include "app/cli/messages.h"
#ifdef MESECINA_HAS_WINDOW
#include "app/window/run_window.h"
#endif

namespace {

/// What no boundary caught, on whichever thread, ends the program with one line instead of a core dump.
[[noreturn]] void end_in_one_line() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    mes::cli::say("ended by a broken invariant");
  } catch (const std::bad_alloc&) {
    mes::cli::say("there is not enough memory");
  } catch (const std::exception& error) {
    mes::cli::say(error.what());
  } catch (...) {
    mes::cli::say("ended by an unknown exception");
  }
  std::_Exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_in_one_line);
  // A reader that goes away and a file that grows too large are errors of a write, not reasons to die in silence.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
#ifdef MESECINA_HAS_WINDOW
  return mes::cli::run_command_line(argc, argv, [argv](std::vector<std::string> files) {
    return mes::run_window({.files = std::move(files), .executable = argv[0]});
  });
#else
  return mes::cli::run_command_line(argc, argv, [](const std::vector<std::string>&) {
    return mes::cli::report(
        {mes::ErrorCode::no_display, "this build has no window; mesecina render draws pictures", {}, 0, 0});
  });
#endif
}
