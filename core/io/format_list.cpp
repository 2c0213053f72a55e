// SPDX-License-Identifier: GPL-3.0-or-later
// The list of file formats, in the order in which contents are tried. A new one is a file that defines its function, and
// two lines here.
#include "core/io/format_registry.h"

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
Format ply_format();
Format off_format();
Format obj_format();
Format triangle_format();
Format edg_format();
Format csv_format();
Format tsv_format();
Format xyz_format();
Format pairs_format();

std::span<const Format> formats() {
  static const std::vector<Format> list{
      session_file_format(), poff_format(), wpoff_format(),   geojson_format(), wkt_format(),      kml_format(),
      gpx_format(),          svg_format(),  picture_format(), ipe_format(),     dxf_format(),      shapefile_format(),
      wkb_format(),          ply_format(),  off_format(),     obj_format(),     triangle_format(), edg_format(),
      csv_format(),          tsv_format(),  xyz_format(),     pairs_format(),
  };
  return list;
}

}  // namespace mes
