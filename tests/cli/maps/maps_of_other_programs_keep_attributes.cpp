// SPDX-License-Identifier: GPL-3.0-or-later
// GeoPackages, FlatGeobufs, shapefiles and KML with attributes, written by ogr2ogr; and what the program writes, read
// by it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

constexpr const char* kParcels =
    R"({"type":"FeatureCollection","features":[)"
    R"({"type":"Feature","properties":{"name":"Süd","use":7,"area":1.5},"geometry":{"type":"Polygon","coordinates":)"
    R"([[[8.0,50.0],[8.003,50.0],[8.003,50.001],[8.0,50.001],[8.0,50.0]]]}},)"
    R"({"type":"Feature","properties":{"name":"say \"x\"","use":9,"area":null},"geometry":{"type":"Polygon",)"
    R"("coordinates":[[[8.01,50.0],[8.011,50.0],[8.0115,50.004],[8.0105,50.004],[8.01,50.0]]]}}]})";

/// Writes the parcels by ogr2ogr, in UTM zone 32.
std::string parcels_as(const TemporaryFolder& folder, const std::string& name,
                       const std::vector<std::string>& more = {}) {
  const std::string from = folder.write("parcels.geojson", kParcels).string();
  const std::string file = (folder / name).string();
  const RunResult made = run(with({"-t_srs", "EPSG:25832", file, from}, more), {.program = "ogr2ogr"});
  INFO(made.err);
  REQUIRE(made.exit_code == 0);
  return file;
}

/// The features of a file as ogr2ogr reads them, in longitude and latitude if they are on the Earth.
Json features_by_ogr(const std::string& file) {
  const RunResult read = run({"-f", "GeoJSON", "/vsistdout/", file}, {.program = "ogr2ogr"});
  INFO(read.err);
  REQUIRE(read.exit_code == 0);
  return Json::parse(read.out);
}

std::string told_by_ogr(const std::string& file) {
  const RunResult read = run({"-al", "-so", file}, {.program = "ogrinfo"});
  REQUIRE(read.exit_code == 0);
  return read.out;
}

Json made(const std::vector<std::string>& command) {
  const RunResult result = run(command);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return result.out.empty() ? Json{} : Json::parse(result.out);
}

std::string map_fault(int code, const std::vector<std::string>& command, const std::string& input = {}) {
  const RunResult result = run(command, {.input = input});
  INFO(result.err);
  CHECK(result.exit_code == code);
  CHECK(result.out.empty());
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  return result.err;
}

}  // namespace

TEST_CASE("the features of each kind of map keep their attributes") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.shp", "a.gpkg", "a.fgb"}) {
    INFO(name);
    const std::string file = parcels_as(folder, name);
    const Json lines = made({"centerline", file, "--each"});
    REQUIRE(lines["features"].size() == 2);
    std::vector<Json> by_use(2);
    for (const Json& feature : lines["features"]) by_use[feature["properties"]["use"] == 9 ? 1 : 0] = feature;
    CHECK(by_use[0]["properties"]["name"] == "Süd");
    CHECK(by_use[0]["properties"]["area"] == 1.5);
    CHECK(by_use[0]["id"].is_number());
    CHECK(by_use[1]["properties"]["name"] == "say \"x\"");
    // The strip is 0.001 degrees of latitude wide, which are 111.19 m in this zone, and the other is 0.004 high.
    CHECK(by_use[0]["properties"]["width_mean"].get<double>() == Approx(111.19).epsilon(1e-4));
    const Json& places = by_use[1]["geometry"]["coordinates"];
    for (const Json& place : places) {
      CHECK(std::abs(place[0].get<double>() - 8.01075) < 0.001);
      CHECK(std::abs(place[1].get<double>() - 50.002) < 0.002);
    }
    // A file whose features have numbers of their own keeps the ids as a property.
    for (const std::string again : {"lines.gpkg", "lines.fgb"}) {
      const std::string out = (folder / again).string();
      REQUIRE(run({"centerline", file, "--each", "-o", out, "--force"}).exit_code == 0);
      const RunResult read = run({"-q", "-f", "GeoJSON", "/vsistdout/", out}, {.program = "ogr2ogr"});
      REQUIRE(read.exit_code == 0);
      const Json written = Json::parse(read.out)["features"];
      REQUIRE(written.size() == 2);
      std::vector<Json> ids;
      for (const Json& feature : written) ids.push_back(feature["properties"]["feature_id"]);
      std::vector<Json> wanted;
      for (const Json& feature : lines["features"]) wanted.push_back(feature["id"]);
      // A FlatGeobuf may order its features by place.
      std::ranges::sort(ids);
      std::ranges::sort(wanted);
      CHECK(ids == wanted);
    }
    // Without --each the map is one document, in its own system.
    const Json computed = made({"compute", file, "--vertices", "--layers", "curve"});
    CHECK(computed["input"]["samples"] == 8);
    const Json apart = made({"centerline", parcels_as(folder, "b.geojson"), "--each"});
    for (const Json& feature : apart["features"])
      if (feature["properties"]["use"] == 9)
        CHECK(feature["properties"]["length"].get<double>() ==
              Approx(by_use[1]["properties"]["length"].get<double>()).epsilon(1e-4));
  }
}

