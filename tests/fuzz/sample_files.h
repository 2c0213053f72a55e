// SPDX-License-Identifier: GPL-3.0-or-later
// Files of samples and balls: what was read is written and reads back equal.
#pragma once

#include <string>
#include <string_view>

#include "core/io/format.h"
#include "core/raster/picture_decoder.h"
#include "tests/fuzz/reader_checks.h"

namespace mes::fuzz {

inline bool are_equal(const SampleData& a, const SampleData& b) {
  return a.positions == b.positions && a.contours == b.contours &&
         std::ranges::equal(a.balls, b.balls, [](const Disk& x, const Disk& y) { return x == y; });
}

/// The data make a document, and its files give the data back.
inline void require_round_trip(const SampleData& data) {
  Document document;
  const auto delta = replace_all(document, data);
  require(delta.has_value(), "data that were read make a document: " + (delta ? "" : delta.error().text));
  document.apply(*delta);
  const LoadedFile points = require_read(read_sample_bytes(write_poff(document), "again.poff", "poff"));
  require(points.warnings.empty(), "what is written is read without a warning");
  const LoadedFile balls = require_read(read_sample_bytes(write_wpoff(document), "again.wpoff", "wpoff"));
  require(are_equal({points.data.positions, points.data.contours, balls.data.balls}, data),
          "what is written reads back equal");
}

/// Reads the bytes as the format, or as whatever they look like.
inline void check_sample_file(std::string_view bytes, const std::string& name, std::string_view format) {
  // A picture has no lines, and its pixels take more memory than its bytes; it has a target of its own.
  if (format.empty() && looks_like_picture(bytes)) return;
  const auto file = read_sample_bytes(bytes, name, format);
  require_little_memory(bytes.size());
  if (!file) return require_error_with_place(file.error(), bytes);
  for (const std::string& warning : file->warnings) require_message(warning);
  require_round_trip(file->data);
}

}  // namespace mes::fuzz
