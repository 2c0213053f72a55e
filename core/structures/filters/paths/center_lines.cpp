// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/paths/center_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "core/base/geometry/box_tree.h"
#include "core/structures/filters/paths/axis_paths.h"
#include "core/structures/filters/paths/branch_pruning.h"

namespace mes {
namespace {

/// The salient branches of a network, those between junctions as one.
class BranchGraph {
 public:
  BranchGraph(const AxisNetwork& network, double least_salience) : network_(network) {
    std::vector<double> radii;
    for (const AxisNetwork::Node& node : network.nodes()) radii.push_back(node.radius);
    const PathGraph whole(network.nodes().size(), {network.branches().begin(), network.branches().end()});
    MergedBranches merged = merge_branches(whole, salient_branches(whole, radii, least_salience));
    chains_ = std::move(merged.chains);
    edges_ = std::move(merged.edges);
    shapes_ = network.points() + AxisPaths(whole).shape_count();
  }

  AxisPaths paths() const { return AxisPaths(PathGraph(network_.nodes().size(), edges_)); }
  /// Shapes of all branches, and isolated points.
  std::size_t shapes() const { return shapes_; }

  /// Where samples lie on a circle, rounding scatters the centres of their balls.
  bool is_rounding(const AxisPath& path, const AxisPaths& paths) const {
    constexpr double kRounding = 0x1p-20;  // of the radius
    return path.length <= kRounding * network_.nodes()[paths.graph().tail(path.steps.front())].radius;
  }

  std::optional<std::uint32_t> end_near(const AxisPaths& paths, Vec2 at) const {
    std::optional<std::uint32_t> out;
    for (std::uint32_t node = 0; node < network_.nodes().size(); ++node)
      if (paths.is_free_end(node) && (!out || distance(place(node), at) < distance(place(*out), at))) out = node;
    return out;
  }

  CenterLine line_of(const AxisPath& path, const AxisPaths& paths) const {
    CenterLine out;
    out.is_closed = path.is_closed;
    const std::uint32_t from = paths.graph().tail(path.steps.front());
    out.is_free = {paths.is_free_end(from), paths.is_free_end(paths.graph().head(path.steps.back()))};
    out.axis.push_back(place(from));
    out.joints.push_back(0);
    for (const PathStep step : path.steps) {
      const std::vector<PathStep>& chain = chains_[step.edge];
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const PathStep part = step.is_backwards ? chain[chain.size() - 1 - i].reversed() : chain[i];
        network_.append(part.edge, part.is_backwards, out);
      }
      // Lines meet at the same doubles. A step that is shorter than doubles can tell has no point of its own.
      if (out.axis.size() > 1) out.axis.back() = place(paths.graph().head(step));
      if (out.joints.empty() || out.joints.back() + 1 < out.axis.size()) out.joints.push_back(out.axis.size() - 1);
    }
    return out;
  }

 private:
  Vec2 place(std::uint32_t node) const { return network_.nodes()[node].place; }

  const AxisNetwork& network_;
  std::vector<PathEdge> edges_;
  std::vector<std::vector<PathStep>> chains_;
  std::size_t shapes_ = 0;
};

void turn_round(CenterLine& line) {
  std::ranges::reverse(line.axis);
  std::ranges::reverse(line.banks);
  for (auto& banks : line.banks) std::swap(banks[0], banks[1]);
  std::ranges::reverse(line.joints);
  for (std::size_t& joint : line.joints) joint = line.axis.size() - 1 - joint;
  std::swap(line.is_free[0], line.is_free[1]);
}

/// The distance at which a ray first meets a wall; more than `most` if it meets none so near. A ray through a sample meets one of the
/// two walls there, since both see the sample on the same side.
double way_to_wall(const BoxTree<Wall>& walls, Vec2 from, Vec2 direction, double most) {
  double out = std::nextafter(most, std::numeric_limits<double>::infinity());
  const auto may_meet = [&](const Box2& box, double /*reach*/) {
    double low = 0.0;
    double high = out;
    for (const auto& [at, way, first, last] : {std::array{from.x, direction.x, box.low.x, box.high.x},
                                               std::array{from.y, direction.y, box.low.y, box.high.y}}) {
      if (way == 0.0) {
        if (at < first || at > last) return false;
        continue;
      }
      const double one = (first - at) / way;
      const double other = (last - at) / way;
      low = std::max(low, std::min(one, other));
      high = std::min(high, std::max(one, other));
    }
    const double margin = 1e-9 * (std::abs(low) + length(from) + length(box.high - box.low));
    return low <= high + margin;
  };
  walls.visit_where(may_meet, [&](const Wall& wall) {
    const double a = cross(direction, wall.a - from);
    const double b = cross(direction, wall.b - from);
    if ((a < 0.0) == (b < 0.0)) return;
    const double share = a / (a - b);
    const double way = dot((1.0 - share) * (wall.a - from) + share * (wall.b - from), direction);
    if (way >= 0.0) out = std::min(out, way);
  });
  return out;
}

/// Direction of the line at its end, from one radius before it.
Vec2 direction_at_end(std::span<const CenterLine::Point> points, double radius, bool is_first) {
  const std::size_t n = points.size();
  const auto at = [&](std::size_t i) { return points[is_first ? i : n - 1 - i].place; };
  const Vec2 end = at(0);
  Vec2 from = end;
  double left = radius;
  for (std::size_t i = 1; i < n && left > 0.0; ++i) {
    const double piece = distance(at(i - 1), at(i));
    from = at(i - 1) + (piece > left ? left / piece : 1.0) * (at(i) - at(i - 1));
    left -= piece;
  }
  const double size = distance(from, end);
  return size > 0.0 ? (1.0 / size) * (end - from) : Vec2{};
}

}  // namespace

