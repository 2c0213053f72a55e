// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "core/io/bundle_file.h"
#include "temporary_folder.h"

using namespace mes;
using mes::test::TemporaryFolder;

namespace {

const std::array<KnownLayer, 9> kLayers{{{"points"},
                                         {"medial-axis", {.dashed = true}},
                                         {"curve", {.line_width_px = 2.0, .flat = true}},
                                         {"all-medial-axis"},
                                         {"a-v-crossing-edges"},
                                         {"a-inner-centers"},
                                         {"a-power-diagram"},
                                         {"a-ball-power-diagram"},
                                         {"a-regular-triangulation"}}};

LayerStyle odd_style() {
  LayerStyle style;
  style.color = {1, 2, 254};
  style.opacity = 1.0 / 3.0;
  style.point_size_px = 7.1;
  style.line_width_px = 0.1;
  style.dashed = true;
  style.flat = true;
  style.color_map = "viridis";
  style.range_locked = true;
  style.range_low = -1e-300;
  style.range_high = 0.1;
  style.thin_when_dense = false;
  return style;
}

// The grammar of BND, spoken.
std::string u32(std::uint32_t value) {
  std::string out;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) out += static_cast<char>(value >> shift & 0xFFU);
  return out;
}
std::string u16(unsigned value) {
  return {static_cast<char>(value >> 8U), static_cast<char>(value & 0xFFU)};
}
std::string text(const std::u16string& symbols) {
  std::string out = u32(static_cast<std::uint32_t>(2 * symbols.size()));
  for (const char16_t symbol : symbols) out += u16(symbol);
  return out;
}
std::string block(const std::string& bytes) {
  return u32(static_cast<std::uint32_t>(bytes.size())) + bytes;
}
const std::string kNull = u32(0xFFFFFFFF);
std::string real(float value) {
  return u32(std::bit_cast<std::uint32_t>(value));
}
std::string real(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return u32(static_cast<std::uint32_t>(bits >> 32U)) + u32(static_cast<std::uint32_t>(bits));
}

template <class Real = float>
std::string state(bool active, const std::string& map = kNull, const std::string& tail = {}, Real point_size = 5) {
  std::string color = "\x01";
  for (const unsigned channel : {0x8000U, 0xFFFFU, 0x8080U, 0U, 0U}) color += u16(channel);
  return u32(0xB1) + u32(2) + color + real(point_size) + real(Real{2}) + static_cast<char>(active) + map + tail;
}
std::string layer(const std::u16string& name, const std::string& bytes) {
  return text(name) + block(bytes);
}
std::string bundle(const std::string& layers) {
  return block(u32(0xB2) + u32(1) + layers);
}
std::string file(const std::string& bundles) {
  return u32(0xB3) + u32(1) + bundles;
}

Expected<LoadedBundles> read(const std::string& bytes) {
  return read_bundles(bytes, "old.bnd", kLayers);
}
LayerConfiguration one(const std::string& layers) {
  const auto loaded = read(file(text(u"x") + bundle(layers)));
  INFO((loaded ? std::string() : loaded.error().message()));
  REQUIRE(loaded);
  REQUIRE(loaded->bundles.size() == 1);
  return loaded->bundles.front().layers;
}

}  // namespace

TEST_CASE("JSON bundles read back equal") {
  const std::vector<Bundle> bundles{{"Fl\xc3\xa4"
                                     "che \"\\\n",
                                     {{{"points", true, odd_style()}, {"a layer of tomorrow", false, {}}}, {}}},
                                    {"empty", {}, "Nothing to see"},
                                    {"traced", {{{"curve", true, {}}}, {"a b.png", {0.1, -2}, 3}}}};
  const std::string bytes = write_bundles(bundles);
  CHECK(looks_like_bundles(bytes));
  const auto loaded = read_bundles(bytes, "x.json", kLayers);
  REQUIRE(loaded);
  CHECK(loaded->bundles == bundles);
  CHECK(loaded->warnings.empty());
  CHECK(write_bundles(loaded->bundles) == bytes);
}

