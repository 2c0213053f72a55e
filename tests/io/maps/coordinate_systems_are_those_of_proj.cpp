// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinate systems of maps: found by name, converted as the program cs2cs does it, and kept in files.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/base/jobs/parallel.h"
#include "core/io/session/session.h"
#include "core/io/systems/chosen_plane.h"
#include "core/io/systems/map_conversion.h"
#include "tests/io/checked_reading.h"
#include "tests/io/document_of.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using namespace mes::test;

namespace {

CoordinateSystem system_of(const std::string& text) {
  const auto out = find_coordinate_system(text);
  INFO((out ? std::string() : out.error().message()));
  REQUIRE(out);
  return *out;
}

MapConversion conversion_of(const MapPlane& plane, MapTarget target) {
  auto out = MapConversion::of(plane, target);
  INFO((out ? std::string() : out.error().message()));
  REQUIRE(out);
  return *std::move(out);
}

struct SystemExample {
  const char* system;
  bool is_northing_first;  ///< in the order of axes of its authority
  std::vector<Vec2> positions;
};

/// Longitudes and latitudes on WGS 84 by cs2cs.
std::vector<Vec2> degrees_by_cs2cs(const SystemExample& example) {
  const std::vector<Vec2>& positions = example.positions;
  const TemporaryFolder folder;
  std::ostringstream input;
  input.precision(17);
  for (const Vec2 p : positions) input << p.x << ' ' << p.y << '\n';
  const std::string in = folder.write("in", input.str()).string();
  // -r exchanges the numbers that are read.
  const std::string command =
      std::string("cs2cs -d 12 ") + (example.is_northing_first ? "-r " : "") + example.system + " OGC:CRS84 < " + in;
  std::FILE* const pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  REQUIRE(pclose(pipe) == 0);
  std::istringstream lines(text);
  std::vector<Vec2> out;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    Vec2 p;
    REQUIRE(numbers >> p.x >> p.y);
    out.push_back(p);
  }
  REQUIRE(out.size() == positions.size());
  return out;
}

/// Metres between positions in degrees that are near each other.
double metres_between(Vec2 a, Vec2 b) {
  constexpr double kMetres = 111'320.0;
  return kMetres * std::hypot(std::remainder(a.x - b.x, 360.0) * std::cos(a.y * 0.017453292519943295), a.y - b.y);
}

