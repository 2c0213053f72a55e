// SPDX-License-Identifier: GPL-3.0-or-later
// Files written here by the technical description of ESRI, byte by byte.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "core/io/format.h"
#include "tests/io/checked_reading.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using mes::test::good;
using mes::test::kAtVertices;

namespace {

using Positions = std::vector<Vec2>;
using Contours = std::vector<SampleData::Contour>;

template <class Value>
std::string bytes_of(Value value, bool is_big = false) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  if (is_big == (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
  return {bytes.data(), bytes.size()};
}
std::string number(std::uint32_t value) {
  return bytes_of(value);
}

std::string positions_of(const Positions& positions) {
  std::string out;
  for (const Vec2 p : positions) out += bytes_of(p.x) + bytes_of(p.y);
  return out;
}

/// Content of records.
std::string point(std::uint32_t type, Vec2 p) {
  return number(type) + positions_of({p});
}
std::string points(const Positions& all) {
  return number(8) + std::string(32, '\0') + number(static_cast<std::uint32_t>(all.size())) + positions_of(all);
}
std::string parts(std::uint32_t type, const std::vector<Positions>& all) {
  std::string begins;
  std::string places;
  std::uint32_t count = 0;
  for (const Positions& part : all) {
    begins += number(count);
    places += positions_of(part);
    count += static_cast<std::uint32_t>(part.size());
  }
  return number(type) + std::string(32, '\0') + number(static_cast<std::uint32_t>(all.size())) + number(count) +
         begins + places;
}

std::string file_of(const std::vector<std::string>& records) {
  std::string out =
      bytes_of(std::uint32_t{9994}, true) + std::string(24, '\0') + number(1000) + number(5) + std::string(64, '\0');
  std::uint32_t i = 0;
  for (const std::string& record : records)
    out += bytes_of(++i, true) + bytes_of(static_cast<std::uint32_t>(record.size() / 2), true) + record;
  return out;
}

void check_refused_shapes(const std::string& bytes, const std::string& message) {
  const auto read = read_sample_bytes(bytes, "a", {}, kAtVertices);
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().code == ErrorCode::bad_input);
  CHECK(read.error().message() == "a: " + message);
}

const Positions kSquare{{0, 0}, {0, 500}, {500, 500}, {500, 0}, {0, 0}};
const Positions kHole{{10, 10}, {20, 10}, {20, 20}, {10, 10}};
constexpr const char* kDegrees =
    "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137.0,298.257223563]],PRIMEM["
    "\"Greenwich\","
    "0.0],UNIT[\"Degree\",0.0174532925199433]]";
/// Comes after the system of degrees in a projected one.
constexpr const char* kUtm32 =
    ",PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"False_Easting\",500000.0],PARAMETER[\"False_Northing\",0.0],"
    "PARAMETER[\"Central_Meridian\",9.0],PARAMETER[\"Scale_Factor\",0.9996],PARAMETER[\"Latitude_Of_Origin\",0.0],"
    "UNIT[\"Meter\",1.0]]";

}  // namespace

TEST_CASE("each type of shape gives its rings, lines and points") {
  const LoadedFile file = good(
      read_sample_bytes(file_of({parts(5, {kSquare, kHole}), number(0), point(1, {-7, 0.1}),
                                 parts(3, {{{1, 1}, {2, 2}}, {{3, 3}, {4, 3}, {4, 4}}}), points({{8, 8}, {9, 9}})}),
                        "a", {}, kAtVertices));
  CHECK(file.format == "shapefile");
  CHECK(file.warnings.empty());
  CHECK(file.data.positions == Positions{{0, 0},
                                         {0, 500},
                                         {500, 500},
                                         {500, 0},
                                         {10, 10},
                                         {20, 10},
                                         {20, 20},
                                         {1, 1},
                                         {2, 2},
                                         {3, 3},
                                         {4, 3},
                                         {4, 4},
                                         {-7, 0.1},
                                         {8, 8},
                                         {9, 9}});
  CHECK(file.data.contours ==
        Contours{{true, {0, 1, 2, 3}}, {true, {4, 5, 6}}, {false, {7, 8}}, {false, {9, 10, 11}}});
}

