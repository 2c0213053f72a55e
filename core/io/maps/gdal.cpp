// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/maps/gdal.h"

#include <fmt/core.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/lower_case.h"
#include "core/io/format_spec.h"
#include "core/io/maps/gdal_library.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

/// The system of a plane. GDAL 3.6 has a leak where the argument is "none" instead.
constexpr const char* kPlane = R"(LOCAL_CS["Undefined Cartesian SRS"])";

/// Keeps messages of GDAL for `problem`, which would be printed otherwise.
class GdalMessages {
 public:
  explicit GdalMessages(const GdalLibrary& gdal) : gdal_(gdal) {
    gdal_.push_handler(gdal_.quiet);
    gdal_.reset_error();
  }
  ~GdalMessages() { gdal_.pop_handler(); }
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  bool were_any() const { return *gdal_.last_error() != '\0'; }
  std::unexpected<Error> problem(std::string text, const std::string& file,
                                 ErrorCode code = ErrorCode::bad_input) const {
    // Names in the memory of GDAL, and options of its programs, say nothing to a user.
    const std::string reason = one_line(gdal_.last_error());
    const bool is_for_users = !reason.contains("/vsimem/") && !reason.contains("skipfailures");
    if (!reason.empty() && is_for_users) text += ": " + reason;
    return std::unexpected(Error{code, std::move(text), file});
  }

 private:
  static std::string one_line(const char* text) {
    constexpr std::size_t kLongest = 300;
    std::string out(text, strnlen(text, kLongest));
    for (char& c : out)
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    return out;
  }
  const GdalLibrary& gdal_;
};

/// A name in the memory of GDAL; the file of this name is removed at the end.
class GdalMemory {
 public:
  GdalMemory(const GdalLibrary& gdal, std::string_view extension) : gdal_(gdal) {
    static std::atomic<std::uint64_t> count{0};
    name_ = fmt::format("/vsimem/mesecina_{}{}", ++count, extension);
  }
  ~GdalMemory() { gdal_.remove(name_.c_str()); }
  GdalMemory(const GdalMemory&) = delete;
  GdalMemory& operator=(const GdalMemory&) = delete;

  const char* name() const { return name_.c_str(); }
  /// The bytes stay those of the caller. GDAL reads them only, since its files are opened for reading.
  void hold(std::string_view bytes) {
    auto* const begin = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
    if (auto* const file = gdal_.file_from(name(), begin, bytes.size(), 0)) gdal_.close_file(file);
  }
  std::string_view bytes() const {
    unsigned long long size = 0;
    const unsigned char* const begin = gdal_.bytes_of(name(), &size, 0);
    if (begin == nullptr) return {};
    return {reinterpret_cast<const char*>(begin), static_cast<std::size_t>(size)};
  }

 private:
  const GdalLibrary& gdal_;
  std::string name_;
};

struct GdalDeleter {
  const GdalLibrary* gdal = nullptr;
  void operator()(GdalLibrary::Dataset set) const { gdal->close(set); }
  void operator()(GdalLibrary::Options options) const { gdal->free_options(options); }
};
using GdalSet = std::unique_ptr<std::remove_pointer_t<GdalLibrary::Dataset>, GdalDeleter>;
using GdalWish = std::unique_ptr<std::remove_pointer_t<GdalLibrary::Options>, GdalDeleter>;

/// `drivers` read files without references to other places; the list ends with a null. Lists of numbers as attributes
/// are text, which all drivers can write.
GdalSet open_with(const GdalLibrary& gdal, const char* name, std::span<const char* const> drivers) {
  constexpr unsigned kVector = 0x04U | 0x40U;  // and keep messages
  constexpr std::array<const char*, 2> kOptions{"ARRAY_AS_STRING=YES", nullptr};
  return {gdal.open(name, kVector, drivers.data(), kOptions.data(), nullptr), GdalDeleter{&gdal}};
}

