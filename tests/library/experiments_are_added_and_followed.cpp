// SPDX-License-Identifier: GPL-3.0-or-later
// Structures and layers from outside: as good as those of the program, and harmless when they are wrong.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <mesecina/experiment.h>

// The example, as a function of this program.
#undef MESECINA_EXPERIMENT
#define MESECINA_EXPERIMENT(name) static void add_gabriel(::mesecina::Experiment& name)
#include "examples/experiments/gabriel.cpp"

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<Point> some_points(std::size_t count, unsigned seed, double grid = 0.0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(0.0, 10.0);
  std::vector<Point> out;
  for (std::size_t i = 0; i < count; ++i) {
    Point p{coordinate(random), coordinate(random)};
    if (grid != 0.0) p = {std::floor(p.x / grid) * grid, std::floor(p.y / grid) * grid};
    out.push_back(p);
  }
  return out;
}

using Edge = std::pair<std::pair<double, double>, std::pair<double, double>>;

Edge edge_between(Point a, Point b) {
  std::pair<double, double> from{a.x, a.y}, to{b.x, b.y};
  return from < to ? Edge{from, to} : Edge{to, from};
}

std::set<Edge> edges_of(const Workbench& bench, std::string_view layer) {
  std::set<Edge> out;
  const Instances drawn = bench.instances(layer, PrimitiveKind::segment);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    out.insert(edge_between({drawn[i][0], drawn[i][1]}, {drawn[i][2], drawn[i][3]}));
  return out;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

Catalogue with(const std::function<void(Experiment&)>& add) {
  return with_experiment(Catalogue::builtin(), add);
}

/// A structure whose functions are given.
struct Given final : Structure {
  std::function<void(const Inputs&)> on_rebuild;
  std::function<bool(const Inputs&)> on_update;
  std::function<std::vector<OwnTable>()> on_tables;
  void rebuild(const Inputs& inputs) override {
    if (on_rebuild) on_rebuild(inputs);
  }
  bool update(const Inputs& inputs) override { return on_update && on_update(inputs); }
  std::vector<OwnTable> tables() const override { return on_tables ? on_tables() : std::vector<OwnTable>(); }
};

Catalogue with_structure(const std::function<void(Given&)>& fill,
                         const StructureSpec& spec = {.id = "given", .inputs = {"delaunay"}}) {
  return with([&](Experiment& experiment) {
    experiment.add_structure(spec, [fill] {
      auto out = std::make_unique<Given>();
      fill(*out);
      return out;
    });
  });
}

/// A layer over Delaunay edges, by what is drawn for a row.
Catalogue with_layer(const std::function<void(Row, Drawn&)>& draw) {
  return with([&](Experiment& experiment) {
    experiment.add_layer({.id = "given",
                          .name = "Given",
                          .description = "What a test draws",
                          .rows = "delaunay/edges",
                          .kinds = {PrimitiveKind::segment}},
                         [draw](const Inputs&) { return [draw](Row row, Drawn& out) { draw(row, out); }; });
  });
}

State state_of(const Workbench& bench, std::string_view layer) {
  for (const LayerReport& report : bench.layer_reports())
    if (report.id == layer) return report.state;
  return State::inactive;
}

}  // namespace

