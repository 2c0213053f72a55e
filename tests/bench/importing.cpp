// SPDX-License-Identifier: GPL-3.0-or-later
// What reading a drawing or a map costs, from its bytes to samples with their curves, against the parser of the library
// alone: processor time of all threads, for drawings are read on several; a note says the same of the clock.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/base/jobs/parallel.h"
#include "core/io/format.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"

namespace mes::bench {
namespace {

constexpr std::size_t kVertices = 1'000'000;
constexpr std::size_t kRings = 1000;

/// Calls `use(ring, x, y)` for each vertex: coasts of a thousand islands.
template <class Use>
void for_each_vertex(Use use) {
  constexpr std::size_t kEach = kVertices / kRings;
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    const double x = 0.25 * static_cast<double>(ring % 32);
    const double y = 0.25 * static_cast<double>(ring / 32);
    for (std::size_t i = 0; i < kEach; ++i) {
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kEach);
      const double radius = 0.1 * (1.0 + 0.1 * std::cos(7.0 * turn) + 0.02 * std::cos(61.0 * turn));
      use(ring, x + radius * std::cos(turn), y + radius * std::sin(turn));
    }
  }
}

std::string svg_of_islands() {
  std::string out = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-100 -100 9000 9000">)";
  std::size_t last = kRings;
  for_each_vertex([&](std::size_t ring, double x, double y) {
    if (ring != last) out += last == kRings ? R"(<path d="M)" : R"(Z"/><path d="M)";
    fmt::format_to(std::back_inserter(out), "{}{:.3f} {:.3f}", ring == last ? "L" : "", 1000.0 * x, 1000.0 * y);
    last = ring;
  });
  return out + R"(Z"/></svg>)";
}

std::string geojson_of_islands() {
  std::string out = R"({"type":"MultiPolygon","coordinates":[)";
  std::size_t last = kRings;
  for_each_vertex([&](std::size_t ring, double x, double y) {
    if (ring != last) out += last == kRings ? "[[" : "]],[[";
    fmt::format_to(std::back_inserter(out), "{}[{:.7f},{:.7f}]", ring == last ? "," : "", x, y);
    last = ring;
  });
  return out + "]]]}";
}

/// `parse(bytes)` is what the library does; true where it went well.
template <class Parse>
void importing(benchmark::State& state, RatioTable& table, const char* what, const std::string& bytes,
               const char* against, Parse parse) {
  using Clock = std::chrono::steady_clock;
  const auto us_since = [](Clock::time_point begin) {
    return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
  };
  std::vector<double> ours;
  std::vector<double> raw;
  std::vector<double> ours_by_clock;
  std::vector<double> raw_by_clock;
  for (auto _ : state) {
    Clock::time_point begin = Clock::now();
    double start = process_us();
    const bool is_parsed = parse(bytes);
    raw.push_back(process_us() - start);
    raw_by_clock.push_back(us_since(begin));
    begin = Clock::now();
    start = process_us();
    const auto file = read_sample_bytes(bytes, what);
    ours.push_back(process_us() - start);
    ours_by_clock.push_back(us_since(begin));
    if (!is_parsed || !file || file->data.positions.size() != kVertices) {
      state.SkipWithError("it was not read");
      return;
    }
  }
  table.add({what, kVertices, median(ours), median(raw), 3.0, against});
  table.add_note(fmt::format("{}, {} vertices, by the clock on {} threads: {:.2f} times {}", what, kVertices,
                             worker_count(), median(ours_by_clock) / median(raw_by_clock), against));
}

void import_svg(benchmark::State& state, RatioTable& table) {
  importing(state, table, "import of SVG", svg_of_islands(), "pugixml parsing it", [](const std::string& bytes) {
    pugi::xml_document document;
    return static_cast<bool>(document.load_buffer(bytes.data(), bytes.size()));
  });
}

void import_geojson(benchmark::State& state, RatioTable& table) {
  importing(state, table, "import of GeoJSON", geojson_of_islands(), "nlohmann-json parsing it, keeping nothing",
            [](const std::string& bytes) { return nlohmann::json::accept(bytes); });
}

}  // namespace

void register_importing(RatioTable& table) {
  constexpr int kRuns = 7;
  benchmark::RegisterBenchmark("importing/svg", [&table](benchmark::State& state) { import_svg(state, table); })
      ->Iterations(kRuns)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("importing/geojson",
                               [&table](benchmark::State& state) { import_geojson(state, table); })
      ->Iterations(kRuns)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