TEST_CASE("columns have one type and one name in every format, whatever the values are") {
  // The width is whole, one integer does not fit into 64 bits, and a name differs from one of ours in case.
  const std::string parcel =
      R"({"type":"Feature","properties":{"Length":5,"big":123456789012345678901234567890,"text":"-1 \"2"},)"
      R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[1000,0],[1000,200],[0,200],[0,0]]]}})";
  const std::vector<std::string> command{"centerline", "-", "--each", "--exact", "--crs", "EPSG:25832"};
  const RunResult text = run(command, {.input = parcel});
  REQUIRE(text.exit_code == 0);
  CHECK_THAT(text.out, Catch::Contains(R"("Length":5,)") && Catch::Contains(R"("centerline_length":800.0,)") &&
                           Catch::Contains(R"("width_least":200.0,)") && Catch::Contains(R"("shape":1,)"));
  const TemporaryFolder folder;
  for (const char* const name : {"a.gpkg", "a.fgb"}) {
    const std::string file = (folder / name).string();
    REQUIRE(run(with(command, {"-o", file}), {.input = parcel}).exit_code == 0);
    const std::string told = told_by_ogr(file);
    for (const char* const column : {"centerline_length", "width_least", "width_mean", "width_largest"})
      CHECK_THAT(told, Catch::Contains(std::string(column) + ": Real"));
    for (const char* const column : {"Length", "shape", "line"})
      CHECK_THAT(told, Catch::Contains(std::string(column) + ": Integer"));
    const Json back = features_by_ogr(file)["features"][0]["properties"];
    CHECK(back["big"] == "123456789012345678901234567890");
    CHECK(back["text"] == "-1 \"2");
  }
}

TEST_CASE("cells have the attributes of their points, in a box and within an outline") {
  // A county with wells in it: two single ones, one of several points, and one that lies on another.
  Json features = Json::array();
  const auto add = [&](const Json& id, const Json& properties, const Json& geometry) {
    features.push_back({{"type", "Feature"}, {"id", id}, {"properties", properties}, {"geometry", geometry}});
  };
  const Json county = Json::array({{10.0, 50.0}, {10.1, 50.0}, {10.1, 50.1}, {10.0, 50.1}, {10.0, 50.0}});
  add("a", {{"name", "A"}, {"Area", 3}}, {{"type", "Point"}, {"coordinates", {10.02, 50.03}}});
  add("b", {{"name", "B"}}, {{"type", "MultiPoint"}, {"coordinates", {{10.07, 50.02}, {10.03, 50.08}}}});
  const std::size_t outline = features.size();
  add("county", {{"name", "county"}}, {{"type", "Polygon"}, {"coordinates", Json::array({county})}});
  add("c", {{"name", "C"}}, {{"type", "Point"}, {"coordinates", {10.06, 50.06}}});
  add("d", {{"name", "D"}}, {{"type", "Point"}, {"coordinates", {10.06, 50.06}}});
  const TemporaryFolder folder;
  const auto file_of = [&](const char* name, const Json& of) {
    return folder.write(name, Json{{"type", "FeatureCollection"}, {"features", of}}.dump()).string();
  };
  Json wells = features;
  wells.erase(outline);
  const std::vector<std::pair<std::string, std::string>> cases{{file_of("county.geojson", features), "outline"},
                                                               {file_of("wells.geojson", wells), "box"}};
  for (const auto& [file, region] : cases) {
    INFO(region);
    const RunResult result = run({"export", file, "--cells", region, "--format", "geojson"});
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, Catch::Contains("1 sample lies on another one, and shares its cell"));
    const Json cells = Json::parse(result.out)["features"];
    REQUIRE(cells.size() == 4);
    const std::vector<std::string> ids{"a", "b", "b", "c"};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      CHECK(cells[i]["id"] == ids[i]);
      const Json& properties = cells[i]["properties"];
      CHECK(properties["sample"] == i);
      CHECK(properties["cell_area"].get<double>() > 0.0);
      CHECK(properties["name"].get<std::string>() == std::string(1, static_cast<char>(ids[i][0] - 'a' + 'A')));
    }
    CHECK(cells[0]["properties"]["Area"] == 3);
    CHECK(cells[2]["properties"]["center"][1].get<double>() == Approx(50.08));
    const std::string package = (folder / (region + ".gpkg")).string();
    REQUIRE(run({"export", file, "--cells", region, "--format", "gpkg", "-o", package}).exit_code == 0);
    const Json back = features_by_ogr(package)["features"];
    REQUIRE(back.size() == 4);
    CHECK(back[3]["properties"]["feature_id"] == "c");
  }
}