TEST_CASE("the Gabriel graph is that of its definition, through edits") {
  const double grid = GENERATE(0.0, 1.0);  // with ties and duplicates
  const Catalogue catalogue = with(add_gabriel);
  Workbench bench(catalogue);
  bench.show({"gabriel"});
  bench.insert(some_points(40, 1, grid));
  std::mt19937 random(7);
  for (int edit = 0; edit < 60; ++edit) {
    const std::vector<SampleId> ids = bench.sample_ids();
    const SampleId id = ids[random() % ids.size()];
    if (edit % 3 == 0)
      bench.remove(id);
    else if (edit % 3 == 1)
      bench.insert(some_points(1, 100U + static_cast<unsigned>(edit), grid).front());
    else
      bench.move(id, some_points(1, 200U + static_cast<unsigned>(edit), grid).front());
    bench.run();

    const std::vector<Point> points = bench.data().samples;
    std::set<Edge> expected;
    for (const Point a : points)
      for (const Point b : points)
        if (a != b && std::ranges::none_of(points, [&](Point c) { return side_of_diametral_circle(a, b, c) > 0; }))
          expected.insert(edge_between(a, b));
    // Of cocircular corners the triangulation has one diagonal; the definition has both.
    const std::set<Edge> drawn = edges_of(bench, "gabriel");
    CHECK(std::ranges::includes(expected, drawn));
    if (grid == 0.0) CHECK(drawn == expected);

    Workbench fresh(catalogue);
    fresh.show({"gabriel"});
    fresh.insert(points);
    fresh.run();
    CHECK(bench.digest("gabriel") == fresh.digest("gabriel"));
  }
  bench.want_statistics();
  bench.run();
  CHECK(bench.number("gabriel", "gabriel_edges") ==
        static_cast<double>(bench.instances("gabriel", PrimitiveKind::segment).size()));
}

TEST_CASE("an update touches what changed alone") {
  const Catalogue catalogue = with(add_gabriel);
  Workbench bench(catalogue);
  bench.need({"gabriel"});
  const std::vector<SampleId> ids = bench.insert(some_points(2000, 3));
  bench.run();
  bench.move(ids[17], {5.0, 5.0});
  bench.run();
  for (const StructureReport& report : bench.structure_reports())
    if (report.id == "gabriel") {
      CHECK_FALSE(report.is_rebuilt);
      CHECK(report.touched_rows > 0);
      CHECK(report.touched_rows < 200);
    }
}

TEST_CASE("what is added is listed, and has its parameters") {
  const Catalogue catalogue = with([](Experiment& experiment) {
    experiment.add_parameter(
        {.id = "longest", .description = "Longer edges are left out", .high = 100.0, .default_value = 100.0});
    experiment.add_layer({.id = "short-edges",
                          .name = "Short edges",
                          .description = "Delaunay edges up to a length",
                          .rows = "delaunay/edges",
                          .parameters = {"longest"},
                          .kinds = {PrimitiveKind::segment},
                          .scalar = "length"},
                         [](const Inputs& inputs) {
                           const auto ends = inputs.column<std::array<Row, 2>>("delaunay/edges/sites");
                           const auto place = inputs.column<Point>("delaunay/sites/position");
                           return [=, longest = inputs.parameter("longest")](Row edge, Drawn& out) {
                             const Point a = place[ends[edge][0]], b = place[ends[edge][1]];
                             const double length = std::hypot(b.x - a.x, b.y - a.y);
                             if (length <= longest) out.segment(a, b, length);
                           };
                         });
    experiment.add_shape(
        {.id = "test-triangle",
         .name = "Triangle",
         .description = "A triangle",
         .parameters = {{.id = "side", .description = "Its side", .low = 1.0, .high = 9.0, .default_value = 2.0}}},
        [](std::span<const double> values) {
          return std::vector<std::vector<Point>>{{{0.0, 0.0}, {values[0], 0.0}, {0.0, values[0]}}};
        });
    experiment.add_evolution({.id = "test-shift", .name = "Shift", .description = "Moves all samples to the right"},
                             [](const MovingSamples& samples, std::span<const double>) {
                               std::vector<Point> next(samples.positions.begin(), samples.positions.end());
                               for (Point& p : next) p.x += 1.0;
                               return next;
                             });
  });
  const auto has = [](const auto& list, std::string_view id) {
    return std::ranges::any_of(list, [id](const auto& one) { return one.id == id; });
  };
  // An evolution moves samples, or a parameter of the experiment or of the program.
  const Catalogue with_moves = with_experiment(catalogue, [](Experiment& experiment) {
    experiment.add_evolution(
        {.id = "test-longer",
         .name = "Longer",
         .description = "More edges are short",
         .parameters = {{.id = "way", .description = "Of a step", .high = 9.0, .default_value = 2.0}},
         .moved_parameter = "longest"},
        [](double first, std::uint64_t step, std::span<const double> values) {
          return first + static_cast<double>(step) * values[0];
        });
  });
  for (const EvolutionInfo& evolution : with_moves.evolutions())
    if (evolution.id == "test-longer") CHECK(evolution.moved_parameter == "longest");
  CHECK(has(with_moves.evolutions(), "test-longer"));
  const auto add = [&](const EvolutionSpec& spec) {
    const auto value = [](double first, std::uint64_t, std::span<const double>) { return first; };
    with_experiment(catalogue, [&](Experiment& to) { to.add_evolution(spec, value); });
  };
  CHECK_THROWS_WITH(add({.id = "test-other", .moved_parameter = "unheard-of"}), Catch::Contains("unheard-of"));
  CHECK_THROWS_WITH(add({.id = "test-other"}), Catch::Contains("parameter"));
  CHECK_THROWS_WITH(add({.id = "test-shift", .moved_parameter = "longest"}), Catch::Contains("already"));
  CHECK(has(catalogue.layers(), "short-edges"));
  CHECK(has(catalogue.parameters(), "longest"));
  CHECK(has(catalogue.shapes(), "test-triangle"));
  CHECK(has(catalogue.evolutions(), "test-shift"));
  CHECK_FALSE(has(Catalogue::builtin().layers(), "short-edges"));
  for (const LayerInfo& layer : catalogue.layers())
    if (layer.id == "short-edges") {
      CHECK(layer.group == "Experiments");
      CHECK(layer.parameters == std::vector<std::string>{"longest"});
    }

  Workbench bench(catalogue);
  bench.load(make_shape(catalogue, "test-triangle", {.parameters = {{"side", 3.0}}, .samples = 60}));
  bench.show({"short-edges", "delaunay"});
  bench.run();
  const std::size_t all = bench.instances("delaunay", PrimitiveKind::segment).size();
  CHECK(bench.instances("short-edges", PrimitiveKind::segment).size() == all);
  bench.set("longest", 0.5);
  bench.run();
  const Instances drawn = bench.instances("short-edges", PrimitiveKind::segment);
  CHECK(drawn.size() < all);
  CHECK(drawn.size() > 0);
  for (std::size_t i = 0; i < drawn.size(); ++i) CHECK(drawn[i][4] <= 0.5);
}

