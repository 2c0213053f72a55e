// SPDX-License-Identifier: GPL-3.0-or-later
// JSON from files that cannot be trusted.
#pragma once

#include <cstddef>
#include <expected>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/read_job.h"

namespace mes {

/// An error with line and column of a byte of the text.
std::unexpected<Error> bad_json(std::string_view text, std::size_t offset, std::string what, const std::string& file);

/// Whether the text can be looked at by `JsonView`; takes no memory but for the longest word or number of the text.
/// Error: `bad_input` with line and column; also for objects and lists nested more than 64 deep, and for numbers that
/// no double can hold. `job`, which may be null, goes through the text; throws `Cancelled`.
Expected<void> check_json(std::string_view text, const std::string& file, ReadJob* job = nullptr);

/// Takes the first value off the front of texts that follow each other with blanks or record separators (RFC 8142)
/// between them; empty at the end. Whether it is JSON is for `check_json` to say: it ends where its brackets do. One look at each byte.
std::string_view take_json_text(std::string_view& rest);

}  // namespace mes
