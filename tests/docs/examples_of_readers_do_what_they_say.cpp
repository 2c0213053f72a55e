// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest uses in the comments of the headers of core/io, word for word, each with what it needs around it.
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/files/file_lock.h"
#include "core/io/maps/map_shapes.h"
#include "core/io/meshes/vertex_graph.h"
#include "core/io/session/json_text.h"
#include "core/io/session/json_view.h"
#include "core/io/session/session.h"
#include "core/io/session/session_values.h"
#include "core/io/systems/chosen_plane.h"
#include "core/io/systems/coordinate_system.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/coordinate_pairs.h"
#include "core/io/text/counted_remarks.h"
#include "core/io/text/line_layout.h"
#include "core/io/text/line_words.h"
#include "core/io/text/read_job.h"
#include "core/io/text/repeated_corners.h"
#include "core/io/text/short_decimal.h"
#include "core/io/text/text_numbers.h"
#include "core/io/text/written_decimals.h"
#include "core/io/xml/xml_long_values.h"
#include "core/io/xml/xml_source.h"
#include "tests/io/temporary_folder.h"

using namespace mes;

namespace {

Expected<LoadedFile> crete(const std::string& name) {
  const ReadRequest request;
  ReadJob job;
  // core/io/maps/map_shapes.h
  MapShapes shapes(request);
  shapes.assume_degrees();
  for (const Vec2 corner : {Vec2{23.9, 35.5}, Vec2{26.0, 35.2}, Vec2{24.8, 34.9}}) shapes.add(corner);
  shapes.end_ring();
  return std::move(shapes).load(name, job);
}

Expected<LoadedFile> file_of_triangle(const std::string& name) {
  ReadJob job;
  // core/io/meshes/vertex_graph.h
  VertexGraph graph;
  for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}) graph.add_vertex(corner);
  graph.add_face(std::vector<std::uint32_t>{0, 1, 2});
  return std::move(graph).load(name, job);
}

Expected<std::size_t> lines_with_positions(std::string_view bytes, const std::string& name) {
  // core/io/text/line_words.h
  LineWords lines(bytes, name);
  while (lines.next()) {
    const auto position = lines.position(0);
    if (!position) return std::unexpected(position.error());
  }
  return lines.line();
}

void go_through(std::string_view text, JobControl& control) {
  // core/io/text/read_job.h
  ReadJob job(&control);
  job.begin(text);
  for (const char& c : text) job.passed(&c);
}

Expected<std::size_t> count_timeline(std::string_view text) {
  const std::string file = "a.json";
  std::size_t count = 0;
  const auto use = [&count](const JsonView& entry) { count += entry.is_object() ? 1U : 0U; };
  // core/io/session/json_view.h
  if (auto good = check_json(text, file); !good) return std::unexpected(good.error());
  for (const JsonView entry : JsonView::whole(text).find("timeline").elements()) use(entry);
  return count;
}

}  // namespace

TEST_CASE("core/io/text/written_decimals.h") {
  const double a = 0.12346;
  for (const auto& [b, expected] : {std::pair(0.123465, true), std::pair(0.1236, false)}) {
    WrittenDecimals decimals;
    for (const std::string_view word : {"0.12346", "2", "1.12346"}) decimals.add(word);
    const bool are_equal = std::abs(a - b) <= 2.0 * decimals.error_of(2.0);
    CHECK(are_equal == expected);
  }
}

TEST_CASE("core/io/text/text_numbers.h") {
  const std::string_view bytes = "1 2\n 3";
  std::vector<std::uint64_t> columns;
  const auto use = [&columns](std::string_view, std::uint64_t, std::uint64_t column) { columns.push_back(column); };
  Scanner scanner(bytes);
  while (scanner.next()) use(scanner.token(), scanner.line(), scanner.column());
  CHECK(columns == std::vector<std::uint64_t>{1, 3, 2});
}