TEST_CASE("names and numbers of an experiment are checked, and a mistake adds nothing") {
  const LayerSpec good{.id = "a-layer", .rows = "delaunay/edges", .kinds = {PrimitiveKind::segment}};
  const auto nothing = [](const Inputs&) { return [](Row, Drawn&) {}; };
  const auto refusal = [&](LayerSpec spec) {
    return message_of([&] { with([&](Experiment& experiment) { experiment.add_layer(spec, nothing); }); });
  };
  CHECK(refusal(good).empty());
  const auto changed = [&](auto change) {
    LayerSpec spec = good;
    change(spec);
    return refusal(spec);
  };
  CHECK(changed([](LayerSpec& spec) { spec.id = "delaunay"; }) == "there is a layer delaunay already");
  CHECK(changed([](LayerSpec& spec) { spec.id = "Big"; }).starts_with("\"Big\" is no id of a layer"));
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.id = ""; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.id = "a--b"; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.id = "-a"; }).empty());
  CHECK(changed([](LayerSpec& spec) { spec.rows = "delaunay/nothing"; }).find("delaunay/nothing") !=
        std::string::npos);
  CHECK(changed([](LayerSpec& spec) { spec.rows = "nowhere/edges"; }).find("nowhere") != std::string::npos);
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.rows = ""; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.follows = {"delaunay/foo"}; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.structures = {"foo"}; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.parameters = {"foo"}; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.kinds = {}; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.kinds = {PrimitiveKind::arc, PrimitiveKind::arc}; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.kinds = {static_cast<PrimitiveKind>(77)}; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.opacity = kNan; }).empty());
  CHECK_FALSE(changed([](LayerSpec& spec) { spec.color = {0.0, 2.0, 0.0}; }).empty());

  CHECK_FALSE(message_of([] { with_structure([](Given&) {}, {.id = "given", .inputs = {}}); }).empty());
  CHECK_FALSE(message_of([] { with_structure([](Given&) {}, {.id = "given", .inputs = {"given"}}); }).empty());
  CHECK_FALSE(message_of([] { with_structure([](Given&) {}, {.id = "delaunay", .inputs = {"samples"}}); }).empty());
  for (const ParameterInfo& wrong :
       {ParameterInfo{.id = "x", .low = 2.0, .high = 1.0, .default_value = 1.5},
        ParameterInfo{.id = "x", .low = kNan}, ParameterInfo{.id = "x", .default_value = 7.0},
        ParameterInfo{.id = "lambda-limit"}, ParameterInfo{.id = ""}})
    CHECK_FALSE(message_of([&] { with([&](Experiment& experiment) { experiment.add_parameter(wrong); }); }).empty());

  // Two of one name, in one experiment and in two.
  const auto twice = [&](Experiment& experiment) {
    experiment.add_layer(good, nothing);
    experiment.add_layer(good, nothing);
  };
  CHECK(message_of([&] { with(twice); }) == "there is a layer a-layer already");
  const Catalogue once = with([&](Experiment& experiment) { experiment.add_layer(good, nothing); });
  CHECK_FALSE(message_of([&] {
                with_experiment(once, [&](Experiment& experiment) { experiment.add_layer(good, nothing); });
              }).empty());
  // What it throws itself passes.
  CHECK_THROWS_AS(with([](Experiment&) { throw std::logic_error("mine"); }), std::logic_error);
}

