// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/layer_text.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>

#include "app/store/texts/internal/layer_writers.h"

namespace mes {
namespace {

bool holds_all(const LayerDescriptor& /*layer*/) {
  return true;
}
bool holds_points(const LayerDescriptor& layer) {
  return emits(layer, PrimitiveKind::point) || emits(layer, PrimitiveKind::segment);
}
bool holds_balls(const LayerDescriptor& layer) {
  return emits(layer, PrimitiveKind::disk) || emits(layer, PrimitiveKind::circle) || layer.data == LayerData::balls;
}
bool holds_areas(const LayerDescriptor& layer) {
  return std::ranges::any_of(layer.kinds, [](PrimitiveKind kind) {
    return kind != PrimitiveKind::point && kind != PrimitiveKind::ray && kind != PrimitiveKind::line;
  });
}
bool holds_curve(const LayerDescriptor& layer) {
  return layer.data == LayerData::curve || layer.data == LayerData::curve_normals;
}

// One line per format.
constexpr std::array<LayerTextFormat, 14> kFormats{{
    {"csv", "csv", "CSV table",
     "one primitive a line, segments without length left out; the second pair of numbers is the other end of a "
     "segment, "
     "but the direction of a ray or a line",
     false, false, "", holds_all, csv_of},
    {"poff", "poff", "POFF points", "points, or the ends of segments with the chains they form", false, false,
     "points", holds_points, poff_of},
    {"wpoff", "wpoff", "WPOFF balls", "disks, or circles", false, false, "disks", holds_balls, wpoff_of},
    {"npoff", "npoff", "NPOFF points with normals",
     "samples of the curve in order with unit normals, a block a chain", false, true, "curve with normals",
     holds_curve, npoff_of},
    {"geojson", "geojson", "GeoJSON", "features with layer, kind and scalar, segments as the chains they form", true,
     false, "", holds_all, geojson_of},
    {"wkt", "wkt", "WKT", "well-known text, a geometry a line", true, false, "", holds_all, wkt_of},
    {"geojson-areas", "geojson", "GeoJSON of areas",
     "polygons with holes: the areas that the lines of a layer enclose", true, false, "lines or areas", holds_areas,
     geojson_areas_of},
    {"wkt-areas", "wkt", "WKT of areas", "polygons with holes as well-known text", true, false, "lines or areas",
     holds_areas, wkt_areas_of},
    {"gpkg", "gpkg", "GeoPackage", "features as in GeoJSON in a GeoPackage, by the library GDAL", true, false, "",
     holds_all, geopackage_of},
    {"gpkg-areas", "gpkg", "GeoPackage of areas", "areas as in GeoJSON of areas, in a GeoPackage", true, false,
     "lines or areas", holds_areas, geopackage_areas_of},
    {"fgb", "fgb", "FlatGeobuf", "features as in GeoJSON in a FlatGeobuf, by the library GDAL", true, false, "",
     holds_all, flatgeobuf_of},
    {"fgb-areas", "fgb", "FlatGeobuf of areas", "areas as in GeoJSON of areas, in a FlatGeobuf", true, false,
     "lines or areas", holds_areas, flatgeobuf_areas_of},
    {"dxf", "dxf", "DXF", "entities of release 12, arcs and circles as such, on a layer with the id of theirs", true,
     false, "", holds_all, dxf_of},
    {"svg-path", "txt", "SVG path", "the d of one path, upright in SVG, on the page of a drawing", true, false, "",
     holds_all, svg_path_of},
}};

}  // namespace

std::span<const LayerTextFormat> layer_text_formats() {
  return kFormats;
}

const LayerTextFormat* find_layer_text_format(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &LayerTextFormat::name);
  return found == kFormats.end() ? nullptr : &*found;
}

Expected<void> check_layers(std::span<const LayerDescriptor> descriptors, const LayerTextFormat& format,
                            std::span<const LayerIndex> layers) {
  const auto refuse = [](std::string text) { return std::unexpected(Error{ErrorCode::usage, std::move(text)}); };
  if (layers.size() > 1 && !format.is_of_many)
    return refuse(fmt::format(
        "a file of format {} holds one layer; geojson, wkt, gpkg, fgb, their areas, dxf and svg-path hold several",
        format.name));
  for (const LayerIndex layer : layers)
    if (!format.holds(descriptors[layer]))
      return refuse(fmt::format("layer {} has no {} to write as {}; csv can hold it", descriptors[layer].id,
                                format.contents, format.name));
  return {};
}

}  // namespace mes
