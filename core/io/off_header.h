// SPDX-License-Identifier: GPL-3.0-or-later
// The header that POFF and WPOFF share: a magic word, a count and two integers without meaning. Private to core/io.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/io/line_layout.h"
#include "core/io/read_job.h"
#include "core/io/text_numbers.h"

namespace mes {

/// What differs between the two.
struct OffKind {
  std::string_view magic;    ///< "POFF"
  std::string_view things;   ///< what is counted, in the plural
  std::string_view numbers;  ///< what one of them consists of, in the plural
  std::size_t numbers_each = 2;
  /// What a file with this many numbers a line probably is; empty: unknown.
  std::string_view (*guess)(std::size_t columns) = nullptr;
};

/// Whether the first word is the magic one.
bool has_off_magic(std::string_view bytes, const OffKind& kind);

/// Reads header and numbers in the order of the file; no more memory than the bytes deserve, whatever the header
/// says. White space is free, but lines that contradict such a reading are an error (`LineLayout`). Errors have line
/// and column.
class OffReader {
 public:
  /// The scanner stands at the beginning; `bytes` is all it reads, `name` stands for the file in messages,
  /// `job` goes through the bytes.
  OffReader(const OffKind& kind, Scanner& scanner, std::string_view bytes, const std::string& name, ReadJob& job)
      : kind_(kind), scanner_(scanner), bytes_(bytes), name_(name), job_(job) {}

  /// The number of things announced.
  Expected<std::uint64_t> read_header();
  /// As many things as one may prepare memory for.
  std::size_t likely_count() const;
  /// The numbers of the next thing. The scanner stands at the last of them afterwards. Throws `Cancelled`.
  Expected<void> read_next(std::span<double> numbers);
  /// An error where the scanner stands.
  std::unexpected<Error> fail(std::string text) const;
  /// A remark where the scanner stands, as one line.
  std::string warning(std::string text) const;
  /// Reads on to the end of the file; a remark if there is something.
  Expected<std::vector<std::string>> finish();

 private:
  /// Goes to the next number.
  bool next();
  /// Looks at the lines ahead, as far as their layout is in doubt.
  Expected<void> survey() const;
  std::optional<Error> contradiction(const LineLayout& layout) const;
  const OffKind& kind_;
  Scanner& scanner_;
  std::string_view bytes_;
  const std::string& name_;
  ReadJob& job_;
  std::uint64_t count_ = 0;
  std::uint64_t numbers_read_ = 0;
  LineLayout layout_{0, 0};  // of the numbers seen so far
  CoordinateReader coordinates_;
};

}  // namespace mes
