// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "app/editing/curves/resample_job.h"
#include "app/editing/editor.h"
#include "app/insight/branch_table.h"
#include "app/insight/critical_values.h"
#include "app/insight/latest_branches.h"
#include "app/insight/persistence_table.h"
#include "app/insight/scale_events.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/io/systems/map_conversion.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;

namespace {

BranchTable table_of(const SampleData& data, BranchAxis axis = BranchAxis::whole, double lambda = 0.0) {
  ComputationSettings settings;
  settings[Parameter::lambda_limit] = lambda;
  JobControl job;
  auto out = branch_table_of(builtins(), data, settings, axis, job);
  REQUIRE(out.has_value());
  return *std::move(out);
}

SampleData rectangle() {
  return {.positions = test::rounded_rectangle(3.0, 2.0, 0.5, 0.05, {0.3, 0.0, 1}).data.positions};
}

/// Follows until the table is that of the state; the job's thread has nothing to wake here.
void wait_for(LatestBranches& latest, const LatestBranches::State& state, const SampleData& data) {
  while (!latest.is_current() || latest.state() != state) latest.follow(state, [&] { return data; });
}

}  // namespace

TEST_CASE("a table has stations of each centre line in equal steps, with the width of the shape") {
  const BranchTable table = table_of(rectangle());
  REQUIRE(table.stations.size() == 1);
  const std::vector<Station>& stations = table.stations.front();
  REQUIRE(stations.size() > 300);
  for (std::size_t i = 1; i < stations.size(); ++i)
    CHECK(std::abs(stations[i].along - static_cast<double>(i) * stations[1].along) < 1e-9);
  // Halves of its sides are 3 and 2.
  for (const Station& at : stations) CHECK(std::abs(at.width - 4.0) < 0.1);
  CHECK(table_of({.positions = {{0, 0}, {1, 0}}}).stations.empty());
}

TEST_CASE("lines of branches are as long as the branches, and end where they do") {
  const BranchTable table = table_of(rectangle());
  REQUIRE(table.branches.size() == table.lines.size());
  REQUIRE(table.branches.size() == 5);
  double sum = 0.0;
  for (std::size_t row = 0; row < table.branches.size(); ++row) {
    const std::vector<Vec2>& line = table.lines[row];
    CHECK(line.size() == table.branches[row].edges.size() + 1);
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
    CHECK(length == Approx(table.branches[row].length).margin(1e-9));
    CHECK(distance(line.front(), table.branches[row].from.place) < 1e-9);
    CHECK(distance(line.back(), table.branches[row].to.place) < 1e-9);
    sum += table.branches[row].length;
  }
  CHECK(sum == Approx(table.length));
  // The histogram is of the whole axis, whatever the limit leaves.
  const BranchTable pruned = table_of(rectangle(), BranchAxis::lambda, 1.0);
  CHECK(pruned.length < table.length);
  for (const std::vector<AxisShare>* shares : {&pruned.radii, &pruned.lambdas}) {
    double all = 0.0;
    for (const AxisShare& share : *shares) all += share.length;
    CHECK(all == Approx(table.length));
    const ShareHistogram histogram = histogram_of(*shares, 40);
    double binned = 0.0;
    for (const double length : histogram.lengths) binned += length;
    CHECK(binned == Approx(all));
    CHECK(histogram.lengths.back() > 0.0);
  }
  CHECK(histogram_of({}, 40).lengths.empty());
  CHECK(table_of({.positions = {{0, 0}, {1, 1}}}).branches.empty());
  CHECK(!table_of({.positions = {{0, 0}, {1, 1}}}).reason.empty());
}

TEST_CASE("the table of branches is the same whatever a filter makes of its angles") {
  // Two triangles, obtuse at one end: the axis crosses their common edge, from which it sees both samples under 90 degrees.
  const SampleData kite{.positions = {{0, -1}, {3, 0}, {0, 1}, {-3, 0}}};
  for (const SampleData& data : {kite, rectangle()}) {
    for (const BranchAxis axis : {BranchAxis::whole, BranchAxis::lambda, BranchAxis::cover}) {
      std::string first;
      for (const double mode : {0.0, 1.0, 2.0}) {
        ComputationSettings settings;
        settings[Parameter::angle_mode] = mode;
        JobControl job;
        const auto table = branch_table_of(builtins(), data, settings, axis, job);
        REQUIRE(table.has_value());
        if (first.empty()) first = branches_as_csv(*table).value();
        CHECK(branches_as_csv(*table).value() == first);
      }
    }
  }
  const BranchTable table = table_of(kite);
  REQUIRE(table.branches.size() == 1);
  CHECK(table.branches.front().angle == 90.0);
  CHECK(table.branches.front().length == Approx(8.0 / 3.0));
}

