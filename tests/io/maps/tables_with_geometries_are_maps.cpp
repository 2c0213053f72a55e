// SPDX-License-Identifier: GPL-3.0-or-later
// Tables with a column of WKT, or of WKB in digits: they give what the geometries alone give, with the other columns as
// properties.
#include <catch2/catch.hpp>

#include "core/io/format.h"
#include "core/io/maps/map_features.h"
#include "tests/io/checked_reading.h"

using namespace mes;
using mes::test::read_map;

namespace {

const std::string kWktSquare = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
const std::string kWktLine = "LINESTRING (9 9, 12 13)";

std::string table_row(const std::string& a, const std::string& b, const std::string& c, char separator) {
  return a + separator + b + separator + c + '\n';
}

std::string in_double_quotes(const std::string& text) {
  return '"' + text + '"';
}

std::string table_fault(std::string_view bytes) {
  const auto read = read_sample_bytes(bytes, "a");
  REQUIRE_FALSE(read.has_value());
  return read.error().message();
}

}  // namespace

TEST_CASE("a column of WKT is read as its geometries, whatever separates the columns") {
  const LoadedFile expected = read_map(kWktSquare + "\n" + kWktLine);
  const std::string square = in_double_quotes(kWktSquare);
  const std::string line = in_double_quotes(kWktLine);
  for (const char separator : {',', ';', '\t'}) {
    CAPTURE(separator);
    const std::string names = table_row("id", "WKT", "name", separator);
    for (const std::string& table :
         {names + table_row("1", square, "a", separator) + table_row("2", line, "b", separator),
          table_row("WKT", "x", "y", separator) + table_row(square, "1", "2", separator) +
              table_row(line, "3", "4", separator),
          table_row("1", "a", square, separator) + table_row("2", "b", line, separator),
          names + table_row("1", kWktSquare, "a (old", separator) + table_row("2", "", "no place", separator) +
              table_row("3", "NULL", "nor here", separator) + table_row("4", kWktLine, "b", separator),
          "\xEF\xBB\xBF" + names + "\r\n" +
              table_row("1", square, in_double_quotes("two\nlines, \"\"said\"\""), separator) +
              table_row("2", line, "", separator)}) {
      INFO(table);
      const LoadedFile file = read_map(table);
      CHECK(file.format == "geometry-table");
      CHECK(file.warnings == expected.warnings);
      CHECK(file.data.positions == expected.data.positions);
      CHECK(file.data.contours == expected.data.contours);
    }
  }
  CHECK(read_map("WKT\n" + kWktSquare + "\n" + kWktLine + "\n").data.positions == expected.data.positions);
  CHECK(read_map("name,g\na,SRID=4326;POINT (8 50)\nb,SRID=4326;POINT (9 50)\n").degrees.has_value());
}

TEST_CASE("a column of WKB in digits is read as its geometries") {
  const std::string point = "0101000000000000000000f03f0000000000000040";  // 1, 2
  const std::string other =
      "00000000014008000000000000"
      "4010000000000000";  // 3, 4, with the highest byte first
  const std::vector<Vec2> expected{{1, 2}, {3, 4}};
  CHECK(read_map("gid,the_geom\n1," + point + "\n2,\n3," + other + "\n").data.positions == expected);
  CHECK(read_map("\"" + point + "\";a\r\n\"" + other + "\";b\r\n").data.positions == expected);
  CHECK(table_fault("gid,the_geom\n1," + point + "\n2," + point.substr(2) + "\n").starts_with("a:3:"));
}

TEST_CASE("a fault of a geometry is at its line and column") {
  CHECK(table_fault("id;WKT\n1;" + kWktLine + "\n\"2\n\";foo\n") ==
        "a:4:3: expected a geometry such as POLYGON, found \"foo\"");
  CHECK(table_fault("id,WKT\n1,\"POLYGON ((0 0, 1 1, east 0))\"\n") == "a:2:24: expected a number, found \"east\"");
  CHECK(read_map("id,WKT\n1,\"" + kWktLine).data.positions ==
        read_map(kWktLine).data.positions);  // no quote at the end
}

TEST_CASE("tables of points stay tables of points") {
  for (const std::string table :
       {"x,y,kind\n1,2,POLYGON (old)\n3,4,POINT\n", "x,y\n1,2\n3,4\n", "1;2;Line (a)\n3;4;b\n"})
    CHECK(read_map(table).data.positions == std::vector<Vec2>{{1, 2}, {3, 4}});
}

TEST_CASE("the other columns are properties") {
  const auto features =
      geometry_table_features("id,area,g,name,name\n007,1.5,\"" + kWktLine + "\",\"say \"\"x\"\"\",S\xFC" +
                              "d\n8,-2e3,SRID=25832;POINT (1 2),,\n9,,NULL,null\n");
  REQUIRE(features.size() == 3);
  CHECK(features[0].keys == std::vector<std::string>{"id", "area", "name", "name_2"});
  CHECK(features[0].properties == R"("id":"007","area":1.5,"name":"say \"x\"","name_2":"Süd")");
  CHECK(features[0].text == "SRID=25832;" + kWktLine);
  CHECK(features[1].properties == R"("id":"8","area":-2e3,"name":null,"name_2":null)");
  CHECK(features[1].text == "SRID=25832;POINT (1 2)");
  CHECK(features[2].properties == R"("id":"9","area":null,"name":null)");
  CHECK(features[2].text == "GEOMETRYCOLLECTION EMPTY");
  const auto nameless = geometry_table_features("a\tPOINT (1 2)\t7\n");
  REQUIRE(nameless.size() == 1);
  CHECK(nameless[0].properties == R"("field_1":"a","field_3":7)");
  CHECK(geometry_table_features("x,y\n1,2\n").empty());
}
