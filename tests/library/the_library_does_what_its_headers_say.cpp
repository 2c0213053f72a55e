// SPDX-License-Identifier: GPL-3.0-or-later
// Each promise of the public headers, against the program behind them.
#include <mesecina/mesecina.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <ranges>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

using namespace mesecina;

static_assert(std::random_access_iterator<Values<double>::Iterator>);
static_assert(std::ranges::random_access_range<Values<Point>>);
static_assert(std::is_nothrow_copy_constructible_v<Error>);
static_assert(std::is_trivially_copyable_v<Ball> && sizeof(Ball) == 3 * sizeof(double));

namespace {

std::vector<Point> ellipse(int count) {
  std::vector<Point> out;
  for (int i = 0; i < count; ++i) {
    const double t = 2.0 * std::numbers::pi * i / count;
    out.push_back({2.0 * std::cos(t), std::sin(t)});
  }
  return out;
}

/// The code of the error that the call throws; nothing: it throws none.
template <class Call>
std::optional<ErrorCode> code_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    INFO(error.what());
    CHECK_FALSE(error.text().empty());
    return error.code();
  }
  return {};
}

}  // namespace

TEST_CASE("edits, undo and redo lead to the geometry of the data") {
  Workbench bench;
  const std::vector<SampleId> ids = bench.insert(ellipse(40));
  bench.show({"medial-axis", "curve"});
  bench.run();
  const std::string whole = bench.digest("medial-axis");
  CHECK(bench.instances("curve", PrimitiveKind::segment).size() == 40);
  CHECK(bench.instances("curve", PrimitiveKind::arc).empty());
  CHECK(bench.sample_ids() == ids);

  {
    const Step step(bench, "Move two");
    bench.move(ids[0], {2.1, 0.01});
    bench.remove(std::array{ids[5]});
    CHECK(code_of([&] { bench.begin_step("Another"); }) == ErrorCode::usage);
    CHECK_FALSE(bench.undo());
  }
  bench.run();
  CHECK(bench.digest("medial-axis") != whole);
  CHECK(bench.position(ids[0]) == Point{2.1, 0.01});
  CHECK_FALSE(bench.position(ids[5]));

  Workbench fresh;
  fresh.load(bench.data());
  fresh.show({"medial-axis"});
  fresh.run();
  CHECK(fresh.digest("medial-axis") == bench.digest("medial-axis"));

  CHECK(bench.undo());
  bench.run();
  CHECK(bench.digest("medial-axis") == whole);
  CHECK(bench.position(ids[5]));
  CHECK(bench.can_redo());
  CHECK(bench.redo());
}

TEST_CASE("balls are edited like samples") {
  Workbench bench;
  const BallId id = bench.insert_ball({{0.0, 0.0}, 1.0});
  bench.change_balls(std::array{ChangedBall{id, {{1.0, 0.0}, 2.0}}});
  CHECK(bench.ball(id) == Ball{{1.0, 0.0}, 2.0});
  CHECK(bench.ball_ids() == std::vector{id});
  bench.remove_balls(std::array{id});
  CHECK(bench.ball_count() == 0);
  CHECK(code_of([&] { bench.insert_ball({{0.0, 0.0}, -1.0}); }).has_value());
  CHECK(bench.ball_count() == 0);
}

TEST_CASE("what is refused changes nothing, and says why") {
  Workbench bench;
  bench.insert(ellipse(10));
  CHECK(code_of([&] { bench.remove(std::array{SampleId{12345}}); }).has_value());
  CHECK(code_of([&] { bench.insert({std::nan(""), 0.0}); }).has_value());
  CHECK(bench.sample_count() == 10);
  CHECK(code_of([&] { bench.show({"curv"}); }) == ErrorCode::usage);
  CHECK(code_of([&] { bench.need({"delauny"}); }) == ErrorCode::usage);
  CHECK(code_of([&] { bench.set("no-such-parameter", 1.0); }) == ErrorCode::usage);
  CHECK(code_of([&] { bench.set_precision("rough"); }) == ErrorCode::usage);
  CHECK(bench.precision() == "fast");
  bench.run();
  CHECK(code_of([&] { bench.table("delaunay/faces"); }) == ErrorCode::usage);
  CHECK(code_of([&] { bench.digest("curve"); }) == ErrorCode::usage);
  CHECK(code_of([&] { bench.text("docx"); }) == ErrorCode::usage);
  Workbench other = std::move(bench);
  CHECK(code_of([&] { bench.run(); }) == ErrorCode::usage);
  bench = std::move(other);
  CHECK(bench.sample_count() == 10);
}

