// SPDX-License-Identifier: GPL-3.0-or-later
// Segments in the format of the CGAL demos: the number of segments, then a line "x1 y1 x2 y2" for each. Ends at equal
// positions become one vertex.
#include <fmt/core.h>

#include "core/io/format_spec.h"
#include "core/io/meshes/vertex_graph.h"
#include "core/io/text/line_words.h"

namespace mes {
namespace {

constexpr std::size_t kNumbers = 4;

Match match_edg(std::string_view bytes) {
  static const std::string kNoName;
  constexpr std::size_t kLookedAt = std::size_t{1} << 12U;
  LineWords lines(bytes.substr(0, kLookedAt), kNoName);
  if (!lines.next() || lines.count() != 1 || !parse_count(lines.word(0))) return Match::no;
  if (!lines.next() || lines.count() != kNumbers) return Match::no;
  for (const std::string_view word : lines.words())
    if (!parse_number(word)) return Match::no;
  // Other tables may begin with a number of rows as well.
  return Match::maybe;
}

Expected<LoadedFile> read_edg(std::string_view bytes, const std::string& name, ReadJob& job) {
  LineWords lines(bytes, name, &job);
  lines.next();
  const auto count = lines.whole(0, "the number of segments");
  if (!count) return std::unexpected(count.error());
  VertexGraph graph;
  for (std::uint64_t i = 0; i < *count; ++i) {
    if (!lines.next()) return lines.refuse(0, fmt::format("the file ends after {} of {} segments", i, *count));
    const auto from = lines.position(0);
    if (!from) return std::unexpected(from.error());
    const auto to = lines.position(2);
    if (!to) return std::unexpected(to.error());
    const std::uint32_t first = graph.vertex_at(*from);
    graph.add_segment(first, graph.vertex_at(*to));
  }
  std::vector<std::string> remarks;
  if (lines.next())
    remarks.push_back(lines.remark(0, fmt::format("everything after the {} announced segments is ignored", *count)));
  auto file = std::move(graph).load(name, job);
  if (file) file->warnings.insert(file->warnings.end(), remarks.begin(), remarks.end());
  return file;
}

}  // namespace

Format edg_format() {
  return {.descriptor = {.id = "edg", .name = "Segments of CGAL", .extensions = {".edg"}, .can_read = true},
          .match = match_edg,
          .read = read_edg};
}

}  // namespace mes
