// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console/messages.h"

#include <cstdio>

#include "core/io/text/text_numbers.h"

namespace mes::cli {

int exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::cannot_compute:
    case ErrorCode::out_of_memory: return 1;
    case ErrorCode::usage: return 2;
    case ErrorCode::bad_input: return 3;
    case ErrorCode::cannot_write:
    case ErrorCode::no_display: return 4;
    case ErrorCode::cancelled: return 130;
  }
  return 1;
}

void say(std::string_view text) {
  // Writes the line in one call, so that lines of several processes do not mix.
  const std::string line = "mesecina: " + printable(text) + '\n';
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

int report(const Error& error) {
  say(error.message());
  return exit_code_of(error.code);
}

}  // namespace mes::cli
