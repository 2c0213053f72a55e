// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest uses in the comments of headers, word for word, each with what it needs around it.
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <thread>

#include "core/base/disjoint_sets.h"
#include "core/base/geometry/box_tree.h"
#include "core/base/geometry/coordinate_range.h"
#include "core/base/jobs/task_queue.h"
#include "core/base/max_tree.h"
#include "core/base/radix_sort.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/curves/clip_region.h"
#include "core/curves/corners.h"
#include "core/curves/cuts.h"
#include "core/curves/feature_field.h"
#include "core/curves/filled_area.h"
#include "core/curves/interpolation/b_spline.h"
#include "core/curves/interpolation/cubic_interpolation.h"
#include "core/curves/interpolation/smooth_curve.h"
#include "core/curves/joined_ends.h"
#include "core/curves/line_regions.h"
#include "core/curves/nearest_place.h"
#include "core/curves/resolution.h"
#include "core/curves/sampling.h"
#include "core/document/commands.h"
#include "core/document/curve_source.h"
#include "core/document/live_corners.h"
#include "core/document/moved_curves.h"
#include "core/document/taken_samples.h"
#include "core/document/timeline/history.h"
#include "core/document/timeline/layer_fold.h"
#include "core/document/timeline/timeline.h"
#include "core/draw/layer_mirror.h"
#include "core/edit/frame_handles.h"
#include "core/engine/engine.h"
#include "core/engine/graph.h"
#include "core/engine/sampling_verdict.h"
#include "core/evolutions/evolution_run.h"
#include "core/formula/formula.h"
#include "core/glyphs/text_outlines.h"
#include "core/graph/live_registry.h"
#include "core/graph/table_maker.h"
#include "core/graph/write_table.h"
#include "core/io/session/session.h"
#include "core/layers/parts/helpers.h"
#include "core/raster/trace.h"
#include "core/resampling/resampling.h"
#include "core/shapes/shape.h"
#include "core/structures/alpha/persistence.h"
#include "core/structures/crust/internal/link_cut_forest.h"
#include "core/structures/delaunay/voronoi_cells.h"
#include "core/structures/density/feature_size.h"
#include "core/structures/density/sample_sizes.h"
#include "core/structures/filters/axis_pruning.h"
#include "core/structures/filters/center_lines.h"
#include "core/structures/filters/paths/axis_paths.h"
#include "core/structures/filters/paths/branch_pruning.h"
#include "core/workbench/workbench.h"
#include "tests/curves/curve_parts.h"

using namespace mes;

namespace mes {
Layer make_points_layer(const StructureSet& set);
}

namespace {

/// Samples around a circle.
std::vector<Vec2> ring(std::size_t count = 16) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    out.push_back({std::cos(t), std::sin(t)});
  }
  return out;
}

std::vector<Vec2> ellipse() {
  std::vector<Vec2> out = ring(60);
  for (Vec2& p : out) p.x *= 2.0;
  return out;
}

Document ring_document() {
  Document document;
  document.apply(*insert_samples(document, ring()));
  return document;
}

PlaneCurve bow() {
  // core/curves/curve.h
  PlaneCurve curve({0.0, 0.0});
  curve.line_to({1.0, 0.0});
  curve.cubic_to({1.5, 0.0}, {1.5, 1.0}, {1.0, 1.0});
  curve.close();
  return curve;
}

std::string refused_by_coordinate_range(double x) {
  const auto refuse = [](std::string why) { return why; };
  // core/base/geometry/coordinate_range.h
  Magnitudes seen;
  if (const auto fault = seen.fault_of(x)) return refuse(describe(*fault, x, seen));
  seen.add(x);
  return seen.is_empty() ? "nothing was seen" : "";
}

Layer curve_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  // core/graph/layer.h
  const auto emit = [&](EdgeSlot edge, Instance& out) {
    if (crust.is_crust(edge)) emit_edge(delaunay, edge, out);
  };
  return make_layer({.id = "curve", .kinds = {PrimitiveKind::segment}}, {&delaunay, &crust},
                    edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(), emit));
}

}  // namespace

