// SPDX-License-Identifier: GPL-3.0-or-later
// The range of coordinates, in files: what lies at its ends is read, what lies one unit in the last place outside is
// refused with its place.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/io/bundle_file.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
#include "core/io/text/text_numbers.h"

using namespace mes;

namespace {

const double kLeast = 0x1p-500;
const double kMost = std::nextafter(0x1p500, 0.0);

std::string text_of(double x) {
  std::string out;
  append_number(out, x);
  return out;
}

struct Refusal {
  std::uint64_t line;
  std::uint64_t column;
  std::string says;
};

void require_refused_coordinates(const std::string& name, const std::string& bytes, const Refusal& expected) {
  INFO(name << ": " << bytes);
  const auto read = read_sample_bytes(bytes, name);
  REQUIRE_FALSE(read.has_value());
  INFO(read.error().message());
  CHECK(read.error().code == ErrorCode::bad_input);
  CHECK(read.error().file == name);
  CHECK(read.error().line == expected.line);
  CHECK(read.error().column == expected.column);
  CHECK_THAT(read.error().text, Catch::Contains(expected.says));
  CHECK(read.error().text.size() < 300);
}

void require_good(const std::string& name, const std::string& bytes) {
  INFO(name << ": " << bytes);
  const auto read = read_sample_bytes(bytes, name);
  if (!read) FAIL(read.error().message());
}

std::string session_with(const std::string& data, const std::string& timeline) {
  return "{\"mesecina\":\"session\",\"schema\":1,\n\"data\":{" + data + "},\n\"timeline\":[" + timeline + "]}";
}

/// Two numbers as they may stand in each format, the second at the given place.
struct Form {
  std::string name;
  std::string before, between, after;
  std::uint64_t line;
  std::uint64_t column;  ///< of the second, after a first of one character
};
const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {"a.poff", "POFF 2 0 0\n0 ", "\n0 ", "\n", 3, 3},
      {"a.wpoff", "WPOFF 2 0 0\n0 0 ", "\n0 0 ", "\n", 3, 5},
      {"b.wpoff", "WPOFF 2 0 0\n0 0 ", "\n", " 0 0\n", 3, 1},
      {"a.csv", "x,y\n", ",0\n0,", "\n", 3, 3},
      {"a.tsv", "x\ty\n", "\t0\n0\t", "\n", 3, 3},
      {"a.xyz", "", " 0 0\n0 ", " 0\n", 2, 3},
      {"a.txt", "0 ", "\n0 ", "\n", 2, 3},
  };
  return all;
}

}  // namespace

TEST_CASE("the ends of the range are read, and nothing beyond, in every format") {
  for (const Form& form : forms()) {
    const auto with = [&](double first, double second) {
      return form.before + text_of(first) + form.between + text_of(second) + form.after;
    };
    for (const double x : {kLeast, 0x1.fffffffffffffp-401, 0x1p399, kMost}) require_good(form.name, with(x, x));
    require_good(form.name, with(1, 0x1p-100));
    require_good(form.name, with(1, 0x1.fffffffffffffp100));
    require_good(form.name, with(0, kLeast));
    require_good(form.name, with(0, kMost));
    require_good(form.name, with(kMost, 0x1p399));
    require_good(form.name, with(kLeast, 0x1.fffffffffffffp-400));
    const Refusal small{form.line, form.column, " is too small: coordinates and radii are 0, or from 2^-500"};
    const Refusal large{form.line, form.column, " is too large: coordinates and radii are 0, or from 2^-500"};
    require_refused_coordinates(form.name, with(0, std::nextafter(kLeast, 0.0)), small);
    require_refused_coordinates(form.name, with(0, 5e-324), small);
    require_refused_coordinates(form.name, with(0, 0x1p500), large);
    require_refused_coordinates(
        form.name, with(1, std::nextafter(0x1p-100, 0.0)),
        {form.line, form.column, "too small beside numbers of about 1: the largest may be 2^100"});
    require_refused_coordinates(
        form.name, with(1, 0x1p101),
        {form.line, form.column, "too large beside numbers of about 1: the largest may be 2^100"});
  }
}

TEST_CASE("a number that no double is near enough to is out of range, and no zero") {
  require_refused_coordinates("a.poff", "POFF 1 0 0\n1 1e-400\n", {2, 3, "\"1e-400\" is too small"});
  require_refused_coordinates("a.poff", "POFF 1 0 0\n1 -0.0000001E-99999999999999999999\n", {2, 3, "is too small"});
  require_refused_coordinates("a.csv", "1;0,5e-400\n", {1, 3, "\"0,5e-400\" is too small"});
  require_refused_coordinates("a.poff", "POFF 1 0 0\n1 1e400\n", {2, 3, "\"1e400\" is too large: coordinates"});
  require_good("a.poff", "POFF 1 0 0\n1 0e-400\n");
  require_good("a.poff", "POFF 1 0 0\n1 -0.000\n");
}

