// SPDX-License-Identifier: GPL-3.0-or-later
// The list of file formats, in the order in which contents are tried. A new format is a file that defines its function,
// and two lines here.
#include <memory>
#include <utility>

#include "core/io/format_spec.h"

namespace mes {

Format session_file_format();
Format poff_format();
Format wpoff_format();
Format geojson_format();
Format wkt_format();
Format kml_format();
Format gpx_format();
Format svg_format();
Format picture_format();
Format ipe_format();
Format dxf_format();
Format shapefile_format();
Format wkb_format();
Format geometry_table_format();
Format geopackage_format();
Format flatgeobuf_format();
Format ply_format();
Format off_format();
Format obj_format();
Format triangle_format();
Format edg_format();
Format csv_format();
Format tsv_format();
Format xyz_format();
Format pairs_format();

void add_formats(NamedList<Format>& to) {
  const auto add = [&to](Format format) {
    std::string id = format.descriptor.id;
    to.add(std::move(id), std::make_shared<const Format>(std::move(format)));
  };
  add(session_file_format());
  add(poff_format());
  add(wpoff_format());
  add(geojson_format());
  add(wkt_format());
  add(kml_format());
  add(gpx_format());
  add(svg_format());
  add(picture_format());
  add(ipe_format());
  add(dxf_format());
  add(shapefile_format());
  add(wkb_format());
  add(geometry_table_format());
  add(geopackage_format());
  add(flatgeobuf_format());
  add(ply_format());
  add(off_format());
  add(obj_format());
  add(triangle_format());
  add(edg_format());
  add(csv_format());
  add(tsv_format());
  add(xyz_format());
  add(pairs_format());
}

}  // namespace mes