TEST_CASE("core/base/disjoint_sets.h") {
  const std::size_t count = 3;
  const FaceSlot a(0), b(2);
  DisjointSets<FaceSlot> sets(count);
  sets.join(sets.root(a), sets.root(b));
  const bool are_together = sets.root(a) == sets.root(b);
  CHECK(are_together);
  CHECK(sets.root(FaceSlot(1)) != sets.root(a));
  sets.grow(5);
  CHECK(sets.root(FaceSlot(4)) == FaceSlot(4));
}

TEST_CASE("core/base/slot.h") {
  const std::size_t count = 3;
  using CornerSlot = Slot<struct CornerTag>;
  Table<CornerSlot, double> angle(count);
  for (const CornerSlot corner : angle.rows()) angle[corner] = 60.0;
  CHECK(angle.values() == std::vector<double>(count, 60.0));
}

TEST_CASE("core/base/table.h") {
  Table<EdgeSlot, double> length;
  const EdgeSlot edge = length.next();
  length.push_back(1.0);
  length[edge] *= 2.0;
  CHECK(length.values() == std::vector{2.0});
}

TEST_CASE("core/base/jobs/task_queue.h") {
  std::atomic<int> a = 0;
  int b = 0;
  const auto fill = [](std::atomic<int>& x) { x = 1; };
  const auto compute = [](int& x) { x = 2; };
  TaskQueue tasks;
  tasks.add([&] { fill(a); });
  compute(b);
  tasks.finish();
  CHECK(a == 1);
  CHECK(b == 2);
}

TEST_CASE("core/base/geometry/coordinate_range.h") {
  CHECK(refused_by_coordinate_range(3.0).empty());
  CHECK_FALSE(refused_by_coordinate_range(0x1p600).empty());
}

TEST_CASE("core/base/rng.h") {
  const std::uint64_t seed = 7;
  Rng random(seed);
  double x = random.uniform(-1.0, 1.0);
  CHECK(x == Rng(seed).uniform(-1.0, 1.0));
  CHECK(std::abs(x) <= 1.0);
}

TEST_CASE("core/document/document.h") {
  const std::vector<Vec2> points = ring();
  Document document;
  if (auto delta = insert_samples(document, points)) document.apply(*delta);
  CHECK(document.sample_count() == points.size());
}

TEST_CASE("core/document/timeline/history.h") {
  Document document = ring_document();
  const auto before = document.position(SampleSlot(0));
  const std::vector<std::pair<SampleId, Vec2>> targets{{document.id(SampleSlot(0)), Vec2{2.0, 0.5}}};
  const DocumentDelta moved = *move_samples(document, targets);
  History history;
  history.begin_gesture("Move samples");
  document.apply(moved);
  history.record(moved);
  history.end_gesture();
  for (const DocumentDelta& delta : history.undo()) document.apply(delta);
  CHECK(document.position(SampleSlot(0)) == before);
}

TEST_CASE("core/document/timeline/layer_fold.h") {
  Session session;
  session.layers.layers = {{"curve", false, {}}};
  LayersChanged hidden, shown;
  hidden.changed = {{"points", false, {}}};
  shown.changed = {{"points", true, {}}};
  const std::vector<LayersChanged> changes{hidden, shown};
  LayerConfiguration seen;
  const auto show = [&seen](const LayerConfiguration& configuration) { seen = configuration; };
  LayerFold fold(session.layers);
  for (const LayersChanged& change : changes) fold.apply(change);
  show(fold.configuration());
  REQUIRE(seen.layers.size() == 2);
  CHECK(seen.layers.back().visible);
}

TEST_CASE("core/document/timeline/timeline.h") {
  SampleData data;
  data.positions = ring();
  Document document = ring_document();
  const std::vector<Vec2> more{{0.25, 0.5}};
  const DocumentDelta delta = *insert_samples(document, more);
  document.apply(delta);
  Timeline timeline;
  timeline.restart(std::make_shared<const SampleData>(data));
  timeline.note_edit(document, delta, "Insert sample", false);
  DocumentReplay replay;
  replay.begin(*timeline.data());
  for (const TimelineEntry& entry : timeline.entries()) replay.apply(entry);
  CHECK(replay.document().sample_count() == data.positions.size() + 1);
}