TEST_CASE("a structure that fails says why, and the rest goes on") {
  const auto failure_of = [](const Catalogue& catalogue) {
    Workbench bench(catalogue);
    bench.need({"given"});
    bench.show({"delaunay"});
    bench.insert(some_points(10, 1));
    std::string text;
    try {
      bench.run();
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::cannot_compute);
      CHECK(error.structure() == "given");
      text = error.text();
    }
    CHECK(bench.instances("delaunay", PrimitiveKind::segment).size() > 0);
    return text;
  };
  const auto throwing = [&](auto what) {
    return failure_of(
        with_structure([what](Given& given) { given.on_rebuild = [what](const Inputs&) { throw what; }; }));
  };
  CHECK(throwing(std::runtime_error("no luck")).find("no luck") != std::string::npos);
  CHECK(throwing(std::runtime_error("two\nlines")).find("two lines") != std::string::npos);
  CHECK(throwing(Error(ErrorCode::cannot_compute, "mine")).find("mine") != std::string::npos);
  CHECK(throwing(42).find("no exception") != std::string::npos);
  CHECK(failure_of(with_structure([](Given& given) {
          given.on_rebuild = [](const Inputs& inputs) { inputs.rows("voronoi/edges"); };
        })).find("not among the inputs") != std::string::npos);
  CHECK(failure_of(with_structure([](Given& given) {
          given.on_rebuild = [](const Inputs& inputs) { inputs.column<double>("delaunay/sites/position"); };
        })).find("position") != std::string::npos);
  CHECK(failure_of(with_structure([](Given& given) {
          given.on_rebuild = [](const Inputs& inputs) { inputs.parameter("lambda-limit"); };
        })).find("lambda-limit") != std::string::npos);
  CHECK(failure_of(with_structure([](Given&) {})).empty());
  CHECK_FALSE(message_of([] {
                with([](Experiment& experiment) {
                  experiment.add_structure({.id = "given", .inputs = {"delaunay"}},
                                           [] { return std::unique_ptr<Structure>(); });
                });
              }).empty());
}

