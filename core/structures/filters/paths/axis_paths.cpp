// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/paths/axis_paths.h"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

#include "core/base/sum.h"

namespace mes {

AxisPaths::AxisPaths(PathGraph graph)
    : graph_(std::move(graph)),
      shape_of_(graph_.nodes(), kNone),
      is_taken_(graph_.edges().size(), 0),
      distance_(graph_.nodes(), kFar),
      arrival_(graph_.nodes()) {
  find_shapes();
}

void AxisPaths::find_shapes() {
  std::vector<std::uint32_t> open;
  for (std::uint32_t edge = 0; edge < graph_.edges().size(); ++edge) {
    if (shape_of_[graph_.edges()[edge].from] == kNone) {
      const auto number = static_cast<std::uint32_t>(shapes_.size());
      shapes_.emplace_back();
      open = {graph_.edges()[edge].from};
      shape_of_[open.front()] = number;
      while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        for (const PathStep step : graph_.away_from(node)) {
          const std::uint32_t other = graph_.head(step);
          if (std::exchange(shape_of_[other], number) == kNone) open.push_back(other);
        }
      }
    }
    shapes_[shape_of_[graph_.edges()[edge].from]].edges.push_back(edge);
  }
  for (std::uint32_t node = 0; node < shape_of_.size(); ++node) {
    if (shape_of_[node] == kNone) continue;
    Shape& shape = shapes_[shape_of_[node]];
    shape.nodes.push_back(node);
    if (is_free_end(node)) shape.ends.push_back(node);
  }
}

void AxisPaths::spread(const Shape& shape, std::span<const std::uint32_t> sources) {
  for (const std::uint32_t node : shape.nodes) distance_[node] = kFar;
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const std::uint32_t source : sources) {
    distance_[source] = 0.0;
    arrival_[source] = {kNone, false};
    open.emplace(0.0, source);
  }
  while (!open.empty()) {
    const auto [distance, node] = open.top();
    open.pop();
    if (distance > distance_[node]) continue;
    for (const PathStep step : graph_.away_from(node)) {
      if (is_taken_[step.edge] != 0) continue;
      const double there = distance + graph_.length(step);
      const std::uint32_t other = graph_.head(step);
      if (there >= distance_[other]) continue;
      distance_[other] = there;
      arrival_[other] = step;
      open.emplace(there, other);
    }
  }
}

std::uint32_t AxisPaths::farthest_end(const Shape& shape) const {
  std::uint32_t out = kNone;
  for (const std::uint32_t end : shape.ends)
    if (distance_[end] < kFar && (out == kNone || distance_[end] > distance_[out])) out = end;
  return out;
}

std::vector<PathStep> AxisPaths::way_to(std::uint32_t node) const {
  std::vector<PathStep> out;
  for (std::uint32_t at = node; arrival_[at].edge != kNone; at = graph_.tail(out.back())) out.push_back(arrival_[at]);
  std::ranges::reverse(out);
  return out;
}

void AxisPaths::measure(AxisPath& path) const {
  Sum length;
  for (const PathStep step : path.steps) length.add(graph_.length(step));
  path.length = length.value();
}

// The longest way in a tree: the end farthest from any node begins it. With cycles, let d be the distance of an end
// from the root: two ends that are each nearer than d are less than 2 d apart, so the search in descending order of
// distance may stop when the longest way so far has length 2 d or more.
AxisPath AxisPaths::longest_way(const Shape& shape, JobControl& job) {
  spread(shape, std::array{shape.ends.front()});
  const std::uint32_t begin = farthest_end(shape);
  spread(shape, std::array{begin});
  AxisPath out{way_to(farthest_end(shape))};
  double longest = distance_[farthest_end(shape)];
  if (shape.edges.size() < shape.nodes.size()) return out;
  std::uint32_t root = begin;
  for (const PathStep step : out.steps)
    if (distance_[graph_.head(step)] <= 0.5 * longest) root = graph_.head(step);
  spread(shape, std::array{root});
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const std::uint32_t end : shape.ends) order.emplace_back(distance_[end], end);
  std::ranges::stable_sort(order, std::greater<>(), &std::pair<double, std::uint32_t>::first);
  for (const auto& [distance, end] : order) {
    if (2.0 * distance <= longest) break;
    job.checkpoint();
    spread(shape, std::array{end});
    const std::uint32_t other = farthest_end(shape);
    if (distance_[other] <= longest) continue;
    longest = distance_[other];
    out.steps = way_to(other);
  }
  return out;
}