TEST_CASE("core/document/settings/parameter.h") {
  const Parameter reach{.id = "reach", .explanation = "Edges are at most this long", .unit = "units", .high = 10.0};
  ParameterValues values;
  values[reach] = 2.5;
  CHECK(values[reach] == 2.5);
  CHECK(values != ParameterValues());
}

namespace {

/// A structure with one table.
struct FaceTable {
  Table<FaceSlot, FaceRow> face_;
  std::string_view id() const { return "triangles"; }
  bool is_face(FaceSlot face) const { return face_[face].is_alive(); }
  std::vector<TableColumns> table_columns() const {
    TableMaker<FaceSlot> faces("faces", "Triangles", face_.size(), [this](FaceSlot face) { return is_face(face); });
    faces.column("circumradius", "radius of the circumcircle", face_, &FaceRow::radius);
    faces.reference("corners", "counter-clockwise", face_, &FaceRow::v, table_name(id(), "sites"));
    return taken(faces);
  }
};

}  // namespace

TEST_CASE("core/graph/table_maker.h, table_columns.h and write_table.h") {
  FaceTable structure;
  structure.face_.resize(2);
  structure.face_[FaceSlot(std::size_t{1})].radius = 2.5;
  for (std::size_t i = 0; i < 3; ++i) structure.face_[FaceSlot(std::size_t{1})].v[i] = SiteSlot(i);
  std::size_t printed = 0;
  const auto print = [&printed](const TableColumn& column, RowNumber row) {
    double radius = 0.0;
    column.copy_row(row, &radius);
    CHECK(radius == 2.5);
    ++printed;
  };
  for (const TableColumns& table : structure.table_columns())
    for (RowNumber row = 0; row < table.rows; ++row)
      if (table.is_alive(row)) print(table.columns.front(), row);
  CHECK(printed == 1);

  const TableColumns table = structure.table_columns().front();
  std::string text;
  write_table(table, TableFormat::csv, [&](std::string_view piece) { text += piece; });
  CHECK(text == "row,circumradius,corners_0,corners_1,corners_2\n1,2.5,0,1,2\n");
}

TEST_CASE("core/evolutions/evolution.h") {
  const Document document = ring_document();
  const Registry& registry = builtins();
  JobControl job;
  EvolutionStates states(state_of(document), {.evolution = registry.evolutions().find("smooth")});
  const auto state = states.at(12, job);
  REQUIRE(state);
  CHECK((*state)->positions.size() == document.sample_count());
}

TEST_CASE("core/evolutions/evolution_states.h") {
  const Document document = ring_document();
  const Registry& registry = builtins();
  JobControl job;
  EvolutionStates states(state_of(document), {.evolution = registry.evolutions().find("smooth")});
  auto state = states.at(12, job);
  REQUIRE(state);
  CHECK(length((*state)->positions[0]) < 1.0);
}

TEST_CASE("core/evolutions/evolution_run.h") {
  const Document document = ring_document();
  const EvolutionChoice choice{.evolution = builtins().evolutions().find("smooth")};
  std::size_t shown = 0;
  const auto show = [&shown](const EvolutionRun::Answer& answer) {
    REQUIRE(answer.state);
    CHECK(answer.k == 12);
    ++shown;
  };
  EvolutionRun run({});
  run.begin(state_of(document), choice);
  run.want(12);
  if (auto answer = run.poll()) show(*answer);
  while (shown == 0) {
    std::this_thread::yield();
    if (auto answer = run.poll()) show(*answer);
  }
  CHECK_FALSE(run.poll());
}

TEST_CASE("core/engine/engine.h") {
  const DocumentDelta delta = *insert_samples(Document(), ring());
  LayerMirror scene;
  const Registry& registry = builtins();
  Engine engine(registry, {});
  engine.set_demand({registry.find_layer("medial-axis")});
  engine.post(std::make_shared<const DocumentDelta>(delta));
  while (auto patch = engine.sync()) {
    scene.apply(*patch);
    engine.recycle(std::move(patch));
  }
  CHECK(scene.document_revision() == delta.to_revision);
}

