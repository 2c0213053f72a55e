// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "app/store/texts/internal/geo_text.h"
#include "app/store/texts/internal/layer_writers.h"
#include "app/store/texts/internal/shapes_on_earth.h"
#include "app/store/texts/internal/straight_shapes.h"
#include "core/document/document.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

using ShapesOf = std::vector<StraightShape> (*)(const LayerGeometry&, LayerIndex, LayerText&);

std::vector<StraightShape> all_shapes_of(const LayerGeometry& geometry, LayerIndex layer, LayerText& out) {
  return straight_shapes_of(geometry, layer, out.left_out);
}

/// Calls `use` for each converted shape. Shapes not on the Earth are left out.
template <class Use>
void for_each_shape(const LayerGeometry& geometry, const std::optional<MapConversion>& conversion, ShapesOf shapes_of,
                    LayerText& out, Use use) {
  for (const LayerIndex layer : geometry.layers) {
    for (const StraightShape& shape : shapes_of(geometry, layer, out)) {
      const GeoParts parts = geo_parts_of(shape, conversion ? &*conversion : nullptr);
      if (parts.empty())
        ++out.off_earth;
      else
        use(layer, shape, parts);
    }
  }
}

void append_feature(std::string& out, std::string_view layer, const StraightShape& shape, const GeoParts& parts,
                    const std::optional<MapConversion>& conversion) {
  out += R"({"type":"Feature","properties":{"layer":")";
  out += layer;
  out += R"(","kind":")";
  out += name_of(shape.of);
  out += '"';
  if (shape.circle) {
    const Vec2 center = conversion ? conversion->from_plane(shape.circle->center) : shape.circle->center;
    out += R"(,"center":[)";
    append_number(out, center.x);
    out += ',';
    append_number(out, center.y);
    out += R"(],"radius":)";
    append_measure(out, shape.circle->radius);
  }
  if (shape.scalar) {
    out += R"(,"scalar":)";
    append_measure(out, *shape.scalar);
  }
  if (!shape.scalars.empty()) {
    out += R"(,"scalars":)";
    for (std::size_t i = 0; i < shape.scalars.size(); ++i) {
      out += i == 0 ? '[' : ',';
      append_measure(out, shape.scalars[i]);
    }
    out += ']';
  }
  out += R"(},"geometry":)";
  append_geojson(out, shape.kind, parts);
  out += '}';
}

Expected<LayerText> features_of(const LayerGeometry& geometry, ShapesOf shapes_of, MapTarget target) {
  const auto conversion = conversion_for(geometry, target);
  if (!conversion) return std::unexpected(conversion.error());
  LayerText out{begin_of_features(geometry.document.map(), target)};
  bool is_first = true;
  for_each_shape(geometry, *conversion, shapes_of, out,
                 [&](LayerIndex layer, const StraightShape& shape, const GeoParts& parts) {
                   out.text += is_first ? "\n" : ",\n";
                   is_first = false;
                   append_feature(out.text, geometry.registry.layers()[layer].id, shape, parts, *conversion);
                 });
  out.text += kEndOfFeatures;
  return out;
}

Expected<LayerText> well_known_text_of(const LayerGeometry& geometry, ShapesOf shapes_of) {
  const auto conversion = conversion_for(geometry, MapTarget::own_system);
  if (!conversion) return std::unexpected(conversion.error());
  const std::string srid = srid_of(geometry.document.map());
  LayerText out;
  for_each_shape(geometry, *conversion, shapes_of, out,
                 [&](LayerIndex, const StraightShape& shape, const GeoParts& parts) {
                   append_wkt(out.text, shape.kind, parts, srid);
                 });
  return out;
}

}  // namespace

Expected<std::optional<MapConversion>> conversion_for(const LayerGeometry& geometry, MapTarget target) {
  const std::optional<MapPlane>& map = geometry.document.map();
  if (!map || !is_on_earth(*map)) return std::nullopt;
  auto conversion = MapConversion::of(*map, target);
  if (!conversion) return std::unexpected(conversion.error());
  return std::optional<MapConversion>(*std::move(conversion));
}

Expected<LayerText> geojson_of(const LayerGeometry& geometry) {
  return features_of(geometry, all_shapes_of, MapTarget::wgs84);
}
Expected<LayerText> geojson_areas_of(const LayerGeometry& geometry) {
  return features_of(geometry, area_shapes_of, MapTarget::wgs84);
}

Expected<LayerText> by_gdal(const LayerGeometry& geometry, ShapesOf shapes_of, const char* driver) {
  auto features = features_of(geometry, shapes_of, MapTarget::own_system);
  if (!features) return features;
  auto file = map_file_of(features->text, driver, geometry.document.map(), MapTarget::own_system);
  if (!file) return std::unexpected(file.error());
  features->text = *std::move(file);
  return features;
}
Expected<LayerText> geopackage_of(const LayerGeometry& geometry) {
  return by_gdal(geometry, all_shapes_of, kGeoPackage);
}
Expected<LayerText> geopackage_areas_of(const LayerGeometry& geometry) {
  return by_gdal(geometry, area_shapes_of, kGeoPackage);
}
Expected<LayerText> flatgeobuf_of(const LayerGeometry& geometry) {
  return by_gdal(geometry, all_shapes_of, kFlatGeobuf);
}
Expected<LayerText> flatgeobuf_areas_of(const LayerGeometry& geometry) {
  return by_gdal(geometry, area_shapes_of, kFlatGeobuf);
}

Expected<LayerText> wkt_of(const LayerGeometry& geometry) {
  return well_known_text_of(geometry, all_shapes_of);
}
Expected<LayerText> wkt_areas_of(const LayerGeometry& geometry) {
  return well_known_text_of(geometry, area_shapes_of);
}

}  // namespace mes
