// SPDX-License-Identifier: GPL-3.0-or-later
// Letters with the components and holes that everybody knows, counted by crossings of lines with sampled contours.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "core/curves/sampling.h"
#include "core/glyphs/text_outlines.h"

using namespace mes;

namespace {

const FontFile kInter{.path = std::string(MESECINA_FONTS) + "/Inter-Regular.otf", .index = 0, .name = "Inter"};

TextOutlines outlines(TextRequest request) {
  request.font = kInter;
  auto out = outlines_of_text(request);
  INFO((out ? std::string() : out.error().message()));
  REQUIRE(out.has_value());
  return *std::move(out);
}

using Polygon = std::vector<Vec2>;

std::vector<Polygon> polygons_of(const CurveSet& curves) {
  const auto samples = sample(curves, {.rule = SamplingRule::count, .count = 5000});
  REQUIRE(samples.has_value());
  std::vector<Polygon> out;
  for (const SampledCurves::Chain& chain : samples->chains) {
    REQUIRE(chain.is_closed);
    const auto first = samples->positions.begin() + static_cast<std::ptrdiff_t>(chain.first);
    out.emplace_back(first, first + static_cast<std::ptrdiff_t>(chain.count));
  }
  return out;
}

bool is_inside(Vec2 p, const Polygon& polygon) {
  bool out = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) out = !out;
  }
  return out;
}

/// Contours around an even number of others, and around an odd one.
struct Topology {
  int solids = 0;
  int holes = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};
Topology topology_of(const CurveSet& curves) {
  const std::vector<Polygon> polygons = polygons_of(curves);
  Topology out;
  for (const Polygon& one : polygons) {
    const auto around = std::ranges::count_if(
        polygons, [&](const Polygon& other) { return &other != &one && is_inside(one.front(), other); });
    ++(around % 2 == 0 ? out.solids : out.holes);
  }
  return out;
}

struct Extent {
  Vec2 low{1e300, 1e300};
  Vec2 high{-1e300, -1e300};
};
Extent extent_of(const CurveSet& curves) {
  Extent out;
  for (const Polygon& polygon : polygons_of(curves))
    for (const Vec2 p : polygon) {
      out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y)};
      out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y)};
    }
  return out;
}

}  // namespace

TEST_CASE("letters have the components and the holes that they are known by") {
  const std::vector<std::pair<std::string, Topology>> letters{
      {"B", {1, 2}}, {"i", {2, 0}},        {"o", {1, 1}},    {"8", {1, 2}},    {"C", {1, 0}}, {"%", {3, 2}},
      {"=", {2, 0}}, {"\xC3\xA4", {3, 1}}, {"Bio8", {5, 5}}, {"A\nB", {2, 3}}, {"&", {1, 2}}, {"@", {1, 1}}};
  for (const auto& [text, known] : letters) {
    INFO(text);
    const TextOutlines out = outlines({.text = text});
    const Topology seen = topology_of(out.curves);
    CHECK(seen.solids == known.solids);
    CHECK(seen.holes == known.holes);
    CHECK(out.remarks.empty());
    for (const PlaneCurve& curve : out.curves.curves) CHECK(curve.is_closed());
  }
}

TEST_CASE("an H stands on the line, and a size scales everything") {
  const Extent small = extent_of(outlines({.text = "H", .size = 10}).curves);
  CHECK(small.low.y == Approx(0.0).margin(1e-12));
  // The height of capitals of Inter, of an em.
  CHECK(small.high.y == Approx(10 * 0.727).epsilon(0.01));
  const Extent large = extent_of(outlines({.text = "H", .size = 40}).curves);
  CHECK(large.high.x == Approx(4 * small.high.x).epsilon(1e-9));
  CHECK(large.high.y == Approx(4 * small.high.y).epsilon(1e-9));
}

TEST_CASE("kerning brings letters together, and does not change them") {
  const Extent kerned = extent_of(outlines({.text = "AVAVA"}).curves);
  const Extent apart = extent_of(outlines({.text = "AVAVA", .has_kerning = false}).curves);
  CHECK(kerned.high.x < apart.high.x - 1.0);
  CHECK(extent_of(outlines({.text = "HIH"}).curves).high.x ==
        Approx(extent_of(outlines({.text = "HIH", .has_kerning = false}).curves).high.x));
}

TEST_CASE("lines stand below each other, as far apart as asked") {
  const Extent one = extent_of(outlines({.text = "H"}).curves);
  const Extent two = extent_of(outlines({.text = "H\r\nH"}).curves);
  const Extent wide = extent_of(outlines({.text = "H\n\nH", .line_spacing = 2.0}).curves);
  CHECK(two.high.y == Approx(one.high.y));
  CHECK(two.low.y < -100.0);
  CHECK(wide.low.y == Approx(4.0 * two.low.y));
}