TEST_CASE("core/draw/layer_mirror.h") {
  const Registry& registry = builtins();
  Engine engine(registry, {});
  engine.set_demand({registry.find_layer("medial-axis")});
  engine.post(std::make_shared<const DocumentDelta>(*insert_samples(Document(), ellipse())));
  LayerMirror mirror;
  while (auto patch = engine.sync()) {
    mirror.apply(*patch);
    engine.recycle(std::move(patch));
  }
  mirror.count(registry.find_layer("medial-axis"), PrimitiveKind::segment);
  CHECK(mirror.count(registry.find_layer("medial-axis"), PrimitiveKind::segment) > 10);
}

TEST_CASE("core/engine/graph.h") {
  Document document;
  const auto delta = std::make_shared<const DocumentDelta>(*insert_samples(document, ring()));
  const Registry& registry = builtins();
  Graph graph(registry);
  graph.set_demand(std::vector{registry.find_layer("medial-axis")});
  graph.post(delta);
  FramePatch patch;
  JobControl job;
  graph.run(patch, job);
  LayerMirror mirror;
  mirror.apply(patch);
  const auto& delaunay = graph.structures().get<Delaunay>();
  CHECK(delaunay.site_rows() == 16);

  const Box2 box{{-10.0, -10.0}, {10.0, 10.0}};
  const SiteSlot site(0);
  // core/structures/delaunay/voronoi_cells.h
  const VoronoiCells cells(delaunay);
  std::vector<Vec2> corners = cells.cell(site, box);
  CHECK(corners.size() >= 3);
}

TEST_CASE("core/workbench/workbench.h") {
  const std::vector<Vec2> points = ellipse();
  std::size_t drawn = 0;
  const auto draw = [&drawn](std::span<const double> segments) { drawn = segments.size(); };
  Workbench bench(builtins());
  JobControl job;
  bench.insert(points);
  bench.show({"medial-axis"});
  if (bench.run(job)) draw(*bench.instances("medial-axis", PrimitiveKind::segment));
  CHECK(drawn > 10 * stride_of(PrimitiveKind::segment));
}

TEST_CASE("core/engine/sampling_verdict.h") {
  std::string said;
  const auto say = [&said](const std::string& text) { said = text; };
  Workbench bench(builtins());
  JobControl job;
  bench.insert(ellipse());
  bench.need<FeatureSize>();
  bench.set_want_findings(true);
  if (bench.run(job)) say(sampling_verdict(bench.nodes()).text());
  CHECK_THAT(said, Catch::StartsWith("estimated epsilon ") && Catch::EndsWith(" for these samples"));
}

TEST_CASE("core/graph/live_registry.h") {
  Registry changed = builtins();
  REQUIRE(changed.remove_layer("points"));
  LiveRegistry registry(builtins());
  const LiveRegistry of_a_window = registry;
  const auto of_a_job = of_a_window.share();
  registry.set(std::make_shared<const Registry>(changed));
  of_a_window.now().find_layer("points");
  CHECK(of_a_window.now().find_layer("points") == kNoLayer);
  CHECK(of_a_job->find_layer("points") != kNoLayer);
}

TEST_CASE("core/graph/registry.h") {
  Registry registry;
  registry.add_structure<Samples>();
  registry.add_structure<SettingsSource>();
  registry.add_layer(make_points_layer);
  Graph graph(registry);
  graph.set_demand(std::vector{registry.find_layer("points")});
  Document document;
  graph.post(std::make_shared<const DocumentDelta>(*insert_samples(document, ring())));
  FramePatch patch;
  JobControl job;
  graph.run(patch, job);
  LayerMirror mirror;
  mirror.apply(patch);
  CHECK(mirror.count(LayerIndex{0}, PrimitiveKind::point) == 16);
}

TEST_CASE("core/graph/layer.h") {
  Document document;
  Graph graph{builtins()};
  graph.set_demand(std::vector{builtins().find_layer("curve")});
  graph.post(std::make_shared<const DocumentDelta>(*insert_samples(document, ring())));
  FramePatch patch;
  JobControl job;
  graph.run(patch, job);
  Layer layer = curve_layer(graph.structures());
  LayerPatch fresh;
  layer.parts.front()->reset(fresh);
  CHECK(fresh[PrimitiveKind::segment].count == 16);
}

TEST_CASE("core/base/radix_sort.h") {
  std::vector<RadixKey> keys{{7, 0}, {3, 1}};
  radix_sort(keys);  // item 1, then item 0
  CHECK(keys.front().item == 1);
  CHECK(keys.back().item == 0);
}