AxisPath AxisPaths::closed_line(const Shape& shape) {
  std::vector<std::uint32_t> order = shape.edges;
  std::ranges::stable_sort(order, std::greater<>(), [&](std::uint32_t edge) { return graph_.edges()[edge].length; });
  for (const std::uint32_t edge : order) {
    is_taken_[edge] = 1;
    spread(shape, std::array{graph_.edges()[edge].to});
    is_taken_[edge] = 0;
    if (!(distance_[graph_.edges()[edge].from] < kFar)) continue;
    AxisPath out{.steps = {{edge, false}}, .is_closed = true};
    const std::vector<PathStep> back = way_to(graph_.edges()[edge].from);
    out.steps.insert(out.steps.end(), back.begin(), back.end());
    return out;
  }
  return {};
}

/// The line through an edge between two nodes that the last `spread` reached: from a source to it, and on to a source
/// or to the first node of the way there.
AxisPath AxisPaths::through(std::uint32_t edge) const {
  std::vector<PathStep> there = way_to(graph_.edges()[edge].from);
  std::vector<PathStep> back = way_to(graph_.edges()[edge].to);
  std::size_t common = 0;
  while (common < there.size() && common < back.size() && there[common] == back[common]) ++common;
  AxisPath out{std::move(there)};
  out.steps.push_back({edge, false});
  for (std::size_t i = back.size(); i-- > common;) out.steps.push_back(back[i].reversed());
  measure(out);
  return out;
}

AxisPath AxisPaths::next_line(const Shape& shape, std::span<const std::uint32_t> sources) {
  spread(shape, sources);
  AxisPath out;
  if (const std::uint32_t end = farthest_end(shape); end != kNone && distance_[end] > 0.0) {
    out.steps = way_to(end);
    measure(out);
  }
  for (const std::uint32_t edge : shape.edges) {
    const PathEdge row = graph_.edges()[edge];
    if (is_taken_[edge] != 0 || arrival_[row.from].edge == edge || arrival_[row.to].edge == edge) continue;
    if (!(distance_[row.from] < kFar) || distance_[row.from] + row.length + distance_[row.to] <= out.length) continue;
    if (AxisPath other = through(edge); other.length > out.length) out = std::move(other);
  }
  return out;
}

AxisPath AxisPaths::first_line(const Shape& shape, JobControl& job) {
  if (shape.ends.size() >= 2) return longest_way(shape, job);
  return shape.ends.empty() ? closed_line(shape) : next_line(shape, shape.ends);
}

std::vector<AxisPath> AxisPaths::main_lines(std::size_t most, JobControl& job) {
  std::ranges::fill(is_taken_, std::uint8_t{0});
  std::vector<AxisPath> out;
  for (std::uint32_t number = 0; number < shapes_.size(); ++number) {
    const Shape& shape = shapes_[number];
    std::vector<std::uint32_t> sources;
    for (std::size_t i = 0; i < most; ++i) {
      job.checkpoint();
      AxisPath line = i == 0 ? first_line(shape, job) : next_line(shape, sources);
      if (line.steps.empty()) break;
      measure(line);
      line.shape = number;
      for (const PathStep step : line.steps) {
        is_taken_[step.edge] = 1;
        sources.push_back(graph_.tail(step));
        sources.push_back(graph_.head(step));
      }
      std::ranges::sort(sources);
      sources.erase(std::ranges::unique(sources).begin(), sources.end());
      out.push_back(std::move(line));
    }
  }
  return out;
}

std::optional<AxisPath> AxisPaths::between(std::uint32_t a, std::uint32_t b) {
  if (shape_of_[a] != shape_of_[b] || shape_of_[a] == kNone) return std::nullopt;
  std::ranges::fill(is_taken_, std::uint8_t{0});
  spread(shapes_[shape_of_[a]], std::array{a});
  AxisPath out{.steps = way_to(b), .shape = shape_of_[a]};
  measure(out);
  return out;
}

}  // namespace mes