TEST_CASE("a web map has widths in metres, and its lines are in its own system") {
  const TemporaryFolder folder;
  const Json expected = made({"centerline", parcels_as(folder, "a.gpkg"), "--each", "--exact"});
  const std::string web = parcels_as(folder, "web.gpkg", {"-t_srs", "EPSG:3857"});
  const std::string lines = (folder / "lines.gpkg").string();
  made({"centerline", web, "--each", "--exact", "-o", lines});
  CHECK_THAT(told_by_ogr(lines), Catch::Contains("Pseudo-Mercator"));
  const Json given = features_by_ogr(lines)["features"];
  REQUIRE(given.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& wanted = expected["features"][i];
    for (const std::string key : {"length", "width_largest"})
      CHECK(given[i]["properties"][key].get<double>() ==
            Approx(wanted["properties"][key].get<double>()).epsilon(1e-3));   // a grid has the factor 0.9996
    constexpr double kMetresOfDegree = 6378137.0 * std::numbers::pi / 180.0;  // along the equator
    CHECK(given[i]["geometry"]["coordinates"][0][0].get<double>() ==
          Approx(kMetresOfDegree * wanted["geometry"]["coordinates"][0][0].get<double>()).margin(1.0));
  }
  // Whole, and with the coordinates kept.
  const auto totals = [&](const std::vector<std::string>& more) {
    return run(with({"centerline", web, "--exact", "-o", (folder / "o.wkt").string()}, more)).err;
  };
  CHECK_THAT(totals({}), Catch::Contains("EPSG:3857) are projected to metres about 8.0"));
  CHECK_THAT(totals({"--degrees"}), Catch::Contains("lengths differ from those on the Earth by up to 56 %"));
}

TEST_CASE("the rows of a table with WKT keep their columns") {
  const TemporaryFolder folder;
  const Json expected = made({"centerline", parcels_as(folder, "a.gpkg"), "--each"});
  for (const std::string separator : {"COMMA", "SEMICOLON", "TAB"}) {
    INFO(separator);
    const std::string file = parcels_as(folder, separator + ".csv",
                                        {"-f", "CSV", "-lco", "GEOMETRY=AS_WKT", "-lco", "SEPARATOR=" + separator});
    const Json lines = made({"centerline", file, "--each", "--crs", "EPSG:25832"});
    REQUIRE(lines["features"].size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      const Json& given = lines["features"][i]["properties"];
      const Json& wanted = expected["features"][i]["properties"];
      for (const std::string key : {"name", "use", "area"}) CHECK(given[key] == wanted[key]);
      CHECK(given["length"].get<double>() == Approx(wanted["length"].get<double>()).epsilon(1e-6));
    }
  }
}