TEST_CASE("the angle of a branch is the largest along it, also where the filter keeps edges by their mean") {
  // Where all is kept, all modes keep the same.
  std::string whole;
  for (const double mode : {0.0, 1.0, 2.0}) {
    ComputationSettings settings;
    settings[Parameter::angle_mode] = mode;
    JobControl job;
    const auto table = branch_table_of(builtins(), rectangle(), settings, BranchAxis::angle, job);
    REQUIRE(table.has_value());
    if (whole.empty()) whole = branches_as_csv(*table).value();
    CHECK(branches_as_csv(*table).value() == whole);
  }
  for (const double mode : {1.0, 2.0}) {
    ComputationSettings settings;
    settings[Parameter::angle_mode] = mode;
    settings[Parameter::angle_limit] = 20.0;
    JobControl job;
    const auto table = branch_table_of(builtins(), rectangle(), settings, BranchAxis::angle, job);
    REQUIRE(table.has_value());
    REQUIRE_FALSE(table->branches.empty());
    for (const AxisBranch& branch : table->branches) CHECK(branch.angle >= 20.0);
  }
}

TEST_CASE("rows are sorted by any column, and filtered by conditions") {
  const BranchTable table = table_of(rectangle());
  for (std::size_t i = 0; i < kBranchColumns; ++i) {
    const auto column = static_cast<BranchColumn>(i);
    for (const bool is_descending : {false, true}) {
      const auto rows = rows_of(table, {}, column, is_descending);
      REQUIRE(rows.size() == table.branches.size());
      for (std::size_t k = 1; k < rows.size(); ++k) {
        const double a = number_in(table.branches[rows[k - 1]], rows[k - 1], column);
        const double b = number_in(table.branches[rows[k]], rows[k], column);
        REQUIRE((is_descending ? b <= a : a <= b));
        if (a == b) REQUIRE(rows[k - 1] < rows[k]);
      }
    }
  }
  const auto count = [&](std::string_view text) {
    const auto filter = BranchFilter::parse(text);
    INFO(text);
    REQUIRE(filter.has_value());
    return rows_of(table, *filter, BranchColumn::number, false).size();
  };
  const std::size_t all = table.branches.size();
  CHECK(count("") == all);
  CHECK(count("length>=0") == all);
  CHECK(count("length>1 length<=1") == 0);
  CHECK(count("length>1") + count("length<=1") == all);
  CHECK(count("radius>1.2, angle<60") <= count("radius>1.2"));
  // Only the core joins two junctions.
  std::size_t with_leaf = 0;
  for (const AxisBranch& branch : table.branches)
    with_leaf += branch.from.kind == BranchEndKind::leaf || branch.to.kind == BranchEndKind::leaf ? 1U : 0U;
  CHECK(count("leaf") == with_leaf);
  CHECK(count("none") == 0);
  for (const char* wrong : {"length", "size>1", "length>", "length>x", "length=1", "twig", "length>nan"}) {
    INFO(wrong);
    CHECK_FALSE(BranchFilter::parse(wrong));
  }
}

TEST_CASE("tables of a map are written in its coordinate system, and in metres") {
  SampleData data = rectangle();
  const auto written = [](const SampleData& of) {
    const std::string csv = branches_as_csv(table_of(of)).value();
    std::istringstream text(csv.substr(csv.find('\n') + 1));
    std::vector<std::array<double, 3>> out;  // position of an end, and length
    for (std::string line; std::getline(text, line);) {
      std::istringstream cells(line);
      std::vector<std::string> row;
      for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
      out.push_back({std::stod(row[2]), std::stod(row[3]), std::stod(row[8])});
    }
    return out;
  };
  const auto plain = written(data);
  REQUIRE(plain.size() > 4);
  for (const MapProjection projection : {MapProjection::azimuthal, MapProjection::equirectangular}) {
    data.map = MapPlane{.projection = projection, .longitude = 10.0, .latitude = 50.0};
    const auto conversion = MapConversion::of(*data.map, MapTarget::own_system).value();
    const auto on_map = written(data);
    REQUIRE(on_map.size() == plain.size());
    for (std::size_t row = 0; row < plain.size(); ++row) {
      CHECK(on_map[row][0] == Approx(10.0).margin(0.1));
      CHECK(on_map[row][1] == Approx(50.0).margin(0.1));
      const Vec2 back = conversion.to_plane({on_map[row][0], on_map[row][1]});
      CHECK(distance(back, {plain[row][0], plain[row][1]}) < 1e-5);
      CHECK(on_map[row][2] == Approx(plain[row][2] * data.map->written_size()));
    }
  }
  JobControl job;
  data.map->projection = MapProjection::azimuthal;
  const auto table = persistence_table_of(builtins(), {data, GrowthOf::samples, {}}, job);
  const std::string csv = persistence_as_csv(table.value()).value();
  const std::string row = csv.substr(csv.find('\n') + 1);
  CHECK(row.starts_with("0,0,,,"));
  CHECK(std::stod(row.substr(6)) == Approx(10.0).margin(0.001));
}

