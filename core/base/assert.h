// SPDX-License-Identifier: GPL-3.0-or-later
// MES_ASSERT: a broken invariant of ours. On in every build; throws, and is caught at command and
// node boundary, so that a mistake costs one picture and not the user's work.
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
