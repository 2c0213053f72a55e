// SPDX-License-Identifier: GPL-3.0-or-later
// The writers of app/store/layer_text.h, one function per format.
#pragma once

#include <algorithm>

#include "app/store/layer_text.h"
#include "core/graph/registry.h"

namespace mes {

inline bool emits(const LayerDescriptor& layer, PrimitiveKind kind) {
  return std::ranges::find(layer.kinds, kind) != layer.kinds.end();
}

/// One header line, then one primitive per line; a layer that may emit several kinds has a first column `kind`.
LayerText csv_of(const LayerGeometry& geometry);

/// The points of a layer. For a layer of segments: their distinct ends in order of appearance, with the chains that
/// the segments form as `# loop` lines. The layer of samples is written as the document has them.
LayerText poff_of(const LayerGeometry& geometry);
/// The disks of a layer, or its circles.
LayerText wpoff_of(const LayerGeometry& geometry);
/// The samples of the curve in order, each with its unit normal: one block per chain.
LayerText npoff_of(const LayerGeometry& geometry);

/// RFC 7946. Data of a map in degrees are in degrees again, with the name of their reference system; all others are
/// in coordinates of the document, which RFC 7946 does not provide for. Circles, disks and arcs become polygons and
/// chains with 96 sides per turn and have centre and radius as properties; radii and scalars stay as the document has
/// them.
LayerText geojson_of(const LayerGeometry& geometry);
/// Well-known text, one geometry per line, round shapes as in GeoJSON; `SRID=4326;` precedes each of a map in
/// degrees.
LayerText wkt_of(const LayerGeometry& geometry);

/// The `d` of one path. In SVG y grows downwards, so it is negated.
LayerText svg_path_of(const LayerGeometry& geometry);

}  // namespace mes
