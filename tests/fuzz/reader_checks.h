// SPDX-License-Identifier: GPL-3.0-or-later
// What every reader promises about what it says and what it takes.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/text/text_numbers.h"
#include "tests/fuzz/driver/coverage.h"
#include "tests/fuzz/driver/memory.h"
#include "tests/fuzz/target.h"

namespace mes::fuzz {

/// The bytes must not be empty.
inline std::uint8_t first_byte(std::string_view bytes) {
  return static_cast<std::uint8_t>(bytes.front());
}

/// One printable line.
inline void require_message(const std::string& text) {
  require(!text.empty() && printable(text) == text, "a message is one printable line: " + printable(text));
}

/// An error of input, at a place that there is.
inline void require_error(const Error& error, std::string_view bytes) {
  require(error.code == ErrorCode::bad_input, "the bytes are to blame: " + error.message());
  require_message(error.text);
  require(!error.text.ends_with('.'), "no full stop after " + error.text);
  const auto lines =
      static_cast<std::uint64_t>(std::ranges::count_if(bytes, [](char c) { return c == '\n' || c == '\r'; }) + 1);
  require(error.line <= lines && error.column <= bytes.size() + 1 && (error.line != 0 || error.column == 0),
          "the place is one of the file: " + error.message());
}
inline void require_error_with_place(const Error& error, std::string_view bytes) {
  require_error(error, bytes);
  require(error.line != 0 && error.column != 0, "the error has line and column: " + error.message());
}

/// What was read from what the program wrote itself, without a complaint.
template <class T>
T require_read(Expected<T> read) {
  require(read.has_value(), "what is written can be read: " + (read ? std::string() : read.error().message()));
  return *std::move(read);
}

/// A reader may take this many bytes of memory for a file of any size.
inline constexpr std::size_t kAnyMemory = std::size_t{4} << 20U;
/// The same for a reader of maps: the library PROJ reads its database.
inline constexpr std::size_t kMemoryOfProj = std::size_t{16} << 20U;

/// Memory grows with the bytes, not with what they announce. Checked where the build can measure it.
inline void require_little_memory(std::size_t size, std::size_t bytes_each = 400, std::size_t always = kAnyMemory) {
  require(peak_bytes() <= always + bytes_each * size,
          "little memory for " + std::to_string(size) + " bytes: " + std::to_string(peak_bytes()));
}

/// Basic blocks that reading may enter: some for each byte, and some however few the bytes are.
struct ReadingWork {
  std::uint64_t always;
  std::uint64_t each;
};
/// Files that hold what they say.
inline constexpr ReadingWork kPlainWork{4'000'000, 4'000};
/// Files of curves, which are joined, cut and sampled. A few bytes may place the same part many times, and curves that
/// nearly touch are measured to the last digit.
inline constexpr ReadingWork kCurveWork{500'000'000, 100'000};

/// Work grows with the bytes, whatever they say. Checked in builds that count it.
inline void require_little_work(std::size_t size, ReadingWork limit) {
  const std::uint64_t work = blocks_entered();
  require(work <= limit.always + limit.each * size,
          "little work for " + std::to_string(size) + " bytes: " + std::to_string(work) + " blocks");
}

}  // namespace mes::fuzz