TEST_CASE("errors in files have their places") {
  Workbench bench;
  try {
    bench.open_bytes("POFF 2 0 0\n0 0\n0 zero\n", "bad.poff");
    FAIL("it was read");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::bad_input);
    CHECK(error.file() == "bad.poff");
    CHECK(error.line() > 0);
    CHECK(std::string(error.what()).starts_with("bad.poff:"));
  }
}

TEST_CASE("settings are read back, and saved in a session") {
  Workbench bench;
  bench.load({.samples = ellipse(12), .balls = {{{0.0, 0.0}, 0.25}}});
  for (const ParameterInfo& parameter : bench.catalogue().parameters()) {
    INFO(parameter.id);
    CHECK(bench.value(parameter.id) == parameter.default_value);
    bench.set(parameter.id, parameter.high);
    CHECK(bench.value(parameter.id) == parameter.high);
  }
  bench.set_precision("exact");
  Workbench other;
  other.open_bytes(bench.text("session"), "saved.json");
  CHECK(other.precision() == "exact");
  CHECK(other.data() == bench.data());
  for (const ParameterInfo& parameter : bench.catalogue().parameters())
    CHECK(other.value(parameter.id) == parameter.high);
  other.reset_settings();
  CHECK(other.precision() == "fast");
  other.open_bytes(bench.text("poff"), "saved.poff");
  CHECK(other.data().samples == bench.data().samples);
  CHECK(other.ball_count() == 0);
}

TEST_CASE("a view of a column has the values that a copy has") {
  Workbench bench;
  bench.insert(ellipse(30));
  bench.want_statistics();
  for (const StructureInfo& structure : bench.catalogue().structures()) {
    INFO(structure.id);
    bench.need({structure.id});
    bench.run();
    const std::vector<Table> tables = bench.tables(structure.id);
    REQUIRE(tables.size() == structure.tables.size());
    for (std::size_t i = 0; i < tables.size(); ++i) {
      CHECK(tables[i].id() == structure.tables[i].id);
      for (const Column& column : tables[i].columns()) {
        INFO(tables[i].id() + " " + column.name());
        if (column.info().type != ColumnType::float64 || column.info().width != 2) continue;
        const std::vector<Point> copied = column.copy<Point>();
        CHECK(copied.size() == tables[i].rows());
        CHECK(code_of([&] { column.copy<double>(); }) == ErrorCode::usage);
        if (!column.info().is_stored) {
          CHECK(code_of([&] { column.values<Point>(); }) == ErrorCode::usage);
          continue;
        }
        const Values<Point> values = column.values<Point>();
        for (const Row row : tables[i].live_rows()) CHECK(values[row] == copied[row]);
        CHECK(values.end() - values.begin() == static_cast<std::ptrdiff_t>(tables[i].rows()));
      }
    }
  }
  bench.need({"delaunay"});
  bench.run();
  const Table faces = bench.table("delaunay/faces");
  CHECK(static_cast<double>(faces.live_rows().size()) >= bench.number("delaunay", "faces"));
}

TEST_CASE("history can be forgotten") {
  Workbench bench;
  const SampleId id = bench.insert({1.0, 2.0});
  bench.begin_step("Move");
  CHECK(code_of([&] { bench.forget_history(); }) == ErrorCode::usage);
  bench.move(id, {3.0, 4.0});
  bench.end_step();
  bench.undo();
  bench.forget_history();
  CHECK_FALSE(bench.can_undo());
  CHECK_FALSE(bench.can_redo());
  CHECK(*bench.position(id) == Point{1.0, 2.0});
  bench.move(id, {5.0, 6.0});
  CHECK(bench.undo());
  CHECK_FALSE(bench.undo());
  CHECK(bench.sample_count() == 1);
}