TEST_CASE("JSON that is not a file of bundles is refused in one line") {
  const auto complaint = [](const std::string& bytes) {
    const auto loaded = read_bundles(bytes, "x.json", kLayers);
    return loaded ? std::string() : loaded.error().message();
  };
  CHECK(complaint("") == "x.json:1:1: this is not JSON");
  CHECK(complaint("{\"mesecina\":\"bundles\",\n!}").starts_with("x.json:2:1: "));
  CHECK(complaint("[]") == "x.json: this is not a file of bundles");
  CHECK(complaint("{\"mesecina\":\"session\"}") == "x.json: this is not a file of bundles");
  CHECK(complaint("{\"mesecina\":\"bundles\"}") == "x.json: this file of bundles has no version");
  CHECK(complaint("{\"mesecina\":\"bundles\",\"schema\":-1}") == "x.json: this file of bundles has no version");
  const std::string begin = "{\"mesecina\":\"bundles\",\"schema\":1,\"bundles\":";
  CHECK(complaint(begin + "7}") == "x.json: \"bundles\" is not a list");
  CHECK(complaint(begin + "[]}") == "x.json: there is no bundle in it");
  CHECK(complaint(begin + "[7]}") == "x.json: bundle 1 has no name");
  CHECK(complaint(begin + "[{\"name\":\"\"}]}") == "x.json: bundle 1 has no name");
  CHECK(complaint(begin + "[{\"name\":\"a\",\"layers\":7}]}").starts_with("x.json: bundle 1: "));
  CHECK(complaint(begin + "[{\"name\":\"a\",\"description\":7}]}").starts_with("x.json: bundle 1: "));
  CHECK(complaint(begin + "[{\"name\":\"a\",\"note\":7}],\"note\":8}").empty());
  const std::string future = "{\"mesecina\":\"bundles\",\"schema\":2,\"bundles\":[]}";
  CHECK(complaint(future) == "x.json: these bundles are of a later version of the program");
  CHECK(are_bundles_of_the_future(future));
  CHECK_FALSE(are_bundles_of_the_future(begin + "[]}"));
  CHECK_FALSE(are_bundles_of_the_future("{"));
}

TEST_CASE("a BND file is read by its grammar") {
  const auto loaded = read(file(text(u"na\u00efve \xD83D\xDE00 \xD800.") + bundle(layer(u"Points", state(true))) +
                                kNull + bundle(layer(u"Points", state(false)))));
  REQUIRE(loaded);
  REQUIRE(loaded->bundles.size() == 2);
  CHECK(loaded->bundles[0].name == "na\xc3\xafve \xf0\x9f\x98\x80 \xef\xbf\xbd.");
  CHECK(loaded->bundles[1].name == "Bundle 2");
  CHECK(loaded->warnings.empty());
  REQUIRE(loaded->bundles[0].layers.layers.size() == 1);
  const LayerConfiguration::Entry& entry = loaded->bundles[0].layers.layers[0];
  CHECK(entry.layer == "points");
  CHECK(entry.visible);
  CHECK(entry.style.color == Rgb{255, 128, 0});
  CHECK(entry.style.opacity == Approx(0.5).margin(1e-4));
  CHECK(entry.style.point_size_px == 5.0);
  CHECK(entry.style.line_width_px == 2.0);
  CHECK(entry.style.color_map.empty());
  CHECK_FALSE(loaded->bundles[1].layers.layers[0].visible);
}

TEST_CASE("a state in BND has a tail in either form, or none, and sizes of four bytes or eight") {
  const LayerConfiguration plain = one(layer(u"Points", state(true, text(u"maps/gray.map"))));
  CHECK(plain.layers.at(0).style.color_map == "gray");
  for (const std::string& tail :
       {text(u"a.png") + "\x01", kNull + std::string(1, '\0'), u32(6) + std::string("a.png\0\x01", 7)})
    CHECK(one(layer(u"Points", state(true, text(u"gray"), tail))) == plain);
  CHECK(one(layer(u"Points", state<double>(true, text(u"gray"), {}, 5))) == plain);
  CHECK(one(layer(u"Points", state(true, kNull, {}, 1e9F))).layers.at(0).style.point_size_px == 64.0);
  CHECK(one(layer(u"Points", state(true, kNull, {}, -1.F))).layers.at(0).style.point_size_px == 0.5);
}

