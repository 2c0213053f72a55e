// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/io/format.h"
#include "temporary_folder.h"

using namespace mes;

namespace {

struct MalformedFile {
  std::string name;  ///< of the file: its extension counts
  std::string bytes;
  std::uint64_t line;
  std::uint64_t column;
  std::string says;  ///< part of the message
};

void require_refused_file(const MalformedFile& test) {
  INFO(test.name << ", expected to say: " << test.says);
  const auto read = read_sample_bytes(test.bytes, test.name);
  REQUIRE_FALSE(read.has_value());
  const Error& error = read.error();
  INFO(error.message());
  CHECK(error.code == ErrorCode::bad_input);
  CHECK(error.file == test.name);
  CHECK(error.line == test.line);
  CHECK(error.column == test.column);
  CHECK_THAT(error.text, Catch::Contains(test.says));
  // One printable line, however large the mistake is.
  CHECK(error.text.size() < 300);
  for (const char c : error.text) CHECK((static_cast<unsigned char>(c) >= 0x20 && c != 0x7f));
}

std::string with_nul(const char* before, const char* after) {
  return std::string(before) + '\0' + after;
}

}  // namespace

TEST_CASE("POFF files that are wrong are refused where they are wrong") {
  const std::string long_word(1'000'000, 'x');
  const std::string long_digits(1'000'000, '7');
  const std::vector<MalformedFile> cases{
      {"a.poff", "", 1, 1, "empty"},
      {"a.poff", " \n\t\r\n", 1, 1, "empty"},
      {"a.poff", "# only this\n", 2, 1, "expected \"POFF\", found the end"},
      {"a.poff", "PUFF 3 0 0\n", 1, 1, "expected \"POFF\", found \"PUFF\""},
      {"a.poff", "POFFS 3 0 0\n", 1, 1, "found \"POFFS\""},
      {"a.poff", "poff 1 0 0\n1 2\n", 1, 1, "found \"poff\""},
      {"a.poff", "POFF", 1, 5, "number of points, found the end"},
      {"a.poff", "POFF -3 0 0\n", 1, 6, "found \"-3\""},
      {"a.poff", "POFF 2.5 0 0\n", 1, 6, "found \"2.5\""},
      {"a.poff", "POFF 99999999999999999999 0 0\n", 1, 6, "points are announced"},
      {"a.poff", "POFF 4294967295 0 0\n", 1, 6, "points are announced"},
      {"a.poff", "POFF 4000000000 0 0\n1 2\n", 3, 1, "after 2 of 8000000000 coordinates"},
      {"a.poff", "POFF 3 0\n", 2, 1, "two integers"},
      {"a.poff", "POFF 3 0 zero\n", 1, 10, "found \"zero\""},
      {"a.poff", "POFF 2 0 0\n1 2\n3", 3, 2, "after 3 of 4 coordinates"},
      {"a.poff", "POFF 2 0 0\n1 2\n3 4x\n", 3, 3, "found \"4x\""},
      {"a.poff", "POFF 2 0 0\r\n1 2\r\n3 ,4\r\n", 3, 3, "found \",4\""},
      {"a.poff", "POFF 2 0 0\r1 2\r3 y\r", 3, 3, "found \"y\""},
      {"a.poff", "\xEF\xBB\xBFPOFF x", 1, 6, "found \"x\""},
      {"a.poff", "POFF 1 0 0\nnan 2\n", 2, 1, "\"nan\" is not a finite number"},
      {"a.poff", "POFF 1 0 0\n1 -inf\n", 2, 3, "\"-inf\" is not a finite number"},
      {"a.poff", "POFF 1 0 0\n1 INFINITY\n", 2, 3, "not a finite number"},
      {"a.poff", "POFF 1 0 0\n1 1e309\n", 2, 3, "\"1e309\" is too large"},
      {"a.poff", "POFF 1 0 0\n1 -2e999999999999999999999\n", 2, 3, "too large"},
      {"a.poff", "POFF 1 0 0\n0x10 1\n", 2, 1, "found \"0x10\""},
      {"a.poff", "POFF 1 0 0\n1,5 1\n", 2, 1, "found \"1,5\""},
      {"a.poff", "POFF 1 0 0\n+ 1\n", 2, 1, "found \"+\""},
      {"a.poff", "POFF 1 0 0\n+-1 1\n", 2, 1, "found \"+-1\""},
      {"a.poff", "POFF 1 0 0\n1 2e\n", 2, 3, "found \"2e\""},
      {"a.poff", "POFF 1 0 0\n1 " + long_word, 2, 3, "(1000000 characters)"},
      {"a.poff", "POFF 1 0 0\n1 " + long_digits, 2, 3, "too large"},
      {"a.poff", "POFF " + long_digits + " 0 0", 1, 6, "points are announced"},
      {"a.poff", long_word, 1, 1, "(1000000 characters)"},
      {"a.poff", "POFF 1 0 0\n1 \x01\x02\x7f\n", 2, 3, "\"\\x01\\x02\\x7f\""},
      {"a.poff", "POFF 1 0 0\n1 \xff\xc3\x28\n", 2, 3, "\\xff\\xc3("},
      {"a.poff", "POFF 1 0 0\n1 \xc2\x9b\n", 2, 3, "\\xc2\\x9b"},
      {"a.poff", with_nul("POFF 1 0 0\n1 ", " 2\n"), 1, 1, "binary data"},
      {"a.poff", "GIF89a", 1, 1, "GIF picture"},
      {"a.poff", "\xff\xfeP\x01O\x01", 1, 1, "UTF-16 text, which must be saved as UTF-8"},
      {"a.poff", std::string("P\0O\0F\0F\0", 8), 1, 1, "UTF-16 text, which must be saved as UTF-8"},
      {"a.svg", std::string("\0<\0s\0v\0g", 8), 1, 1, "UTF-16 text, which must be saved as UTF-8"},
      {"a.poff", std::string("\0\0O\0F\0F\0", 8), 1, 1, "binary data"},
      {"a.poff", std::string(64, '\0'), 1, 1, "binary data"},
  };
  for (const MalformedFile& test : cases) require_refused_file(test);
}