TEST_CASE("the placemarks of a KML keep their attributes") {
  const TemporaryFolder folder;
  const std::string from = folder.write("parcels.geojson", kParcels).string();
  for (const std::string driver : {"KML", "LIBKML"}) {
    INFO(driver);
    const std::string file = (folder / (driver + ".kml")).string();
    REQUIRE(run({"-f", driver, file, from}, {.program = "ogr2ogr"}).exit_code == 0);
    const Json lines = made({"centerline", file, "--each"});
    const Json expected = made({"centerline", from, "--each"});
    REQUIRE(lines["features"].size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      const Json& given = lines["features"][i]["properties"];
      CHECK(given["name"] == expected["features"][i]["properties"]["name"]);
      CHECK(given["use"] == expected["features"][i]["properties"]["use"]);
      CHECK(given["length"].get<double>() ==
            Approx(expected["features"][i]["properties"]["length"].get<double>()).epsilon(1e-6));
      CHECK(lines["features"][i].contains("id"));
    }
    CHECK(lines["features"][0]["properties"]["area"] == 1.5);
    const std::string written = (folder / (driver + ".gpkg")).string();
    made({"centerline", file, "--each", "-o", written});
    CHECK(features_by_ogr(written)["features"][0]["properties"]["use"] == 7);
  }

  const auto strip = [](const std::string& east) {
    return "<Polygon><outerBoundaryIs><LinearRing><coordinates>" + east + "0,50 " + east + "4,50 " + east +
           "4,50.1 " + east + "0,50.1 " + east + "0,50</coordinates></LinearRing></outerBoundaryIs></Polygon>";
  };
  const std::string kml =
      R"(<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document>)"
      R"(<Schema id="s"><SimpleField type="int" name="lanes"/><SimpleField type="bool" name="open"/>)"
      R"(<SimpleField type="double" name="depth"/></Schema><Folder>)"
      R"(<Placemark id="a"><name> Isar &amp; "co" </name><description><![CDATA[<b>wide</b>]]></description>)"
      R"(<TimeSpan><begin>1998</begin></TimeSpan><ExtendedData><Data name="name"><value>second</value></Data>)"
      R"(<Data name="length"><displayName>x</displayName><value>007</value></Data>)"
      R"(<SchemaData schemaUrl="#s"><SimpleData name="lanes">2</SimpleData><SimpleData name="open">1</SimpleData>)"
      R"(<SimpleData name="depth">deep</SimpleData><SimpleData name="other">3</SimpleData></SchemaData>)"
      R"(<camp:site>14</camp:site></ExtendedData>)" +
      strip("8.") + "</Placemark><Placemark><name>nothing</name></Placemark><Placemark><name>S\xFC" + "d</name>" +
      strip("9.") + "</Placemark></Folder></Document></kml>";
  const RunResult apart = run({"centerline", "-", "--each", "--branches", "1"}, {.input = kml});
  INFO(apart.err);
  REQUIRE(apart.exit_code == 1);
  CHECK_THAT(apart.err, Catch::Contains("-: feature 2: there is nothing in it to take samples of"));
  const Json lines = Json::parse(apart.out)["features"];
  REQUIRE(lines.size() == 2);
  CHECK(lines[0]["id"] == "a");
  Json given = lines[0]["properties"];
  CHECK(given["centerline_length"].get<double>() > 10'000.0);
  for (const char* const measured :
       {"centerline_length", "shape", "line", "width_least", "width_mean", "width_largest"})
    given.erase(measured);
  CHECK(given == Json{{"name", "Isar & \"co\""},
                      {"description", "<b>wide</b>"},
                      {"begin", "1998"},
                      {"name_2", "second"},
                      {"length", "007"},
                      {"lanes", 2},
                      {"open", true},
                      {"depth", "deep"},
                      {"other", "3"},
                      {"site", "14"}});
  CHECK(lines[1]["id"] == 3);
  CHECK(lines[1]["properties"]["name"] == "Süd");
  CHECK(lines[1]["geometry"]["coordinates"][0][0].get<double>() > 9.0);
}

TEST_CASE("the geometries of WKT are numbered, and one that is wrong is named") {
  const std::string text =
      "SRID=25832;POLYGON ((500000 5500000, 500800 5500000, 500800 5500200, 500000 5500200, 500000 5500000))\n"
      "POLYGN ((0 0, 1 0, 1 1, 0 0))\n"
      "POLYGON EMPTY\n"
      "POLYGON\n  ((501000 5500000, 501300 5500000, 501300 x, 501000 5500000))\n"
      "CURVEPOLYGON (COMPOUNDCURVE ((502000 5500000, 502800 5500000), CIRCULARSTRING (502800 5500000, 502900 "
      "5500100, "
      "502800 5500200), (502800 5500200, 502000 5500200, 502000 5500000)));"
      "MULTIPOLYGON Z (((503000 5500000 1, 503800 5500000 1, 503800 5500200 1, 503000 5500200 1, 503000 5500000 1)),"
      "((505000 5500000 1, 505800 5500000 1, 505800 5500200 1, 505000 5500200 1, 505000 5500000 1)))\n"
      "POLYGON ((1 2";
  const RunResult apart = run({"centerline", "-", "--each", "--extend"}, {.input = text});
  INFO(apart.err);
  REQUIRE(apart.exit_code == 1);
  CHECK_THAT(apart.err, Catch::Contains("feature 2: expected a geometry such as POLYGON, found \"POLYGN\"") &&
                            Catch::Contains("feature 3: there is nothing in it to take samples of") &&
                            Catch::Contains("feature 4: expected a number, found \"x\"") &&
                            Catch::Contains("feature 7: "));
  const Json lines = Json::parse(apart.out)["features"];
  std::vector<int> ids;
  for (const Json& line : lines) ids.push_back(line["id"]);
  CHECK(ids == std::vector<int>{1, 5, 6, 6});
  // UTM zone 32 has 9 degrees east at 500 km.
  for (const Json& line : lines)
    CHECK(line["geometry"]["coordinates"][0][0].get<double>() == Approx(9.0).margin(0.1));
  CHECK(lines[0]["properties"]["length"].get<double>() == Approx(800.0).epsilon(1e-3));
  CHECK(lines[1]["properties"]["length"].get<double>() == Approx(900.0).epsilon(1e-2));
  // Text that does not begin as WKT is not taken apart, though it may have as many lines as it likes.
  for (const char* const other : {"\x01\x02 (((\n\n(((", "[[1, 2],\n[3, 4]]", ""})
    CHECK_THAT(map_fault(3, {"centerline", "-", "--each", "--from", "wkt"}, other), Catch::Contains("no features"));
}

TEST_CASE("a GeoPackage may have several layers, tables without geometries and curves") {
  const TemporaryFolder folder;
  const std::string file = parcels_as(folder, "a.gpkg", {"-nln", "first"});
  parcels_as(folder, "a.gpkg", {"-update", "-nln", "second layer", "-nlt", "MULTISURFACE"});
  parcels_as(folder, "a.gpkg", {"-update", "-nln", "table", "-nlt", "NONE"});
  CHECK(made({"centerline", file, "--each"})["features"].size() == 4);
  const std::string other = parcels_as(folder, "a.gpkg", {"-update", "-nln", "third", "-t_srs", "EPSG:32633"});
  CHECK_THAT(map_fault(3, {"compute", other}), Catch::Contains("EPSG:32633"));
}

TEST_CASE("GeoPackages and FlatGeobufs are written in the system of the map") {
  const TemporaryFolder folder;
  const std::string map = parcels_as(folder, "parcels.gpkg");
  const std::string drawing = folder.write("strip.wkt", "POLYGON ((0 0, 800 0, 800 200, 0 200, 0 0))").string();
  for (const std::string extension : {"gpkg", "fgb"}) {
    INFO(extension);
    const auto named = [&](const std::string& name) { return (folder / (name + "." + extension)).string(); };
    made({"centerline", map, "--each", "-o", named("lines")});
    CHECK_THAT(told_by_ogr(named("lines")), Catch::Contains("EPSG\",25832"));
    const Json lines = features_by_ogr(named("lines"));
    const Json expected = made({"centerline", map, "--each"});
    REQUIRE(lines["features"].size() == 2);
    for (const Json& feature : lines["features"]) {
      const Json& same =
          expected["features"][feature["properties"]["use"] == expected["features"][0]["properties"]["use"] ? 0 : 1];
      CHECK(feature["properties"]["name"] == same["properties"]["name"]);
      CHECK(feature["properties"]["length"].get<double>() == Approx(same["properties"]["length"].get<double>()));
      REQUIRE(feature["geometry"]["coordinates"].size() == same["geometry"]["coordinates"].size());
    }
    CHECK(contents_of(named("lines")) == [&] {
      made({"centerline", map, "--each", "-o", named("again")});
      return contents_of(named("again"));
    }());

    // Layers, areas and cells; of a drawing too, which is nowhere on the Earth.
    made({"export", map, "--layer", "curve,points", "--format", extension, "-o", named("layers")});
    CHECK_THAT(told_by_ogr(named("layers")), Catch::Contains("EPSG\",25832") && Catch::Contains("kind: String"));
    const std::vector<std::string> disks{"export", map, "--layer", "interior-voronoi-disks", "--format"};
    made(with(disks, {extension + "-areas", "-o", named("areas")}));
    const std::size_t count = made(with(disks, {"geojson-areas"}))["features"].size();
    CHECK(count > 100);
    CHECK(features_by_ogr(named("areas"))["features"].size() == count);
    made({"export", map, "--vertices", "--cells", "outline", "--format", extension, "-o", named("cells")});
    CHECK(features_by_ogr(named("cells"))["features"].size() == 8);
    // Centres are attributes, in metres of the zone as the geometry is: east of its middle at 500 km lies 9 E.
    const auto check_centers = [&](const std::string& name) {
      std::size_t centers = 0;
      const Json read = features_by_ogr(named(name));
      for (const Json& feature : read["features"]) {
        const Json& given = feature["properties"]["center"];
        const Json center = given.is_string() ? Json::parse(given.get<std::string>()) : given;
        CHECK(center[0].get<double>() == Approx(429'000.0).margin(2000.0));
        CHECK(center[1].get<double>() == Approx(5'539'000.0).margin(1000.0));
        ++centers;
      }
      CHECK(centers > 0);
    };
    check_centers("cells");
    check_centers("areas");
    made({"centerline", drawing, "-o", named("strip")});
    CHECK_THAT(told_by_ogr(named("strip")), !Catch::Contains("EPSG\",4326"));
    const Json strip = features_by_ogr(named("strip"));
    REQUIRE(strip["features"].size() == 1);
    for (const Json& place : strip["features"][0]["geometry"]["coordinates"])
      CHECK(place[1].get<double>() == Approx(100.0).margin(0.1));
    // The program reads what it has written.
    const Json back = made({"compute", named("strip"), "--vertices", "--layers", "points"});
    CHECK(back["input"]["samples"] == strip["features"][0]["geometry"]["coordinates"].size());
  }
}

TEST_CASE("a DXF in space has heights for others") {
  const TemporaryFolder folder;
  const std::string strip = folder.write("strip.wkt", "POLYGON ((0 0, 800 0, 800 200, 0 200, 0 0))").string();
  const std::string file = (folder / "strip.dxf").string();
  made({"centerline", strip, "--format", "dxf-3d", "-o", file});
  CHECK_THAT(told_by_ogr(file), Catch::Contains("Feature Count: 1"));
  const Json places = features_by_ogr(file)["features"][0]["geometry"]["coordinates"];
  REQUIRE(places.size() > 1);
  for (const Json& place : places) CHECK(place[2].get<double>() == Approx(100.0).margin(0.1));
}

TEST_CASE("a shapefile that is cut short or lacks what belongs beside it is one line") {
  const TemporaryFolder folder;
  const std::string file = parcels_as(folder, "a.shp");
  const std::string shapes = contents_of(file);
  const std::string system = contents_of(folder / "a.prj");
  const std::vector<std::string> command{"centerline", file, "--each"};
  folder.write("a.shp", shapes.substr(0, shapes.size() - 60));
  CHECK_THAT(map_fault(3, command),
             Catch::Contains("a.shp: the file ends at byte " + std::to_string(shapes.size() - 60) +
                             ", and its header tells of " + std::to_string(shapes.size())));
  folder.write("a.shp", shapes);
  folder.write("a.prj", "garbage");
  CHECK_THAT(map_fault(3, command), Catch::Contains("a.prj:1:1: this is not the well-known text"));
  CHECK(run(with(command, {"--crs", "EPSG:25832"})).exit_code == 0);
  folder.write("a.prj", "PROJCS[\"of nowhere\"]");
  CHECK_THAT(map_fault(3, command), Catch::Contains("a.prj: "));
  folder.write("a.prj", "");
  const RunResult plain = run(command);
  CHECK(plain.exit_code == 0);
  CHECK_THAT(plain.err, Catch::Contains("a.prj: the file is empty; coordinates are taken as they are"));
  folder.write("a.prj", system);
  CHECK(run(command).exit_code == 0);
  std::filesystem::remove(folder / "a.shx");
  CHECK_THAT(map_fault(3, command), Catch::Contains("a.shp: its attributes cannot be read without the .shx file"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}, shapes),
             Catch::Contains("-: the attributes of a shapefile"));
}

TEST_CASE("a GeoPackage keeps properties whose names it uses itself") {
  const TemporaryFolder folder;
  const std::string out = (folder / "stations.gpkg").string();
  const std::string parcel =
      R"({"type":"Feature","properties":{"id":7,"FID":"P-17","geom":null},"geometry":)"
      R"({"type":"Polygon","coordinates":[[[8,47],[8.01,47],[8.01,47.003],[8,47.003],[8,47]]]}})";
  const RunResult written = run({"centerline", "-", "--each", "--every", "100", "-o", out}, {.input = parcel});
  INFO(written.err);
  REQUIRE(written.exit_code == 0);
  const Json stations = features_by_ogr(out)["features"];
  REQUIRE(stations.size() > 2);
  double before = -1.0;
  for (const Json& station : stations) {
    const Json& properties = station["properties"];
    CHECK(properties["id"] == 7);
    CHECK(properties["FID"] == "P-17");
    CHECK(properties["geom"].is_null());
    CHECK(properties["station"].get<double>() > before);
    before = properties["station"].get<double>();
  }
  // The names are the usual ones where no property has them.
  const std::string plain = (folder / "plain.gpkg").string();
  REQUIRE(run({"centerline", parcels_as(folder, "a.fgb"), "-o", plain}).exit_code == 0);
  CHECK_THAT(told_by_ogr(plain), Catch::Contains("FID Column = fid") && Catch::Contains("Geometry Column = geom"));
}

TEST_CASE("a map that GDAL cannot read is one line") {
  const TemporaryFolder folder;
  const std::string package = contents_of(parcels_as(folder, "a.gpkg"));
  const std::string flat = contents_of(parcels_as(folder, "a.fgb"));
  const std::string shapes = contents_of(parcels_as(folder, "a.shp"));
  for (const std::size_t size : {std::size_t{100}, std::size_t{5000}, package.size() / 2}) {
    const std::string file = folder.write("cut.gpkg", package.substr(0, size)).string();
    CHECK_THAT(map_fault(3, {"compute", file}), Catch::Contains("cut.gpkg: "));
    CHECK_THAT(map_fault(3, {"centerline", file, "--each"}), Catch::Contains("cut.gpkg: "));
  }
  for (std::size_t size = 8; size < flat.size(); size += flat.size() / 7)
    CHECK_THAT(map_fault(3, {"compute", "-"}, flat.substr(0, size)), Catch::Contains("-: ") &&
                                                                         !Catch::Contains("no layer of the map") &&
                                                                         !Catch::Contains("nothing in it"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}, shapes), Catch::Contains("-: "));
  const std::string garbage = folder.write("garbage.gpkg", "garbage\x01\x02").string();
  CHECK_THAT(map_fault(3, {"compute", garbage}),
             Catch::Contains("cannot read the map") && !Catch::Contains("vsimem"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}, "1 2\n3 4\n"), Catch::Contains("GeoPackages"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}, "<kml><Placemark></kml>"), Catch::Contains("-:1:"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}, "<kml></kml>"), Catch::Contains("no features"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}), Catch::Contains("the file is empty"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}, R"({"type":"Topology","objects":{},"arcs":[]})"),
             Catch::Contains("TopoJSON"));
  CHECK_THAT(map_fault(3, {"centerline", "-", "--each"}, R"({"type":"FeatureCollection","features":[]} xyz)"),
             Catch::Contains("-:1:") && Catch::Contains("this is not JSON"));
  const std::string both = folder.write("strip.wkt", "POLYGON ((0 0, 800 0, 800 200, 0 200, 0 0))").string();
  CHECK_THAT(map_fault(2, {"export", both, "--layer", "points", "--format", "gpkg-areas"}),
             Catch::Contains("points"));
}