TEST_CASE("heights and measures are left out with a warning, and so are surfaces in space") {
  // What follows the positions of such a record is not looked at.
  const LoadedFile file = good(
      read_sample_bytes(file_of({point(11, {1000, 2}) + std::string(16, '\1'),
                                 parts(25, {kSquare}) + std::string(56, '\1'), number(31) + std::string(60, '\1')}),
                        "a", {}, kAtVertices));
  CHECK(file.data.positions.size() == 5);
  CHECK(file.warnings == std::vector<std::string>{"a: heights and measures are left out",
                                                  "a: 1 surface in space (multipatch) is left out"});
}

TEST_CASE("zeros between records and at the end are passed over, with a warning") {
  const std::string one = file_of({point(1, {1000, 1})});
  const std::string two = file_of({point(1, {1000, 1}), point(1, {2, 3})});
  const std::string second = two.substr(one.size());
  for (const std::size_t zeros : {2U, 4U, 6U, 16U, 100U}) {
    const LoadedFile between = good(read_sample_bytes(one + std::string(zeros, '\0') + second, "a", {}, kAtVertices));
    CHECK(between.data.positions == std::vector<Vec2>{{1000, 1}, {2, 3}});
    CHECK(between.warnings == std::vector<std::string>{"a: 1 gap of zeros between records is passed over"});
    if (zeros < 4) continue;  // less may be the beginning of a record
    const LoadedFile after = good(read_sample_bytes(one + std::string(zeros, '\0'), "a", {}, kAtVertices));
    CHECK(after.data.positions == std::vector<Vec2>{{1000, 1}});
  }
  // Numbers of records do not count: some programs leave them zero, and large ones begin with fewer zeros.
  for (const std::uint32_t number : {0U, 65'536U, 70'000U}) {
    const std::string other = file_of({point(1, {1000, 1}), point(1, {2, 3})}).substr(one.size() + 4);
    std::string head;
    for (int shift = 24; shift >= 0; shift -= 8) head += static_cast<char>((number >> shift) & 0xffU);
    for (const std::size_t zeros : {0U, 8U})
      CHECK(good(read_sample_bytes(one + std::string(zeros, '\0') + head + other, "a", {}, kAtVertices))
                .data.positions == std::vector<Vec2>{{1000, 1}, {2, 3}});
  }
}

TEST_CASE("the .prj beside it says whether positions are degrees") {
  const test::TemporaryFolder folder;
  const auto path = folder.write("a.shp", file_of({parts(5, {{{9, 50}, {11, 50}, {11, 51}, {9, 51}, {9, 50}}})}));
  const LoadedFile alone = good(read_sample_file(path, {}, nullptr, {.keeps_vertices = true}));
  CHECK(alone.data.positions.front() == Vec2{9, 50});
  REQUIRE(alone.warnings.size() == 1);
  CHECK_THAT(alone.warnings[0], Catch::Contains("no .prj file beside it says whether these are degrees"));

  const auto beside = folder.write("a.prj", kDegrees);
  const LoadedFile projected = good(read_sample_file(path, {}, nullptr, {.keeps_vertices = true}));
  REQUIRE(projected.warnings.size() == 1);
  CHECK_THAT(projected.warnings[0], Catch::Contains("metres about 10 E, 50.5 N"));
  CHECK(distance(projected.data.positions[1], projected.data.positions[2]) == Approx(111238.7).epsilon(1e-3));
  REQUIRE(projected.sources.size() == 2);
  CHECK(projected.sources[0].path == beside);
  CHECK(projected.degrees == MapDegrees::projected);

  const LoadedFile kept = good(read_sample_file(path, {}, {}, {.degrees = MapDegrees::kept, .keeps_vertices = true}));
  CHECK(kept.data.positions == alone.data.positions);
  CHECK(kept.degrees == MapDegrees::kept);
  REQUIRE(kept.warnings.size() == 1);
  CHECK_THAT(kept.warnings[0], Catch::Contains("degrees are kept as coordinates of the plane"));
  CHECK(kept.sources.size() == 2);

  std::filesystem::resize_file(beside, std::uintmax_t{3} << 30U);  // takes no room on the disk
  const LoadedFile unread = good(read_sample_file(path, {}, nullptr, {.keeps_vertices = true}));
  CHECK(unread.data.positions == alone.data.positions);
  REQUIRE(unread.warnings.size() == 2);
  CHECK_THAT(unread.warnings[1],
             Catch::Contains("a.prj: it is too large to read; coordinates are taken as they are"));

  folder.write("a.prj", "PROJCS[\"WGS_1984_UTM_Zone_32N\"," + std::string(kDegrees) + kUtm32);
  const LoadedFile plane = good(read_sample_file(path, {}, nullptr, {.keeps_vertices = true}));
  CHECK(plane.data.positions.front() == Vec2{9, 50});
  CHECK(plane.data.map == MapPlane{.system = "EPSG:32632", .unit = "metre"});

  // A system that is nonsense is refused; another one may be given.
  for (const char* nonsense : {"WGS 84", "PROJCS[\"a\"", "GEOGCS[\"a\",UNIT[\"Degree\",0.01]]", "\xff\xfe[\x01"}) {
    folder.write("a.prj", nonsense);
    const auto refused = read_sample_file(path);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::bad_input);
    CHECK_THAT(refused.error().message(), Catch::StartsWith(beside.string()));
    CHECK(good(read_sample_file(path, {}, nullptr, {.system = "EPSG:25832"})).data.map->system == "EPSG:25832");
  }
  folder.write("a.prj", " \n");
  const LoadedFile blank = good(read_sample_file(path, {}, nullptr, {.keeps_vertices = true}));
  CHECK_FALSE(blank.data.map);
  REQUIRE(blank.warnings.size() == 1);
  CHECK_THAT(blank.warnings[0], Catch::Contains("a.prj: the file is empty"));
  REQUIRE(plane.warnings.size() == 1);
  CHECK_THAT(plane.warnings[0], Catch::Contains("WGS 84 / UTM zone 32N (EPSG:32632), in m; lengths are right to "));
}