TEST_CASE("a table says what changed, and when it is outdated") {
  std::optional<Table> kept;
  {
    Workbench bench;
    const std::vector<SampleId> ids = bench.insert(ellipse(200));
    bench.need({"delaunay"});
    bench.run();
    const Table before = bench.table("delaunay/faces");
    CHECK_FALSE(before.changes());
    const std::vector<Point> centers_before = before.column("circumcenter").copy<Point>();
    bench.get_ready();
    const Point at = *bench.position(ids[7]);
    bench.move(ids[7], {1.01 * at.x, 1.01 * at.y});
    CHECK(before.is_current());
    bench.run();
    CHECK_FALSE(before.is_current());
    CHECK(code_of([&] { before.rows(); }) == ErrorCode::usage);
    kept = bench.table("delaunay/faces");
    const auto changes = kept->changes();
    REQUIRE(changes);
    const std::set<Row> touched(changes->touched.begin(), changes->touched.end());
    CHECK_FALSE(touched.empty());
    CHECK(touched.size() < 100);
    const std::vector<Point> centers = kept->column("circumcenter").copy<Point>();
    for (const Row row : kept->live_rows())
      if (!touched.contains(row) && std::isfinite(centers[row].x)) CHECK(centers[row] == centers_before[row]);
  }
  CHECK_FALSE(kept->is_current());
  CHECK(code_of([&] { kept->live_rows(); }) == ErrorCode::usage);
  CHECK(kept->id() == "delaunay/faces");
}

TEST_CASE("a run that only computes more leaves tables and instances where they are") {
  Workbench bench;
  const std::vector<SampleId> ids = bench.insert(ellipse(300));
  bench.need({"inner-balls"});
  bench.show({"medial-axis"});
  bench.run();
  const Table balls = bench.table("inner-balls/faces");
  const auto radius = balls.column("radius").values<double>();
  const std::vector<double> radii = balls.column("radius").copy<double>();
  const Instances axis = bench.instances("medial-axis", PrimitiveKind::segment);
  const std::vector<double> segments(axis.values.begin(), axis.values.end());

  std::vector<std::string> structures, layers;
  for (const StructureInfo& structure : bench.catalogue().structures()) structures.push_back(structure.id);
  for (const LayerInfo& layer : bench.catalogue().layers()) layers.push_back(layer.id);
  bench.need(structures);
  bench.show(layers);
  bench.want_findings();
  bench.run();
  CHECK(balls.is_current());
  CHECK(balls.column("radius").data() == radius.data());
  CHECK(std::equal(radii.begin(), radii.end(), radius.begin(), radius.end()));
  CHECK(std::ranges::equal(axis.values, segments));
  CHECK(bench.instances("medial-axis", PrimitiveKind::segment).values.data() == axis.values.data());
  CHECK(code_of([&] { balls.changes(); }) == ErrorCode::usage);
  const auto changes = bench.table("inner-balls/faces").changes();
  CHECK((!changes || (changes->touched.empty() && changes->removed.empty())));

  // A setting moves what depends on it, and an edit what is computed from the samples.
  const Table filtered = bench.table("lambda-axis/edges");
  bench.set("lambda-limit", 0.5);
  bench.run();
  CHECK(balls.is_current());
  CHECK_FALSE(filtered.is_current());
  bench.move(ids[3], {0.1, 0.2});
  bench.run();
  CHECK_FALSE(balls.is_current());

  // What is not needed any more is not kept.
  const Table again = bench.table("inner-balls/faces");
  bench.need({"delaunay"});
  bench.show({"points"});
  bench.want_findings(false);
  bench.run();
  CHECK_FALSE(again.is_current());
}

TEST_CASE("tables are written as files, and what the caller throws comes back") {
  Workbench bench;
  bench.insert(ellipse(20));
  bench.need({"delaunay"});
  bench.run();
  const Table faces = bench.table("delaunay/faces");
  std::string text;
  faces.write("csv", [&](std::string_view bytes) { text += bytes; });
  CHECK(std::ranges::count(text, '\n') == static_cast<std::ptrdiff_t>(faces.live_rows().size() + 1));
  CHECK(code_of([&] { faces.write("xls", [](std::string_view) {}); }) == ErrorCode::usage);
  CHECK_THROWS_AS(faces.write("npy", [](std::string_view) { throw std::range_error("full"); }), std::range_error);
}

TEST_CASE("a stopped job stops every call, also where there is nothing to do") {
  Workbench bench;
  const std::vector<SampleId> ids = bench.insert(ellipse(20));
  bench.need({"delaunay"});
  bench.run();
  Job job;
  job.stop();
  CHECK(code_of([&] { bench.run(job); }) == ErrorCode::cancelled);
  CHECK(code_of([&] { bench.tables("delaunay"); }) == ErrorCode::cancelled);
  CHECK(code_of([&] { bench.open_bytes("POFF 1 0 0\n0 0\n", "a.poff", {}, job); }) == ErrorCode::cancelled);
  CHECK(code_of([&] { make_shape(Catalogue::builtin(), "circle", {}, job); }) == ErrorCode::cancelled);
  CHECK_FALSE(code_of([&] { bench.get_ready(job); }));
  CHECK(bench.sample_count() == 20);

  // What the stopped run may have changed is not known any more.
  bench.move(ids[3], {2.5, 0.5});
  CHECK(code_of([&] { bench.run(job); }) == ErrorCode::cancelled);
  bench.run();
  CHECK_FALSE(bench.table("delaunay/faces").changes());
  bench.move(ids[3], {2.4, 0.5});
  bench.run();
  CHECK(bench.table("delaunay/faces").changes());
  bench.remove(ids[3]);
  CHECK(bench.sample_count() == 19);
}

