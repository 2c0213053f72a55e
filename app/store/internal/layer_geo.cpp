// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <span>
#include <string_view>

#include "app/store/internal/layer_writers.h"
#include "app/store/internal/straight_shapes.h"
#include "core/io/text_numbers.h"

namespace mes {
namespace {

void append_list(std::string& out, std::span<const Vec2> corners, std::string_view open, std::string_view between,
                 std::string_view close) {
  bool is_first = true;
  for (const Vec2 p : corners) {
    if (!is_first) out += ',';
    is_first = false;
    out += open;
    append_number(out, p.x);
    out += between;
    append_number(out, p.y);
    out += close;
  }
}

// A scalar may be infinite, which JSON cannot say.
void append_json_number(std::string& out, double x) {
  if (std::isfinite(x))
    append_number(out, x);
  else
    out += "null";
}

void append_feature(std::string& out, std::string_view layer, const StraightShape& shape) {
  out += R"({"type":"Feature","properties":{"layer":")";
  out += layer;
  out += R"(","kind":")";
  out += name_of(shape.of);
  out += '"';
  if (shape.circle) {
    out += R"(,"center":[)";
    append_number(out, shape.circle->center.x);
    out += ',';
    append_number(out, shape.circle->center.y);
    out += R"(],"radius":)";
    append_number(out, shape.circle->radius);
  }
  if (shape.scalar) {
    out += R"(,"scalar":)";
    append_json_number(out, *shape.scalar);
  }
  if (!shape.scalars.empty()) {
    out += R"(,"scalars":)";
    for (std::size_t i = 0; i < shape.scalars.size(); ++i) {
      out += i == 0 ? '[' : ',';
      append_json_number(out, shape.scalars[i]);
    }
    out += ']';
  }
  out += R"(},"geometry":{"type":")";
  switch (shape.kind) {
    case StraightKind::point:
      out += R"(Point","coordinates":)";
      append_list(out, shape.corners, "[", ",", "]");
      break;
    case StraightKind::chain:
      out += R"(LineString","coordinates":[)";
      append_list(out, shape.corners, "[", ",", "]");
      out += ']';
      break;
    case StraightKind::polygon:
      out += R"(Polygon","coordinates":[[)";
      append_list(out, shape.corners, "[", ",", "]");
      out += "]]";
      break;
  }
  out += "}}";
}

void append_wkt(std::string& out, const StraightShape& shape) {
  switch (shape.kind) {
    case StraightKind::point: out += "POINT ("; break;
    case StraightKind::chain: out += "LINESTRING ("; break;
    case StraightKind::polygon: out += "POLYGON (("; break;
  }
  append_list(out, shape.corners, "", " ", "");
  out += shape.kind == StraightKind::polygon ? "))\n" : ")\n";
}

}  // namespace

LayerText geojson_of(const LayerGeometry& geometry) {
  LayerText out{R"({"type":"FeatureCollection","features":[)"};
  bool is_first = true;
  for (const LayerIndex layer : geometry.layers) {
    for (const StraightShape& shape : straight_shapes_of(geometry.mirror, layer, out.left_out)) {
      out.text += is_first ? "\n" : ",\n";
      is_first = false;
      append_feature(out.text, layer_descriptors()[layer].id, shape);
    }
  }
  out.text += "\n]}\n";
  return out;
}

LayerText wkt_of(const LayerGeometry& geometry) {
  LayerText out;
  for (const LayerIndex layer : geometry.layers)
    for (const StraightShape& shape : straight_shapes_of(geometry.mirror, layer, out.left_out))
      append_wkt(out.text, shape);
  return out;
}

}  // namespace mes