TEST_CASE("layers of 2007 and 2009 are found under their names of today") {
  const auto id = [](const std::u16string& name) { return one(layer(name, state(true))).layers.at(0).layer; };
  CHECK(id(u"Local crust") == "curve");
  CHECK(id(u"A medial axis") == "medial-axis");
  CHECK(id(u"A onestep medial axis") == "medial-axis");
  CHECK(id(u"Full medial axis") == "all-medial-axis");
  CHECK(id(u"All medial axis") == "all-medial-axis");
  CHECK(id(u"A V crosssing edges") == "a-v-crossing-edges");
  CHECK(id(u"A V crossing edges") == "a-v-crossing-edges");
  CHECK(id(u"A inner vertices") == "a-inner-centers");
  CHECK(id(u"A power diagram") == "a-ball-power-diagram");
  const LayerConfiguration of_2007 =
      one(layer(u"A power diagram", state(true)) + layer(u"A regular triangulation", state(true)));
  CHECK(of_2007.layers.at(0).layer == "a-power-diagram");
}

TEST_CASE("two layers of old that are one today look as the one that was shown") {
  for (const bool first : {true, false}) {
    const LayerConfiguration out = one(layer(u"A medial axis", state(first, kNull, {}, first ? 9.F : 5.F)) +
                                       layer(u"A onestep medial axis", state(!first, kNull, {}, first ? 5.F : 9.F)));
    REQUIRE(out.layers.size() == 1);
    CHECK(out.layers[0].visible);
    CHECK(out.layers[0].style.point_size_px == 9.0);
  }
  // Where both were shown or neither was, as the first.
  for (const bool shown : {true, false}) {
    const LayerConfiguration out = one(layer(u"A medial axis", state(shown, kNull, {}, 9.F)) +
                                       layer(u"A onestep medial axis", state(shown, kNull, {}, 5.F)));
    REQUIRE(out.layers.size() == 1);
    CHECK(out.layers[0].visible == shown);
    CHECK(out.layers[0].style.point_size_px == 9.0);
  }
}

TEST_CASE("layers of BND that are not available are left out and counted once") {
  const std::string layers = layer(u"Moebius centers", state(true)) + layer(u"Points", state(true));
  const auto loaded = read(file(text(u"a") + bundle(layers) + text(u"b") + bundle(layers)));
  REQUIRE(loaded);
  CHECK(loaded->bundles.at(1).layers.layers.size() == 1);
  REQUIRE(loaded->warnings.size() == 1);
  CHECK(loaded->warnings[0] == "old.bnd: 1 layer is not available here and left out: \"Moebius centers\"");
}

TEST_CASE("a broken BND file is refused with the byte") {
  const auto complaint = [](const std::string& bytes) {
    const auto loaded = read(bytes);
    return loaded ? std::string() : loaded.error().message();
  };
  CHECK(complaint(file("")) == "old.bnd: there is no bundle in it");
  CHECK(complaint(u32(0xB3) + u32(2)) == "old.bnd: version 2 of a file of bundles is not known (at byte 8)");
  CHECK(complaint(file(u32(0xFFFFFFF0))) == "old.bnd: the length of a text is wrong (at byte 12)");
  CHECK(complaint(file(u32(3) + "abc")) == "old.bnd: the length of a text is wrong (at byte 12)");
  CHECK(complaint(file(text(u"a") + u32(0x7FFFFFFF))) == "old.bnd: a block is longer than the file (at byte 18)");
  CHECK(complaint(file(text(u"a") + block(u32(0xB1) + u32(1)))) == "old.bnd: this is not a bundle (at byte 22)");
  CHECK(complaint(file(text(u"a") + bundle(layer(u"Points", state(true) + "xx")))) ==
        "old.bnd: the file ends too early (at byte 78)");
  const std::string whole = file(text(u"a") + bundle(layer(u"Points", state(true, text(u"gray")))));
  REQUIRE(complaint(whole).empty());
  for (std::size_t length = 9; length < whole.size(); ++length)
    CHECK_FALSE(complaint(whole.substr(0, length)).empty());
}

