// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the library PROJ when a map first needs it. Private to core/io/systems.
#pragma once

#include <proj.h>

#include <memory>

#include "core/base/error.h"

namespace mes {

/// The functions of PROJ that this program calls. Linking them would load forty libraries at each start.
struct ProjLibrary {
  decltype(&proj_context_create) context_create = nullptr;
  decltype(&proj_context_destroy) context_destroy = nullptr;
  decltype(&proj_context_set_enable_network) context_set_enable_network = nullptr;
  decltype(&proj_context_get_database_path) context_get_database_path = nullptr;
  decltype(&proj_log_func) log_func = nullptr;
  decltype(&proj_create) create = nullptr;
  decltype(&proj_create_crs_to_crs) create_crs_to_crs = nullptr;
  decltype(&proj_normalize_for_visualization) normalize_for_visualization = nullptr;
  decltype(&proj_destroy) destroy = nullptr;
  decltype(&proj_trans) trans = nullptr;
  decltype(&proj_get_type) get_type = nullptr;
  decltype(&proj_get_name) get_name = nullptr;
  decltype(&proj_get_area_of_use) get_area_of_use = nullptr;
  decltype(&proj_get_id_auth_name) get_id_auth_name = nullptr;
  decltype(&proj_get_id_code) get_id_code = nullptr;
  decltype(&proj_as_wkt) as_wkt = nullptr;
  decltype(&proj_get_source_crs) get_source_crs = nullptr;
  decltype(&proj_crs_get_sub_crs) crs_get_sub_crs = nullptr;
  decltype(&proj_crs_get_coordinate_system) crs_get_coordinate_system = nullptr;
  decltype(&proj_cs_get_axis_info) cs_get_axis_info = nullptr;
  decltype(&proj_get_ellipsoid) get_ellipsoid = nullptr;
  decltype(&proj_ellipsoid_get_parameters) ellipsoid_get_parameters = nullptr;
  decltype(&proj_identify) identify = nullptr;
  decltype(&proj_int_list_destroy) int_list_destroy = nullptr;
  decltype(&proj_list_get_count) list_get_count = nullptr;
  decltype(&proj_list_get) list_get = nullptr;
  decltype(&proj_list_destroy) list_destroy = nullptr;
};

/// Loads the library at the first call. Error: `bad_input`; the library is not there, or lacks a function.
Expected<const ProjLibrary*> proj_library();

/// Objects of PROJ. A context belongs to one thread at a time.
struct ProjDeleter {
  const ProjLibrary* proj = nullptr;
  void operator()(PJ_CONTEXT* context) const { proj->context_destroy(context); }
  void operator()(PJ* object) const { proj->destroy(object); }
};
using ProjContext = std::unique_ptr<PJ_CONTEXT, ProjDeleter>;
using ProjObject = std::unique_ptr<PJ, ProjDeleter>;

/// A context that prints nothing and uses no network.
ProjContext new_context(const ProjLibrary& proj);

}  // namespace mes
