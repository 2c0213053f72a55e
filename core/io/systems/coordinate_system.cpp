// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/systems/coordinate_system.h"

#include <fmt/core.h>
#include <cctype>
#include <map>
#include <mutex>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/systems/proj_library.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

/// Positions have two numbers, so these are the same to this program.
bool is_wgs84(std::string_view id) {
  return id == "EPSG:4326" || id == "EPSG:4979" || id == "OGC:CRS84" || id == "OGC:CRS84h";
}

std::string as_proj_expects(std::string_view text) {
  if (parse_count(text)) return fmt::format("EPSG:{}", text);
  // Without this PROJ makes a conversion of it.
  if (text.starts_with('+') && !text.contains("+type=crs")) return fmt::format("{} +type=crs", text);
  return std::string(text);
}

/// Whether the text is only a name, of which PROJ takes any part for the first name that holds it.
bool is_plain_name(std::string_view text) {
  return !text.starts_with('+') && text.find_first_of(":[{") == std::string_view::npos;
}

/// The letters and digits of a name, in lower case.
std::string letters_of(std::string_view name) {
  std::string out;
  for (const char c : lower_case(name))
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) out += c;
  return out;
}

/// Looks a system up with PROJ.
class SystemSearch {
 public:
  explicit SystemSearch(const ProjLibrary& proj) : proj_(proj), context_(new_context(proj)) {}

  Expected<CoordinateSystem> find(std::string_view text) {
    if (text.contains("+proj=pipeline")) return fail(in_quotes(text) + " is a conversion, not a coordinate system");
    const std::string wanted = as_proj_expects(text);
    ProjObject whole = owned(proj_.create(context_.get(), wanted.c_str()));
    if (!whole) {
      if (proj_.context_get_database_path(context_.get()) == nullptr) return fail("PROJ does not find its proj.db");
      return fail(in_quotes(text) + " is not a coordinate system that PROJ knows");
    }
    while (proj_.get_type(whole.get()) == PJ_TYPE_COMPOUND_CRS)
      whole = owned(proj_.crs_get_sub_crs(context_.get(), whole.get(), 0));
    const bool is_bound = proj_.get_type(whole.get()) == PJ_TYPE_BOUND_CRS;
    const ProjObject base = is_bound ? owned(proj_.get_source_crs(context_.get(), whole.get())) : nullptr;
    PJ* const system = base ? base.get() : whole.get();
    const PJ_TYPE type = proj_.get_type(system);
    CoordinateSystem out;
    out.is_geographic = type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
    if (!out.is_geographic && type != PJ_TYPE_PROJECTED_CRS)
      return fail(in_quotes(text) + " is not a coordinate system of the Earth's surface");
    out.name = printable(proj_.get_name(system));
    if (is_plain_name(wanted) && letters_of(text) != letters_of(out.name))
      return fail(fmt::format("{} names no coordinate system, though it is part of {}", in_quotes(text),
                              in_quotes(out.name)));
    out.id = is_bound ? wkt_of(whole.get()) : id_of(system);
    if (is_wgs84(out.id)) return CoordinateSystem{};
    proj_.get_area_of_use(context_.get(), system, &out.west, &out.south, &out.east, &out.north, nullptr);
    if (out.west < -180.0) out.west = -180.0, out.south = -90.0, out.east = 180.0, out.north = 90.0;  // unknown
    // A system of parameters has no name, so messages and files have the parameters.
    constexpr std::string_view kNoName = R"("unknown")";
    if (const std::size_t at = out.id.find(kNoName);
        text.starts_with('+') && !text.contains('"') && at != std::string::npos) {
      out.name = printable(text);
      out.id.replace(at, kNoName.size(), fmt::format(R"("{}")", out.name));
    }
    if (out.id.empty() || !read_axes(system, out) || !read_ellipsoid(system, out))
      return fail(in_quotes(text) + " is a coordinate system that PROJ cannot describe");
    return out;
  }

