// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that a text can make its reader take, for texts that hold as much as possible in as few bytes as possible.
#include <catch2/catch.hpp>
#include <functional>

#include "core/io/bundle_file.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
#include "tests/faults/faulty_memory.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::size_t kSize = 3'000'000;
constexpr double kMost = 12.0;

std::string repeated(std::string_view part, std::string_view between = ",") {
  std::string out(part);
  while (out.size() < kSize) (out += between) += part;
  return out;
}

std::string session(const std::string& rest) {
  return R"({"mesecina":"session","schema":1,)" + rest + "}";
}
std::string with_timeline(std::string_view entries) {
  return session("\"data\":{\"samples\":[0,0,1,1]},\"timeline\":[" + repeated(entries, ",\n") + "]");
}

std::string source_of(const std::string& curves) {
  return R"("source":{"drawing":{"curves":[)" + curves + R"(]},"sampling":{},"first":0,"count":0})";
}
std::string of_curves(const std::string& curves) {
  return session("\"data\":{" + source_of(curves) + "}");
}

/// The most memory in use while reading, the text included, for each byte of the text.
template <class Read>
double peak_per_byte(std::string text, const Read& read) {
  text.shrink_to_fit();
  const std::size_t before = memory_in_use() - text.capacity();
  watch_memory();
  read(text);
  return static_cast<double>(peak_of_memory() - before) / static_cast<double>(text.size());
}

}  // namespace

TEST_CASE("reading a session takes less than twelve times its text, whatever it holds") {
  const std::pair<const char*, std::string> texts[] = {
      {"samples", session("\"data\":{\"samples\":[" + repeated("0,0") + "]}")},
      {"balls", session("\"data\":{\"balls\":[" + repeated("0,0,0") + "]}")},
      {"contours", session("\"data\":{\"samples\":[0,0],\"contours\":[" + repeated("{\"points\":[0]}") + "]}")},
      {"empty contours", session("\"data\":{\"contours\":[" + repeated("{}") + "]}")},
      {"inserts", with_timeline(R"({"edit":{"insert":[0,0]}})")},
      {"empty edits", with_timeline(R"({"edit":{}})")},
      {"moves", with_timeline(R"({"edit":{"move":[0,0.25,0.5],"name":"Move sample"}})")},
      {"one long edit", session("\"timeline\":[{\"edit\":{\"insert\":[" + repeated("0,0") + "]}}]")},
      {"undo and redo", with_timeline(R"({"undo":1},{"redo":1})")},
      {"gestures", with_timeline(R"({"begin":""},{"end":1})")},
      {"curves", of_curves(repeated(R"({"closed":true,"points":[0,0,0,0]})"))},
      {"one long curve", of_curves(R"({"closed":false,"points":[)" + repeated("0,0") + "]}")},
      {"arcs", of_curves(R"({"closed":false,"points":[0,0],"arcs":[)" + repeated("0,0,0,0,0,0,0,0") + "]}")},
      {"curves in edits", with_timeline("{\"edit\":{" + source_of(R"({"closed":true,"points":[0,0,0,0]})") + "}}")},
      {"layers", with_timeline(R"({"layers":{"changed":{"layers":[{"layer":"a"}]}}})")},
      {"no layers", with_timeline(R"({"layers":{"changed":{"layers":[{}]}}})")},
      {"empty layers", with_timeline(R"({"layers":{}})")},
      {"settings", with_timeline(R"({"settings":{}})")},
      {"views", with_timeline(R"({"view":[0,0,1,1]})")},
      {"captions", with_timeline(R"({"caption":""})")},
      {"unknown entries", with_timeline(R"({"x":[1,{"y":[]}]})")},
      {"lists", session("\"x\":[" + repeated("[]") + "]")},
      {"objects", session("\"x\":[" + repeated("{\"\":0}") + "]")},
      {"keys", session(repeated("\"\":0"))},
      {"a long title", session("\"title\":\"" + std::string(kSize, 'a') + "\"")},
      {"an escaped title", session("\"title\":\"" + repeated("\\u0041", "") + "\"")},
      {"garbage", session("\"x\":[" + repeated("0") + "?")},
      {"deep nests", session("\"x\":" + std::string(kSize, '['))},
      {"parameters", session("\"evolution\":{\"parameters\":{" + repeated("\"\":0") + "}}")},
      {"steps of a lesson", session("\"lesson\":{\"steps\":[" + repeated("{}") + "]}")},
      {"a long caption", session("\"lesson\":{\"steps\":[{\"caption\":\"" + repeated("\\u0041", "") + "\"}]}")},
      {"an order", session("\"timeline\":[{\"layers\":{\"order\":[" + repeated("\"\"") + "]}}]")}};
  for (const auto& [name, text] : texts) {
    const double peak =
        peak_per_byte(text, [](const std::string& bytes) { static_cast<void>(read_session(bytes, "session.json")); });
    INFO(name << ": " << peak << " bytes a byte");
    CHECK(peak < kMost);
  }
}

TEST_CASE("reading bundles takes less than twelve times the text") {
  const std::string begin = R"({"mesecina":"bundles","schema":1,"bundles":[{"name":"a","layers":[)";
  for (const char* layer : {R"({})", R"({"layer":"medial-axis","visible":true})", R"([[],[]])"}) {
    std::string text = begin;
    const std::string list = [&] {
      std::string out = layer;
      for (int i = 1; i < 9'999; ++i) (out += ',') += layer;
      return out;
    }();
    for (int i = 0; i < 10; ++i) text += (i == 0 ? "" : R"(]},{"name":"a","layers":[)") + list;
    text += "]}]}";
    const double peak = peak_per_byte(
        text, [](const std::string& bytes) { static_cast<void>(read_bundles(bytes, "bundles.json", {})); });
    INFO(layer << ": " << peak << " bytes a byte");
    CHECK(peak < kMost);
  }
}

TEST_CASE("headers that promise much take no memory") {
  const std::pair<const char*, const char*> texts[] = {
      {"OFF\n4000000000 4000000000 0\n0 0 0\n", "a.poff"},
      {"4000000000 2 0 0\n1 0 0\n2 1 1\n", "a.node"},
      {"4000000000\n0 0 1 1\n", "a.edg"},
      {"ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty int "
       "x\nproperty int y\nend_header\n0 0\n",
       "a.ply"},
      {"POFF 4000000000 4000000000 4000000000\n0 0\n", "a.poff"},
      {"WPOFF 4000000000 0 0\n0 0 1\n", "a.wpoff"}};
  for (const auto& [text, name] : texts) {
    const std::size_t before = memory_in_use();
    watch_memory();
    CHECK_FALSE(read_sample_bytes(text, name));
    INFO(text);
    CHECK(peak_of_memory() - before < 1'000'000);
  }
}
