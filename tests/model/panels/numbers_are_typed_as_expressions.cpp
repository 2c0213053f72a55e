// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for numbers take expressions; what is refused is said until it is right or given up.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/typed_number.h"
#include "imgui.h"

using namespace mes;

namespace {

/// Dear ImGui without a window, with two fields and nothing else.
struct Fields {
  double first = 3.0;
  std::uint64_t second = 7;
  int third = 7;
  int news = 0;  // how often the first was left with another number

  Fields() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {800, 600};
    for (const ImGuiKey key : {ImGuiKey_Enter, ImGuiKey_Escape, ImGuiKey_Tab, ImGuiKey_Backspace})
      io.KeyMap[key] = key;
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    frame();
  }
  ~Fields() { ImGui::DestroyContext(); }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  void frame() {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({800, 600});
    ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
    ImGui::SetCursorScreenPos({100, 100});
    ImGui::SetNextItemWidth(200);
    if (number_field("##first", first, "%.3g px", [](double x) -> std::optional<std::string> {
          if (x > 1000.0) return "too much";
          return std::nullopt;
        }))
      ++news;
    ImGui::SetCursorScreenPos({100, 200});
    ImGui::SetNextItemWidth(200);
    number_field("##second", second);
    ImGui::SetCursorScreenPos({100, 300});
    ImGui::SetNextItemWidth(200);
    number_field("##third", third, 3, 100);
    ImGui::End();
    ImGui::EndFrame();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }
  void click(float x, float y) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {x, y};
    frame();
    for (const bool is_down : {true, false}) {
      io.MouseDown[0] = is_down;
      frame();
    }
    frames(3);
  }
  void press(ImGuiKey key) {
    for (const bool is_down : {true, false}) {
      ImGui::GetIO().KeysDown[key] = is_down;
      frame();
    }
    frames(3);
  }
  /// In place of the whole text, as a click selects it.
  void type(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frames(2);
  }
};

}  // namespace

TEST_CASE("the unit of a format may stand after what is typed") {
  CHECK(unit_in("%.0f px") == "px");
  CHECK(unit_in("%.0f %%") == "%");
  CHECK(unit_in("%.5g\u00b0") == "\u00b0");
  CHECK(unit_in("%.4g") == "");
  CHECK(typed_number("1/2 px", "px").value() == 0.5);
  CHECK(typed_number(" 1/2px ", "px").value() == 0.5);
  CHECK(typed_number("1/2", "px").value() == 0.5);
  CHECK(typed_number("2*pi/3").value() == Approx(std::acos(-0.5)));
  CHECK(typed_number("45\u00b0", "\u00b0").value() == 45.0);
  for (const char* text : {"", "px", "1/0", "1 +", "3 mm", "nan", "inf", "1e400"}) {
    INFO(text);
    CHECK_FALSE(typed_number(text, "px").has_value());
  }
}

TEST_CASE("whole numbers are taken with every digit, or as expressions that are whole") {
  CHECK(typed_count("18446744073709551615").value() == ~std::uint64_t{0});
  CHECK(typed_count("9007199254740993").value() == 9007199254740993U);
  CHECK(typed_count("2^10 - 1").value() == 1023U);
  CHECK(typed_count(" 12 ").value() == 12U);
  for (const char* text : {"", "-1", "1/2", "2^64", "18446744073709551616", "x"}) {
    INFO(text);
    CHECK_FALSE(typed_count(text).has_value());
  }
}

TEST_CASE("a number outside of its range is refused, with the range, and never taken to its end") {
  CHECK_FALSE(range_fault(0.5, {0.0, 1.0}));
  CHECK_FALSE(range_fault(0.0, {0.0, 1.0}));
  CHECK_FALSE(range_fault(1.0, {0.0, 1.0}));
  CHECK_FALSE(range_fault(-1e300, {}));
  CHECK(range_fault(-1.0, {1e-6, 1e6}).value() == "a number from 1e-06 to 1000000 is wanted");
  CHECK(range_fault(std::nextafter(1.0, 2.0), {0.0, 1.0}).has_value());
  CHECK(range_fault(2.5, {1.0, 9.0, true}).value() == "a whole number from 1 to 9 is wanted");
  CHECK_FALSE(range_fault(2.0, {1.0, 9.0, true}));
  CHECK(range_fault(-1.0, {.low = 0.0}).value() == "a number from 0 on is wanted");
  CHECK(range_fault(0.5, {.is_whole = true}).value() == "a whole number is wanted");
  CHECK(typed_count("3", 3, 100).value() == 3U);
  CHECK(typed_count("10^2", 3, 100).value() == 100U);
  for (const char* text : {"2", "101", "0", "-5", "2.5", "1e30"}) {
    INFO(text);
    const auto count = typed_count(text, 3, 100);
    REQUIRE_FALSE(count.has_value());
    CHECK_THAT(count.error().message(), Catch::Contains("a whole number from 3 to 100 is wanted"));
  }
}