TEST_CASE("core/base/max_tree.h") {
  MaxTree<EdgeSlot> lengths;
  lengths.build(2, [](EdgeSlot edge) { return edge.index() == 0 ? 3.0 : 1.0; });
  lengths.set(EdgeSlot(1), 5.0);  // largest() is 5, and row_of_largest() row 1
  CHECK(lengths.largest() == 5.0);
  CHECK(lengths.row_of_largest() == EdgeSlot(1));
}

TEST_CASE("core/base/geometry/box_tree.h") {
  const std::vector<Vec2> some{{5, 5}, {1, 2}, {-3, 0}};
  const std::span<const Vec2> places(some);
  const Vec2 p{1, 1};
  BoxTree<Vec2> tree;
  tree.build(
      places,
      [](Vec2 at) {
        return TreeBounds{{at, at}};
      },
      [](Vec2, std::uint32_t) {});
  double nearest = std::numeric_limits<double>::infinity();  // squared
  tree.visit_near(p, nearest, [&](Vec2 at) { nearest = std::min(nearest, dot(at - p, at - p)); });
  CHECK(nearest == 1.0);
}

TEST_CASE("core/structures/alpha/persistence.h") {
  PlaneFiltration plane;
  plane.corners = {{0, 0}, {0, 1}, {0, 2}};
  const std::uint32_t none = PlaneFiltration::kOutside;
  plane.edges = {{1, {0, 1}, {0, none}}, {1, {1, 2}, {0, none}}, {2, {0, 2}, {0, none}}};
  plane.triangles = {{3, 0}};
  const std::vector<PersistentClass> classes = persistent_classes(plane);
  REQUIRE(classes.size() == 4);
  CHECK(classes[0] == PersistentClass{false, 1, 0, 0, 1});
  CHECK(classes[1] == PersistentClass{false, 2, 1, 0, 1});
  CHECK(classes[2] == PersistentClass{true, 2, 0, 2, 3});
  CHECK(classes[3].death == PersistentClass::kNever);
}

TEST_CASE("core/structures/filters/axis_pruning.h") {
  const std::size_t edge_rows = 1;
  const std::size_t node_rows = 2;
  const EdgeSlot edge(0);
  const FaceSlot node(0);
  const FaceSlot other_node(1);
  bool is_kept = false;
  const auto reaches = [](EdgeSlot) { return true; };
  const auto keep = [&](EdgeSlot) { is_kept = true; };
  AxisPruning pruning;
  pruning.begin(edge_rows, node_rows);
  pruning.add(edge, node, other_node);  // in ascending order of the values
  pruning.run([](FaceSlot a, FaceSlot b) { return a < b; });
  if (const EdgeSlot level = pruning.level_of(edge); level == kNoSlot || reaches(level)) keep(edge);
  CHECK(is_kept);
  CHECK(pruning.level_of(edge) == edge);
}

TEST_CASE("core/structures/filters/paths/path_graph.h") {
  std::vector<std::uint32_t> heads;
  const auto use = [&](std::uint32_t node) { heads.push_back(node); };
  const PathGraph graph(3, {{0, 1, 5.0}, {1, 2, 3.0}});
  for (const PathStep step : graph.away_from(1)) use(graph.head(step));
  CHECK(heads == std::vector<std::uint32_t>{0, 2});
}

TEST_CASE("core/structures/filters/paths/axis_paths.h") {
  AxisPaths paths(PathGraph(4, {{0, 1, 5.0}, {1, 2, 3.0}, {1, 3, 1.0}}));
  JobControl job;
  const std::vector<AxisPath> lines = paths.main_lines(1, job);  // 0-1-2, of length 8
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].length == 8.0);
}

TEST_CASE("core/structures/filters/paths/branch_pruning.h") {
  const PathGraph graph(4, {{0, 1, 5.0}, {1, 2, 5.0}, {1, 3, 1.1}});
  const std::vector<double> radii{1.0, 1.0, 1.0, 0.0};
  const std::vector<std::uint8_t> is_kept = salient_branches(graph, radii, 0.5);
  const MergedBranches lines = merge_branches(graph, is_kept);
  REQUIRE(lines.edges.size() == 1);
  CHECK(lines.edges[0].length == 10.0);
}