TEST_CASE("WPOFF files that are wrong are refused where they are wrong") {
  const std::string long_word(1'000'000, 'x');
  const std::vector<MalformedFile> cases{
      {"a.wpoff", "", 1, 1, "empty"},
      {"a.wpoff", "# only this\n", 2, 1, "expected \"WPOFF\", found the end"},
      {"a.wpoff", "wpoff 1 0 0\n1 2 3\n", 1, 1, "found \"wpoff\""},
      {"a.wpoff", "WPOFF", 1, 6, "number of balls, found the end"},
      {"a.wpoff", "WPOFF many 0 0\n", 1, 7, "found \"many\""},
      {"a.wpoff", "WPOFF -1 0 0\n", 1, 7, "found \"-1\""},
      {"a.wpoff", "WPOFF 4294967295 0 0\n", 1, 7, "balls are announced"},
      {"a.wpoff", "WPOFF 4000000000 0 0\n1 2 3\n", 3, 1, "after 3 of 12000000000 numbers"},
      {"a.wpoff", "WPOFF 1 0\n", 2, 1, "two integers"},
      {"a.wpoff", "WPOFF 1 0.5 0\n1 2 3\n", 1, 9, "found \"0.5\""},
      {"a.wpoff", "WPOFF 2 0 0\n1 2 3\n4 5", 3, 4, "after 5 of 6 numbers"},
      // Radii forgotten: a file of points under the wrong name.
      {"a.wpoff", "WPOFF 2 0 0\n1 2\n4 5\n", 2, 4, "2 numbers a line, but balls have 3: probably points"},
      {"a.wpoff", "WPOFF 1 0 0\n1 2 nan\n", 2, 5, "\"nan\" is not a finite number"},
      {"a.wpoff", "WPOFF 1 0 0\n1 inf 3\n", 2, 3, "\"inf\" is not a finite number"},
      {"a.wpoff", "WPOFF 1 0 0\n1 2 1e309\n", 2, 5, "too large"},
      {"a.wpoff", "WPOFF 2 0 0\n1 2 3\n4 5 -6\n", 3, 5, "radius is negative: \"-6\""},
      {"a.wpoff", "WPOFF 1 0 0\n1 2 -5e-24\n", 2, 5, "radius is negative"},
      {"a.wpoff", "WPOFF 1 0 0\n1 2 3,5\n", 2, 5, "found \"3,5\""},
      {"a.wpoff", "WPOFF 1 0 0\n1 2 " + long_word, 2, 5, "(1000000 characters)"},
      {"a.wpoff", with_nul("WPOFF 1 0 0\n1 2 ", " 3\n"), 1, 1, "binary data"},
  };
  for (const MalformedFile& test : cases) require_refused_file(test);
}