TEST_CASE("centres and radii of balls keep the range together") {
  require_refused_coordinates("a.wpoff", "WPOFF 2 0 0\n1e20 0 1\n0 0 1e-20\n",
                              {3, 5, "too small beside numbers of about"});
  require_refused_coordinates("a.wpoff", "WPOFF 2 0 0\n0 0 1e-20\n1e20 0 1\n",
                              {3, 1, "too large beside numbers of about"});
}

TEST_CASE("the inputs that ended the program are refused with their place") {
  const auto message = [](const char* file) {
    const auto read = read_sample_file(std::string("tests/data/") + file);
    return read ? std::string("read") : read.error().message();
  };
  using Catch::StartsWith;
  CHECK_THAT(message("subnormal_circumcentre.poff"),
             StartsWith("tests/data/subnormal_circumcentre.poff:3:1: \"5e-324\" is too small: "));
  CHECK_THAT(message("mixed_scales_div0.poff"),
             StartsWith("tests/data/mixed_scales_div0.poff:2:1: \"1e-300\" is too small: "));
  CHECK_THAT(message("extreme_recursion.poff"),
             StartsWith("tests/data/extreme_recursion.poff:2:1: \"5e-324\" is too small: "));
  CHECK_THAT(message("extreme_sigfpe.poff"),
             StartsWith("tests/data/extreme_sigfpe.poff:4:3: \"1e160\" is too large: "));
  CHECK_THAT(message("extreme_session.json"),
             StartsWith("tests/data/extreme_session.json:1:59: data \"samples\": 1e-300 is too small: "));
}

TEST_CASE("the data of a session keep the range, with line and column") {
  require_good("s.json", session_with("\"samples\":[1,1e-30],\"balls\":[0,0,1]", ""));
  require_refused_coordinates("s.json", session_with("\"samples\":[0,1,\n 2, 1e160]", ""),
                              {3, 5, "data \"samples\": 1e+160 is too large"});
  require_refused_coordinates("s.json", session_with("\"balls\":[0,1,1e-160]", ""),
                              {2, 22, "data \"balls\": 1e-160 is too small"});
  // Each by itself is in range; keys may come in any order, and strings hold anything.
  require_refused_coordinates("s.json",
                              session_with("\"x\\\"]}\":\"],[}\\\\\",\"balls\":[0,1,1e-40],\"samples\":[1,2]", ""),
                              {2, 39, "data \"balls\": 1e-40 is too small beside numbers of about 2"});
}

TEST_CASE("every entry of a timeline keeps the range") {
  const std::string data = "\"samples\":[1,1],\"balls\":[0,0,1]";
  const auto refused = [&](const std::string& edit, const Refusal& expected) {
    require_refused_coordinates(
        "s.json", session_with(data, "\n{\"begin\":\"a\"},{\"end\":true},\n{\"edit\":{" + edit + "}}\n"), expected);
  };
  refused("\"insert\":[0,1e200]", {5, 22, "entry 3 of the timeline: edit \"insert\": 1e+200 is too large"});
  refused("\"move\":[0,1,1e-200]", {5, 22, "edit \"move\": 1e-200 is too small"});
  refused("\"insert_balls\":[0,0,1e-200]", {5, 30, "edit \"insert_balls\": 1e-200 is too small"});
  refused("\"change_balls\":[0,1e200,0,1]", {5, 28, "edit \"change_balls\": 1e+200 is too large"});
  // Beside what the document holds then.
  refused("\"insert\":[0,1e40]", {0, 0, "entry 3 of the timeline: 1e+40 is too large beside numbers of about 1"});
  refused("\"change_balls\":[0,0,0,1e-40]", {0, 0, "entry 3 of the timeline: 1e-40 is too small beside"});
  // Once the others are gone, or go along, the same numbers are good.
  require_good("s.json", session_with(data,
                                      "{\"edit\":{\"remove\":[0],\"remove_balls\":[0]}},{\"edit\":{\"insert\":"
                                      "[0,1e40]}}"));
  require_good("s.json", session_with(data, "{\"edit\":{\"move\":[0,1e40,0],\"change_balls\":[0,1e40,0,1e40]}}"));
}

TEST_CASE("a view may be anywhere, a picture to trace may not") {
  require_good("s.json",
               "{\"mesecina\":\"session\",\"schema\":1,\"data\":{\"samples\":[1,1]},\"view\":[0,0,1e-200,1e-200]}");
  const auto with_picture = [](const std::string& center, const std::string& width) {
    return "{\"mesecina\":\"session\",\"schema\":1,\"layers\":{\"layers\":[],\"image\":{\"file\":\"a.png\","
           "\"center\":" +
           center + ",\"width\":" + width + "}}}";
  };
  require_good("s.json", with_picture("[0,3e150]", "1e-150"));
  require_refused_coordinates("s.json", with_picture("[0,4e150]", "1"),
                              {0, 0, "the traced picture: 4e+150 is too large"});
  require_refused_coordinates("s.json", with_picture("[0,1]", "1e-200"),
                              {0, 0, "the traced picture: 1e-200 is too small"});
}