TEST_CASE("core/structures/filters/paths/center_line.h") {
  CenterLines set;
  const std::array<Bank, 2> banks{Bank{{50.0, 3.0}, {{{0.0, 3.0}, {100.0, 3.0}}}},
                                  Bank{{50.0, -3.0}, {{{0.0, -3.0}, {100.0, -3.0}}}}};
  set.lines.resize(1);
  set.lines.front().axis = {{0.0, 0.0}, {50.0, 0.0}, {100.0, 0.0}};
  set.lines.front().banks = {banks, banks};
  take_axis(set.lines.front());
  std::vector<double> widths;
  const auto use = [&](Vec2 place, double width) {
    CHECK(place.y == 0.0);
    widths.push_back(width);
  };
  CenterLine line = set.lines.front();  // of `center_lines_of`
  smooth(line, {.share = 0.25});        // within a quarter of the half width
  for (const Station& at : stations_of(line, 10.0)) use(at.place, at.width);
  CHECK(widths.size() >= 10);
  CHECK(std::ranges::all_of(widths, [](double width) { return width == 6.0; }));
}

TEST_CASE("core/formula/formula.h") {
  const auto formula = Formula::parse("2 * x + 1", {"x"});
  const double values[]{3.0};
  const double seven = formula->value(values);
  CHECK(seven == 7.0);
}

TEST_CASE("core/structures/crust/internal/link_cut_forest.h") {
  LinkCutForest<EdgeSlot, std::less<>> forest({});
  forest.clear(3, 2);
  forest.link(EdgeSlot(0), 0, 1);
  forest.link(EdgeSlot(1), 1, 2);
  const EdgeSlot best = forest.best_between(0, 2);
  CHECK(best == EdgeSlot(0));
  CHECK(forest.best_between(2, 1) == EdgeSlot(1));
  forest.cut(EdgeSlot(0), 0, 1);
  CHECK_FALSE(forest.are_connected(0, 2));
  CHECK(forest.are_connected(2, 1));
}

TEST_CASE("curves are sampled as their header shows") {
  CurveSet curves;
  curves.curves.push_back(bow());
  // core/curves/sampling.h
  auto samples = sample(curves, {.rule = SamplingRule::spacing, .spacing = 0.5});
  REQUIRE(samples);
  CHECK(samples->positions.size() > 6);
}

TEST_CASE("curves lose their corners, are laid through points, and are sampled, as headers show") {
  PlaneCurve square({0, 0});
  for (const Vec2 p : {Vec2{9, 0}, Vec2{9, 9}, Vec2{0, 9}}) square.line_to(p);
  square.close();
  const CurveSet sharp{.curves = {square}};
  std::size_t marked = 0;
  const auto mark = [&](Vec2 place, double angle) { marked += place.x == 0 || angle > 1.5 ? 1U : 0U; };
  {
    const CurveSet& curves = sharp;
    // core/curves/corners.h
    for (const CurveCorner& corner : corners_of(curves, 0.5)) mark(corner.place, corner.angle);
    const CurveSet smooth = with_round_corners(curves, 0.5, 2.0);
    CHECK(corners_of(smooth, 0.5).empty());
    Vec2 found{};
    const auto use = [&](Vec2 place) { found = place; };
    // core/curves/nearest_place.h
    if (const auto place = nearest_place(curves, {0.0, 5.0}, 6.0)) use(*place);
    CHECK(found == Vec2{0.0, 5.0});
  }
  CHECK(marked == 4);
  {
    const std::vector<Vec2> points = ring();
    // core/curves/interpolation/smooth_curve.h
    const PlaneCurve curve = smooth_curve(points, true, 0.8);
    CHECK(curve.piece_count() == points.size());
  }
  const auto curves = std::make_shared<const CurveSet>(sharp);
  {
    const SamplingRequest request{.rule = SamplingRule::count, .count = 40};
    // core/document/taken_samples.h
    auto samples = sample(*curves, request);
    auto data = taken_from(curves, *std::move(samples), request);
    REQUIRE(data);
    CHECK(data->positions.size() == 40);
  }
  {
    Document document;
    // core/resampling/resampling.h
    JobControl job;
    auto taken = take_samples(curves, {.rule = SamplingRule::feature_size, .count = 400, .epsilon = 0.25}, job);
    if (taken) document.apply(*resample(document, taken->data));
    CHECK(document.sample_count() > 40);
  }
}

