// SPDX-License-Identifier: GPL-3.0-or-later
// Maps in the formats of GDAL: there and back, cut off anywhere, and stopped.
#include <catch2/catch.hpp>
#include <string>

#include "core/io/format.h"
#include "core/io/maps/gdal.h"
#include "tests/io/checked_reading.h"

using namespace mes;
using mes::test::good;
using mes::test::kAtVertices;

namespace {

const std::string kLine =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","id":3,"properties":{"list":[1,2.5],"s":"é\"\\"},)"
    R"("geometry":{"type":"LineString","coordinates":[[8.1,50.25],[8.0000000000000018,50.1],[9.30000000000000071,51]]}}]})";

std::string map_of(const std::string& driver, const std::optional<GdalSystem>& system) {
  auto out = map_by_gdal(kLine, driver, system);
  if (!out) FAIL(out.error().message());
  return *out;
}

}  // namespace

TEST_CASE("positions of a map in degrees or of a plane come back bit for bit") {
  for (const std::string driver : {"GPKG", "FlatGeobuf"}) {
    INFO(driver);
    for (const bool is_plane : {false, true}) {
      const std::string file = map_of(driver, is_plane ? std::nullopt : std::optional(GdalSystem{}));
      CHECK(is_for_gdal(file));
      ReadRequest request = kAtVertices;
      request.degrees = MapDegrees::kept;
      const LoadedFile back = good(read_sample_bytes(file, "a", {}, request));
      CHECK(back.format == (driver == "GPKG" ? "geopackage" : "flatgeobuf"));
      CHECK(back.data.map.has_value() == !is_plane);
      CHECK(back.data.positions ==
            std::vector<Vec2>{{8.1, 50.25}, {8.0000000000000018, 50.1}, {9.30000000000000071, 51}});
      const auto text = geojson_by_gdal(file, "a", nullptr, nullptr);
      REQUIRE(text);
      CHECK(text->contains(R"("s": "é\"\\")"));
      CHECK(text->contains("2.5"));
    }
  }
}

TEST_CASE("a system without a code is named by its WKT") {
  const std::string own = "+proj=laea +lat_0=50 +lon_0=8 +ellps=intl +units=m";
  for (const std::string driver : {"GPKG", "FlatGeobuf"}) {
    INFO(driver);
    const LoadedFile back = good(read_sample_bytes(map_of(driver, GdalSystem{own}), "a", {}, kAtVertices));
    REQUIRE(back.data.map);
    CHECK(back.data.map->system.contains("Azimuthal"));
    REQUIRE(back.data.positions.size() == 3);
    // 0.1 degrees of longitude, and a quarter of a degree of latitude.
    CHECK(back.data.positions[0].x == Approx(7130).epsilon(0.01));
    CHECK(back.data.positions[0].y == Approx(27800).epsilon(0.01));
  }
}

TEST_CASE("a map that is cut off is refused, or is a shorter map") {
  for (const std::string driver : {"GPKG", "FlatGeobuf"}) {
    const std::string file = map_of(driver, GdalSystem{});
    for (std::size_t size = 0; size < file.size(); size += 1 + size / 16) {
      const auto read = read_sample_bytes(std::string_view(file).substr(0, size), "a", {}, kAtVertices);
      if (read) continue;
      INFO(size);
      CHECK(read.error().code == ErrorCode::bad_input);
      CHECK(read.error().message().starts_with("a"));
    }
    CHECK_FALSE(is_for_gdal(std::string_view(file).substr(0, 6)));
  }
  CHECK_FALSE(map_by_gdal("{}", "GPKG", GdalSystem{}));
  CHECK_FALSE(geojson_by_gdal("nothing", "a", nullptr, nullptr));
}

TEST_CASE("reading a map is stopped") {
  const std::string file = map_of("FlatGeobuf", GdalSystem{});
  JobControl job;
  job.stop_at_look(1);
  CHECK_THROWS_AS(geojson_by_gdal(file, "a", nullptr, &job), Cancelled);
}