TEST_CASE("tables that are wrong are refused where they are wrong") {
  const std::string long_word(1'000'000, 'x');
  const std::vector<MalformedFile> cases{
      {"a.csv", "", 1, 1, "empty"},
      {"a.csv", "# nothing\n", 1, 1, "no samples"},
      {"a.csv", "x,y\n1,2\n3\n", 3, 2, "number for y, found the end of the line"},
      {"a.csv", "x,y\n1,2\n3,\n", 3, 3, "number for y, found nothing"},
      {"a.csv", "x,y\n1,2\n,3\n", 3, 1, "number for x, found nothing"},
      {"a.csv", "x,y\n1,2\n3,four\n", 3, 3, "found \"four\""},
      {"a.csv", "x,y\n1,2\n\n# c\n3,  four\n", 5, 5, "found \"four\""},
      {"a.csv", "1,two\n3,4\n", 1, 3, "found \"two\""},
      {"a.csv", "x,y\none,2\n", 2, 1, "found \"one\""},
      {"a.csv", "id,x,y\n7,1,2\n8,1,oops\n", 3, 5, "found \"oops\""},
      {"a.csv", "x,y\r\n1,2\r\n3,4e400\r\n", 3, 3, "too large"},
      {"a.csv", "1,2\nnan,3\n", 2, 1, "not a finite number"},
      {"a.csv", "nan,nan\n1,2\n", 1, 1, "not a finite number"},
      {"a.csv", "1;2\n1,5;2,5;\n1.000,5;3\n", 3, 1, "found \"1.000,5\""},
      {"a.csv", "1,2\n" + long_word + ",3\n", 2, 1, "(1000000 characters)"},
      {"a.csv", "\"1\",\"2\"\n\"1\",\"2", 2, 5, "expected a number"},
      {"a.tsv", "1\t2\n3\tb\n", 2, 3, "found \"b\""},
      {"a.xyz", "1 2 3\n4\n", 2, 2, "number for y, found the end of the line"},
      {"a.xyz", "1 2 3\n4 1e999 0\n", 2, 3, "too large"},
      {"a.txt", "1 2\nhello\n", 2, 1, "found \"hello\""},
      {"a.txt", "hello\n", 1, 1, "found \"hello\""},
      {"a.txt", "5\n6\n7\n", 1, 2, "number for y, found the end of the line"},
      {"a.txt", "1 2\n3 4,5\n", 2, 3, "found \"4,5\""},
      {"notes", "Dear all,\nplease find enclosed\n", 1, 1, "none of the formats"},
  };
  for (const MalformedFile& test : cases) require_refused_file(test);
}