TEST_CASE("what curves have in common is found as their headers show") {
  const auto polygon = [](const std::vector<Vec2>& points) {
    PlaneCurve curve(points.front());
    for (const Vec2 p : std::span(points).subspan(1)) curve.line_to(p);
    return curve;
  };
  const auto ring_of = [&](const std::vector<Vec2>& points) {
    PlaneCurve curve = polygon(points);
    curve.close();
    return curve;
  };
  {
    const PlaneCurve curve = polygon({{0.25, 1.5}, {3, 4.75}});
    CurveSet curves;
    // core/curves/resolution.h
    curves.resolution = resolution_of(curve.points());
    CHECK(curves.resolution == 0.01);
  }
  {
    std::vector<PlaneCurve> curves{ring_of({{170, 0}, {180, 0}, {180, 9}, {170, 9}}),
                                   ring_of({{180, 0}, {190, 0}, {190, 9}, {180, 9}})};
    // core/curves/cuts.h
    curves = without_cuts(std::move(curves), 0.0, [](Vec2 p) { return p.x == 180.0; });
    CHECK(curves.size() == 1);
  }
  {
    std::vector<PlaneCurve> walls{polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}}), polygon({{4, 0}, {4, 9}})};
    std::vector<PlaneCurve> curves;
    // core/curves/line_regions.h
    curves = with_line_regions(std::move(walls), 0.001);
    CHECK(curves.size() == 2);
  }
  {
    PlaneCurve circle({1, 0});
    circle.arc_to({.u = {1, 0}, .v = {0, 1}, .sweep = 2.0 * std::numbers::pi}, {1, 0});
    circle.close();
    const PlaneCurve square = ring_of({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
    // core/curves/clip_region.h
    const ClipRegion disk = ClipRegion::of(std::vector{circle}, FillRule::nonzero, clip_grid(100.0));
    const ClippedCurves seen = disk.clipped({square}, Ink::nonzero_area);
    CHECK(seen.seen == ClippedCurves::Seen::part);
    CHECK(seen.curves.size() == 1);
  }
}

TEST_CASE("what an epsilon is measured by is made as the headers show") {
  CurveSet curves;
  curves.curves.push_back(bow());
  const SamplingRequest request;
  double found = 0.0;
  const auto use = [&](double epsilon) { found = epsilon; };
  {
    JobControl job;
    // core/structures/density/sample_sizes.h
    SampleSizes sizes(job);
    auto field = FeatureField::of(
        curves, request, [&](auto positions) { return sizes.of(positions); }, &job);
    CHECK(field.has_value());
  }
  JobControl job;
  SampleSizes measured(job);
  const FeatureSizes sizes = [&](std::span<const Vec2> places) { return measured.of(places); };
  const std::vector<Vec2> positions = sample(curves, {.rule = SamplingRule::count, .count = 50})->positions;
  // core/curves/feature_field.h
  auto field = FeatureField::of(curves, request, sizes);
  if (field) use(field->standing(positions).epsilon);
  CHECK(found > 0.0);
  CHECK(std::isfinite(found));
}

TEST_CASE("pictures are traced as their headers show") {
  GrayImage image{20, 20, std::vector<std::uint8_t>(400, 0)};
  for (int y = 5; y < 15; ++y)
    for (int x = 5; x < 15; ++x) image.values[static_cast<std::size_t>(20 * y + x)] = 255;
  {
    // core/raster/contours.h
    const auto contours = contours_of(image, {.level = Level{127}, .is_figure_light = true});
    REQUIRE(contours.kept.size() == 1);
    CHECK(contours.kept[0].area == Approx(100.0 - 4 * 0.125));
  }
  std::size_t used = 0;
  const auto use = [&](const CurveSet& curves) { used += curves.curves.size(); };
  // core/raster/trace.h
  const auto tracing = trace(image, {});
  if (tracing) use(tracing->curves);
  CHECK(used == 1);
}

TEST_CASE("shapes are made as their headers show") {
  // core/shapes/shape.h
  const ShapeDescriptor* star = find_shape("star");
  const auto data = make_shape(*star, {.values = values_of(*star), .sampling = {.samples = 300}});
  REQUIRE(data);
  CHECK(data->positions.size() == 300);
}

TEST_CASE("splines, pieces and letters become curves as their headers show") {
  // core/curves/interpolation/b_spline.h
  const auto curve = curve_of_spline(BSpline::clamped(3, {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {6, 0}}));
  REQUIRE(curve);
  CHECK(curve->piece_count() == 2);

  // core/curves/interpolation/cubic_interpolation.h
  const auto arch = cubic_through(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 0}}, false);
  REQUIRE(arch);
  CHECK(arch->piece_count() == 2);

  PlaneCurve left_half({0, 1});
  left_half.line_to({-1, 0});
  left_half.line_to({0, -1});
  PlaneCurve right_half({0, 1});
  right_half.line_to({1, 0});
  right_half.line_to({0, -1});
  // core/curves/joined_ends.h
  const auto outline = joined_ends({left_half, right_half}, 1e-6);
  REQUIRE(outline.size() == 1);
  CHECK(outline[0].is_closed());

  // core/glyphs/text_outlines.h
  const auto font = find_font("DejaVu Sans");
  if (!font) return;  // which fonts there are is up to the machine
  const auto outlines = outlines_of_text({.text = "B", .font = *font});
  REQUIRE(outlines);
  CHECK(outlines->curves.curves.size() == 3);
}

