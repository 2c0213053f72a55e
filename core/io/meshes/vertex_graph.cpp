// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/meshes/vertex_graph.h"

#include <fmt/core.h>
#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/counted.h"
#include "core/curves/joined_ends.h"
#include "core/io/curve_samples.h"
#include "core/io/meshes/flat_vertices.h"

namespace mes {
namespace {

/// Joins chains to closed curves that meet no vertex twice. An even number of chains must end at each vertex.
std::vector<PlaneCurve> closed_chains(std::vector<PlaneCurve> chains) {
  struct Before {
    bool operator()(Vec2 a, Vec2 b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
  };
  std::map<Vec2, std::vector<std::size_t>, Before> at;
  for (std::size_t i = chains.size(); i-- > 0;)
    for (const Vec2 end : {chains[i].start(), chains[i].end()}) at[end].push_back(i);
  std::vector<bool> is_used(chains.size());
  std::vector<PlaneCurve> out;
  for (std::size_t first = 0; first < chains.size(); ++first) {
    if (is_used[first]) continue;
    std::vector<PlaneCurve> path;
    std::map<Vec2, std::size_t, Before> met{{chains[first].start(), 0}};  // number of chains up to there
    for (Vec2 place = chains[first].start();;) {
      std::vector<std::size_t>& ways = at[place];
      while (!ways.empty() && is_used[ways.back()]) ways.pop_back();
      if (ways.empty()) break;
      const std::size_t way = ways.back();
      is_used[way] = true;
      path.push_back(chains[way].start() == place ? chains[way] : reversed(chains[way]));
      place = path.back().end();
      const auto [found, is_new] = met.try_emplace(place, path.size());
      if (is_new) continue;
      PlaneCurve& ring = out.emplace_back(path[found->second]);
      for (std::size_t i = found->second + 1; i < path.size(); ++i)
        ring.lines_to(std::span(path[i].points()).subspan(1));
      ring.close();
      for (std::size_t i = found->second; i + 1 < path.size(); ++i) met.erase(path[i].end());
      path.resize(found->second, PlaneCurve({}));
    }
  }
  return out;
}

}  // namespace

std::uint32_t VertexGraph::vertex_at(Vec2 position) {
  // Merges positive and negative zero.
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
  // Keeps the first of equal segments, and the order of the rest.
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
  // For each vertex, its segments in file order.
  std::vector<std::uint32_t> begin(count + std::size_t{1}, 0);
  for (const Segment& s : segments_)
    for (const std::uint32_t v : {s.from, s.to}) ++begin[v + std::size_t{1}];
  for (std::size_t v = 0; v < count; ++v) begin[v + 1] += begin[v];
  std::vector<std::uint32_t> at(2 * segments_.size());
  {
    std::vector<std::uint32_t> filled(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < segments_.size(); ++i)
      for (const std::uint32_t v : {segments_[i].from, segments_[i].to}) at[filled[v]++] = i;
  }
  const auto degree = [&](std::uint32_t v) { return begin[v + std::size_t{1}] - begin[v]; };
  std::size_t junctions = 0;
  for (std::uint32_t v = 0; v < count; ++v) junctions += degree(v) > 2 ? 1U : 0U;

  CurveSet out;
  std::size_t inside = 0;
  std::vector<bool> is_done(segments_.size());
  // Follows segments to the next vertex that does not have degree 2, or around to the start.
  const auto follow = [&](std::uint32_t start, std::uint32_t segment) {
    PlaneCurve& curve = out.curves.emplace_back(positions_[start]);
    for (std::uint32_t v = start;;) {
      is_done[segment] = true;
      v = segments_[segment].from == v ? segments_[segment].to : segments_[segment].from;
      if (v == start && degree(v) == 2) return curve.close();
      curve.line_to(positions_[v]);
      if (degree(v) != 2) return;
      segment = at[begin[v]] == segment ? at[begin[v] + 1] : at[begin[v]];
    }
  };
  // First open curves from their ends, in the direction of the file if there is one; the remaining ones are circles.
  const auto follow_all = [&](auto can_begin, bool along_file) {
    for (std::uint32_t v = 0; v < count; ++v) {
      if (!can_begin(v)) continue;
      for (std::uint32_t k = begin[v]; k < begin[v + std::size_t{1}]; ++k)
        if (!is_done[at[k]] && (!along_file || segments_[at[k]].from == v)) follow(v, at[k]);
    }
  };
  for (const bool along_file : {true, false}) {
    follow_all([&](std::uint32_t v) { return degree(v) == 1; }, along_file);
    follow_all([&](std::uint32_t v) { return degree(v) > 2; }, along_file);
  }
  // Outlines of faces are closed curves. Explicit segments may have any ends.
  if (own_segments == 0) out.curves = closed_chains(std::move(out.curves));
  for (std::uint32_t v = 0; v < count; ++v) {
    if (degree(v) != 2) continue;
    const std::uint32_t first = at[begin[v]];
    const std::uint32_t second = at[begin[v] + 1];
    if (!is_done[first]) follow(v, segments_[first].from == v ? first : second);
  }
  for (std::uint32_t v = 0; v < count; ++v) {
    if (degree(v) != 0) continue;
    if (has_outlines && is_on_face_[v])
      ++inside;
    else
      out.points.push_back(positions_[v]);
  }
  if (junctions != 0)
    remarks.push_back(counted(junctions, "vertex has more than two segments: curves meet there",
                              "vertices have more than two segments each: curves meet there"));
  if (inside != 0)
    remarks.push_back(fmt::format("{} left out, for the outlines of the faces are read",
                                  counted(inside, "vertex inside faces is", "vertices inside faces are")));
  return out;
}

Expected<LoadedFile> VertexGraph::load(const std::string& name, ReadJob& job) && {
  job.checkpoint();
  std::vector<std::string> remarks;
  CurveSet set = std::move(*this).curves(remarks);
  auto file = load_samples(std::move(set), name, job);
  if (file)
    for (std::string& remark : remarks)
      file->warnings.push_back(Error{ErrorCode::bad_input, std::move(remark), name}.message());
  return file;
}

}  // namespace mes
