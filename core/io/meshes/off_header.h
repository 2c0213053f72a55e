// SPDX-License-Identifier: GPL-3.0-or-later
// The common header of POFF and WPOFF: a magic word, a count and two meaningless integers. Private to core/io.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/io/text/line_layout.h"
#include "core/io/text/read_job.h"
#include "core/io/text/text_numbers.h"

namespace mes {

/// The differences between the two formats.
struct OffKind {
  std::string_view magic;    ///< "POFF"
  std::string_view things;   ///< name of the counted things, in the plural
  std::string_view numbers;  ///< name of their numbers, in the plural
  std::size_t numbers_each = 2;
  /// Guesses the kind of a file with this many numbers a line; empty: unknown.
  std::string_view (*guess)(std::size_t columns) = nullptr;
};

/// Whether the first word is the magic one.
bool has_off_magic(std::string_view bytes, const OffKind& kind);

/// Reads header and numbers in file order; memory is bounded by the size of the file, whatever the header says. White
/// space is free, but lines that contradict such a reading are an error (`LineLayout`). Errors have line and column.
class OffReader {
 public:
  /// The scanner is at the beginning of `bytes`; `name` stands for the file in messages; `job` follows the bytes.
  OffReader(const OffKind& kind, Scanner& scanner, std::string_view bytes, const std::string& name, ReadJob& job)
      : kind_(kind), scanner_(scanner), bytes_(bytes), name_(name), job_(job) {}

  /// The number of things announced.
  Expected<std::uint64_t> read_header();
  /// A safe number of things to reserve memory for.
  std::size_t likely_count() const;
  /// Reads the numbers of the next thing; the scanner is then at the last of them. Throws `Cancelled`.
  Expected<void> read_next(std::span<double> numbers);
  /// Makes an error at the position of the scanner.
  std::unexpected<Error> fail(std::string text) const;
  /// Makes a one-line remark at the position of the scanner.
  std::string warning(std::string text) const;
  /// Reads to the end of the file; returns a remark if anything follows.
  Expected<std::vector<std::string>> finish();

 private:
  /// Advances to the next number.
  bool next();
  /// Checks the lines ahead while their layout is in doubt.
  Expected<void> survey() const;
  std::optional<Error> contradiction(const LineLayout& layout) const;
  const OffKind& kind_;
  Scanner& scanner_;
  std::string_view bytes_;
  const std::string& name_;
  ReadJob& job_;
  std::uint64_t count_ = 0;
  std::uint64_t numbers_read_ = 0;
  LineLayout layout_{0, 0};  // layout of the numbers read so far
  CoordinateReader coordinates_;
};

}  // namespace mes