TEST_CASE("an error is one printable line") {
  Workbench bench;
  bench.need({"delaunay"});
  bench.run();
  const auto line_of = [](auto call) -> std::string {
    try {
      call();
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  const std::vector<std::string> lines{
      line_of([] { throw Error(ErrorCode::usage, "a\nb"); }), line_of([&] { bench.value("a\nb"); }),
      line_of([&] { bench.open_bytes("POFF", "a\nb.poff"); }),
      line_of([&] { bench.table("delaunay/faces").write("c\nsv", [](std::string_view) {}); })};
  for (const std::string& line : lines) {
    INFO(line);
    CHECK_FALSE(line.empty());
    CHECK(line.find('\n') == std::string::npos);
  }
  CHECK(code_of([&] { bench.table("delaunay/faces").write("csv", {}); }) == ErrorCode::usage);
}

TEST_CASE("a stopped job stops a run, and the next run completes it") {
  Workbench bench;
  bench.insert(ellipse(100));
  bench.show({"medial-axis"});
  std::stop_source source;
  Job job(source.get_token());
  source.request_stop();
  CHECK(job.is_stopped());
  CHECK(code_of([&] { bench.run(job); }) == ErrorCode::cancelled);
  CHECK(code_of([&] { bench.tables("delaunay"); }) == ErrorCode::cancelled);
  Job another;
  bench.run(another);
  CHECK(another.progress() >= 0.0);
  CHECK_FALSE(another.task().empty());
  CHECK_FALSE(bench.instances("medial-axis", PrimitiveKind::segment).empty());
}

TEST_CASE("findings and reports are those of the last run") {
  Workbench bench;
  CHECK(bench.structure_reports().empty());
  CHECK(bench.light() == Light::none);
  bench.insert(ellipse(60));
  bench.want_findings();
  bench.show({"medial-axis"});
  bench.run();
  CHECK(bench.light() != Light::none);
  const auto reports = bench.structure_reports();
  CHECK(reports.size() == bench.catalogue().structures().size());
  const auto axis = std::ranges::find(reports, "medial-axis", &StructureReport::id);
  REQUIRE(axis != reports.end());
  CHECK(axis->state == State::up_to_date);
  const auto layers = bench.layer_reports();
  CHECK(std::ranges::count(layers, State::up_to_date, &LayerReport::state) == 1);
}

TEST_CASE("the catalogue has what there is, each id once") {
  const Catalogue catalogue = Catalogue::builtin();
  const auto ids_of = [](const auto& infos) {
    std::set<std::string> ids;
    for (const auto& info : infos) ids.insert(info.id);
    CHECK(ids.size() == infos.size());
    return ids;
  };
  const auto structures = ids_of(catalogue.structures());
  CHECK(ids_of(catalogue.layers()).contains("medial-axis"));
  CHECK(ids_of(catalogue.evolutions()).contains("smooth"));
  CHECK(ids_of(Catalogue::precisions()).size() == 4);
  CHECK(ids_of(Catalogue::builtin().formats()).contains("poff"));
  for (const LayerInfo& layer : catalogue.layers())
    for (const std::string& id : layer.structures) CHECK(structures.contains(id));
  for (const StructureInfo& structure : catalogue.structures())
    for (const std::string& id : structure.inputs) CHECK(structures.contains(id));
  for (const ShapeInfo& shape : catalogue.shapes()) {
    INFO(shape.id);
    const Data data = make_shape(catalogue, shape.id);
    CHECK(data.samples.size() + data.balls.size() > 0);
    CHECK(data == make_shape(catalogue, shape.id));
  }
  CHECK(code_of([&] { make_shape(catalogue, "no-such-shape"); }) == ErrorCode::usage);
  CHECK(make_shape(catalogue, "ellipse", {.samples = 50}).samples.size() == 50);
}
