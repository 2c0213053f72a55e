// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/file_conflict.h"

#include <algorithm>
#include <system_error>

#include "core/io/format.h"

namespace mes {
namespace {

/// Counts the edits among the entries before `end`.
std::size_t edits_in(const TimelineLog& entries, std::size_t end) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < end; ++i) out += changes_document(entries[i]) ? 1U : 0U;
  return out;
}

bool are_equal(const SampleData& a, const SampleData& b) {
  return a.positions == b.positions && a.contours == b.contours && a.balls == b.balls &&
         a.annotations == b.annotations && (a.source == b.source || (a.source && b.source && *a.source == *b.source));
}

std::optional<std::size_t> shared_edits(const Session& mine, const Session& theirs) {
  if (!are_equal(*mine.data, *theirs.data)) return std::nullopt;
  std::size_t end = 0;
  while (end < mine.entries.size() && end < theirs.entries.size() && mine.entries[end] == theirs.entries[end]) ++end;
  return edits_in(mine.entries, end);
}

}  // namespace

FileConflict look_into(const std::filesystem::path& file, const Document& document, const Session* mine,
                       const NamedList<Format>& formats) {
  FileConflict out{.file = file, .mine = {document.sample_count(), document.ball_count()}};
  if (mine != nullptr) out.mine.edits = edits_in(mine->entries, mine->entries.size());
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    out.problem = "it is not a regular file any more";
    return out;
  }
  auto loaded = read_sample_file(file, {}, nullptr, {.formats = &formats});
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
  const Session& theirs = *loaded->session;
  out.theirs->edits = edits_in(theirs.entries, theirs.entries.size());
  if (mine != nullptr) out.shared_edits = shared_edits(*mine, theirs);
  return out;
}

}  // namespace mes