TEST_CASE("core/edit/frame_handles.h") {
  std::vector<Vec2> places{{0, 0}, {4, 2}};
  const Box2 box{{0, 0}, {4, 2}};
  const double units_per_pixel = 0.01;
  const Vec2 pointer{4.13, 1.02};
  const Vec2 to{5.0, 1.0};
  const HandleFrame frame(box, units_per_pixel);
  if (const auto handle = frame.handle_at(pointer, 8.0 * units_per_pixel))
    places = dragged(places, box, {*handle, held_place(box, *handle), to}).value().places;
  CHECK(places == std::vector<Vec2>{{0, 0}, {5, 2}});
}

TEST_CASE("core/document/live_corners.h") {
  Document document;
  document.apply(
      *replace_all(document, {.positions = {{0, 0}, {1, 0}, {2, 0}}, .contours = {{false, {0, 1, 0, 2}}}}));
  const SampleId first = document.id(SampleSlot(0));
  const SampleId last = document.id(SampleSlot(2));
  document.apply(*remove_samples(document, std::vector{document.id(SampleSlot(1))}));
  std::vector<SampleId> seen;
  const auto use = [&](SampleId id) { seen.push_back(id); };
  const CurveOrder::Contour& contour = document.curve_order()->contours.front();
  for (const SampleId id : live_corners(document, contour)) use(id);
  CHECK(seen == std::vector<SampleId>{first, last});
}

TEST_CASE("core/document/moved_curves.h") {
  Document document;
  const auto curves = std::make_shared<const CurveSet>(CurveSet{.curves = {test::polygon({{0, 0}, {1, 0}, {0, 1}})}});
  document.apply(
      *replace_all(document, {.positions = {{0, 0}, {1, 0}, {0, 1}},
                              .source = std::make_shared<const CurveSource>(CurveSource{curves, {}, 0, 3})}));
  std::vector<std::pair<SampleId, Vec2>> targets;
  for (const SampleSlot slot : document.slots_in_input_order())
    targets.emplace_back(document.id(slot), document.position(slot) + Vec2{5, 0});
  DocumentDelta delta = *move_samples(document, targets);
  if (auto source = source_after_move(document, delta.edits)) delta.source_after = source;
  REQUIRE(delta.changes_source());
  CHECK(delta.source_after->curves->curves[0].start() == Vec2{5, 0});
}

TEST_CASE("core/curves/filled_area.h") {
  std::vector<PlaneCurve> curves(2, test::polygon({{0, 0}, {1, 0}, {0, 1}}));
  std::vector<PlaneCurve> used;
  const auto use = [&](std::vector<PlaneCurve> area) { used = std::move(area); };
  auto area = nonzero_area(std::move(curves));
  if (area.is_changed) use(area.curves);
  CHECK(used.size() == 1);
}
