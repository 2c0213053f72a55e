// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzz target is one function of some bytes.
//
// A target takes any bytes, does the same each time, and ends the process when a promise is broken.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace mes::fuzz {

void run_bnd(std::string_view bytes);
void run_bundle(std::string_view bytes);
void run_carried_session(std::string_view bytes);
void run_color_map(std::string_view bytes);
void run_contours(std::string_view bytes);
void run_coordinate_system(std::string_view bytes);
void run_dxf(std::string_view bytes);
void run_edits(std::string_view bytes);
void run_formula(std::string_view bytes);
void run_geojson(std::string_view bytes);
void run_geometry(std::string_view bytes);
void run_gpx(std::string_view bytes);
void run_ipe(std::string_view bytes);
void run_kml(std::string_view bytes);
void run_mesh(std::string_view bytes);
void run_picture(std::string_view bytes);
void run_poff(std::string_view bytes);
void run_session(std::string_view bytes);
void run_shapefile(std::string_view bytes);
void run_svg(std::string_view bytes);
void run_table(std::string_view bytes);
void run_wkb(std::string_view bytes);
void run_wkt(std::string_view bytes);
void run_wpoff(std::string_view bytes);

struct Target {
  std::string_view name;  ///< its folder in corpus/ has the same
  void (*run)(std::string_view bytes);
};
inline constexpr std::array<Target, 24> kTargets{{
    {"bnd", run_bnd},
    {"bundle", run_bundle},
    {"carried_session", run_carried_session},
    {"color_map", run_color_map},
    {"contours", run_contours},
    {"coordinate_system", run_coordinate_system},
    {"dxf", run_dxf},
    {"edits", run_edits},
    {"formula", run_formula},
    {"geojson", run_geojson},
    {"geometry", run_geometry},
    {"gpx", run_gpx},
    {"ipe", run_ipe},
    {"kml", run_kml},
    {"mesh", run_mesh},
    {"picture", run_picture},
    {"poff", run_poff},
    {"session", run_session},
    {"shapefile", run_shapefile},
    {"svg", run_svg},
    {"table", run_table},
    {"wkb", run_wkb},
    {"wkt", run_wkt},
    {"wpoff", run_wpoff},
}};

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "broken promise: %s\n", what.c_str());
  std::abort();
}

/// A promise; ends the process when it is broken.
inline void require(bool is_kept, const std::string& promise) {
  if (!is_kept) fail(promise);
}

}  // namespace mes::fuzz