const std::vector<SystemExample>& examples() {
  static const std::vector<SystemExample> all{
      {"EPSG:25832", false, {{548'200.5, 5'803'100.25}, {300'000, 5'300'000}, {899'999, 6'100'000}}},
      {"EPSG:31467", true, {{3'548'200.5, 5'803'100.25}, {3'400'000, 5'300'000}}},  // Gauss-Krueger, another datum
      {"EPSG:27700", false, {{530'000, 180'000}, {250'000, 665'000}}},
      {"EPSG:2263", false, {{990'000, 200'000}}},  // in feet
      {"EPSG:3857", false, {{1'080'000, 6'870'000}, {-20'000'000, 1'000'000}}},
      {"EPSG:3413", false, {{100, -200}, {1'000'000, -1'000'000}}},  // about the North Pole
      {"EPSG:4314", true, {{9.7, 52.3}, {11.5, 48.1}}},
      {"EPSG:4258", true, {{9.7, 52.3}}},
  };
  return all;
}

}  // namespace

TEST_CASE("positions become longitude and latitude within a millimetre of cs2cs, and come back") {
  for (const SystemExample& example : examples()) {
    INFO(example.system);
    const CoordinateSystem system = system_of(example.system);
    const MapPlane plane{.system = system.id, .unit = system.unit};
    const MapConversion conversion = conversion_of(plane, MapTarget::wgs84);
    const std::vector<Vec2> expected = degrees_by_cs2cs(example);
    const double unit = system.is_geographic ? 111'320.0 : system.unit_size;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CHECK(metres_between(conversion.from_plane(example.positions[i]), expected[i]) < 1e-3);
      // A change of datum is not inverted exactly.
      CHECK(unit * distance(conversion.to_plane(expected[i]), example.positions[i]) < 2e-3);
    }
    // Its own system is the plane itself.
    const MapConversion same = conversion_of(plane, MapTarget::own_system);
    for (const Vec2 p : example.positions) CHECK(same.from_plane(p) == p);
  }
}

TEST_CASE("conversions side by side and one after another are the same to the last bit") {
  const std::array<std::string, 2> systems{"EPSG:25832", "EPSG:2263"};
  const std::array<Vec2, 2> places{Vec2{512'000.0, 5'400'000.0}, Vec2{985'000.0, 200'000.0}};
  const auto there = [&](std::size_t i) {
    return conversion_of(MapPlane{.system = systems[i]}, MapTarget::wgs84).from_plane(places[i]);
  };
  const std::array first{there(0), there(1)};
  CHECK(first[0] != first[1]);
  std::array<int, 16> differences{};
  run_tasks(differences.size(), [&](std::size_t task) {
    const MapConversion longer = *MapConversion::of(MapPlane{.system = systems[task % 2]}, MapTarget::wgs84);
    for (std::size_t k = 0; k < 20; ++k) {
      const std::size_t i = (task + k) % 2;
      const MapConversion one = *MapConversion::of(MapPlane{.system = systems[i]}, MapTarget::wgs84);
      differences[task] += one.from_plane(places[i]) != first[i] ? 1 : 0;
      differences[task] += longer.from_plane(places[task % 2]) != first[task % 2] ? 1 : 0;
    }
  });
  CHECK(std::ranges::count(differences, 0) == static_cast<std::ptrdiff_t>(differences.size()));
}

TEST_CASE("the local plane of degrees is a plane of the same system, within a millimetre") {
  for (const char* text : {"EPSG:4326", "EPSG:4314", "EPSG:4258"}) {
    INFO(text);
    const CoordinateSystem system = system_of(text);
    std::vector<Vec2> positions{{9.70, 52.30}, {9.71, 52.30}, {9.71, 52.31}, {15.0, 47.2}, {5.9, 55.0}};
    const std::vector<Vec2> before = positions;
    const auto chosen = choose_plane(positions, system, MapDegrees::projected);
    REQUIRE(chosen);
    CHECK(positions == before);
    CHECK(chosen->plane.projection == MapProjection::azimuthal);
    CHECK(chosen->plane.plane_unit() == "m");
    const auto kept = choose_plane(positions, system, MapDegrees::kept);
    REQUIRE(kept);
    CHECK(kept->plane.plane_unit() == "degrees");
    const MapConversion conversion = conversion_of(chosen->plane, MapTarget::own_system);
    std::vector<Vec2> placed = positions;
    conversion.to_plane(placed);
    for (std::size_t i = 0; i < placed.size(); ++i)
      CHECK(metres_between(conversion.from_plane(placed[i]), before[i]) < 1e-3);
    // Both ways to WGS 84 agree: from the local plane, and from the system itself.
    const MapConversion local = conversion_of(chosen->plane, MapTarget::wgs84);
    const MapConversion own = conversion_of({.system = system.id, .unit = system.unit}, MapTarget::wgs84);
    for (std::size_t i = 0; i < placed.size(); ++i)
      CHECK(metres_between(local.from_plane(placed[i]), own.from_plane(before[i])) < 1e-3);
  }
}

TEST_CASE("a system has one name, whatever it was called") {
  for (const char* name : {"EPSG:25832", "epsg:25832", "25832", " EPSG:25832\n", "urn:ogc:def:crs:EPSG::25832",
                           "ETRS89 / UTM zone 32N"}) {
    INFO(name);
    const CoordinateSystem system = system_of(name);
    CHECK(system.id == "EPSG:25832");
    CHECK(system.title() == "ETRS89 / UTM zone 32N (EPSG:25832)");
    CHECK(system.unit == "metre");
    CHECK(system.half_turn() == 0.0);
  }
  for (const char* name : {"", "EPSG:4326", "4326", "OGC:CRS84", "urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4979",
                           "+proj=longlat +datum=WGS84"}) {
    INFO(name);
    if (name[0] != '+') CHECK(system_of(name) == CoordinateSystem{});
    CHECK(system_of(name).half_turn() == 180.0);
  }
  // The part for positions is taken of a system with heights.
  CHECK(system_of("EPSG:7405").id == "EPSG:27700");
  CHECK(system_of("EPSG:4807").half_turn() == 200.0);  // grads
  const CoordinateSystem local = system_of("+proj=tmerc +lon_0=10.5 +lat_0=51 +ellps=GRS80");
  CHECK(local.id.starts_with("PROJCRS["));
  CHECK_FALSE(local.id.contains('\n'));
  CHECK(system_of(local.id) == local);
}

TEST_CASE("a system is used near the area that its authority names") {
  const CoordinateSystem zone = system_of("EPSG:25832");
  CHECK(zone.is_used_near(9.0, 50.0));
  CHECK(zone.is_used_near(13.0, 52.0));  // many use the zone beside theirs
  CHECK_FALSE(zone.is_used_near(4.5, 0.0));
  CHECK_FALSE(zone.is_used_near(30.0, 50.0));
  const CoordinateSystem across = system_of("EPSG:3460");  // Fiji, across the 180th meridian
  CHECK(across.is_used_near(179.0, -18.0));
  CHECK(across.is_used_near(-179.0, -18.0));
  CHECK_FALSE(across.is_used_near(0.0, -18.0));
  for (const char* const everywhere : {"EPSG:3857", "", "+proj=tmerc +lon_0=10.5 +lat_0=51 +ellps=GRS80"})
    CHECK(system_of(everywhere).is_used_near(-100.0, -80.0));
}

TEST_CASE("a text that names no horizontal system of the Earth is refused in one line") {
  for (const char* name : {"EPSG:999999", "EPSG:43260", "no system", "EPSG:5773", "EPSG:4978", "GEOGCS[", "[[[[",
                           "+proj=nonsense", "+proj=", "PROJCS[\"a\nb\"]", "\x01\x02"}) {
    INFO(name);
    const auto system = find_coordinate_system(name);
    REQUIRE_FALSE(system);
    CHECK(system.error().code == ErrorCode::bad_input);
    CHECK_FALSE(system.error().message().contains('\n'));
    CHECK_FALSE(system.error().message().contains('\x01'));
  }
}

TEST_CASE("the error of lengths is stated, and holds") {
  const auto chosen_for = [](std::vector<Vec2> positions, const std::string& system,
                             MapDegrees degrees = MapDegrees::projected) {
    const auto chosen = choose_plane(positions, system_of(system), degrees);
    REQUIRE(chosen);
    return *chosen;
  };
  CHECK_THAT(chosen_for({{9.7, 52.3}, {9.7003, 52.3002}}, "EPSG:4326").remark,
             Catch::Contains("azimuthal equidistant, lengths are right to 0.0001 %"));
  // A transverse Mercator projection has the factor 0.9996 along its meridian.
  CHECK_THAT(chosen_for({{500'000, 5'800'000}, {500'010, 5'800'010}}, "EPSG:25832").remark,
             Catch::Contains("ETRS89 / UTM zone 32N (EPSG:25832), in m; lengths are right to 0.04 %"));
  CHECK_THAT(chosen_for({{1'080'000, 6'870'000}}, "EPSG:3857", MapDegrees::kept).remark,
             Catch::Contains("differ from those on the Earth by up to 64 %"));
  CHECK_THAT(chosen_for({{990'000, 200'000}}, "EPSG:2263").remark, Catch::Contains("in US survey foot;"));

  // A side across the direction of the origin at the edge of a map of 1000 km: as long as geod says, within the bound.
  const std::vector<Vec2> country{{5.0, 50.0}, {19.0, 50.0}, {12.0, 47.0}, {12.0, 53.0}};
  const ChosenPlane wide = chosen_for(country, "EPSG:4326");
  const MapConversion conversion = conversion_of(wide.plane, MapTarget::own_system);
  const double side = distance(conversion.to_plane(Vec2{19.0, 49.9}), conversion.to_plane(Vec2{19.0, 50.1}));
  constexpr double kByGeod = 22'247.40;  // metres from 49.9 to 50.1 degrees north
  const auto bound = largest_scale_error(wide.plane, std::vector<Vec2>{conversion.to_plane(Vec2{19.0, 50.0})});
  REQUIRE(bound);
  CHECK(side > kByGeod);
  CHECK(side / kByGeod - 1.0 < *bound);
  CHECK(side / kByGeod - 1.0 > 0.9 * *bound);
}

TEST_CASE("a web map has the lengths of the Earth, and comes back") {
  const std::vector<Vec2> degrees{{8.0, 50.0}, {8.02, 50.0}, {8.02, 50.01}, {8.0, 50.015}};
  const MapConversion of_web = conversion_of({.system = "EPSG:3857", .unit = "metre"}, MapTarget::wgs84);
  std::vector<Vec2> web = degrees;
  of_web.to_plane(web);
  const auto chosen = choose_plane(web, system_of("EPSG:3857"), MapDegrees::projected);
  REQUIRE(chosen);
  CHECK(chosen->is_choice);
  CHECK(
      chosen->remark ==
      "coordinates of WGS 84 / Pseudo-Mercator (EPSG:3857) are projected to metres about 8.01 E, 50.01 N: azimuthal "
      "equidistant, lengths are right to 0.0001 %");
  CHECK(chosen->plane.system == "EPSG:3857");
  CHECK(chosen->plane.plane_unit() == "m");
  const MapConversion to_web = conversion_of(chosen->plane, MapTarget::own_system);
  const MapConversion to_degrees = conversion_of(chosen->plane, MapTarget::wgs84);
  const MapConversion expected =
      conversion_of({MapProjection::azimuthal, chosen->plane.longitude, chosen->plane.latitude}, MapTarget::wgs84);
  CHECK(to_web.half_turn() == 0.0);
  CHECK(to_degrees.half_turn() == 180.0);
  for (std::size_t i = 0; i < web.size(); ++i) {
    const Vec2 at = to_web.to_plane(web[i]);
    CHECK(distance(at, expected.to_plane(degrees[i])) < 1e-6);
    CHECK(distance(at, to_degrees.to_plane(degrees[i])) < 1e-6);
    CHECK(distance(to_web.from_plane(at), web[i]) < 1e-3);
    CHECK(metres_between(to_degrees.from_plane(at), degrees[i]) < 1e-3);
  }

  const auto plane_of = [](std::vector<Vec2> positions, MapDegrees wanted) {
    const auto of = choose_plane(positions, system_of("EPSG:3857"), wanted);
    REQUIRE(of);
    return of->plane.projection;
  };
  CHECK(plane_of(web, MapDegrees::kept) == MapProjection::none);
  CHECK(plane_of({{0, 0}, {1000, 1000}}, MapDegrees::projected) == MapProjection::none);  // lengths are right there
  CHECK(plane_of({{-2e7, -1e7}, {2e7, 1e7}}, MapDegrees::projected) == MapProjection::none);
}

TEST_CASE("maps at a pole, across the 180th meridian and of the whole Earth have a plane that fits") {
  const auto plane_of = [](std::vector<Vec2> positions) {
    const auto chosen = choose_plane(positions, CoordinateSystem{}, MapDegrees::projected);
    REQUIRE(chosen);
    const MapConversion conversion = conversion_of(chosen->plane, MapTarget::own_system);
    for (const Vec2 p : positions) {
      const Vec2 back = conversion.from_plane(conversion.to_plane(p));
      CHECK(metres_between(back, p) < 1e-3);
    }
    return chosen->plane;
  };
  CHECK(plane_of({{0, 90}}).latitude == 90.0);
  CHECK(plane_of({{12, -90}, {13, -89.99}}).projection == MapProjection::azimuthal);
  CHECK(plane_of({{-120, 80}, {0, 80}, {120, 80}}) == MapPlane{MapProjection::azimuthal, 0.0, 90.0});
  CHECK(plane_of({{-120, -70}, {0, -75}, {120, -65}}) == MapPlane{MapProjection::azimuthal, 0.0, -90.0});
  const MapPlane fiji = plane_of({{179, -17}, {-179, -18}});
  CHECK(fiji.projection == MapProjection::azimuthal);
  CHECK(fiji.longitude == 180.0);
  const MapPlane earth = plane_of({{-170, 70}, {170, 70}, {0, -60}});
  CHECK(earth.projection == MapProjection::equirectangular);
  CHECK(earth.plane_unit() == "km");
}

TEST_CASE("long lines between degrees stay where the degrees have them") {
  // The border along a parallel: its middle is 600 km north of the straight line of the plane through its ends.
  const std::string text = R"({"type":"LineString","coordinates":[[-123,49],[-95,49]]})";
  const LoadedFile file = good(read_sample_bytes(text, "a.geojson"));
  const MapConversion conversion = conversion_of(*file.data.map, MapTarget::wgs84);
  for (const Vec2 p : file.data.positions) CHECK(std::abs(conversion.from_plane(p).y - 49.0) < 1e-3);
  CHECK(read_map(text).data.positions.size() == 2);
}

TEST_CASE("polygons that were cut at the 180th meridian are one again, around a pole too") {
  const LoadedFile island = read_map(R"({"type":"MultiPolygon","coordinates":[
      [[[179,-17],[180,-17.2],[180,-16.4],[179,-16],[179,-17]]],
      [[[-180,-17.2],[-179,-17],[-179,-16],[-180,-16.4],[-180,-17.2]]]]})");
  CHECK(island.data.contours.size() == 1);
  CHECK(island.data.positions.size() == 6);
  // Antarctica, as maps of the world have it.
  std::string ring;
  for (int longitude = -180; longitude <= 180; longitude += 10)
    ring += "[" + std::to_string(longitude) + "," + std::to_string(-75 + longitude % 20 / 10) + "],";
  const LoadedFile antarctica =
      read_map(R"({"type":"Polygon","coordinates":[[)" + ring + R"([180,-90],[-180,-90],[-180,-75]]]})");
  REQUIRE(antarctica.data.contours.size() == 1);
  CHECK(antarctica.data.contours[0].closed);
  CHECK(antarctica.data.contours[0].points.size() == 36);
  const LoadedFile arctic = good(read_sample_bytes(
      R"({"type":"Polygon","coordinates":[[[-180,80],[-90,80],[0,80],[90,80],[180,80],[180,90],[-180,90],[-180,80]]]})",
      "a"));
  const MapConversion conversion = conversion_of(*arctic.data.map, MapTarget::wgs84);
  for (const Vec2 p : arctic.data.positions) CHECK(conversion.from_plane(p).y == Approx(80.0).margin(1e-3));
}

TEST_CASE("systems of one file are one, and unknown ones are refused with their place") {
  const auto refused = [](const std::string& text) {
    const auto read = read_sample_bytes(text, "a");
    REQUIRE_FALSE(read);
    CHECK(read.error().code == ErrorCode::bad_input);
    return read.error().message();
  };
  CHECK(refused("SRID=999999;POINT (9 50)") == "a:1:6: \"EPSG:999999\" is not a coordinate system that PROJ knows");
  CHECK_THAT(
      refused("SRID=4326;POINT (9 50)\nSRID=25832;POINT (500000 5800000)"),
      Catch::StartsWith("a:2:6: this is in ETRS89 / UTM zone 32N (EPSG:25832), and what comes before it in WGS 84"));
  CHECK_THAT(refused("SRID=4326;POINT (500000 5800000)"),
             Catch::Contains("500000, 5800000 is not a longitude and latitude, as WGS 84 needs"));
  CHECK_THAT(refused("SRID=4326;POINT (9 90.5)"), Catch::Contains("is not a longitude and latitude"));
  const std::string feature = R"({"type":"Point","coordinates":[9,50],"crs":{"type":"name","properties":{"name":")";
  CHECK_THAT(refused(feature + R"(EPSG:4326"}}})" + "\n" + feature + R"(EPSG:4314"}}})"),
             Catch::StartsWith("a:2:") && Catch::Contains("a file may have only one coordinate system"));
  // The same one twice, or one that is called differently.
  CHECK(read_map("SRID=25832;POINT (1 2)\nPOINT (3 4)\nSRID=25832;POINT (5 6)").data.positions.size() == 3);
  CHECK(read_map(feature + R"(EPSG:4326"}}})" + "\n" + feature + R"(urn:ogc:def:crs:OGC:1.3:CRS84"}}})")
            .data.positions.size() == 2);
  CHECK(read_map("SRID=102100;POINT (1 2)").data.map->system == "ESRI:102100");
}

