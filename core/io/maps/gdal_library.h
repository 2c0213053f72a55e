// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the library GDAL when a map first needs it. Private to core/io/maps.
#pragma once

#include "core/base/error.h"

namespace mes {

/// The functions of GDAL's C interface that this program calls, as its documentation declares them. Its headers come
/// with a gigabyte of other packages, and the library is optional, so that it is not part of the build.
struct GdalLibrary {
  using Dataset = struct GdalDataset*;
  using Layer = struct GdalLayer*;
  using System = struct GdalSystem*;
  using File = struct GdalFile*;
  using Options = struct GdalOptions*;

  void (*register_all)() = nullptr;
  Dataset (*open)(const char* name, unsigned flags, const char* const* drivers, const char* const* options,
                  const char* const* siblings) = nullptr;
  void (*close)(Dataset) = nullptr;
  int (*layer_count)(Dataset) = nullptr;
  Layer (*layer)(Dataset, int) = nullptr;
  const char* (*layer_name)(Layer) = nullptr;
  int (*geometry_type)(Layer) = nullptr;
  long long (*feature_count)(Layer, int is_forced) = nullptr;
  System (*system)(Layer) = nullptr;
  int (*is_local)(System) = nullptr;
  int (*identify)(System) = nullptr;
  const char* (*authority_name)(System, const char* key) = nullptr;
  const char* (*authority_code)(System, const char* key) = nullptr;
  int (*write_wkt)(System, char** text) = nullptr;
  Options (*new_options)(char** arguments, void* for_binary) = nullptr;
  void (*free_options)(Options) = nullptr;
  void (*set_progress)(Options, int (*progress)(double, const char*, void*), void* data) = nullptr;
  Dataset (*translate)(const char* name, Dataset to, int count, Dataset* from, Options,
                       int* is_usage_error) = nullptr;
  File (*file_from)(const char* name, unsigned char* bytes, unsigned long long size, int takes) = nullptr;
  int (*close_file)(File) = nullptr;
  unsigned char* (*bytes_of)(const char* name, unsigned long long* size, int takes) = nullptr;
  int (*remove)(const char* name) = nullptr;
  void (*free)(void*) = nullptr;
  void (*push_handler)(void (*handler)(int, int, const char*)) = nullptr;
  void (*pop_handler)() = nullptr;
  void (*quiet)(int, int, const char*) = nullptr;  ///< a handler
  void (*reset_error)() = nullptr;
  const char* (*last_error)() = nullptr;
  void (*set_thread_option)(const char* key, const char* value) = nullptr;
};

/// Loads the library at the first call. Error: `bad_input`; the library is not there, or lacks a function.
Expected<const GdalLibrary*> gdal_library();

}  // namespace mes
