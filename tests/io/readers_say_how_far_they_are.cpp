// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of every format can be stopped, wherever it is, and says how far it is.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/format.h"
#include "core/io/session/session.h"
#include "tests/io/temporary_folder.h"

using namespace mes;

namespace {

constexpr int kVertices = 30'000;

/// Of a circle, so that no two of them are equal and none is zero.
template <class Write>
std::string of_all(const char* begin, const char* between, const char* end, Write write) {
  std::string out = begin;
  for (int i = 0; i < kVertices; ++i) {
    const double turn = 6.25 * i / kVertices;
    if (i != 0) out += between;
    write(std::back_inserter(out), i, 500.0 + 100.0 * std::cos(turn), 500.0 + 100.0 * std::sin(turn));
  }
  return out + end;
}

void append_double(std::string& out, double value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string ply_of_vertices() {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\nend_header\n",
      kVertices);
  for (int i = 0; i < kVertices; ++i) {
    append_double(out, 500.0 + std::cos(6.25 * i / kVertices));
    append_double(out, 500.0 + std::sin(6.25 * i / kVertices));
  }
  return out;
}

void append_big(std::string& out, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) out += static_cast<char>((value >> shift) & 0xffU);
}
void append_little(std::string& out, std::uint32_t value) {
  for (const unsigned shift : {0U, 8U, 16U, 24U}) out += static_cast<char>((value >> shift) & 0xffU);
}

/// One set of points.
std::string shapefile() {
  std::string content;
  append_little(content, 8);
  for (int i = 0; i < 4; ++i) append_double(content, 0.0);
  append_little(content, kVertices);
  for (int i = 0; i < kVertices; ++i) {
    append_double(content, 500.0 + std::cos(6.25 * i / kVertices));
    append_double(content, 500.0 + std::sin(6.25 * i / kVertices));
  }
  std::string out;
  append_big(out, 9994);
  out.resize(24, '\0');
  append_big(out, static_cast<std::uint32_t>((100 + 8 + content.size()) / 2));
  append_little(out, 1000);
  append_little(out, 8);
  out.resize(100, '\0');
  append_big(out, 1);
  append_big(out, static_cast<std::uint32_t>(content.size() / 2));
  return out + content;
}

struct Example {
  const char* format;
  std::string bytes;
};

std::vector<Example> examples() {
  const auto pair = [](auto out, int, double x, double y) { fmt::format_to(out, "{} {}", x, y); };
  const auto numbered = [](auto out, int i, double x, double y) { fmt::format_to(out, "{} {} {}", i + 1, x, y); };
  const auto triple = [](auto out, int, double x, double y) { fmt::format_to(out, "{} {} 1", x, y); };
  const std::string count = std::to_string(kVertices);
  std::vector<Example> out;
  out.push_back({"poff", of_all(("POFF " + count + " 0 0\n").c_str(), "\n", "\n", pair)});
  out.push_back({"wpoff", of_all(("WPOFF " + count + " 0 0\n").c_str(), "\n", "\n", triple)});
  out.push_back({"pairs", of_all("", "\n", "\n", pair)});
  out.push_back({"csv", of_all("x,y\n", "\n", "\n",
                               [](auto to, int, double x, double y) { fmt::format_to(to, "{},{}", x, y); })});
  out.push_back({"svg", of_all("<svg><path d='M", "L", "Z'/></svg>", pair)});
  out.push_back({"wkt", of_all("LINESTRING (", ", ", ")", pair)});
  out.push_back({"geojson", of_all(R"({"type":"LineString","coordinates":[)", ",", "]}",
                                   [](auto to, int, double x, double y) { fmt::format_to(to, "[{},{}]", x, y); })});
  out.push_back({"obj", of_all("v ", "\nv ", "\n", triple)});
  out.push_back({"off", of_all(("OFF\n" + count + " 0 0\n").c_str(), "\n", "\n", triple)});
  out.push_back({"ply", of_all(("ply\nformat ascii 1.0\nelement vertex " + count +
                                "\nproperty double x\nproperty double y\nend_header\n")
                                   .c_str(),
                               "\n", "\n", pair)});
  out.push_back({"ply", ply_of_vertices()});
  out.push_back({"triangle", of_all((count + " 2 0 0\n").c_str(), "\n", "\n", numbered)});
  out.push_back({"edg", of_all((count + "\n").c_str(), "\n", "\n", [](auto to, int i, double x, double y) {
                   fmt::format_to(to, "{} {} {} {}", x, y, x + 1.0 + i, y);
                 })});
  out.push_back({"shapefile", shapefile()});
  out.push_back(
      {"ipe", of_all("<ipe><page><path>", " l\n", " l\n</path></page></ipe>", [](auto to, int i, double x, double y) {
         fmt::format_to(to, "{} {}{}", x, y, i == 0 ? " m\n1 1" : "");
       })});
  out.push_back(
      {"dxf", of_all("0\nSECTION\n2\nENTITIES\n", "", "0\nENDSEC\n0\nEOF\n", [](auto to, int, double x, double y) {
         fmt::format_to(to, "0\nPOINT\n10\n{}\n20\n{}\n", x, y);
       })});
  return out;
}

}  // namespace