TEST_CASE("a request names the system of any file that has none, and of one that has another") {
  const ReadRequest utm{.system = "EPSG:25832"};
  const MapPlane plane{.system = "EPSG:25832", .unit = "metre"};
  for (const char* text : {"548200.5 5803100.25\n548210 5803100\n", "x,y\n548200.5,5803100.25\n548210,5803100\n",
                           "MULTIPOINT (548200.5 5803100.25, 548210 5803100)",
                           "SRID=999999;MULTIPOINT (548200.5 5803100.25, 548210 5803100)",
                           R"({"type":"MultiPoint","coordinates":[[548200.5,5803100.25],[548210,5803100]]})",
                           "POFF 2 0 0\n548200.5 5803100.25\n548210 5803100\n"}) {
    INFO(text);
    const LoadedFile file = read_map(text, "a", utm);
    CHECK(file.data.map == plane);
    CHECK(file.data.positions == std::vector<Vec2>{{548200.5, 5803100.25}, {548210, 5803100}});
    CHECK(file.degrees == std::nullopt);
    REQUIRE(file.warnings.size() == 1);
    CHECK_THAT(file.warnings[0], Catch::Contains("ETRS89 / UTM zone 32N (EPSG:25832), in m"));
  }
  // A table of longitudes and latitudes is projected, or kept.
  const LoadedFile table = read_map("9.7,52.3\n9.71,52.31\n", "a", {.system = "EPSG:4326"});
  CHECK(table.data.map->projection == MapProjection::azimuthal);
  CHECK(table.degrees == MapDegrees::projected);
  CHECK(distance(table.data.positions[0], table.data.positions[1]) == Approx(1305.2).epsilon(1e-3));
  CHECK(read_map("9.7,52.3\n", "a", {.degrees = MapDegrees::kept, .system = "EPSG:4326"}).data.map == MapPlane{});
  // None, one that does not fit, and files that say where they lie.
  const auto code_of = [](std::string_view text, const ReadRequest& request) {
    const auto read = read_sample_bytes(text, "a", {}, request);
    REQUIRE_FALSE(read);
    return read.error().code;
  };
  CHECK(code_of("1 2\n", {.system = "EPSG:999999"}) == ErrorCode::bad_input);
  CHECK(code_of("1 200\n", {.system = "EPSG:4326"}) == ErrorCode::bad_input);
  CHECK(code_of("POFF 1 0 0\n1 2\n# map degrees\n", utm) == ErrorCode::usage);
  CHECK(code_of(write_session({}), utm) == ErrorCode::usage);
  CHECK(code_of("P1\n3 3\n0 0 0\n0 1 0\n0 0 0\n", utm) == ErrorCode::usage);
}