TEST_CASE("characters without a glyph are left out and named") {
  const TextOutlines out = outlines({.text = "o\xE5\xAD\x97o"});
  CHECK(topology_of(out.curves) == Topology{2, 2});
  CHECK(out.remarks == std::vector<std::string>{"Inter has no glyph for \"\xE5\xAD\x97\" (U+5B57); left out"});
  const auto none = outlines_of_text({.text = "\xE5\xAD\x97\xE5\xAD\x98", .font = kInter});
  REQUIRE_FALSE(none.has_value());
  CHECK(none.error().code == ErrorCode::bad_input);
  CHECK(none.error().text == "Inter has no glyphs for 2 characters, the first of them \"\xE5\xAD\x97\" (U+5B57)");
}

TEST_CASE("texts of which nothing is drawn, and wishes that make no sense, are refused in one line") {
  const auto refused = [](TextRequest request) {
    if (request.font.path.empty()) request.font = kInter;
    const auto out = outlines_of_text(request);
    REQUIRE_FALSE(out.has_value());
    return out.error();
  };
  CHECK(refused({.text = ""}).text == "nothing of this text is drawn");
  CHECK(refused({.text = " \n "}).text == "nothing of this text is drawn");
  CHECK(refused({.text = "a", .size = 0}).code == ErrorCode::usage);
  CHECK(refused({.text = "a", .size = std::numeric_limits<double>::infinity()}).code == ErrorCode::usage);
  CHECK(refused({.text = "a", .line_spacing = -1}).code == ErrorCode::usage);
  CHECK(refused({.text = std::string(kLongestText + 1, 'a')}).code == ErrorCode::usage);
  const Error no_font = refused({.text = "a", .font = {.path = std::string(MESECINA_FONTS) + "/OFL.txt"}});
  CHECK(no_font.code == ErrorCode::bad_input);
  CHECK(no_font.text == "this is not a TrueType or OpenType font");
  CHECK(refused({.text = "a", .font = {.path = "/nowhere/font.otf"}}).text == "cannot be read");
}

TEST_CASE("bytes that are not UTF-8 end in a message that can be printed") {
  const auto out = outlines_of_text({.text = "a\xFF\xC3", .font = kInter});
  REQUIRE(out.has_value());
  for (const std::string& remark : out->remarks)
    CHECK(std::ranges::none_of(remark, [](char c) { return static_cast<signed char>(c) < ' ' && c != '\0'; }));
}

TEST_CASE("equal requests give equal curves, and a long text is the text of its letters") {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "Bio";
  CHECK(topology_of(outlines({.text = text}).curves) == Topology{1200, 900});
  CHECK(polygons_of(outlines({.text = "Sphinx"}).curves) == polygons_of(outlines({.text = "Sphinx"}).curves));
}

TEST_CASE("a font in a file is found by its path, and a name that no font has is refused") {
  const auto file = find_font(kInter.path.string());
  REQUIRE(file.has_value());
  CHECK(file->path == kInter.path);
  for (const std::string name : {"No Such Font Anywhere", "./nowhere.otf"}) {
    const auto none = find_font(name);
    REQUIRE_FALSE(none.has_value());
    CHECK(none.error().code == ErrorCode::usage);
    CHECK_THAT(none.error().text, Catch::Contains(name));
  }
}

TEST_CASE("each installed family is found by its name, in any case") {
  const std::vector<std::string> families = font_families();
  CHECK(std::ranges::is_sorted(families));
  std::size_t count = 0;
  for (const std::string& family : families) {
    // Names are patterns of fontconfig, in which these signs mean something.
    if (family.find_first_of("-:,\\") != std::string::npos || ++count > 20) continue;
    INFO(family);
    const auto font = find_font(family);
    REQUIRE(font.has_value());
    CHECK_FALSE(font->path.empty());
    std::string shouted = family;
    for (char& c : shouted)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    CHECK(find_font(shouted) == *font);
  }
}

TEST_CASE("the outlines of a long text can be stopped") {
  TextRequest request{.text = std::string(1000, 'A'), .font = kInter};
  JobControl job;
  job.stop_at_look(100);
  CHECK_THROWS_AS(outlines_of_text(request, &job), Cancelled);
  request.text = "A";
  JobControl enough;
  enough.stop_at_look(100);
  CHECK(outlines_of_text(request, &enough).has_value());
}
