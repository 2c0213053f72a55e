// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest uses of the public headers, compiled and run as they stand there.
#include <mesecina/mesecina.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

std::vector<mesecina::Point> points_of_ellipse(int count) {
  std::vector<mesecina::Point> out;
  for (int i = 0; i < count; ++i) {
    const double t = 2.0 * std::numbers::pi * i / count;
    out.push_back({2.0 * std::cos(t), std::sin(t)});
  }
  return out;
}

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_layer({.id = "long-edges",
                        .name = "Long edges",
                        .description = "Delaunay edges, coloured by their length",
                        .rows = "delaunay/edges",
                        .kinds = {mesecina::PrimitiveKind::segment},
                        .scalar = "length"},
                       [](const mesecina::Inputs& inputs) {
                         const auto ends = inputs.column<std::array<mesecina::Row, 2>>("delaunay/edges/sites");
                         const auto place = inputs.column<mesecina::Point>("delaunay/sites/position");
                         return [=](mesecina::Row edge, mesecina::Drawn& out) {
                           const mesecina::Point a = place[ends[edge][0]], b = place[ends[edge][1]];
                           out.segment(a, b, std::hypot(b.x - a.x, b.y - a.y));
                         };
                       });
}

TEST_CASE("headers and library have the same version") {
  if (!mesecina::is_compatible()) std::puts("the library is older than the headers");
  CHECK(mesecina::is_compatible());
  CHECK(mesecina::version() == mesecina::kVersion);
  CHECK_FALSE(mesecina::is_compatible(mesecina::kVersionMajor + 1));
}

TEST_CASE("an error says what is wrong with a file") {
  mesecina::Workbench bench;
  try {
    bench.open("missing.poff");
  } catch (const mesecina::Error& error) {
    if (error.code() == mesecina::ErrorCode::bad_input) std::puts(error.what());
  }
  const auto is_about_the_file = [](const mesecina::Error& error) {
    return error.code() == mesecina::ErrorCode::bad_input && error.file() == "missing.poff";
  };
  CHECK_THROWS_MATCHES(bench.open("missing.poff"), mesecina::Error,
                       Catch::Predicate<mesecina::Error>(is_about_the_file, "it names the file"));
}

TEST_CASE("a ball is a centre and a radius") {
  const mesecina::Ball ball{{0.0, 1.0}, 0.5};
  const double top = ball.center.y + ball.radius;
  const bool is_left = mesecina::orientation({0.0, 0.0}, {1.0, 0.0}, ball.center) > 0;
  CHECK(top == 1.5);
  CHECK(is_left);
}

TEST_CASE("a table is read in place") {
  mesecina::Workbench bench;
  bench.insert(points_of_ellipse(30));
  bench.need({"delaunay"});
  bench.run();
  double sum = 0.0;
  const mesecina::Table faces = bench.table("delaunay/faces");
  const auto is_finite = faces.column("is_finite").copy<bool>();
  const auto radius = faces.column("circumradius").values<double>();
  for (const mesecina::Row row : faces.live_rows())
    if (is_finite[row]) sum += radius[row];
  CHECK(sum > 0.0);
}

TEST_CASE("the catalogue lists layers") {
  for (const mesecina::LayerInfo& layer : mesecina::Catalogue::builtin().layers())
    if (layer.is_visible_at_start) std::puts(layer.id.c_str());
}

TEST_CASE("a workbench computes the medial axis of points") {
  const std::vector<mesecina::Point> points = points_of_ellipse(40);
  std::size_t edges = 0;
  mesecina::Workbench bench;
  bench.insert(points);
  bench.show({"medial-axis"});
  bench.run();
  edges = bench.instances("medial-axis", mesecina::PrimitiveKind::segment).size();
  CHECK(edges == 37);
}

TEST_CASE("an experiment adds a layer") {
  const mesecina::Catalogue catalogue =
      mesecina::with_experiment(mesecina::Catalogue::builtin(), MESECINA_EXPERIMENT_ENTRY);
  mesecina::Workbench bench(catalogue);
  bench.insert(points_of_ellipse(30));
  bench.show({"long-edges", "delaunay"});
  bench.run();
  CHECK(bench.instances("long-edges", mesecina::PrimitiveKind::segment).size() ==
        bench.instances("delaunay", mesecina::PrimitiveKind::segment).size());
}