TEST_CASE("core/io/text/read_job.h") {
  const std::string text(std::size_t{1} << 20U, 'x');
  JobControl control;
  go_through(text, control);
  CHECK(control.progress() > 0.8);
  CHECK(control.progress() < 0.91);
  std::stop_source source;
  source.request_stop();
  JobControl stopped(source.get_token());
  CHECK_THROWS_AS(go_through(text, stopped), Cancelled);
}

TEST_CASE("core/io/text/line_layout.h") {
  struct Number {
    std::uint64_t line, column;
    std::size_t length;
  };
  const std::vector<Number> numbers{{2, 1, 1}, {2, 3, 1}, {2, 5, 1}, {3, 1, 1}, {3, 3, 1}, {3, 5, 1}};
  const std::uint64_t header_line = 1;
  const std::uint64_t announced = 2;
  std::uint64_t refused_line = 0;
  const auto refuse = [&refused_line](const LineLayout::OddLine& line) { refused_line = line.place.line; };
  LineLayout layout(2, header_line);
  for (const auto& number : numbers) layout.add(number.line, number.column, number.length);
  layout.end();
  if (const auto line = layout.contradiction(announced)) refuse(*line);
  CHECK(refused_line == 2);
}

TEST_CASE("core/io/session/session.h") {
  Session given;
  SampleData data;
  data.positions = {{0, 0}, {1, 0}, {0, 1}};
  given.data = std::make_shared<const SampleData>(data);
  const std::string text = write_session(given);
  auto session = read_session(text, "a.json");
  DocumentReplay replay;
  auto done = replay_session(*session, replay, "a.json");
  REQUIRE(done);
  CHECK(replay.document().sample_count() == data.positions.size());
}

TEST_CASE("core/io/session/json_view.h") {
  const auto count = count_timeline(R"({"timeline": [{}, {}, {}]})");
  REQUIRE(count);
  CHECK(*count == 3);
  CHECK_FALSE(count_timeline("{"));
}

TEST_CASE("core/io/session/session_values.h") {
  const std::string text = R"({"samples": [0, 1, 2, 3]})";
  REQUIRE(check_json(text, "a.json"));
  const JsonView object = JsonView::whole(text);
  Magnitudes seen;
  // core/io/session/session_values.h
  std::vector<Vec2> samples;
  read_flat(object.find("samples"), "samples", samples, "data");
  require_together(samples, object.find("samples"), "samples", "data", seen);
  CHECK(samples == std::vector<Vec2>{{0, 1}, {2, 3}});
  CHECK_FALSE(seen.is_empty());
}

TEST_CASE("core/io/text/repeated_corners.h") {
  SampleData data;
  data.contours = {{true, {0, 1, 2, 1}}};
  std::vector<std::string> warnings;
  const std::string name = "a.json";
  // core/io/text/repeated_corners.h
  RepeatedCorners repeated;
  for (const SampleData::Contour& contour : data.contours) repeated.add(contour);
  if (auto remark = repeated.remark(name)) warnings.push_back(*std::move(remark));
  CHECK(warnings.size() == 1);
}

TEST_CASE("maps are read as their header shows") {
  const auto island = crete("crete.json");
  REQUIRE(island);
  REQUIRE(island->data.contours.size() == 1);
  CHECK(island->data.contours.front().closed);
  REQUIRE(island->data.source);
  // Long lines between degrees are bent.
  CHECK(island->data.source->curves->curves.front().piece_count() > 3);
  ReadJob corners(nullptr, 0.0, true);
  MapShapes shapes(ReadRequest{});
  shapes.assume_degrees();
  for (const Vec2 corner : {Vec2{23.9, 35.5}, Vec2{26.0, 35.2}, Vec2{24.8, 34.9}}) shapes.add(corner);
  shapes.end_ring();
  CHECK(std::move(shapes).load("crete.json", corners)->data.source->curves->curves.front().piece_count() == 3);
  CHECK(island->data.positions.size() > 300);  // between the corners, too
}

