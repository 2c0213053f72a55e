// SPDX-License-Identifier: GPL-3.0-or-later
// Reads, checks and writes JSON.
#pragma once

#include <cstddef>
#include <expected>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/text/read_job.h"

namespace mes {

/// Makes an error with the line and column of a byte of the text.
std::unexpected<Error> bad_json(std::string_view text, std::size_t offset, std::string what, const std::string& file);

/// Whether the text is valid for `JsonView`; needs memory only for the longest word or number of the text. Error:
/// `bad_input` with line and column; also for objects and lists nested more than 64 deep, and for numbers that no
/// double can hold. `job`, which may be null, follows the text; throws `Cancelled`.
Expected<void> check_json(std::string_view text, const std::string& file, ReadJob* job = nullptr);

/// The value of a text; discarded (`is_discarded`) where it is not JSON. For files of the program itself.
nlohmann::json parse_json(std::string_view text);

/// The text of a value; with an indent, a line for each member. Bytes that are not UTF-8 become U+FFFD.
std::string json_text(const nlohmann::json& value, int indent = -1);
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

/// Takes the first value off the front of a sequence of texts, separated by blanks or record separators (RFC 8142);
/// empty at the end. The value ends where its brackets do; `check_json` decides whether it is JSON. Reads each byte
/// once.
std::string_view take_json_text(std::string_view& rest);

}  // namespace mes