TEST_CASE("maps that are wrong are refused where they are wrong") {
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "GEOMETRYCOLLECTION(";
  const std::vector<MalformedFile> cases{
      {"a.wkt", "POINT", 1, 6, "expected \"(\" or EMPTY, found the end"},
      {"a.wkt", "POINT (", 1, 8, "expected a number, found the end"},
      {"a.wkt", "POINT (1)", 1, 9, "expected a number, found \")\""},
      {"a.wkt", "POINT (1 2", 1, 11, "expected \",\" or \")\", found the end"},
      {"a.wkt", "POINT (1 2 3 4 5)", 1, 16, "found \"5\""},
      {"a.wkt", "POINT (1 x)", 1, 10, "found \"x\""},
      {"a.wkt", "LINESTRING (0 0,\r\n 1 nan)", 2, 4, "not a finite number"},
      {"a.wkt", "LINESTRING (0 0,\n 1 1e999)", 2, 4, "too large"},
      {"a.wkt", "LINESTRING (0 0, , 1 1)", 1, 18, "expected a number, found \",\""},
      {"a.wkt", "POLYGON (0 0, 1 0, 1 1)", 1, 10, "expected \"(\" or EMPTY"},
      {"a.wkt", "POLYGON ((0 0, 1 0, 1 1)) nonsense", 1, 27,
       "expected a geometry such as POLYGON, found \"nonsense\""},
      {"a.wkt", "CIRCULARSTRING (0 0, 1 0, 1 1, 2 2)", 1, 16, "three positions, or two more for each other arc"},
      {"a.wkt", "POINT EMPTY", 1, 1, "nothing in it"},
      {"a.wkt", "SRID=many;POINT (1 2)", 1, 6, "found \"many\""},
      {"a.wkt", "SRID=4326 POINT (1 2)", 1, 11, "expected \";\""},
      {"a.wkt", deep, 1, 65 * 19 + 1, "nested too deeply"},
      {"a.geojson", "{\"type\": \"Point\"}", 1, 1, "list of \"coordinates\""},
      {"a.geojson", "{\"type\": \"Point\", \"coordinates\": [1, 2", 1, 39, "not JSON"},
      {"a.geojson", "{\"type\": \"Point\",\n \"coordinates\": [1]}", 2, 17, "two numbers"},
      {"a.geojson", "{\"type\": \"Point\",\n \"coordinates\": [1, \"2\"]}", 2, 21, "expected a number"},
      {"a.geojson", "{\"type\": \"Point\", \"coordinates\": [1, 1e400]}", 1, 38, "too large"},
      {"a.geojson", "{\"type\": \"Point\", \"coordinates\": [1, 1e200]}", 1, 38, "too large"},
      {"a.geojson", "{\"type\": \"Point\", \"coordinates\": []}", 1, 1, "nothing in it"},
      {"a.geojson", "{\"type\": \"Polygon\", \"coordinates\": [[0, 0], [1, 0]]}", 1, 38, "list of coordinates"},
      {"a.geojson", "{\"type\": \"Topology\", \"arcs\": []}", 1, 1, "this is TopoJSON"},
      {"a.geojson", "{\"type\": \"Pentagon\", \"arcs\": []}", 1, 10, "\"Pentagon\" is not a type of GeoJSON"},
      {"a.geojson", "{\"type\": \"FeatureCollection\"}", 1, 1, "list of \"features\""},
      {"a.geojson", "{\"type\": \"FeatureCollection\", \"features\": [7]}", 1, 44, "expected an object"},
      {"a.geojson", "{\"type\": \"FeatureCollection\", \"features\": []}", 1, 1, "nothing in it"},
      {"a.geojson", "{}", 1, 1, "\"type\""},
      {"a.json", "[[1, 2], [3]]", 1, 10, "two numbers"},
      {"a.json", "[[[]]]", 1, 3, "two numbers"},
      {"a.json", std::string(100, '['), 1, 65, "nested too deeply"},
  };
  for (const MalformedFile& test : cases) require_refused_file(test);
}

TEST_CASE("drawings that are wrong are refused where they are wrong") {
  const std::vector<MalformedFile> cases{
      {"a.svg", "<html/>", 1, 1, "XML"},
      {"a.svg", "<svg/>", 1, 1, "no shape is drawn in it"},
      {"a.svg", "<svg><text/></svg>", 1, 1, "no shape is drawn in it; 1 text element is left out"},
      {"a.svg", "<svg>\n <g", 2, 3, "not XML"},
      {"a.svg", "<svg>\n <g></svg>", 2, 7, "an element ends that is not open"},
      {"a.svg", "<svg>\n<path d=\"M0 0L1 1\"/>", 2, 20, "not XML"},
      {"a.svg", "<svg><path d=\"M0 0L1e200 1e200\"/></svg>", 1, 1, "too large"},
      {"a.svg", "<svg><path d=\"M0 0Lnan inf\"/></svg>", 1, 1, "no shape is drawn in it; 1 list of coordinates"},
      {"a.svg", "<svg><path d=\"M0 0L1e999 1\"/></svg>", 1, 1, "no shape"},
      {"a.svg", "<svg><g transform=\"scale(1e300) scale(1e300)\"><path d=\"M0 0L1 1\"/></g></svg>", 1, 1, "range"},
  };
  for (const MalformedFile& test : cases) require_refused_file(test);
}