/// Whether all of it was written. Throws `Cancelled`.
bool translate(const GdalLibrary& gdal, GdalLibrary::Dataset from, const char* to, std::vector<std::string> arguments,
               JobControl* job) {
  std::vector<char*> list;
  for (std::string& argument : arguments) list.push_back(argument.data());
  list.push_back(nullptr);
  const GdalWish wish(gdal.new_options(list.data(), nullptr), GdalDeleter{&gdal});
  if (wish == nullptr) return false;
  const auto goes_on = [](double, const char*, void* control) {
    return control != nullptr && static_cast<JobControl*>(control)->stop_requested() ? 0 : 1;
  };
  gdal.set_progress(wish.get(), goes_on, job);
  // Closing completes the file.
  const bool is_written =
      GdalSet(gdal.translate(to, nullptr, 1, &from, wish.get(), nullptr), GdalDeleter{&gdal}) != nullptr;
  if (job != nullptr) job->checkpoint();
  return is_written;
}

/// The name of member `crs`.
std::string system_of(const GdalLibrary& gdal, GdalLibrary::Layer layer) {
  const GdalLibrary::System system = gdal.system(layer);
  if (system == nullptr || gdal.is_local(system) != 0) return "none";
  const char* name = gdal.authority_name(system, nullptr);
  if (name == nullptr) {
    gdal.identify(system);
    name = gdal.authority_name(system, nullptr);
  }
  const char* const code = gdal.authority_code(system, nullptr);
  if (name != nullptr && code != nullptr) return fmt::format("{}:{}", name, code);
  char* text = nullptr;
  gdal.write_wkt(system, &text);
  std::string out = text == nullptr ? "none" : text;
  gdal.free(text);
  return out;
}

void append_quoted(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  out += '"';
}

/// A name for a column that no property of the GeoJSON text has; names of columns do not differ in case.
std::string free_column(std::string name, std::string_view geojson) {
  const std::string text = lower_case(geojson);
  while (text.contains(fmt::format("\"{}\":", name))) name.insert(0, "mesecina_");
  return name;
}

}  // namespace

Expected<std::string> geojson_by_gdal(std::string_view bytes, const std::string& name,
                                      const std::filesystem::path* path, JobControl* job) {
  const auto library = gdal_library();
  if (!library) return std::unexpected(Error{library.error().code, library.error().text, name});
  const GdalLibrary& gdal = **library;
  const GdalMessages messages(gdal);
  GdalMemory memory(gdal, "");
  if (path == nullptr) memory.hold(bytes);
  const std::string place = path == nullptr ? memory.name() : path->string();
  constexpr std::array<const char*, 4> kDrivers{"GPKG", "FlatGeobuf", "ESRI Shapefile", nullptr};
  const GdalSet set = open_with(gdal, place.c_str(), kDrivers);
  if (set == nullptr) return messages.problem("GDAL cannot read the map", name);
  std::string out;
  for (int i = 0; i < gdal.layer_count(set.get()); ++i) {
    const GdalLibrary::Layer layer = gdal.layer(set.get(), i);
    constexpr int kNoGeometry = 100;
    if (layer == nullptr || gdal.geometry_type(layer) == kNoGeometry) continue;
    const GdalMemory text(gdal, ".geojson");
    const bool is_written = translate(gdal, set.get(), text.name(),
                                      {"-f", "GeoJSON", "-a_srs", kPlane, "-dim", "XY", "-nlt", "CONVERT_TO_LINEAR",
                                       "-preserve_fid", "-lco", "SIGNIFICANT_FIGURES=17", gdal.layer_name(layer)},
                                      job);
    const std::string_view written = text.bytes();
    // A layer that is cut short may end without an error.
    const bool is_empty = !written.contains("\"Feature\"") && gdal.feature_count(layer, 0) > 0;
    if (!is_written || is_empty || !written.starts_with('{'))
      return messages.problem(fmt::format("GDAL cannot read layer {} to its end", in_quotes(gdal.layer_name(layer))),
                              name);
    out += R"({"crs":{"type":"name","properties":{"name":)";
    append_quoted(out, system_of(gdal, layer));
    out += "}},";
    out += written.substr(1);
  }
  if (out.empty() && messages.were_any()) return messages.problem("GDAL cannot read the map", name);
  if (out.empty()) return std::unexpected(Error{ErrorCode::bad_input, "no layer of the map has geometries", name});
  return out;
}

