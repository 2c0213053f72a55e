// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/systems/proj_library.h"

#include <dlfcn.h>

#include <string>
#include <type_traits>

namespace mes {
namespace {

struct LoadedProj {
  ProjLibrary functions{};
  std::string problem{};  ///< empty: all functions are there
};

LoadedProj load_proj() {
  LoadedProj out;
  // PROJ frees memory of its own when the program ends, so it stays loaded.
  void* const library = dlopen(MESECINA_PROJ_LIBRARY, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) {
    const char* const reason = dlerror();
    out.problem = reason != nullptr ? reason : "no reason is known";
    return out;
  }
  const auto find = [&](auto& function, const char* name) {
    void* const found = dlsym(library, name);
    if (found == nullptr) out.problem = std::string("it has no ") + name;
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
  };
  ProjLibrary& proj = out.functions;
  find(proj.context_create, "proj_context_create");
  find(proj.context_destroy, "proj_context_destroy");
  find(proj.context_set_enable_network, "proj_context_set_enable_network");
  find(proj.context_get_database_path, "proj_context_get_database_path");
  find(proj.log_func, "proj_log_func");
  find(proj.create, "proj_create");
  find(proj.create_crs_to_crs, "proj_create_crs_to_crs");
  find(proj.normalize_for_visualization, "proj_normalize_for_visualization");
  find(proj.destroy, "proj_destroy");
  find(proj.trans, "proj_trans");
  find(proj.get_type, "proj_get_type");
  find(proj.get_name, "proj_get_name");
  find(proj.get_area_of_use, "proj_get_area_of_use");
  find(proj.get_id_auth_name, "proj_get_id_auth_name");
  find(proj.get_id_code, "proj_get_id_code");
  find(proj.as_wkt, "proj_as_wkt");
  find(proj.get_source_crs, "proj_get_source_crs");
  find(proj.crs_get_sub_crs, "proj_crs_get_sub_crs");
  find(proj.crs_get_coordinate_system, "proj_crs_get_coordinate_system");
  find(proj.cs_get_axis_info, "proj_cs_get_axis_info");
  find(proj.get_ellipsoid, "proj_get_ellipsoid");
  find(proj.ellipsoid_get_parameters, "proj_ellipsoid_get_parameters");
  find(proj.identify, "proj_identify");
  find(proj.int_list_destroy, "proj_int_list_destroy");
  find(proj.list_get_count, "proj_list_get_count");
  find(proj.list_get, "proj_list_get");
  find(proj.list_destroy, "proj_list_destroy");
  return out;
}

}  // namespace

Expected<const ProjLibrary*> proj_library() {
  static const LoadedProj loaded = load_proj();
  if (loaded.problem.empty()) return &loaded.functions;
  return std::unexpected(Error{ErrorCode::bad_input, "maps need the library PROJ: " + loaded.problem});
}

ProjContext new_context(const ProjLibrary& proj) {
  ProjContext out(proj.context_create(), ProjDeleter{&proj});
  proj.log_func(out.get(), nullptr, [](void*, int, const char*) {});
  proj.context_set_enable_network(out.get(), 0);
  return out;
}

}  // namespace mes