TEST_CASE("files that cannot be read say why") {
  const test::TemporaryFolder folder;
  const auto missing = read_sample_file(folder / "missing.poff");
  REQUIRE_FALSE(missing.has_value());
  CHECK(missing.error().code == ErrorCode::bad_input);
  CHECK(missing.error().message() ==
        (folder / "missing.poff").string() + ": cannot be read: No such file or directory");
  const auto directory = read_sample_file(folder.path());
  REQUIRE_FALSE(directory.has_value());
  CHECK_THAT(directory.error().text, Catch::Contains("Is a directory"));
}

TEST_CASE("an endless stream that is no text is left at once") {
  const auto read = read_sample_file("/dev/zero");
  REQUIRE_FALSE(read.has_value());
  CHECK_THAT(read.error().text, Catch::Contains("binary data"));
}

TEST_CASE("a format that does not exist is the fault of the request") {
  const auto read = read_sample_bytes("1 2\n", "a.txt", "svgz");
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().code == ErrorCode::usage);
  CHECK_THAT(read.error().text, Catch::Contains("\"svgz\"") && Catch::Contains("poff"));
}

TEST_CASE("every prefix and every changed byte of a good file gives a result or a refusal") {
  const std::string poff = "POFF 3 0 0\n0 0\n1.5e3 -2 # a comment\n7 8\n# loop closed 0 1 2\n";
  const std::string wpoff = "WPOFF 3 0 0\n0 0 1\n1.5e3 -2 0 # a comment\n7 8 2e1\n";
  const std::string csv = "ring;x;y\na;1,5;2\n\"b\";3;4\na;5;6e1\n";
  const std::string wkt = "SRID=4326;POLYGON Z((0 0 1,1 0 1,1 1 2,0 0 1));MULTIPOINT((5 5),EMPTY)";
  const std::string geojson =
      R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1.5e1,2],[0,0]]]}})";
  const std::string svg =
      "<svg><g transform='scale(2)'><path d='M0 0a1 1 0 00.5.5L2 2z'/><use href='#a' id='a'/></g></svg>";
  const std::string poly = "3 2 1 0\n1 0 0 7\n2 1.5 0 7 # a\n3 1 1 7\n2 0\n1 1 2\n2 3 2\n1\n1 0.5 0.5\n";
  const std::string edg = "2\n0 0 1 0\n1e1 0 1 0\n";
  const std::string obj = "o a\nv 0 0 1\nv 1 0\nv 1 1 2\nf 1/1 2//3 -1\nl 1 2\ncurv 1\n";
  const std::string off = "NOFF 4 1 0\n0 0 0 1\n1 0 0\n1 1 0\n2 2 2\n3 0 1 2\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty int y\nelement face 1\nproperty list uchar "
      "int vertex_index\nend_header\n0 0\n1 0\n1 1\n3 0 1 2\n";
  for (const std::string& good : {poff, wpoff, csv, wkt, geojson, svg, poly, edg, obj, off, ply}) {
    std::vector<std::string> variants;
    for (std::size_t i = 0; i < good.size(); ++i) {
      variants.push_back(good.substr(0, i));
      for (const char c : {'\0', '\n', '"', ';', '9', '-', '#', '\xff'}) {
        variants.push_back(good);
        variants.back()[i] = c;
      }
    }
    for (const std::string& bytes : variants) {
      for (const char* name : {"a.poff", "a.wpoff", "a.csv", "a"}) {
        // What is found by its content is so under any name.
        if (good.starts_with("<svg") && bytes.starts_with("<svg") && name != std::string_view("a")) continue;
        const auto read = read_sample_bytes(bytes, name);
        if (read) {
          CHECK(std::ranges::all_of(read->data.positions, [](Vec2 p) { return is_finite(p); }));
          for (const Disk& ball : read->data.balls) CHECK((is_finite(ball) && ball.radius >= 0.0));
          for (const auto& contour : read->data.contours)
            CHECK(std::ranges::all_of(contour.points,
                                      [&](std::uint32_t point) { return point < read->data.positions.size(); }));
        } else {
          CHECK(read.error().line >= 1);
          CHECK(read.error().column >= 1);
        }
      }
    }
  }
}