Expected<std::string> map_by_gdal(std::string_view geojson, const std::string& driver,
                                  const std::optional<GdalSystem>& system) {
  const auto library = gdal_library();
  if (!library) return std::unexpected(library.error());
  const GdalLibrary& gdal = **library;
  const GdalMessages messages(gdal);
  GdalMemory text(gdal, ".geojson");
  text.hold(geojson);
  const GdalMemory file(gdal, driver == "GPKG" ? ".gpkg" : ".fgb");
  std::vector<std::string> arguments{"-f", driver, "-nln", "mesecina"};
  if (driver == "GPKG") {
    // GDAL takes a property "id" for the number of the row, and "geom" for the geometry.
    arguments.insert(arguments.end(), {"-unsetFid", "-lco", "FID=" + free_column("fid", geojson), "-lco",
                                       "GEOMETRY_NAME=" + free_column("geom", geojson)});
  }
  if (!system)
    arguments.insert(arguments.end(), {"-a_srs", kPlane});
  else if (!system->name.empty())
    arguments.insert(arguments.end(), {system->is_of_text ? "-a_srs" : "-t_srs", system->name});
  gdal.set_thread_option("OGR_CURRENT_DATE", "1970-01-01T00:00:00Z");
  constexpr std::array<const char*, 2> kDrivers{"GeoJSON", nullptr};
  const GdalSet set = open_with(gdal, text.name(), kDrivers);
  const bool is_written = set != nullptr && translate(gdal, set.get(), file.name(), std::move(arguments), nullptr);
  gdal.set_thread_option("OGR_CURRENT_DATE", nullptr);
  if (!is_written) return messages.problem("GDAL cannot write the map", {}, ErrorCode::cannot_write);
  return std::string(file.bytes());
}

Format geojson_format();
Format shapefile_format();

namespace {

/// GeoJSON reads what GDAL gives.
Expected<LoadedFile> read_by_gdal(std::string_view bytes, const std::string& name, const ReadRequest& request,
                                  const std::filesystem::path*, ReadJob& job) {
  const auto text = geojson_by_gdal(bytes, name, nullptr, job.control());
  if (!text) return std::unexpected(text.error());
  auto file = geojson_format().read_map(*text, name, request, nullptr, job);
  // A place in the text is none in the file.
  if (!file) file.error().line = file.error().column = 0;
  return file;
}

Match match_geopackage(std::string_view bytes) {
  constexpr std::size_t kApplication = 68;
  const bool is_database = bytes.starts_with(std::string_view("SQLite format 3\0", 16));
  return is_database && bytes.size() > kApplication && bytes.substr(kApplication).starts_with("GP") ? Match::surely
                                                                                                    : Match::no;
}

Match match_flatgeobuf(std::string_view bytes) {
  return bytes.starts_with("fgb\x03\x66gb") ? Match::surely : Match::no;
}

}  // namespace

Format geopackage_format() {
  return {.descriptor =
              {.id = "geopackage", .name = "GeoPackage", .extensions = {".gpkg"}, .can_read = true, .is_map = true},
          .match = match_geopackage,
          .read_map = read_by_gdal,
          .may_look_foreign = true};
}

Format flatgeobuf_format() {
  return {.descriptor =
              {.id = "flatgeobuf", .name = "FlatGeobuf", .extensions = {".fgb"}, .can_read = true, .is_map = true},
          .match = match_flatgeobuf,
          .read_map = read_by_gdal,
          .may_look_foreign = true};
}

bool is_for_gdal(std::string_view bytes) {
  return match_geopackage(bytes) == Match::surely || match_flatgeobuf(bytes) == Match::surely ||
         shapefile_format().match(bytes) == Match::surely;
}

}  // namespace mes