TEST_CASE("files of the program keep system and plane bit for bit") {
  const CoordinateSystem local = system_of("+proj=tmerc +lon_0=10.5 +lat_0=51 +ellps=GRS80");
  for (const MapPlane& plane :
       {MapPlane{}, MapPlane{MapProjection::equirectangular, 24.9, -1.0 / 3.0},
        MapPlane{MapProjection::azimuthal, 181.0 + 1.0 / 3.0, -17.0},
        MapPlane{MapProjection::azimuthal, 7.8, 55.0, "EPSG:4807"}, MapPlane{.system = "EPSG:25832", .unit = "metre"},
        MapPlane{.system = "EPSG:2263", .unit = "US survey foot"}, MapPlane{.system = "EPSG:4258"},
        MapPlane{.system = local.id, .unit = "metre"}, MapPlane{.unit = "mm"}}) {
    INFO(plane.system);
    SampleData data{.positions = {{1, 2}, {3, 4}}};
    data.map = plane;
    CHECK(good(read_sample_bytes(write_poff(document_of(data)), "a.poff")).data.map == plane);
    Session session;
    session.data = std::make_shared<const SampleData>(data);
    const std::string text = write_session(session);
    const auto read = read_session(text, "a");
    REQUIRE(read);
    CHECK(read->data->map == plane);
    CHECK(write_session(*read) == text);
    // Old programs can read what they knew.
    const bool is_old = is_on_earth(plane) && plane.system.empty() && plane.projection != MapProjection::azimuthal;
    CHECK_THAT(text, Catch::Contains(is_old ? R"("schema":1)" : R"("schema":3)"));
  }
}
