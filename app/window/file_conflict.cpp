// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/file_conflict.h"

#include <algorithm>
#include <span>
#include <system_error>

#include "core/io/format.h"

namespace mes {
namespace {

std::size_t edits_in(std::span<const TimelineEntry> entries) {
  return static_cast<std::size_t>(std::ranges::count_if(entries, changes_document));
}

bool are_equal(const SampleData& a, const SampleData& b) {
  return a.positions == b.positions && a.contours == b.contours && a.balls == b.balls;
}

std::optional<std::size_t> shared_edits(const Session& mine, const Session& theirs) {
  if (!are_equal(*mine.data, *theirs.data)) return std::nullopt;
  const auto end = std::ranges::mismatch(mine.entries, theirs.entries).in1;
  return edits_in({mine.entries.begin(), end});
}

}  // namespace

FileConflict look_into(const std::filesystem::path& file, const Document& document, const Session* mine) {
  FileConflict out{.file = file, .mine = {document.sample_count(), document.ball_count()}};
  if (mine != nullptr) out.mine.edits = edits_in(mine->entries);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    out.problem = "it is not a regular file any more";
    return out;
  }
  auto loaded = read_sample_file(file);
  if (!loaded) {
    out.found = fingerprint_of_file(file);
    out.problem = loaded.error().text;
    return out;
  }
  if (const auto source = std::ranges::find(loaded->sources, file, &SourceFile::path);
      source != loaded->sources.end())
    out.found = source->fingerprint;
  out.theirs = Holdings{loaded->data.positions.size(), loaded->data.balls.size()};
  if (!loaded->session) return out;
  out.theirs->edits = edits_in(loaded->session->entries);
  if (mine != nullptr) out.shared_edits = shared_edits(*mine, *loaded->session);
  return out;
}

}  // namespace mes
