// SPDX-License-Identifier: GPL-3.0-or-later
// MES_ASSERT checks an invariant of our own code. It is on in every build and throws; the command and node boundaries
// catch it, so that a mistake costs one picture and not the user's work.
#pragma once

#include <stdexcept>
#include <string>

namespace mes {

struct AssertionFailure : std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] inline void assertion_failed(const char* condition, const char* file, int line) {
  throw AssertionFailure(std::string("broken invariant: ") + condition + " (" + file + ":" + std::to_string(line) +
                         ")");
}

}  // namespace mes

#define MES_ASSERT(condition) \
  (static_cast<bool>(condition) ? void(0) : ::mes::assertion_failed(#condition, __FILE_NAME__, __LINE__))