TEST_CASE("a file is changed under its lock as the header shows") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "count";
  std::string on_disk = "a";
  const auto read = [&](const std::filesystem::path&) { return on_disk; };
  const auto changed = [](const std::string& text) { return text + "b"; };
  const auto write = [&](const std::filesystem::path&, std::string text) { on_disk = std::move(text); };
  {
    // core/io/files/file_lock.h
    const UpdateLock lock(path);
    write(path, changed(read(path)));
    CHECK(lock.is_held());
    CHECK_FALSE(UpdateLock(path, std::chrono::milliseconds(0)).is_held());
  }
  CHECK(on_disk == "ab");
}

TEST_CASE("short numbers are read as their header shows") {
  // core/io/text/short_decimal.h
  double value = 0.0;
  const std::size_t size = short_decimal("12.5,3", value);  // 4
  CHECK(size == 4);
  CHECK(value == 12.5);
}

TEST_CASE("vertices and long values are read as their headers show") {
  // core/io/text/coordinate_pairs.h
  std::array<Vec2, 256> pairs;
  const PairRun run = read_coordinate_pairs("1,2 3.5-4 L 5 6 ...", 'L', pairs);
  CHECK((run.count == 3 || run.count == 0));  // where there is no SSE2

  const std::string bytes = "<svg><path d='M0 0" + std::string(3000, ' ') + "L1 1'/></svg>";
  ReadJob job;
  job.begin(bytes);
  {
    // core/io/xml/xml_long_values.h
    std::string rest;
    const auto values = take_long_values(bytes, {"d", "points"}, rest, job);
    // In `rest`, at values[0].place, one character stands for values[0].value.
    REQUIRE(values.size() == 1);
    CHECK(rest[values[0].place - 1] == '\'');
    CHECK(rest[values[0].place + 1] == '\'');
  }
  const std::string name = "a.svg";
  // core/io/xml/xml_source.h
  XmlSource source(bytes, name);
  const auto root = source.parse(job);
  REQUIRE(root);
  CHECK(std::string(root->name()) == "svg");
}

TEST_CASE("files are read as headers show") {
  const auto triangle = file_of_triangle("a");
  REQUIRE(triangle);
  CHECK(triangle->data.contours.size() == 1);
  CHECK(lines_with_positions("1 2\n3 4 5\n", "a") == 2U);
  CHECK(lines_with_positions("1 2\n3\n", "a").error().line == 2);

  std::string said;
  const auto warn = [&said](const std::string& text, std::size_t) { said += text; };
  const std::size_t place = 7;
  // core/io/text/counted_remarks.h
  CountedRemarks remarks;
  remarks.add("text element is left out", "text elements are left out", place);
  remarks.for_each([&](const std::string& text, std::size_t at) { warn(text, at); });
  CHECK(said == "1 text element is left out");
}

TEST_CASE("coordinates are converted as headers show") {
  // core/io/systems/coordinate_system.h
  const auto system = find_coordinate_system("EPSG:25832");
  REQUIRE(system);
  CHECK_FALSE(system->is_geographic);

  std::vector<Vec2> positions{{9.7, 52.3}, {9.8, 52.3}, {9.75, 52.4}};
  // core/io/systems/chosen_plane.h
  auto chosen = choose_plane(positions, *find_coordinate_system("EPSG:4258"), MapDegrees::projected);
  REQUIRE(chosen);
  const MapPlane plane = chosen->plane;
  const std::vector<Vec2> outline{{0.0, 0.0}};
  std::vector<Vec2> in_degrees;
  {
    // core/io/systems/map_conversion.h
    std::vector<Vec2> places = outline;
    if (const auto conversion = MapConversion::of(plane, MapTarget::wgs84)) conversion->from_plane(places);
    in_degrees = places;
  }
  CHECK(in_degrees[0].x == Approx(plane.longitude));
  CHECK(in_degrees[0].y == Approx(plane.latitude));
}