CenterLines center_lines_of(const AxisNetwork& network, const CenterLineRequest& request, JobControl& job) {
  const BranchGraph graph(network, request.least_salience);
  AxisPaths paths = graph.paths();
  CenterLines out;
  out.points = graph.shapes() - paths.shape_count();
  std::vector<AxisPath> found;
  for (const auto& [first, last] : request.between) {
    job.checkpoint();
    const auto from = graph.end_near(paths, first);
    const auto to = graph.end_near(paths, last);
    auto path = from && to && *from != *to ? paths.between(*from, *to) : std::nullopt;
    if (path)
      found.push_back(std::move(*path));
    else
      ++out.unjoined;
  }
  if (request.between.empty()) {
    found = paths.main_lines(request.most, job);
    std::vector<bool> has_line(paths.shape_count(), false);
    std::erase_if(found, [&](const AxisPath& path) { return graph.is_rounding(path, paths); });
    for (const AxisPath& path : found) has_line[path.shape] = true;
    out.points = graph.shapes() - static_cast<std::size_t>(std::ranges::count(has_line, true));
  }

  // Shapes by the length of their first line.
  std::vector<double> lengths(paths.shape_count(), 0.0);
  for (const AxisPath& path : found)
    if (lengths[path.shape] == 0.0) lengths[path.shape] = path.length;
  std::ranges::stable_sort(found, [&](const AxisPath& a, const AxisPath& b) {
    return a.shape != b.shape &&
           (lengths[a.shape] != lengths[b.shape] ? lengths[a.shape] > lengths[b.shape] : a.shape < b.shape);
  });
  std::size_t shape = 0;
  std::size_t rank = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool is_same = i != 0 && found[i].shape == found[i - 1].shape;
    rank = is_same ? rank + 1 : 0;
    if (i != 0 && !is_same) ++shape;
    CenterLine line = graph.line_of(found[i], paths);
    if (line.banks.empty()) continue;  // shorter than doubles can tell
    if (line.is_free == std::array{true, true} && request.between.empty() &&
        lexicographically_less(line.axis.back(), line.axis.front()))
      turn_round(line);
    line.shape = shape;
    line.rank = rank;
    take_axis(line);
    out.lines.push_back(std::move(line));
  }
  return out;
}

void smooth(CenterLines& set, const SmoothingTolerance& tolerance) {
  if (!(tolerance.length > 0.0) && !(tolerance.share > 0.0)) return;
  struct Joint {
    std::size_t line = 0;
    double along = 0.0;
  };
  std::map<std::pair<double, double>, Joint> joints;
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    CenterLine& line = set.lines[i];
    const auto key = [&](std::size_t point) { return std::pair(line.axis[point].x, line.axis[point].y); };
    std::array<std::optional<Vec2>, 2> ends;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      if (line.is_closed || line.is_free[end]) continue;
      const auto joint = joints.find(key(end == 0 ? 0 : line.axis.size() - 1));
      if (joint != joints.end()) ends[end] = join_at(set.lines[joint->second.line], joint->second.along);
    }
    smooth(line, tolerance, ends);
    for (const std::size_t joint : line.joints) {
      const auto [at, is_new] = joints.try_emplace(key(joint), Joint{i, along_of(line, joint)});
      // The line meets itself at its end.
      const bool is_last = joint + 1 == line.axis.size();
      if (!is_new && at->second.line == i && is_last && !line.is_closed)
        line.points.back().place = join_at(line, at->second.along);
    }
  }
}

void extend(CenterLines& set, std::span<const Wall> walls, double most) {
  BoxTree<Wall> tree;
  tree.build(
      walls,
      [](const Wall& wall) {
        TreeBounds out;
        out.box.add(wall.a);
        out.box.add(wall.b);
        return out;
      },
      [](const Wall&, std::uint32_t) {});
  for (CenterLine& line : set.lines) {
    const auto end_of = [&](bool is_first) -> std::optional<CenterLine::Point> {
      const CenterLine::Point& end = is_first ? line.points.front() : line.points.back();
      const double radius = radius_at((is_first ? line.banks.front() : line.banks.back())[0], end.place);
      const Vec2 direction = direction_at_end(line.points, radius, is_first);
      const double way = direction == Vec2{} ? 0.0 : way_to_wall(tree, end.place, direction, most * radius);
      if (!(way > 0.0) || way > most * radius) return std::nullopt;
      return CenterLine::Point{end.place + way * direction, end.along};
    };
    if (line.is_closed) continue;
    const auto first = line.is_free[0] ? end_of(true) : std::nullopt;
    const auto last = line.is_free[1] ? end_of(false) : std::nullopt;
    if (first) line.points.insert(line.points.begin(), *first);
    if (last) line.points.push_back(*last);
  }
}

}  // namespace mes