TEST_CASE("a layer that is wrong fails alone") {
  const auto state_with = [](const Catalogue& catalogue) {
    Workbench bench(catalogue);
    bench.show({"given", "delaunay"});
    bench.insert(some_points(10, 1));
    message_of([&] { bench.run(); });
    CHECK(state_of(bench, "delaunay") == State::up_to_date);
    return state_of(bench, "given");
  };
  CHECK(state_with(with_layer([](Row, Drawn& out) { out.segment({0.0, 0.0}, {1.0, 1.0}); })) == State::up_to_date);
  CHECK(state_with(with_layer([](Row, Drawn&) { throw std::runtime_error("no"); })) == State::failed);
  CHECK(state_with(with_layer([](Row, Drawn&) { throw 1; })) == State::failed);
  CHECK(state_with(with_layer([](Row, Drawn& out) { out.point({0.0, 0.0}); })) == State::failed);

  Workbench bench(with_layer([](Row, Drawn& out) { out.segment({kNan, 0.0}, {1.0, 1.0}); }));
  bench.show({"given"});
  bench.insert(some_points(10, 1));
  bench.run();
  CHECK(bench.instances("given", PrimitiveKind::segment).empty());
  for (const LayerReport& report : bench.layer_reports())
    if (report.id == "given") CHECK(report.lost > 0);
}

TEST_CASE("an update that names the wrong rows does no harm") {
  // Its table has as many rows as it likes after an edit, and names others.
  struct Values {
    std::vector<Point> place;
    std::vector<Row> touched, removed;
  };
  const auto wrong = GENERATE(0, 1, 2, 3, 4);
  const auto values = std::make_shared<Values>();
  const auto edit = [wrong, values](const Inputs& inputs) {
    const std::size_t rows = inputs.rows("delaunay/sites");
    values->touched.clear();
    values->removed.clear();
    if (wrong == 0) values->touched = {kNoRow, 1'000'000, 5};
    if (wrong == 1) values->place.clear();
    if (wrong == 2) values->removed = {static_cast<Row>(rows + 7), 0, 0, 0};
    if (wrong == 3) values->place.assign(3, Point{kNan, kNan});
    if (wrong == 4) values->place.assign(rows + 100, Point{1.0, 2.0});  // none of it is named
    return true;
  };
  const Catalogue catalogue = with([&](Experiment& experiment) {
    experiment.add_structure({.id = "given", .inputs = {"delaunay"}}, [values, edit] {
      auto out = std::make_unique<Given>();
      out->on_rebuild = [values](const Inputs& inputs) {
        values->place.assign(inputs.rows("delaunay/sites"), Point{3.0, 4.0});
      };
      out->on_update = edit;
      out->on_tables = [values] {
        std::vector<OwnTable> tables;
        tables.emplace_back("places", "Places")
            .changes(values->touched, values->removed)
            .column("place", "A place", values->place);
        return tables;
      };
      return out;
    });
    experiment.add_layer({.id = "given", .rows = "given/places", .kinds = {PrimitiveKind::point}},
                         [](const Inputs& inputs) {
                           const auto place = inputs.column<Point>("given/places/place");
                           return [=](Row row, Drawn& out) { out.point(place[row]); };
                         });
  });
  Workbench bench(catalogue);
  bench.show({"given"});
  const std::vector<SampleId> ids = bench.insert(some_points(30, 1));
  bench.run();
  for (std::size_t i = 0; i < 10; ++i) {
    bench.move(ids[i], {static_cast<double>(i), 20.0});
    message_of([&] { bench.run(); });
    CHECK(bench.structure_reports().size() > 5);
  }
  // An input that is loaded anew is followed anew.
  bench.load({.samples = some_points(12, 5)});
  bench.run();
  CHECK(bench.instances("given", PrimitiveKind::point).size() == bench.table("given/places").rows());
}

TEST_CASE("a stopped experiment is completed by the next run") {
  Job job;
  const Catalogue catalogue = with_structure([&job](Given& given) {
    given.on_rebuild = [&job](const Inputs& inputs) {
      job.stop();
      inputs.checkpoint();
    };
  });
  Workbench bench(catalogue);
  bench.need({"given"});
  bench.insert(some_points(10, 1));
  try {
    bench.run(job);
    FAIL("it was not stopped");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::cancelled);
  }
  bench.run();
  CHECK(bench.tables("given").empty());
}