TEST_CASE("no change of bytes makes the reader of BND fail otherwise than in words") {
  std::string whole;
  for (const char16_t* name : {u"a", u"b", u"c"})
    whole += text(name) + bundle(layer(u"Points", state(true, text(u"gray"), text(u"x") + "\x01")) +
                                 layer(u"Local crust", state(false)) + layer(u"Witness", state(true)));
  whole = file(whole);
  Rng rng(7);
  std::size_t read_well = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string bytes = whole;
    const std::uint64_t changes = 1 + rng.below(4);
    for (std::uint64_t i = 0; i < changes; ++i) {
      const std::size_t at = rng.below(bytes.size());
      switch (rng.below(4)) {
        case 0: bytes[at] = static_cast<char>(rng.below(256)); break;
        case 1: bytes.erase(at, rng.below(8)); break;
        case 2: bytes.insert(at, rng.below(8), '\xFF'); break;
        default: bytes[at] = static_cast<char>(bytes[at] ^ 1 << rng.below(8)); break;
      }
    }
    const auto loaded = read(bytes);
    if (!loaded) {
      CHECK_FALSE(loaded.error().text.empty());
      continue;
    }
    ++read_well;
    std::size_t size = 0;
    for (const Bundle& each : loaded->bundles) size += each.name.size() + each.layers.layers.size();
    CHECK(size < 4 * bytes.size());
    CHECK(read_bundles(write_bundles(loaded->bundles), "x", kLayers));
  }
  CHECK(read_well > 100);
}

TEST_CASE("files of bundles are recognised") {
  const TemporaryFolder folder;
  CHECK(is_bundle_file(folder.write("a.json", write_bundles({}))));
  CHECK(is_bundle_file(folder.write("b", file(""))));
  CHECK_FALSE(is_bundle_file(folder.write("c.json", "{\"mesecina\":\"session\"}")));
  CHECK_FALSE(is_bundle_file(folder.write("d.poff", "POFF\n0 0 0\n")));
  CHECK_FALSE(is_bundle_file(folder.write("e", "")));
  CHECK_FALSE(is_bundle_file(folder.path()));
  CHECK_FALSE(is_bundle_file(folder / "none"));
  CHECK(is_bundle_file(folder.write("f.bnd", "POFF")));
  CHECK(read_bundle_file(folder / "f.bnd", kLayers).error().text == "this is not a file of bundles");
  CHECK(read_bundle_file(folder / "none", kLayers).error().text == "there is no such file");
  CHECK(read_bundle_file(folder / "e", kLayers).error().text == "this is not JSON");
  CHECK(read_bundle_file(folder.path(), kLayers).error().text == "this is not a file");
}

TEST_CASE("what a style does not say is the layer's own") {
  const auto json = read_bundles(R"({"mesecina":"bundles","schema":1,"bundles":[{"name":"a","layers":[
    {"layer":"curve","visible":true,"style":{"opacity":0.5}},{"layer":"medial-axis"},{"layer":"unheard-of"}]}]})",
                                 "x.json", kLayers);
  REQUIRE(json);
  const auto& layers = json->bundles.at(0).layers.layers;
  CHECK(layers[0].style == LayerStyle{.opacity = 0.5, .line_width_px = 2.0, .flat = true});
  CHECK(layers[1].style.dashed);
  CHECK(layers[2].style == LayerStyle{});
  // Files of earlier versions do not know it.
  CHECK(layers[0].style.thin_when_dense);
  const auto bnd = read_bundles(file(text(u"a") + bundle(layer(u"Local crust", state(true)))), "x.bnd", kLayers);
  REQUIRE(bnd);
  CHECK(bnd->bundles.at(0).layers.layers.at(0).style.flat);
}

TEST_CASE("colours are six digits, numbers come into range, and nothing is longer than anyone could mean") {
  const auto with = [](const std::string& entry) {
    return read_bundles(R"({"mesecina":"bundles","schema":1,"bundles":[{"name":"a","layers":[)" + entry + "]}]}",
                        "x.json", kLayers);
  };
  for (const char* color : {"red", "#12345", "#1234567", "# 12345", "#-12345", "#+12345", "#0x1234", "#12345g", ""})
    CHECK(with(R"({"layer":"x","style":{"color":")" + std::string(color) + "\"}}").error().text.contains("#RRGGBB"));
  const auto wild = with(R"({"layer":"x","style":{"opacity":7,"point_size":-3,"line_width":1e9,"range":[3,1]}})");
  REQUIRE(wild);
  const LayerStyle& style = wild->bundles.at(0).layers.layers.at(0).style;
  CHECK(style.opacity == 1.0);
  CHECK(style.point_size_px == 0.5);
  CHECK(style.line_width_px == 64.0);
  CHECK(style.range_high == 3.0);
  CHECK(with(R"({"layer":")" + std::string(201, 'x') + "\"}").error().text.ends_with("longer than 200 bytes"));
  std::string many = "{}";
  for (int i = 0; i < 10'000; ++i) many += ",{}";
  CHECK(with(many).error().text.ends_with("more than 10000"));
}