TEST_CASE("every reader can be stopped at each of its looks, and there are many") {
  for (const Example& example : examples()) {
    INFO(example.format);
    JobControl all;
    const auto whole = read_sample_bytes(example.bytes, "a", {}, {}, &all);
    INFO((whole ? std::string() : whole.error().message()));
    REQUIRE(whole.has_value());
    CHECK(whole->format == example.format);
    CHECK(all.progress() > 0.8);
    // A stop that was requested before ends it at once, and later ones where it is.
    std::size_t looks = 0;
    double last = 0.0;
    for (std::int64_t look = 1;; ++look) {
      JobControl job;
      job.stop_at_look(look);
      const auto file = read_sample_bytes(example.bytes, "a", {}, {}, &job);
      if (file) break;
      REQUIRE(file.error().code == ErrorCode::cancelled);
      REQUIRE(job.progress() >= last);
      // A drawing is read by its libraries and by several threads in large pieces.
      if (std::string_view(example.format) == "geojson" && look <= 64) REQUIRE(job.progress() - last < 0.25);
      last = job.progress();
      if (look > 64) look += look / 2;
      ++looks;
    }
    CHECK(looks >= 4);
  }
}

TEST_CASE("a reading that is not stopped is the same with and without a job") {
  for (const Example& example : examples()) {
    INFO(example.format);
    JobControl job;
    const auto with = read_sample_bytes(example.bytes, "a", {}, {}, &job);
    const auto without = read_sample_bytes(example.bytes, "a");
    REQUIRE(with.has_value());
    REQUIRE(without.has_value());
    CHECK(with->data.positions == without->data.positions);
    CHECK(with->data.balls.size() == without->data.balls.size());
    CHECK(with->warnings == without->warnings);
  }
}

TEST_CASE("a session on disk says how far it is read without going back") {
  Session session;
  SampleData data;
  for (int i = 0; i < kVertices; ++i)
    data.positions.push_back({500.0 + std::cos(6.25 * i / kVertices), 500.0 + std::sin(6.25 * i / kVertices)});
  session.data = std::make_shared<const SampleData>(std::move(data));
  const test::TemporaryFolder folder;
  folder.write("many.json", write_session(session));
  double last = 0.0;
  for (std::int64_t look = 1;; ++look) {
    JobControl job;
    job.stop_at_look(look);
    const auto file = read_sample_file(folder / "many.json", {}, &job);
    REQUIRE(job.progress() >= last);
    last = job.progress();
    if (file) break;
    REQUIRE(file.error().code == ErrorCode::cancelled);
  }
  CHECK(last > 0.8);
}
