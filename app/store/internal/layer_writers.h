// SPDX-License-Identifier: GPL-3.0-or-later
// The writers of app/store/layer_text.h, one format a function.
#pragma once

#include <algorithm>

#include "app/store/layer_text.h"
#include "core/graph/registry.h"

namespace mes {

inline bool emits(const LayerDescriptor& layer, PrimitiveKind kind) {
  return std::ranges::find(layer.kinds, kind) != layer.kinds.end();
}

/// One header line, then one primitive a line; a layer that may emit several kinds has a first column `kind`.
LayerText csv_of(const LayerGeometry& geometry);

/// The points of a layer; or, for a layer of segments, their distinct ends in order of appearance, with the chains that
/// the segments form as `# loop` lines. The layer of samples is written as the document has them.
LayerText poff_of(const LayerGeometry& geometry);
/// The disks of a layer, or its circles.
LayerText wpoff_of(const LayerGeometry& geometry);
/// The samples of the curve in order, each with its unit normal: a block a chain.
LayerText npoff_of(const LayerGeometry& geometry);

/// RFC 7946. What was a map in degrees is one again, with the name of its reference system; everything else is in coordinates of the
/// document, which RFC 7946 does not know. Circles, disks and arcs are polygons
/// and chains of 96 sides a turn, with centre and radius as properties; radii and scalars stay as the document has them.
LayerText geojson_of(const LayerGeometry& geometry);
/// Well-known text, a geometry a line, round shapes as in GeoJSON; with `SRID=4326;` before each where it is a map in degrees.
LayerText wkt_of(const LayerGeometry& geometry);

/// The `d` of one path; y grows downwards there, so it is negated.
LayerText svg_path_of(const LayerGeometry& geometry);

}  // namespace mes
