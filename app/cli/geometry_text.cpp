// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/geometry_text.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "app/cli/layer_summary.h"
#include "app/cli/messages.h"
#include "core/base/vec2.h"
#include "core/io/format.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

std::string_view csv_columns(PrimitiveKind kind) {
  constexpr std::array<std::string_view, kPrimitiveKinds> names{
      "x,y", "x,y,r", "x,y,r", "x1,y1,x2,y2", "x,y,dx,dy", "x,y,dx,dy", "x1,y1,x2,y2,x3,y3", "x,y,r,a0,a1"};
  return names[static_cast<std::size_t>(kind)];
}
std::size_t csv_width(PrimitiveKind kind) {
  return kind == PrimitiveKind::arc ? 5 : doubles_per(kind);
}

void append_values(std::string& out, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i != 0) out += ',';
    append_number(out, values[i]);
  }
}

/// One row without scalar; arcs by angle in radians, a0 <= a1.
void append_coordinates(std::string& out, PrimitiveKind kind, std::span<const double> values) {
  if (kind != PrimitiveKind::arc) {
    append_values(out, values);
    return;
  }
  const Arc arc = arc_of(values.data());
  const Vec2 start = arc.from - arc.center;
  const double a0 = std::atan2(start.y, start.x);
  append_values(out, std::array{arc.center.x, arc.center.y, arc.radius, a0, a0 + sweep_of(arc)});
}

/// Points by number of first appearance, and the edges between them.
struct PointGraph {
  std::vector<Vec2> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

PointGraph graph_of(std::span<const double> segments) {
  struct Less {
    bool operator()(Vec2 a, Vec2 b) const { return lexicographically_less(a, b); }
  };
  PointGraph graph;
  std::map<Vec2, std::uint32_t, Less> number;
  const auto number_of = [&](Vec2 p) {
    const auto [found, is_new] = number.try_emplace(p, static_cast<std::uint32_t>(graph.points.size()));
    if (is_new) graph.points.push_back(p);
    return found->second;
  };
  for (std::size_t at = 0; at < segments.size(); at += stride_of(PrimitiveKind::segment)) {
    const double* const v = segments.data() + at;
    const std::uint32_t a = number_of({v[0], v[1]});
    const std::uint32_t b = number_of({v[2], v[3]});
    if (a != b) graph.edges.push_back({a, b});
  }
  return graph;
}

struct Chain {
  bool closed = false;
  std::vector<std::uint32_t> points;
};

/// Maximal chains between points that do not have exactly two edges, then the closed ones that are left.
class ChainFinder {
 public:
  explicit ChainFinder(const PointGraph& graph) : graph_(graph), at_(graph.points.size()), used_(graph.edges.size()) {
    for (std::uint32_t edge = 0; edge < graph.edges.size(); ++edge)
      for (const std::uint32_t point : graph.edges[edge]) at_[point].push_back(edge);
  }

  std::vector<Chain> find() {
    std::vector<Chain> chains;
    for (const bool only_ends : {true, false}) {
      for (std::uint32_t point = 0; point < at_.size(); ++point) {
        if (only_ends && at_[point].size() == 2) continue;
        for (const std::uint32_t edge : at_[point])
          if (!used_[edge]) chains.push_back(follow(point, edge));
      }
    }
    return chains;
  }

 private:
  Chain follow(std::uint32_t start, std::uint32_t edge) {
    Chain chain{false, {start}};
    for (std::uint32_t point = start;;) {
      used_[edge] = true;
      const auto& ends = graph_.edges[edge];
      point = ends[0] == point ? ends[1] : ends[0];
      if (point == start) {
        chain.closed = true;
        return chain;
      }
      chain.points.push_back(point);
      if (at_[point].size() != 2) return chain;
      edge = at_[point][0] == edge ? at_[point][1] : at_[point][0];
      if (used_[edge]) return chain;
    }
  }

  const PointGraph& graph_;
  std::vector<std::vector<std::uint32_t>> at_;
  std::vector<bool> used_;
};

std::string poff_text(std::span<const Vec2> points, std::span<const Chain> chains) {
  std::string out = fmt::format("POFF {} 0 0\n", points.size());
  for (const Vec2 p : points) {
    append_number(out, p.x);
    out += ' ';
    append_number(out, p.y);
    out += '\n';
  }
  for (const Chain& chain : chains) {
    out += chain.closed ? "# loop closed" : "# loop open";
    for (const std::uint32_t point : chain.points) {
      out += ' ';
      out += std::to_string(point);
    }
    out += '\n';
  }
  return out;
}

}  // namespace

std::string csv_of(const LayerMirror& mirror, LayerIndex layer, const LayerDescriptor& descriptor) {
  const bool has_kind = descriptor.kinds.size() > 1;
  const bool has_scalar = !descriptor.scalar.empty();
  std::size_t columns = 0;
  std::string_view header;
  for (const PrimitiveKind kind : descriptor.kinds) {
    if (csv_width(kind) <= columns) continue;
    columns = csv_width(kind);
    header = csv_columns(kind);
  }
  std::string out = (has_kind ? "kind," : "") + std::string(header) + (has_scalar ? ",scalar\n" : "\n");
  for (const PrimitiveKind kind : descriptor.kinds) {
    const std::span<const double> instances = mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    for (std::size_t at = 0; at < instances.size(); at += stride) {
      const std::span<const double> values = instances.subspan(at, stride);
      if (kind == PrimitiveKind::segment && is_zero_length(values.data())) continue;
      if (has_kind) {
        out += name_of(kind);
        out += ',';
      }
      append_coordinates(out, kind, values.first(stride - 1));
      out.append(columns - csv_width(kind), ',');
      if (has_scalar) {
        out += ',';
        append_number(out, values.back());
      }
      out += '\n';
    }
  }
  return out;
}

Expected<std::string> wpoff_of(const LayerMirror& mirror, LayerIndex layer, const LayerDescriptor& descriptor) {
  for (const PrimitiveKind kind : {PrimitiveKind::disk, PrimitiveKind::circle}) {
    if (std::ranges::find(descriptor.kinds, kind) == descriptor.kinds.end()) continue;
    std::vector<Disk> balls;
    const std::span<const double> instances = mirror.instances(layer, kind);
    for (std::size_t at = 0; at < instances.size(); at += stride_of(kind))
      balls.push_back({{instances[at], instances[at + 1]}, instances[at + 2]});
    return write_wpoff(balls);
  }
  return usage_error(fmt::format("layer {} has no disks to write as WPOFF; csv can hold it", descriptor.id));
}

Expected<std::string> poff_of(const LayerMirror& mirror, LayerIndex layer, const LayerDescriptor& descriptor) {
  const auto emits = [&descriptor](PrimitiveKind kind) {
    return std::ranges::find(descriptor.kinds, kind) != descriptor.kinds.end();
  };
  if (emits(PrimitiveKind::point)) {
    std::vector<Vec2> points;
    const std::span<const double> instances = mirror.instances(layer, PrimitiveKind::point);
    for (std::size_t at = 0; at < instances.size(); at += stride_of(PrimitiveKind::point))
      points.push_back({instances[at], instances[at + 1]});
    return poff_text(points, {});
  }
  if (emits(PrimitiveKind::segment)) {
    const PointGraph graph = graph_of(mirror.instances(layer, PrimitiveKind::segment));
    return poff_text(graph.points, ChainFinder(graph).find());
  }
  return usage_error(fmt::format("layer {} has no points to write as POFF; csv can hold it", descriptor.id));
}

}  // namespace mes::cli