 private:
  static std::unexpected<Error> fail(std::string text) {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text)});
  }
  ProjObject owned(PJ* object) const { return ProjObject(object, ProjDeleter{&proj_}); }

  std::string wkt_of(const PJ* system) {
    constexpr const char* kOptions[]{"MULTILINE=NO", nullptr};
    const char* const text = proj_.as_wkt(context_.get(), system, PJ_WKT2_2019, kOptions);
    return text != nullptr ? text : "";
  }

  std::string code_of(const PJ* system) const {
    const char* const authority = proj_.get_id_auth_name(system, 0);
    const char* const code = proj_.get_id_code(system, 0);
    return authority != nullptr && code != nullptr ? fmt::format("{}:{}", authority, code) : std::string();
  }

  std::string id_of(const PJ* system) {
    if (std::string code = code_of(system); !code.empty()) return code;
    constexpr int kEqualButForNames = 90;
    int* confidence = nullptr;
    PJ_OBJ_LIST* const known = proj_.identify(context_.get(), system, "EPSG", nullptr, &confidence);
    std::string out;
    if (known != nullptr && proj_.list_get_count(known) > 0 && confidence[0] >= kEqualButForNames)
      out = code_of(owned(proj_.list_get(context_.get(), known, 0)).get());
    proj_.list_destroy(known);
    proj_.int_list_destroy(confidence);
    return out.empty() ? wkt_of(system) : out;
  }

  bool read_axes(const PJ* system, CoordinateSystem& out) {
    const ProjObject axes = owned(proj_.crs_get_coordinate_system(context_.get(), system));
    const char* unit = nullptr;
    double size = 0.0;
    if (!axes || proj_.cs_get_axis_info(context_.get(), axes.get(), 0, nullptr, nullptr, nullptr, &size, &unit,
                                        nullptr, nullptr) == 0)
      return false;
    out.unit = printable(unit);
    // PROJ has fewer digits of a degree.
    if (out.unit != "degree") out.unit_size = size;
    return size > 0.0;
  }

  bool read_ellipsoid(const PJ* system, CoordinateSystem& out) {
    const ProjObject ellipsoid = owned(proj_.get_ellipsoid(context_.get(), system));
    return ellipsoid && proj_.ellipsoid_get_parameters(context_.get(), ellipsoid.get(), &out.major_axis,
                                                       &out.minor_axis, nullptr, nullptr) != 0;
  }

  const ProjLibrary& proj_;
  ProjContext context_;
};

}  // namespace

bool CoordinateSystem::is_used_near(double longitude, double latitude) const {
  constexpr double kLatitudes = 5.0;
  constexpr double kLongitudes = 10.0;
  if (latitude < south - kLatitudes || latitude > north + kLatitudes) return false;
  const double width = east - west + (east < west ? 360.0 : 0.0) + 2.0 * kLongitudes;
  const double from_west = longitude - west + kLongitudes;
  return width >= 360.0 || from_west - 360.0 * std::floor(from_west / 360.0) <= width;
}

std::string CoordinateSystem::title() const {
  if (id.empty() || id.contains('[')) return name;
  return fmt::format("{} ({})", name, id);
}

Expected<CoordinateSystem> find_coordinate_system(std::string_view text) {
  const std::string wanted(trimmed(text));
  if (wanted.empty() || is_wgs84(as_proj_expects(wanted)) || wanted == "urn:ogc:def:crs:OGC:1.3:CRS84")
    return CoordinateSystem{};
  constexpr std::size_t kLongest = 65536;
  if (wanted.size() > kLongest)
    return std::unexpected(Error{ErrorCode::bad_input, fmt::format("a coordinate system of {} bytes is too long; the "
                                                                   "longest has {}",
                                                                   wanted.size(), kLongest)});
  constexpr std::size_t kMostKept = 100;
  static std::mutex mutex;
  static std::map<std::string, CoordinateSystem> found;
  const std::scoped_lock lock(mutex);
  if (const auto known = found.find(wanted); known != found.end()) return known->second;
  const auto proj = proj_library();
  if (!proj) return std::unexpected(proj.error());
  auto system = SystemSearch(**proj).find(wanted);
  if (system) {
    if (found.size() == kMostKept) found.clear();
    found.emplace(wanted, *system);
  }
  return system;
}

}  // namespace mes