TEST_CASE("the branch at a place is the one whose line is nearest there") {
  const BranchTable table = table_of(rectangle(), BranchAxis::lambda, 0.3);
  for (std::size_t row = 0; row < table.branches.size(); ++row) {
    const std::vector<Vec2>& line = table.lines[row];
    if (table.branches[row].length < 0.1) continue;
    const Vec2 middle = 0.5 * (line[line.size() / 2] + line[line.size() / 2 - 1]);
    CHECK(branch_near(table, middle, 1e-6) == row);
  }
  CHECK(branch_near(table, {100, 100}, 1.0) == table.branches.size());
}

TEST_CASE("the table is that of the state asked for last, and keeps what is chosen where it is still there") {
  LatestBranches latest(builtins(), {});
  const SampleData data = rectangle();
  ComputationSettings settings;
  settings[Parameter::lambda_limit] = 0.3;
  const LatestBranches::State first{1, settings, BranchAxis::lambda};
  CHECK_FALSE(latest.is_current());
  CHECK_FALSE(latest.pick({0, 0}, 1.0));
  wait_for(latest, first, data);
  REQUIRE(latest.table() != nullptr);
  latest.choose(0);
  const AxisBranch longest = latest.table()->branches[0];
  latest.follow({1, settings, BranchAxis::angle}, [&] { return data; });
  CHECK_FALSE(latest.is_current());
  wait_for(latest, {2, settings, BranchAxis::lambda}, data);
  REQUIRE(latest.chosen());
  CHECK(latest.table()->branches[*latest.chosen()].from.place == longest.from.place);
  CHECK(latest.pick({1000, 1000}, 1.0));
  CHECK_FALSE(latest.chosen());
  CHECK(latest.pick(latest.table()->lines[1].front(), 1e-9));
  CHECK(latest.chosen());
}

TEST_CASE("a repaired and a decimated sampling are one step of undo each, and edits meanwhile are not overwritten") {
  Editor editor([](const std::shared_ptr<const DocumentDelta>&) {});
  SampleData data;
  SampleData::Contour& loop = data.contours.emplace_back();
  for (std::uint32_t i = 0; i < 16; ++i) {
    const double t = 2.0 * std::numbers::pi * (i + 0.3) / 16.0;
    data.positions.push_back({3.0 * std::cos(t), std::sin(t)});
    loop.points.push_back(i);
  }
  REQUIRE(editor.load(data));
  ResampleJob job(builtins(), editor, {});
  const auto run = [&](ResampleJob::Wish wish) {
    job.begin(wish);
    std::optional<ResampleJob::Report> out;
    while (!out) out = job.follow();
    return *out;
  };
  const ResampleJob::Report repaired = run(ResampleJob::Wish::repair);
  CHECK_FALSE(repaired.is_problem);
  CHECK(editor.undo_name() == "Repair the sampling");
  const std::size_t dense = editor.document().sample_count();
  CHECK(dense > 16);
  CHECK(data_of(editor.document()).contours.front().points.size() == dense);
  job.epsilon = 0.4;
  CHECK_FALSE(run(ResampleJob::Wish::decimate).is_problem);
  CHECK(editor.document().sample_count() < dense);
  editor.undo();
  CHECK(editor.document().sample_count() == dense);
  editor.undo();
  CHECK(data_of(editor.document()).positions == data.positions);
  CHECK(data_of(editor.document()).contours == data.contours);
  CHECK_FALSE(editor.can_undo());

  job.epsilon = 0.25;
  job.begin(ResampleJob::Wish::repair);
  REQUIRE(editor.insert(std::vector<Vec2>{{0.0, 0.0}}, "Insert"));
  std::optional<ResampleJob::Report> late;
  while (!late) late = job.follow();
  CHECK(late->is_problem);
  CHECK(editor.document().sample_count() == 17);
}

TEST_CASE("critical values are those of the lambda axis, found beside the window") {
  SampleData rectangle;
  rectangle.positions = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  JobControl job;
  const auto values = critical_values_of(builtins(), rectangle, job);
  REQUIRE(values.has_value());
  REQUIRE(values->size() == 1);
  CHECK(values->front() == Approx(std::sqrt(5.0)));
  CHECK(critical_values_of(builtins(), {}, job)->empty());
}

