// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/vertex_graph.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/io/curve_samples.h"
#include "core/io/flat_vertices.h"

namespace mes {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// The two segments at a vertex, by their numbers.
using Ends = std::array<std::uint32_t, 2>;

using VertexSlot = Slot<struct VertexTag>;

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

std::uint32_t VertexGraph::vertex_at(Vec2 position) {
  // The two zeros are one place.
  const Vec2 key{position.x + 0.0, position.y + 0.0};
  const auto [found, is_new] = vertex_at_.try_emplace(key, static_cast<std::uint32_t>(positions_.size()));
  if (is_new) positions_.push_back(position);
  return found->second;
}

std::string VertexGraph::leave_heights_out(double rounding) {
  std::string out = bring_into_plane(positions_, heights_, rounding);
  heights_ = {};
  return out;
}

void VertexGraph::add_face(std::span<const std::uint32_t> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t a = corners[i];
    const std::uint32_t b = corners[(i + 1) % corners.size()];
    if (is_on_face_.size() <= a) is_on_face_.resize(positions_.size());
    is_on_face_[a] = true;
    if (a != b) face_edges_.push_back({std::min(a, b), std::max(a, b)});
  }
}

void VertexGraph::add_outlines_of_faces() {
  std::ranges::sort(face_edges_, {}, [](const Segment& s) { return std::tuple(s.from, s.to); });
  for (std::size_t i = 0; i < face_edges_.size();) {
    std::size_t end = i + 1;
    const auto is_same = [&](std::size_t k) {
      return face_edges_[k].from == face_edges_[i].from && face_edges_[k].to == face_edges_[i].to;
    };
    while (end < face_edges_.size() && is_same(end)) ++end;
    if (end == i + 1) segments_.push_back(face_edges_[i]);
    i = end;
  }
  face_edges_ = {};
}

void VertexGraph::drop_repeated_segments() {
  std::erase_if(segments_, [](const Segment& s) { return s.from == s.to; });
  // Of equal ones the first is kept, and the order of the others.
  std::vector<std::uint32_t> order(segments_.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) {
    const Segment& s = segments_[i];
    return std::tuple(std::min(s.from, s.to), std::max(s.from, s.to), i);
  };
  std::ranges::sort(order, {}, key);
  std::vector<bool> is_repeated(segments_.size());
  for (std::size_t k = 1; k < order.size(); ++k) {
    const auto [a, b, i] = key(order[k - 1]);
    const auto [c, d, j] = key(order[k]);
    if (a == c && b == d) is_repeated[j] = true;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i)
    if (!is_repeated[i]) segments_[kept++] = segments_[i];
  segments_.resize(kept);
}

CurveSet VertexGraph::curves(std::vector<std::string>& remarks) && {
  vertex_at_.clear();
  const std::size_t own_segments = segments_.size();
  add_outlines_of_faces();
  const bool has_outlines = segments_.size() > own_segments;
  drop_repeated_segments();

  const auto count = static_cast<std::uint32_t>(positions_.size());
  is_on_face_.resize(count);
  std::vector<std::uint32_t> degree(count, 0);
  std::vector<Ends> ends(count, Ends{kNone, kNone});
  DisjointSets<VertexSlot> parts(count);
  const auto part_of = [&parts](std::uint32_t v) { return parts.root(VertexSlot(v)); };
  for (std::uint32_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    parts.join(part_of(s.from), part_of(s.to));
    for (const std::uint32_t v : {s.from, s.to}) {
      if (degree[v] < 2) ends[v][degree[v]] = i;
      ++degree[v];
    }
  }
  std::vector<bool> is_tangled(count);  // by the root of its part
  std::size_t junctions = 0;
  for (std::uint32_t v = 0; v < count; ++v) {
    if (degree[v] <= 2) continue;
    is_tangled[part_of(v).index()] = true;
    ++junctions;
  }

  CurveSet out;
  std::size_t tangled = 0;
  std::size_t inside = 0;
  std::vector<bool> is_done(count);
  const auto follow = [&](std::uint32_t start) {
    PlaneCurve& curve = out.curves.emplace_back(positions_[start]);
    is_done[start] = true;
    std::uint32_t segment = ends[start][0];
    // In the direction of the file, where both ways are open.
    if (degree[start] == 2 && segments_[segment].from != start) segment = ends[start][1];
    for (std::uint32_t at = start;;) {
      const std::uint32_t next = segments_[segment].from == at ? segments_[segment].to : segments_[segment].from;
      if (next == start) return curve.close();
      curve.line_to(positions_[next]);
      is_done[next] = true;
      if (degree[next] == 1) return;
      segment = ends[next][0] == segment ? ends[next][1] : ends[next][0];
      at = next;
    }
  };
  const auto can_begin = [&](std::uint32_t v) {
    return degree[v] != 0 && !is_done[v] && !is_tangled[part_of(v).index()];
  };
  // Open ones from their ends, in the direction of the file where it has one; what is left then are circles.
  for (std::uint32_t v = 0; v < count; ++v)
    if (degree[v] == 1 && can_begin(v) && segments_[ends[v][0]].from == v) follow(v);
  for (const std::uint32_t wanted : {1U, 2U})
    for (std::uint32_t v = 0; v < count; ++v)
      if (degree[v] == wanted && can_begin(v)) follow(v);
  for (std::uint32_t v = 0; v < count; ++v) {
    if (is_done[v]) continue;
    if (degree[v] == 0 && has_outlines && is_on_face_[v]) {
      ++inside;
      continue;
    }
    if (degree[v] != 0) ++tangled;
    out.points.push_back(positions_[v]);
  }
  if (junctions != 0)
    remarks.push_back(fmt::format(
        "{}, so the {} of these parts have no order along a curve",
        counted(junctions, "vertex has more than two segments", "vertices have more than two segments each"),
        counted(tangled, "vertex", "vertices")));
  if (inside != 0)
    remarks.push_back(fmt::format("{} left out, for the outlines of the faces are read",
                                  counted(inside, "vertex inside faces is", "vertices inside faces are")));
  return out;
}

Expected<LoadedFile> VertexGraph::load(const std::string& name, ReadJob& job) && {
  job.checkpoint();
  std::vector<std::string> remarks;
  CurveSet set = std::move(*this).curves(remarks);
  auto file = load_samples(std::move(set), {.rule = SamplingRule::vertices}, name, job);
  if (file)
    for (std::string& remark : remarks)
      file->warnings.push_back(Error{ErrorCode::bad_input, std::move(remark), name}.message());
  return file;
}

}  // namespace mes
