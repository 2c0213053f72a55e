// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/maps/gdal_library.h"

#include <dlfcn.h>

#include <string>
#include <type_traits>

namespace mes {
namespace {

struct LoadedGdal {
  GdalLibrary functions{};
  std::string problem{};  ///< empty: all functions are there
};

/// The newest of the installed versions. Functions of GDAL's C interface keep their arguments from version to version.
void* newest_gdal() {
  constexpr int kOldest = 28;  // GDAL 3.2
  constexpr int kNewest = 60;
  for (int version = kNewest; version >= kOldest; --version) {
    const std::string name = "libgdal.so." + std::to_string(version);
    if (void* const library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) return library;
  }
  return nullptr;
}

LoadedGdal load_gdal() {
  LoadedGdal out;
  void* const library = newest_gdal();
  if (library == nullptr) {
    out.problem = "it is not installed";
    return out;
  }
  const auto find = [&](auto& function, const char* name) {
    void* const found = dlsym(library, name);
    if (found == nullptr) out.problem = std::string("it has no ") + name;
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
  };
  GdalLibrary& gdal = out.functions;
  find(gdal.register_all, "GDALAllRegister");
  find(gdal.open, "GDALOpenEx");
  find(gdal.close, "GDALClose");
  find(gdal.layer_count, "GDALDatasetGetLayerCount");
  find(gdal.layer, "GDALDatasetGetLayer");
  find(gdal.layer_name, "OGR_L_GetName");
  find(gdal.geometry_type, "OGR_L_GetGeomType");
  find(gdal.feature_count, "OGR_L_GetFeatureCount");
  find(gdal.system, "OGR_L_GetSpatialRef");
  find(gdal.is_local, "OSRIsLocal");
  find(gdal.identify, "OSRAutoIdentifyEPSG");
  find(gdal.authority_name, "OSRGetAuthorityName");
  find(gdal.authority_code, "OSRGetAuthorityCode");
  find(gdal.write_wkt, "OSRExportToWkt");
  find(gdal.new_options, "GDALVectorTranslateOptionsNew");
  find(gdal.free_options, "GDALVectorTranslateOptionsFree");
  find(gdal.set_progress, "GDALVectorTranslateOptionsSetProgress");
  find(gdal.translate, "GDALVectorTranslate");
  find(gdal.file_from, "VSIFileFromMemBuffer");
  find(gdal.close_file, "VSIFCloseL");
  find(gdal.bytes_of, "VSIGetMemFileBuffer");
  find(gdal.remove, "VSIUnlink");
  find(gdal.free, "VSIFree");
  find(gdal.push_handler, "CPLPushErrorHandler");
  find(gdal.pop_handler, "CPLPopErrorHandler");
  find(gdal.quiet, "CPLQuietErrorHandler");
  find(gdal.reset_error, "CPLErrorReset");
  find(gdal.last_error, "CPLGetLastErrorMsg");
  find(gdal.set_thread_option, "CPLSetThreadLocalConfigOption");
  if (out.problem.empty()) gdal.register_all();
  return out;
}

}  // namespace

Expected<const GdalLibrary*> gdal_library() {
  static const LoadedGdal loaded = load_gdal();
  if (loaded.problem.empty()) return &loaded.functions;
  return std::unexpected(Error{ErrorCode::bad_input, "this format needs the library GDAL: " + loaded.problem});
}

}  // namespace mes