TEST_CASE("what is kept is said in one line, for each filter") {
  SampleData rectangle;
  rectangle.positions = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  JobControl job;
  for (const BranchAxis axis : kBranchAxes) {
    const auto table = branch_table_of(builtins(), rectangle, {}, axis, job);
    REQUIRE(table.has_value());
    CHECK(table->area == Approx(5.0 * std::numbers::pi));
    CHECK(kept_in_words(*table) == "1 branch, length 0, 1 component, 0 cycles, 100 % of the shape");
  }
  // The union is taken only where it is asked for, and where it fails the rest is said.
  for (const BranchAxis axis : kBranchAxes) {
    auto table = branch_table_of(builtins(), rectangle, {}, axis, job, false);
    REQUIRE(table.has_value());
    CHECK_FALSE(table->measures_area);
    CHECK(table->area == 0.0);
    CHECK(table->branches.size() == 1);
    CHECK(kept_in_words(*table) == "1 branch, length 0, 1 component, 0 cycles");
    table->area_problem = "structure lambda-union failed: no room";
    CHECK(kept_in_words(*table) ==
          "1 branch, length 0, 1 component, 0 cycles, share of the shape unknown: structure lambda-union failed: no "
          "room");
  }
  const auto none = branch_table_of(builtins(), {}, {}, BranchAxis::cover, job);
  REQUIRE(none.has_value());
  CHECK(none->branches.empty());
  CHECK_FALSE(none->reason.empty());
  CHECK(none->share_of_shape == 0.0);
}

TEST_CASE("events of the scale axis are where disks touch and holes are filled") {
  const auto circle = [](Vec2 center, double radius, int count, std::vector<Vec2>& out) {
    for (int i = 0; i < count; ++i) {
      const double t = 2.0 * std::numbers::pi * (i + 0.3) / count;
      out.push_back({center.x + radius * std::cos(t), center.y + radius * std::sin(t)});
    }
  };
  SampleData two;
  circle({0, 0}, 1.0, 24, two.positions);
  circle({3, 0.25}, 1.0, 24, two.positions);
  JobControl job;
  const auto merged = scale_events_of(builtins(), two, {}, job);
  REQUIRE(merged.has_value());
  REQUIRE(merged->size() == 1);
  CHECK(merged->front().factor == Approx(0.5 * std::hypot(3.0, 0.25)).margin(0.01));
  CHECK(merged->front().words() == "components 2 to 1");
  SampleData none;
  CHECK(scale_events_of(builtins(), none, {}, job)->empty());
}

TEST_CASE("events of noise are where the union differs, below a factor of 1 too, and in order") {
  SampleData data;
  Rng rng(8);
  for (int i = 0; i < 60; ++i) data.positions.push_back({rng.uniform(), rng.uniform()});
  JobControl job;
  const auto events = scale_events_of(builtins(), data, {}, job);
  REQUIRE(events.has_value());
  CHECK(std::ranges::is_sorted(*events, {}, &ScaleEvent::factor));
  CHECK(std::ranges::any_of(*events, [](const ScaleEvent& event) { return event.factor < 1.0; }));
  test::TestBench bench;
  bench.show({"scale-axis"});
  bench.load(data);
  ComputationSettings settings;
  for (const ScaleEvent& event : *events) {
    INFO(event.factor << ": " << event.words());
    CHECK(event.within <= 5e-4);
    settings[Parameter::scale_axis_factor] = event.factor - event.within;
    bench.choose(settings);
    CHECK(bench.count("scale-union", "components") == event.components_before);
    CHECK(bench.count("scale-union", "cycles") == event.holes_before);
    settings[Parameter::scale_axis_factor] = event.factor + event.within;
    bench.choose(settings);
    CHECK(bench.count("scale-union", "components") == event.components_after);
    CHECK(bench.count("scale-union", "cycles") == event.holes_after);
  }
}

TEST_CASE("a certified shape has no events below a factor of 1, and a stopped search throws") {
  SampleData data = test::rounded_rectangle(3.0, 1.0, 0.3, 0.02).data;
  JobControl job;
  const auto events = scale_events_of(builtins(), data, {}, job);
  REQUIRE(events.has_value());
  for (const ScaleEvent& event : *events) CHECK(event.factor > 1.0);
  JobControl stopped;
  stopped.stop_at_look(200);
  CHECK_THROWS_AS(scale_events_of(builtins(), data, {}, stopped), Cancelled);
}
