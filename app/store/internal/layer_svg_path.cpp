// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>
#include <span>

#include "app/store/internal/layer_writers.h"
#include "app/store/internal/segment_chains.h"
#include "core/draw/primitive_values.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

class PathText {
 public:
  explicit PathText(std::string& out) : out_(out) {}

  void move_to(Vec2 p) { place("M", p); }
  void line_to(Vec2 p) { place(" L", p); }
  void close() { out_ += " Z"; }
  void end() { out_ += '\n'; }
  /// Draws a dot, if caps are round.
  void dot(Vec2 p) {
    move_to(p);
    out_ += " h0";
    end();
  }
  /// Draws an arc, counter-clockwise in the plane, which is against the angle of SVG.
  void arc_to(double radius, bool is_large, Vec2 p) {
    out_ += " A";
    number(radius);
    number(radius);
    out_ += is_large ? " 0 1 0" : " 0 0 0";
    place("", p);
  }
  void circle(const Disk& disk) {
    const Vec2 radius{disk.radius, 0.0};
    move_to(disk.center + radius);
    arc_to(disk.radius, false, disk.center - radius);
    arc_to(disk.radius, false, disk.center + radius);
    close();
    end();
  }

 private:
  void number(double x) {
    out_ += ' ';
    append_number(out_, x);
  }
  void place(std::string_view command, Vec2 p) {
    out_ += command;
    number(p.x);
    number(p.y == 0.0 ? 0.0 : -p.y);
  }
  std::string& out_;
};

void append_instance(PathText& path, PrimitiveKind kind, const double* v) {
  switch (kind) {
    case PrimitiveKind::point: path.dot({v[0], v[1]}); return;
    case PrimitiveKind::circle:
    case PrimitiveKind::disk: path.circle({{v[0], v[1]}, v[2]}); return;
    case PrimitiveKind::triangle:
      path.move_to({v[0], v[1]});
      path.line_to({v[2], v[3]});
      path.line_to({v[4], v[5]});
      path.close();
      path.end();
      return;
    case PrimitiveKind::arc: {
      const Arc arc = arc_of(v);
      if (arc.from == arc.to) return path.circle({arc.center, arc.radius});
      path.move_to(arc.from);
      path.arc_to(arc.radius, sweep_of(arc) > std::numbers::pi, arc.to);
      path.end();
      return;
    }
    default: return;
  }
}

void append_chains(PathText& path, std::span<const double> segments) {
  const SegmentChains found = chains_of(segments);
  for (const SegmentChain& chain : found.chains) {
    path.move_to(found.points[chain.points.front()]);
    for (const std::uint32_t point : std::span(chain.points).subspan(1)) path.line_to(found.points[point]);
    if (chain.closed) path.close();
    path.end();
  }
}

}  // namespace

Expected<LayerText> svg_path_of(const LayerGeometry& geometry) {
  LayerText out;
  PathText path(out.text);
  for (const LayerIndex layer : geometry.layers) {
    for (const PrimitiveKind kind : geometry.registry.layers()[layer].kinds) {
      const std::span<const double> instances = geometry.mirror.instances(layer, kind);
      const std::size_t stride = stride_of(kind);
      if (kind == PrimitiveKind::ray || kind == PrimitiveKind::line)
        out.left_out += instances.size() / stride;
      else if (kind == PrimitiveKind::segment)
        append_chains(path, instances);
      else
        for (std::size_t at = 0; at < instances.size(); at += stride)
          append_instance(path, kind, instances.data() + at);
    }
  }
  return out;
}

}  // namespace mes
