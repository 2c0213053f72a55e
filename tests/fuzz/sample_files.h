// SPDX-License-Identifier: GPL-3.0-or-later
// Files of samples and balls: what was read is written and reads back equal.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/commands.h"
#include "core/io/format.h"
#include "core/raster/picture_decoder.h"
#include "tests/fuzz/reader_checks.h"

namespace mes::fuzz {

inline bool are_equal(const SampleData& a, const SampleData& b) {
  return a.positions == b.positions && a.contours == b.contours && a.map == b.map &&
         std::ranges::equal(a.balls, b.balls, [](const Disk& x, const Disk& y) { return x == y; });
}

/// As POFF has them: a point that is named twice in a row, or at both ends of a closed contour, is one corner.
inline std::vector<SampleData::Contour> without_doubled_corners(std::vector<SampleData::Contour> contours) {
  for (SampleData::Contour& contour : contours) {
    auto& points = contour.points;
    points.erase(std::ranges::unique(points).begin(), points.end());
    if (contour.closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  }
  return contours;
}

/// A contour passes some point more than once, which is said.
inline bool has_repeated_corner(const std::vector<SampleData::Contour>& contours) {
  return std::ranges::any_of(contours, [](const SampleData::Contour& contour) {
    std::vector<std::uint32_t> sorted = contour.points;
    std::ranges::sort(sorted);
    return std::ranges::adjacent_find(sorted) != sorted.end();
  });
}

/// The data make a document, and its files give the data back, but for doubled corners.
inline void require_round_trip(SampleData data) {
  Document document;
  const auto delta = replace_all(document, data);
  require(delta.has_value(), "data that were read make a document: " + (delta ? "" : delta.error().text));
  document.apply(*delta);
  const LoadedFile points = require_read(read_sample_bytes(write_poff(document), "again.poff", "poff"));
  data.contours = without_doubled_corners(std::move(data.contours));
  require(points.warnings.size() == (has_repeated_corner(data.contours) ? 1U : 0U),
          "what is written is read without a warning but that of repeated corners");
  const LoadedFile balls = require_read(read_sample_bytes(write_wpoff(document), "again.wpoff", "wpoff"));
  require(are_equal({.positions = points.data.positions,
                     .contours = points.data.contours,
                     .balls = balls.data.balls,
                     .map = points.data.map},
                    data),
          "what is written reads back equal");
}

/// Reads the bytes as the format, or as whatever they look like.
inline void check_sample_file(std::string_view bytes, const std::string& name, std::string_view format,
                              ReadingWork work = kPlainWork, std::size_t memory = kAnyMemory) {
  // A picture has no lines, and its pixels take more memory than its bytes; it has a target of its own.
  if (format.empty() && looks_like_picture(bytes)) return;
  const auto file = read_sample_bytes(bytes, name, format);
  require_little_memory(bytes.size(), 400, memory);
  require_little_work(bytes.size(), work);
  // Bytes that look like WKB have no lines either; the message says at which byte.
  const bool has_lines = file || !format.empty() || !file.error().text.starts_with("at byte ");
  if (!file) return has_lines ? require_error_with_place(file.error(), bytes) : require_error(file.error(), bytes);
  for (const std::string& warning : file->warnings) require_message(warning);
  require_round_trip(file->data);
}

}  // namespace mes::fuzz