TEST_CASE("a shapefile that is wrong is refused with its record and byte") {
  const std::string good_file = file_of({point(1, {1000, 1}), parts(5, {kSquare})});
  for (std::size_t size = 100; size < good_file.size(); ++size) {
    const auto read = read_sample_bytes(good_file.substr(0, size), "a.shp");
    // After the header, and after the first record, what is there is a file.
    CHECK(read.has_value() == (size == 128));
    if (!read && size > 100)
      CHECK_THAT(read.error().text, Catch::StartsWith("record ") && Catch::Contains(" at byte "));
  }
  for (const std::size_t size : {4U, 36U, 99U}) {
    const auto read = read_sample_bytes(good_file.substr(0, size), "a.shp");
    REQUIRE_FALSE(read);
    CHECK(read.error().message() == "a.shp: the file ends at byte " + std::to_string(size) + ", within its header");
  }
  check_refused_shapes(good_file.substr(0, 130), "record 2 at byte 128: the file ends within its header");
  check_refused_shapes(good_file.substr(0, 200), "record 2 at byte 128: the file ends within it");
  check_refused_shapes(file_of({number(7)}), "record 1 at byte 100: there is no type 7");
  check_refused_shapes(file_of({number(10)}), "record 1 at byte 100: there is no type 10");
  check_refused_shapes(file_of({number(20)}), "record 1 at byte 100: there is no type 20");
  check_refused_shapes(file_of({""}), "record 1 at byte 100: it has no type");
  check_refused_shapes(file_of({number(1)}), "record 1 at byte 100: it is too short for a point");
  check_refused_shapes(file_of({point(1, {NAN, 1})}), "record 1 at byte 112: nan is not a finite number");
  check_refused_shapes(file_of({parts(5, {{{0, 0}, {1, 0}, {1, NAN}, {0, 0}}})}),
                       "record 1 at byte 196: nan is not a finite number");
  std::string many = points({{1, 1}});
  many.replace(36, 4, number(0xFFFFFFFF));
  check_refused_shapes(file_of({many}), "record 1 at byte 100: it is too short for 4294967295 points");
  std::string huge = parts(3, {kSquare});
  huge.replace(36, 4, number(0xFFFFFFFF));
  check_refused_shapes(file_of({huge}), "record 1 at byte 100: it is too short for 4294967295 parts of 5 points");
  std::string crossed = parts(3, {kSquare, kHole});
  crossed.replace(48, 4, number(7777));
  check_refused_shapes(file_of({crossed}), "record 1 at byte 100: part 0 does not follow the one before");
  CHECK_FALSE(read_sample_bytes(file_of({}), "a").has_value());
  CHECK_FALSE(read_sample_bytes("no shapefile", "a.shp").has_value());
}
