// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "core/io/format.h"

using namespace mes;
using namespace std::string_literals;

namespace {

struct GoodTable {
  std::string bytes;
  std::string format;
};

}  // namespace

TEST_CASE("the same two points in many ways") {
  const std::vector<Vec2> expected{{1.5, -2}, {3, 4.25}};
  for (const GoodTable& test :
       std::vector<GoodTable>{{"1.5,-2\n3,4.25\n", "csv"},
                              {"1.5,-2\n3,4.25", "csv"},
                              {"1.5 , -2\r\n3 , 4.25\r\n", "csv"},
                              {"1.5,-2\r3,4.25\r", "csv"},
                              {"x,y\n1.5,-2\n3,4.25\n", "csv"},
                              {"\xEF\xBB\xBFx,y\n1.5,-2\n3,4.25\n", "csv"},
                              {"# made by hand\n\nX , Y\n# really\n1.5,-2\n\n3,4.25\n", "csv"},
                              {"\"x\",\"y\"\n\"1.5\",\"-2\"\n\"3\",\"4.25\"\n", "csv"},
                              {"name,x,y\n\"a, b\",1.5,-2\n\"say \"\"c\"\"\",3,4.25\n", "csv"},
                              {"northing,easting\n-2,1.5\n4.25,3\n", "csv"},
                              {"y,z,x\n-2,9,1.5\n4.25,9,3\n", "csv"},
                              {"east,north,height\n1.5,-2,100\n3,4.25,100\n", "csv"},
                              {"1.5,-2,first,2024-01-01\n3,4.25,,\n", "csv"},
                              {"1.5;-2\n3;4.25\n", "csv"},
                              {"1,5;-2\n3;4,25\n", "csv"},
                              {"x;y;Bemerkung\n1,5;-2;a\n3;4,25;b,c\n", "csv"},
                              {"1.5\t-2\n3\t4.25\n", "tsv"},
                              {"x\ty\n1,5\t-2\n3\t4,25\n", "tsv"},
                              {"1.5 -2\n3 4.25\n", "pairs"},
                              {"  1.5   -2\n\t3 4.25  \n", "pairs"},
                              {"x y\n1.5 -2\n3 4.25\n", "pairs"},
                              {"1,5 -2,0\n3,0 4,25\n", "pairs"},
                              {"2\n1.5 -2\n3 4.25\n", "pairs"},
                              {"+1.5e0 -2.\n.3e1 425E-2\n", "pairs"},
                              {"1.5 -2 7\n3 4.25 8\n", "xyz"},
                              {"x y z\n1.5 -2 7\n3 4.25 8\n", "xyz"},
                              {"1.5 -2 # the first\n3 4.25 # the second\n", "xyz"}}) {
    INFO(test.bytes);
    const auto read = read_sample_bytes(test.bytes, "standard input");
    REQUIRE(read.has_value());
    CHECK(read->format == test.format);
    CHECK(read->warnings.empty());
    CHECK(read->data.positions == expected);
    CHECK(read->data.contours.empty());
  }
}

TEST_CASE("times are not taken as coordinates, and a choice among many columns gets a remark") {
  struct ChosenColumns {
    const char* bytes;
    const char* says;
  };
  for (const ChosenColumns& test : std::vector<ChosenColumns>{
           {"time,x,y\n0,1,2\n1,3,4\n", ""},
           {"t,a,b\n0,1,2\n1,3,4\n", R"(x and y are the columns "a" and "b")"},
           {"date;a;b\n2024-01-01;1;2\n2024-01-02;3;4\n", R"(x and y are the columns "a" and "b")"},
           {"a\tb\tTime\n1\t2\t0\n3\t4\t1\n", R"(x and y are the columns "a" and "b")"},
           {"t,a\n1,2\n3,4\n", ""},
           {"a,t\n1,2\n3,4\n", ""},
           {"value1,value2,value3\n1,2,0\n3,4,1\n", R"(x and y are the columns "value1" and "value2")"},
           {"1,2,0\n3,4,1\n", "x and y are the first two of 3 columns"},
           {"1,2,a\n3,4,b\n", ""}}) {
    INFO(test.bytes);
    const auto read = read_sample_bytes(test.bytes, "a.csv");
    REQUIRE(read.has_value());
    CHECK(read->data.positions == std::vector<Vec2>{{1, 2}, {3, 4}});
    const std::string says = test.says;
    CHECK(read->warnings == (says.empty() ? std::vector<std::string>{} : std::vector{"a.csv: " + says}));
  }
}

TEST_CASE("a count line that does not fit the rows is reported") {
  const auto read = read_sample_bytes("3\n1 2\n3 4\n", "a.txt");
  REQUIRE(read.has_value());
  CHECK(read->data.positions.size() == 2);
  REQUIRE(read->warnings.size() == 1);
  CHECK_THAT(read->warnings[0], Catch::StartsWith("a.txt:1:1: 3 samples are announced, there are 2"));
}

TEST_CASE("a header without rows is an empty sample with a warning") {
  const auto read = read_sample_bytes("x,y\n", "a.csv");
  REQUIRE(read.has_value());
  CHECK(read->data.positions.empty());
  CHECK(read->warnings.size() == 1);
}

TEST_CASE("a line of a million columns costs no more than its first two") {
  std::string bytes = "1,2";
  for (int i = 0; i < 1'000'000; ++i) bytes += ",3";
  const auto read = read_sample_bytes(bytes + '\n' + bytes, "a.csv");
  REQUIRE(read.has_value());
  CHECK(read->data.positions == std::vector<Vec2>{{1, 2}, {1, 2}});
}

TEST_CASE("decimals in quotes are decimals, whichever sign separates the columns") {
  const std::vector<Vec2> points{{1.5, 2.5}, {-3.25, 4}, {5, 6.125}};
  for (const std::string& text :
       {"\"1,5\";\"2,5\"\n\"-3,25\";\"4\"\n\"5,0\";\"6,125\"\n"s,
        "\"1.5\",\"2.5\"\n\"-3.25\",\"4\"\n\"5\",\"6.125\"\n"s,
        "\"1,5\",\"2,5\"\n\"-3,25\",\"4\"\n\"5\",\"6,125\"\n"s, "x;y\n\"1,5\";\"2,5\"\n-3,25;4\n\"5\" ; \"6,125\"\n"s,
        "\"x\",\"y\"\r\n\"1,5\",\"2,5\"\r\n\"-3,25\",4\r\n5,\"6,125\"\r\n"s,
        "\"1,5\"\t\"2,5\"\n\"-3,25\"\t4\n5\t\"6,125\"\n"s, "1.5D0,2.5d+0\n-325D-2,4\n5,6.125\n"s,
        "\"1.5\";\"2.5\"\n\"-3.25\";\"4\"\n5;6.125\n"s}) {
    INFO(text);
    for (const char* name : {"a.csv", "a"}) {
      const auto read = read_sample_bytes(text, name);
      REQUIRE(read.has_value());
      CHECK(read->data.positions == points);
    }
  }
}
