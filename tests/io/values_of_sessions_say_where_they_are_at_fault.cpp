// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "core/io/session/json_text.h"
#include "core/io/session/session_values.h"

using namespace mes;

namespace {

/// What the text holds under "v".
JsonView value_in(const std::string& text) {
  REQUIRE(check_json(text, "a.json"));
  return JsonView::whole(text).find("v");
}

/// What is thrown; nothing if nothing is.
template <class Read>
std::optional<Nonsense> thrown_by(Read read) {
  try {
    read();
  } catch (const Nonsense& nonsense) {
    return nonsense;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("lists of numbers are places, balls, and those of counts, in the order of their numbers") {
  const std::string text = R"({"v": [1, 2.5, -0.0, 4, 5, 6]})";
  const JsonView list = value_in(text);
  std::vector<std::uint32_t> counts{9};
  read_flat(JsonView(), "v", counts, "data");
  CHECK(counts == std::vector<std::uint32_t>{9});

  std::vector<Vec2> places;
  read_flat(list, "v", places, "data");
  CHECK(places == std::vector<Vec2>{{1, 2.5}, {-0.0, 4}, {5, 6}});
  CHECK(places_of(list, "view") == places);

  std::vector<Disk> balls;
  read_flat(list, "v", balls, "data");
  CHECK(balls == std::vector<Disk>{{{1, 2.5}, -0.0}, {{4, 5}, 6}});

  std::vector<std::pair<std::uint32_t, Vec2>> moved;
  read_flat(list, "v", moved, "edit");
  CHECK(moved == std::vector<std::pair<std::uint32_t, Vec2>>{{1, {2.5, -0.0}}, {4, {5, 6}}});
}

TEST_CASE("a number that no document can hold is found by its place, and one of the wrong kind by its list") {
  const std::string text = R"({"v": [1, 2, 1e-300, 4, 5, 6]})";
  std::vector<std::pair<std::uint32_t, Vec2>> moved;
  const auto small = thrown_by([&] { read_flat(value_in(text), "v", moved, "edit"); });
  REQUIRE(small);
  CHECK(small->text.starts_with("edit \"v\": "));
  CHECK(small->at.offset_in(text) == text.find("1e-300"));

  const auto part = thrown_by([&] {
    std::vector<Disk> balls;
    read_flat(value_in(R"({"v": [1, 2, 3, 4]})"), "v", balls, "data");
  });
  REQUIRE(part);
  CHECK(part->text == "data \"v\": the number of numbers is not a multiple of 3");
  CHECK(!part->at);

  const auto fraction = thrown_by([&] {
    std::vector<std::uint32_t> counts;
    read_flat(value_in(R"({"v": [1, 2.5]})"), "v", counts, "edit");
  });
  REQUIRE(fraction);
  CHECK(fraction->text == "edit \"v\": not a whole number that counts something");
}

TEST_CASE("numbers that fit alone are refused in the company of those seen before") {
  const std::string text = R"({"v": [1, 2, 3, 1e-40]})";
  const std::vector<Vec2> places = places_of(value_in(text), "data");
  Magnitudes seen;
  const auto alone = thrown_by([&] { require_together(places, value_in(text), "v", "data", seen); });
  REQUIRE(alone);
  CHECK(alone->at.offset_in(text) == text.find("1e-40"));

  Magnitudes small;
  small.add(0x1p-40);
  CHECK(!thrown_by([&] { require_together(std::vector<Vec2>{{1, 2}}, value_in(text), "v", "data", small); }));
  CHECK(small.most == 1);
}

TEST_CASE("a fault without a place of its own gets that of the value around it") {
  const std::string text = R"({"v": {"name": 7}})";
  const JsonView object = value_in(text);
  const auto read_name = [](JsonView value) { return text_from(value.find("name"), "name", "edit"); };
  const auto thrown = thrown_by([&] { read_at(object, "entry 3", read_name); });
  REQUIRE(thrown);
  CHECK(thrown->text == "entry 3: edit: \"name\" is not a text");
  CHECK(thrown->at.offset_in(text) == text.find("{\"name\""));

  const std::string long_text = R"({"v": "abcd"})";
  CHECK(short_text_from(value_in(long_text), "v", 4, "lesson") == "abcd");
  const auto too_long = thrown_by([&] { short_text_from(value_in(long_text), "v", 3, "lesson"); });
  REQUIRE(too_long);
  CHECK(too_long->text == "lesson: \"v\" is longer than 3 bytes");
  const auto outer = thrown_by([&] {
    read_at(value_in(long_text), "step 1", [&](JsonView value) { return short_text_from(value, "v", 3, "lesson"); });
  });
  REQUIRE(outer);
  CHECK(outer->at.offset_in(long_text) == long_text.find("\"abcd\""));
}
