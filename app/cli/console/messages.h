// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of the command line on stderr, and its exit codes: 0 done, 1 not completed, 2 usage, 3 bad input, 4 output
// impossible, 130 interrupted.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes::cli {

inline constexpr int kExitDone = 0;

int exit_code_of(ErrorCode code);

/// Prints "mesecina: text" as one printable line.
void say(std::string_view text);

/// Reports the error and returns its exit code.
int report(const Error& error);

inline std::unexpected<Error> usage_error(std::string text) {
  return std::unexpected(Error{ErrorCode::usage, std::move(text), {}, 0, 0});
}

inline std::unexpected<Error> cannot_write(std::string text, const std::filesystem::path& file) {
  return std::unexpected(Error{ErrorCode::cannot_write, std::move(text), file.string()});
}

}  // namespace mes::cli