TEST_CASE("a format from outside is read by content and by extension") {
  const auto read = [](std::string_view bytes) -> Data {
    if (bytes.starts_with("MINE bad")) throw Error({.code = ErrorCode::bad_input, .text = "not so", .line = 3});
    if (bytes.starts_with("MINE odd")) return {.samples = {{0.0, 0.0}}, .contours = {{true, {7}}}};
    if (bytes.starts_with("MINE no")) throw 1;
    return {.samples = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, .contours = {{true, {0, 1, 2}}}};
  };
  const Catalogue catalogue = with([&](Experiment& experiment) {
    experiment.add_format({.id = "mine", .name = "Mine", .extensions = {".mine"}}, read,
                          [](std::string_view bytes) { return bytes.starts_with("MINE"); });
    experiment.add_format({.id = "other", .extensions = {".other"}}, read);
  });
  Workbench bench(catalogue);
  CHECK(bench.open_bytes("MINE", "a file").format == "mine");
  CHECK(bench.sample_count() == 3);
  CHECK(bench.open_bytes("anything", "a.other").format == "other");
  CHECK(message_of([&] { bench.open_bytes("MINE bad", "a file"); }) == "a file:3: not so");
  CHECK(message_of([&] { bench.open_bytes("MINE odd", "a file"); }).find("that there is not") != std::string::npos);
  CHECK(message_of([&] { bench.open_bytes("MINE no", "a file"); }).find("no exception") != std::string::npos);
  CHECK(bench.sample_count() == 3);
  CHECK(message_of([&] { with([&](Experiment& experiment) { experiment.add_format({.id = "poff"}, read); }); }) ==
        "there is a format poff already");
  CHECK_FALSE(message_of([&] {
                with([&](Experiment& experiment) { experiment.add_format({.id = "x", .extensions = {"x"}}, read); });
              }).empty());
}

TEST_CASE("predicates are exact") {
  const Point a{0.0, 0.0}, b{1.0, 0.0}, c{0.0, 1.0};
  const double next = std::nextafter(1.0, 2.0);
  CHECK(orientation(a, b, c) == 1);
  CHECK(orientation(a, c, b) == -1);
  CHECK(orientation({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}) == 0);
  CHECK(orientation({0.0, 0.0}, {1.0, 1.0}, {next * 0x1p20, 0x1p20}) == -1);
  CHECK(side_of_circle(a, b, c, {1.0, 1.0}) == 0);
  CHECK(side_of_circle(a, b, c, {next, 1.0}) == -1);
  CHECK(side_of_circle(a, c, b, {next, 1.0}) == 1);
  CHECK(side_of_diametral_circle({-1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}) == 0);
  CHECK(side_of_diametral_circle({-1.0, 0.0}, {next, 0.0}, {0.0, 1.0}) == 1);
  CHECK(compare_distances(a, b, b, {2.0, 0.0}) == 0);
  CHECK(compare_distances(a, b, a, {next, 0.0}) == -1);
  // Without radii the power is the distance.
  CHECK(side_of_power_circle({a, 0.0}, {b, 0.0}, {c, 0.0}, {{1.0, 1.0}, 0.0}) == 0);
  CHECK(side_of_power_circle({a, 0.0}, {b, 0.0}, {c, 0.0}, {{0.5, 0.5}, 0.0}) == 1);
  CHECK(side_of_power_circle({a, 0.5}, {b, 0.5}, {c, 0.5}, {{1.0, 1.0}, 0.5}) == 0);
  CHECK(side_of_power_circle({a, 0.5}, {b, 0.5}, {c, 0.5}, {{1.0, 1.0}, std::nextafter(0.5, 1.0)}) == 1);
  CHECK(compare_circumradii(a, b, c, {5.0, 5.0}, {6.0, 5.0}, {5.0, 6.0}) == 0);
  CHECK(compare_circumradii(a, b, c, a, b, {0.0, next}) == -1);
  CHECK(compare_circumradii(a, b, {2.0, 0.0}, a, b, c) == 1);
}
