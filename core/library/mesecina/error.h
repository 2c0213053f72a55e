// SPDX-License-Identifier: GPL-3.0-or-later
// The one exception of the library.
//
// Guarantees:
//  1. Functions of the library throw `Error`, or `std::bad_alloc` if there is no memory for an `Error`. An exception of
//     the caller's callback passes through unchanged.
//  2. `what()` is one printable line, with file, line and column where they are known.
//  3. Copying an error neither throws nor allocates.
//
// Smallest use:
//     try {
//       bench.open("missing.poff");
//     } catch (const mesecina::Error& error) {
//       if (error.code() == mesecina::ErrorCode::bad_input) std::puts(error.what());
//     }
//
// Threads: an error may be handed to another thread.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <mesecina/geometry.h>
#include <mesecina/version.h>

namespace mesecina {
inline namespace v1 {

enum class ErrorCode : std::uint8_t {
  usage = 0,           ///< an invalid call: an unknown id, a value out of range, an outdated table
  bad_input = 1,       ///< data cannot be read or parsed
  cannot_write = 2,    ///< a file cannot be written
  cannot_compute = 3,  ///< a structure failed; `structure()` is its id, and `witnesses()` are the culprits
  out_of_memory = 4,
  cancelled = 5,  ///< stopped through a `Job`
  internal = 6,   ///< a bug of the library; please report it
};

/// "usage", "bad input", ...
MESECINA_API std::string_view name_of(ErrorCode code) noexcept;

class MESECINA_API Error : public std::exception {
 public:
  struct Details {
    ErrorCode code = ErrorCode::usage;
    std::string text{};                 ///< one line, no full stop, without the file
    std::string file{};                 ///< empty if no file is involved
    std::uint64_t line = 0;             ///< from 1; 0 = unknown
    std::uint64_t column = 0;           ///< byte column from 1; 0 = unknown
    std::string structure{};            ///< id of the structure that failed; empty for other errors
    std::vector<SampleId> witnesses{};  ///< samples that a failed structure blames; often empty
  };

  explicit Error(Details details);
  Error(ErrorCode code, std::string text);
  Error(const Error&) noexcept;
  Error& operator=(const Error&) noexcept;
  ~Error() override;

  /// "FILE:LINE:COLUMN: text", with the parts that are known.
  const char* what() const noexcept override;
  ErrorCode code() const noexcept;
  const std::string& text() const noexcept;
  const std::string& file() const noexcept;
  std::uint64_t line() const noexcept;
  std::uint64_t column() const noexcept;
  const std::string& structure() const noexcept;
  const std::vector<SampleId>& witnesses() const noexcept;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace v1
}  // namespace mesecina
