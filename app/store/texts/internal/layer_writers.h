// SPDX-License-Identifier: GPL-3.0-or-later
// The writers of app/store/texts/layer_text.h, one function per format.
#pragma once

#include <algorithm>
#include <optional>

#include "app/store/texts/layer_text.h"
#include "core/graph/registry.h"
#include "core/io/systems/map_conversion.h"

namespace mes {

inline bool emits(const LayerDescriptor& layer, PrimitiveKind kind) {
  return std::ranges::find(layer.kinds, kind) != layer.kinds.end();
}

/// The conversion of the positions of the document; nothing without a map, where they stay as they are.
Expected<std::optional<MapConversion>> conversion_for(const LayerGeometry& geometry, MapTarget target);

/// One header line, then one primitive per line. Positions of a map are in its coordinate system; radii, directions and
/// angles are those of the plane. A layer that may emit several kinds has a first column `kind`.
Expected<LayerText> csv_of(const LayerGeometry& geometry);

/// The points of a layer. For a layer of segments: their distinct ends in order of appearance, with the chains that
/// the segments form as `# loop` lines. The layer of samples is written as the document has them.
Expected<LayerText> poff_of(const LayerGeometry& geometry);
/// The disks of a layer, or its circles.
Expected<LayerText> wpoff_of(const LayerGeometry& geometry);
/// The samples of the curve in order, each with its unit normal: one block per chain.
Expected<LayerText> npoff_of(const LayerGeometry& geometry);

/// RFC 7946. Data of a map are in longitude and latitude on WGS 84, with the name of this system; all others are in
/// coordinates of the document, which RFC 7946 does not provide for. Circles, disks and arcs become polygons and chains
/// with 96 sides per turn and have centre and radius as properties; radii and scalars stay as the document has them.
Expected<LayerText> geojson_of(const LayerGeometry& geometry);
/// Well-known text, one geometry per line, round shapes as in GeoJSON. Data of a map are in its coordinate system, and
/// its number precedes each geometry (`SRID=25832;`) if it has one.
Expected<LayerText> wkt_of(const LayerGeometry& geometry);

/// The same formats with the areas that lines enclose, by the even-odd rule, as polygons with holes.
Expected<LayerText> geojson_areas_of(const LayerGeometry& geometry);
Expected<LayerText> wkt_areas_of(const LayerGeometry& geometry);

/// The features of GeoJSON and their areas in files by GDAL, in the coordinate system of the map.
Expected<LayerText> geopackage_of(const LayerGeometry& geometry);
Expected<LayerText> geopackage_areas_of(const LayerGeometry& geometry);
Expected<LayerText> flatgeobuf_of(const LayerGeometry& geometry);
Expected<LayerText> flatgeobuf_areas_of(const LayerGeometry& geometry);

/// DXF of release 12: points, polylines, circles and arcs, each on a layer of the file with the id of theirs. Data of a
/// map are in its coordinate system; if it is another one than the plane, round shapes are polylines as in GeoJSON.
Expected<LayerText> dxf_of(const LayerGeometry& geometry);

/// The `d` of one path. In SVG y grows downwards, so it is negated.
Expected<LayerText> svg_path_of(const LayerGeometry& geometry);

}  // namespace mes
