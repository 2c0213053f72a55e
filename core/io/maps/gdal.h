// SPDX-License-Identifier: GPL-3.0-or-later
// Maps in the formats of other programs, through the library GDAL, which is loaded if it is installed. All maps pass
// through GeoJSON, so that they are read and written as GeoJSON is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"

namespace mes {

/// The features of a GeoPackage, a FlatGeobuf or a shapefile as GeoJSON: a FeatureCollection for each layer that has
/// geometries, one after another. Attributes are properties, and the row number is the id. Member `crs` names the
/// coordinate system by its code or as WKT; "none" stands for a plane. Curves are replaced by chords; heights are left
/// out. `path` is that of the file, which GDAL reads with the files beside it; null for bytes in memory. Error:
/// `bad_input`, if GDAL is not installed or cannot read the file. Throws `Cancelled`.
///
/// Cost: 0.1 s for the first map of a process; the text has up to ten times the size of the file. Threads: any.
Expected<std::string> geojson_by_gdal(std::string_view bytes, const std::string& name,
                                      const std::filesystem::path* path, JobControl* job);

/// Whether the file begins as those that `geojson_by_gdal` reads.
bool is_for_gdal(std::string_view bytes);

/// The coordinate system of a file that GDAL writes.
struct GdalSystem {
  std::string name{};       ///< an authority and its code, or WKT; empty: longitude and latitude on WGS 84
  bool is_of_text = false;  ///< positions of the text are in it; otherwise GDAL converts them from WGS 84
};

/// A file with the features of a GeoJSON text of this program. `driver` is that of GDAL: "GPKG" or "FlatGeobuf". Without
/// `system` the text is of a plane. Properties are columns, whatever their names, and a GeoPackage has its own numbers of
/// rows. Equal texts give equal bytes: the time of writing is not in them. Error: `bad_input`, if GDAL is not installed;
/// `cannot_write`, if it refuses the text.
Expected<std::string> map_by_gdal(std::string_view geojson, const std::string& driver,
                                  const std::optional<GdalSystem>& system);

}  // namespace mes
