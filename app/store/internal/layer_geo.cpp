// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/store/internal/layer_writers.h"
#include "app/store/internal/shapes_on_earth.h"
#include "app/store/internal/straight_shapes.h"
#include "core/io/text/text_numbers.h"

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

// A scalar may be infinite, for which JSON has no number.
void append_json_number(std::string& out, double x) {
  if (std::isfinite(x))
    append_number(out, x);
  else
    out += "null";
}

/// The written parts of a shape; in the plane it is one part with its corners.
using Parts = std::vector<std::vector<Vec2>>;

/// Calls `use` for each shape, in degrees if the plane is that of a map. Shapes not on the Earth are left out.
template <class Use>
void for_each_shape(const LayerGeometry& geometry, LayerText& out, Use use) {
  const std::optional<MapPlane>& map = geometry.document.map();
  for (const LayerIndex layer : geometry.layers) {
    for (const StraightShape& shape : straight_shapes_of(geometry, layer, out.left_out)) {
      const Parts parts = map ? parts_on_earth(shape, *map) : Parts{shape.corners};
      if (parts.empty())
        ++out.off_earth;
      else
        use(layer, shape, parts);
    }
  }
}

void append_geometry(std::string& out, StraightKind kind, const Parts& parts) {
  out += parts.size() == 1 ? R"({"type":")" : R"({"type":"Multi)";
  switch (kind) {
    case StraightKind::point: out += R"(Point","coordinates":)"; break;
    case StraightKind::chain: out += R"(LineString","coordinates":)"; break;
    case StraightKind::polygon: out += R"(Polygon","coordinates":)"; break;
  }
  if (parts.size() > 1) out += '[';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0) out += ',';
    out += kind == StraightKind::point ? "" : kind == StraightKind::chain ? "[" : "[[";
    append_list(out, parts[i], "[", ",", "]");
    out += kind == StraightKind::point ? "" : kind == StraightKind::chain ? "]" : "]]";
  }
  if (parts.size() > 1) out += ']';
  out += '}';
}

void append_feature(std::string& out, std::string_view layer, const StraightShape& shape, const Parts& parts,
                    const std::optional<MapPlane>& map) {
  out += R"({"type":"Feature","properties":{"layer":")";
  out += layer;
  out += R"(","kind":")";
  out += name_of(shape.of);
  out += '"';
  if (shape.circle) {
    const Vec2 center = map ? map->degrees_of(shape.circle->center) : shape.circle->center;
    out += R"(,"center":[)";
    append_number(out, center.x);
    out += ',';
    append_number(out, center.y);
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
  out += R"(},"geometry":)";
  append_geometry(out, shape.kind, parts);
  out += '}';
}

void append_wkt(std::string& out, StraightKind kind, const Parts& parts, bool is_in_degrees) {
  if (is_in_degrees) out += "SRID=4326;";
  if (parts.size() > 1) out += "MULTI";
  switch (kind) {
    case StraightKind::point: out += "POINT "; break;
    case StraightKind::chain: out += "LINESTRING "; break;
    case StraightKind::polygon: out += "POLYGON "; break;
  }
  if (parts.size() > 1) out += '(';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0) out += ", ";
    out += kind == StraightKind::polygon ? "((" : "(";
    append_list(out, parts[i], "", " ", "");
    out += kind == StraightKind::polygon ? "))" : ")";
  }
  out += parts.size() > 1 ? ")\n" : "\n";
}

}  // namespace

LayerText geojson_of(const LayerGeometry& geometry) {
  const std::optional<MapPlane>& map = geometry.document.map();
  LayerText out{R"({"type":"FeatureCollection",)"};
  // Readers that follow RFC 7946 ignore the member; without it this program reads features as lying in the plane.
  if (map) out.text += R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},)";
  out.text += R"("features":[)";
  bool is_first = true;
  for_each_shape(geometry, out, [&](LayerIndex layer, const StraightShape& shape, const Parts& parts) {
    out.text += is_first ? "\n" : ",\n";
    is_first = false;
    append_feature(out.text, geometry.registry.layers()[layer].id, shape, parts, map);
  });
  out.text += "\n]}\n";
  return out;
}

LayerText wkt_of(const LayerGeometry& geometry) {
  LayerText out;
  for_each_shape(geometry, out, [&](LayerIndex, const StraightShape& shape, const Parts& parts) {
    append_wkt(out.text, shape.kind, parts, geometry.document.map().has_value());
  });
  return out;
}

}  // namespace mes