TEST_CASE("a field with a range keeps its number until one is typed that is in it") {
  Fields fields;
  fields.click(150, 308);
  fields.type("101");
  fields.press(ImGuiKey_Enter);
  CHECK(fields.third == 7);
  CHECK_THAT(refused_number(), Catch::Contains("from 3 to 100"));
  fields.type("100");
  fields.press(ImGuiKey_Enter);
  CHECK(fields.third == 100);
  CHECK(refused_number().empty());
}

TEST_CASE("a field takes an expression by Enter, by Tab and by a click elsewhere") {
  Fields fields;
  fields.click(150, 108);
  fields.type("2*pi/3");
  SECTION("Enter") {
    fields.press(ImGuiKey_Enter);
  }
  SECTION("Tab") {
    fields.press(ImGuiKey_Tab);
  }
  SECTION("a click") {
    fields.click(600, 400);
  }
  CHECK(fields.first == Approx(std::acos(-0.5)).epsilon(1e-15));
  CHECK(fields.news == 1);
  CHECK(refused_number().empty());
}

TEST_CASE("Esc and the same number leave a field as it was") {
  Fields fields;
  fields.click(150, 108);
  SECTION("Esc") {
    fields.type("5");
    fields.press(ImGuiKey_Escape);
  }
  SECTION("the same in other words") {
    fields.type("6/2");
    fields.press(ImGuiKey_Enter);
  }
  CHECK(fields.first == 3.0);
  CHECK(fields.news == 0);
  CHECK(refused_number().empty());
}

TEST_CASE("what is refused by Enter stays with its reason until the text is right or given up") {
  Fields fields;
  fields.click(150, 108);
  CHECK(refused_number().empty());
  fields.type("1/0");
  CHECK(refused_number().empty());  // not before it is left
  fields.press(ImGuiKey_Enter);
  CHECK(fields.first == 3.0);
  CHECK_FALSE(refused_number().empty());
  fields.frames(50);
  CHECK_FALSE(refused_number().empty());
  SECTION("right: nothing is said, also before the field is left") {
    fields.type("1/4");
    CHECK(refused_number().empty());
    CHECK(fields.first == 3.0);
    fields.press(ImGuiKey_Enter);
    CHECK(refused_number().empty());
    CHECK(fields.first == 0.25);
  }
  SECTION("wrong in another way") {
    const std::string before = refused_number();
    fields.type("1 +");
    CHECK_FALSE(refused_number().empty());
    CHECK(refused_number() != before);
    fields.type("1");
    CHECK(refused_number().empty());
  }
  SECTION("what the one who asks refuses is said as well") {
    fields.type("2000");
    CHECK(refused_number() == "too much");
    fields.press(ImGuiKey_Enter);
    CHECK(refused_number() == "too much");
    CHECK(fields.first == 3.0);
  }
  SECTION("given up by Esc") {
    fields.press(ImGuiKey_Escape);
    CHECK(refused_number().empty());
    CHECK(fields.first == 3.0);
  }
  SECTION("given up by a click elsewhere: said until something is pressed") {
    fields.click(600, 400);
    fields.click(600, 400);
    CHECK(refused_number().empty());
    CHECK(fields.first == 3.0);
  }
}

TEST_CASE("what is refused by a click elsewhere is said until something is pressed") {
  Fields fields;
  fields.click(150, 108);
  fields.type("1/0");
  fields.click(600, 400);
  CHECK(fields.first == 3.0);
  fields.frames(50);
  CHECK_FALSE(refused_number().empty());
  SECTION("a click") {
    fields.click(600, 400);
  }
  SECTION("a key") {
    fields.press(ImGuiKey_Backspace);
  }
  CHECK(refused_number().empty());
  CHECK(fields.first == 3.0);
}

TEST_CASE("a whole number is typed as an expression, too") {
  Fields fields;
  fields.click(150, 208);
  fields.type("1/2");
  fields.press(ImGuiKey_Enter);
  CHECK(fields.second == 7);
  CHECK_FALSE(refused_number().empty());
  fields.type("2^63 + 2^12");
  fields.press(ImGuiKey_Enter);
  CHECK(fields.second == (std::uint64_t{1} << 63U) + 4096);
  CHECK(refused_number().empty());
}
