// SPDX-License-Identifier: GPL-3.0-or-later
// Errors as values. `Error` is for input, files and commands; `GeometryError` for a structure that
// cannot be computed; `MES_ASSERT` (assert.h) for our own mistakes.
#pragma once

#include <cstdint>
#include <expected>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/ids.h"

namespace mes {

enum class ErrorCode : std::uint8_t {
  usage,           ///< the request itself makes no sense (exit code 2)
  bad_input,       ///< data cannot be read or parsed (exit code 3)
  cannot_write,    ///< output cannot be written (exit code 4)
  no_display,      ///< no window or no OpenGL (exit code 4)
  cannot_compute,  ///< a structure failed (exit code 1)
  out_of_memory,   ///< (exit code 1)
  cancelled,       ///< stopped on request (exit code 130)
};

struct Error {
  ErrorCode code = ErrorCode::bad_input;
  std::string text{};        ///< one printable line, no trailing full stop, no file name
  std::string file{};        ///< empty when no file is involved
  std::uint64_t line = 0;    ///< counted from 1; 0 = unknown
  std::uint64_t column = 0;  ///< byte column, counted from 1; 0 = unknown

  /// "FILE:LINE:COLUMN: what is wrong" with the parts that are known.
  std::string message() const {
    std::string out;
    if (!file.empty()) {
      out += file;
      if (line != 0) out += ':' + std::to_string(line);
      if (line != 0 && column != 0) out += ':' + std::to_string(column);
      out += ": ";
    }
    return out + text;
  }
};

template <class T>
using Expected = std::expected<T, Error>;

/// Thrown inside a structure; caught at the node boundary, where it becomes a failed node.
struct GeometryError : std::runtime_error {
  explicit GeometryError(const std::string& text, std::vector<SampleId> witness_samples = {})
      : std::runtime_error(text), witnesses(std::move(witness_samples)) {}
  std::vector<SampleId> witnesses;
};

/// Thrown out of a long computation when its stop token asks for it; caught at the node boundary.
struct Cancelled {};

}  // namespace mes
