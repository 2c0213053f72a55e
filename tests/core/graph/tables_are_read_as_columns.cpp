// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of all structures as columns: after random edits every row can be read, refers to rows that are alive, says
// what the accessors of its structure say, and is named by the change sets if it differs from before.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/graph/table_columns.h"
#include "core/structures/axis/axis_nodes.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/crust/curve.h"
#include "core/structures/filters/lambda_axis.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using Bytes = std::vector<std::byte>;
/// By row; none where it is dead.
using RowsBefore = std::vector<std::optional<Bytes>>;

struct NamedTable {
  const Structure* structure;
  TableColumns table;
};
using AllTables = std::map<std::string, NamedTable>;

AllTables tables_of_graph(const Graph& graph) {
  AllTables out;
  for (const auto& structure : graph.structures().all()) {
    if (!graph.is_up_to_date(*structure)) continue;
    for (TableColumns& table : structure->table_columns()) {
      const std::string name = table_name(structure->id(), table.name);
      INFO(name);
      REQUIRE(out.emplace(name, NamedTable{structure.get(), std::move(table)}).second);
    }
  }
  return out;
}

Bytes row_of(const TableColumns& table, RowNumber row, bool all) {
  Bytes out;
  for (const TableColumn& column : table.columns) {
    if (!all && !column.is_followed) continue;
    const std::size_t begin = out.size();
    out.resize(begin + column.row_size());
    column.copy_row(row, out.data() + begin);
  }
  return out;
}

std::map<std::string, RowsBefore> copy_of(const AllTables& tables) {
  std::map<std::string, RowsBefore> out;
  for (const auto& [name, named] : tables) {
    RowsBefore& rows = out[name];
    rows.resize(named.table.rows);
    for (RowNumber row = 0; row < named.table.rows; ++row)
      if (named.table.is_alive(row)) rows[row] = row_of(named.table, row, false);
  }
  return out;
}

template <class Value>
std::vector<Value> values(const TableColumn& column, RowNumber row) {
  std::vector<Value> out(column.width);
  REQUIRE(column.row_size() == out.size() * sizeof(Value));
  column.copy_row(row, out.data());
  return out;
}

const TableColumn& column_of(const TableColumns& table, std::string_view name) {
  const auto found = std::ranges::find(table.columns, name, &TableColumn::name);
  INFO(table.name << " has a column " << name);
  REQUIRE(found != table.columns.end());
  return *found;
}

bool is_snake_case(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

void check_rows(const AllTables& tables) {
  for (const auto& [name, named] : tables) {
    const TableColumns& table = named.table;
    INFO(name);
    REQUIRE(is_snake_case(table.name));
    REQUIRE(!table.columns.empty());
    // Files have these fields besides the columns.
    std::set<std::string> names{"row", "is_alive"};
    for (const TableColumn& column : table.columns) {
      INFO(column.name);
      REQUIRE(is_snake_case(column.name));
      REQUIRE(names.insert(column.name).second);
      REQUIRE((!column.description.empty() && column.description.back() != '.'));
      REQUIRE((column.width == 1 ? column.parts.empty() : column.parts.size() == column.width));
      REQUIRE((column.is_stored() || column.data == nullptr));
      for (RowNumber row = 0; row < table.rows; ++row) {
        if (column.type == ColumnType::boolean && table.is_alive(row))
          for (const std::uint8_t value : values<std::uint8_t>(column, row)) REQUIRE(value <= 1);
        if (!column.is_reference || column.refers_to.empty() || !table.is_alive(row)) continue;
        const auto target = tables.find(column.refers_to);
        REQUIRE(target != tables.end());
        for (const RowNumber other : values<RowNumber>(column, row)) {
          if (other == kNoRow || column.infinity == other) continue;
          INFO("row " << row << " refers to row " << other << " of " << column.refers_to);
          REQUIRE(other < target->second.table.rows);
          REQUIRE(target->second.table.is_alive(other));
        }
      }
    }
    const auto owner = tables.find(table.rows_of);
    REQUIRE((table.rows_of.empty() || owner != tables.end()));
    for (RowNumber row = 0; row < table.rows; ++row) {
      row_of(table, row, true);
      if (owner == tables.end() || !table.is_alive(row)) continue;
      REQUIRE(row < owner->second.table.rows);
      REQUIRE(owner->second.table.is_alive(row));
    }
  }
}

/// Names of the columns that differ in a row that was alive before and is now.
std::string different_columns(const TableColumns& table, const std::optional<Bytes>& a,
                              const std::optional<Bytes>& b) {
  std::string out;
  std::size_t begin = 0;
  for (const TableColumn& column : table.columns) {
    if (!a || !b || !column.is_followed) continue;
    const auto end = begin + column.row_size();
    if (!std::equal(a->begin() + static_cast<std::ptrdiff_t>(begin), a->begin() + static_cast<std::ptrdiff_t>(end),
                    b->begin() + static_cast<std::ptrdiff_t>(begin)))
      out += " " + column.name;
    begin = end;
  }
  return out;
}

/// Tables of structures that were not rebuilt. Adds the names of those that had changes.
void check_changes(const FramePatch& patch, const AllTables& tables, const std::map<std::string, RowsBefore>& before,
                   std::set<std::string>& followed) {
  for (const auto& [name, named] : tables) {
    const TableColumns& table = named.table;
    const auto node = std::ranges::find(patch.nodes, named.structure->id(), &NodeReport::structure);
    REQUIRE(node != patch.nodes.end());
    if (node->rebuilt || !table.changes || !before.contains(name)) continue;
    std::set<RowNumber> named_rows(table.changes->touched.begin(), table.changes->touched.end());
    named_rows.insert(table.changes->removed.begin(), table.changes->removed.end());
    REQUIRE(named_rows.size() == table.changes->touched.size() + table.changes->removed.size());
    const RowsBefore& old_rows = before.at(name);
    for (RowNumber row = 0; row < std::max(table.rows, old_rows.size()); ++row) {
      const std::optional<Bytes> old_row = row < old_rows.size() ? old_rows[row] : std::nullopt;
      std::optional<Bytes> new_row;
      if (row < table.rows && table.is_alive(row)) new_row = row_of(table, row, false);
      if (old_row == new_row) continue;
      followed.insert(name);
      INFO(name << ", row " << row << ": " << (old_row ? "alive" : "dead") << " before, "
                << (new_row ? "alive" : "dead") << " now" << different_columns(table, old_row, new_row));
      REQUIRE(named_rows.contains(row));
    }
    for (const RowNumber row : table.changes->removed) REQUIRE((row >= table.rows || !table.is_alive(row)));
  }
}

/// Tables that were kept since they were first seen are as those that are made anew.
void check_refreshed(const AllTables& tables, AllTables& kept) {
  for (const auto& [name, named] : tables) {
    if (!named.table.refresh) continue;
    TableColumns& table = kept.try_emplace(name, named).first->second.table;
    table.refresh(table);
    INFO(name);
    REQUIRE(table.rows == named.table.rows);
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      REQUIRE(table.columns[i].data == named.table.columns[i].data);
    REQUIRE(table.changes.has_value() == named.table.changes.has_value());
    if (!table.changes) continue;
    REQUIRE(std::ranges::equal(table.changes->touched, named.table.changes->touched));
    REQUIRE(std::ranges::equal(table.changes->removed, named.table.changes->removed));
  }
}

/// What the steps before have left.
struct Before {
  std::map<std::string, RowsBefore> rows;
  AllTables kept;
};

void check_step(const TestBench& bench, Before& before, std::set<std::string>& followed) {
  const AllTables tables = tables_of_graph(bench.graph());
  check_rows(tables);
  check_changes(bench.patch(), tables, before.rows, followed);
  check_refreshed(tables, before.kept);
  before.rows = copy_of(tables);
}

}  // namespace

TEST_CASE("A graph that never ran has tables without rows, and two structures have none") {
  const Graph graph{builtins()};
  std::set<std::string_view> without;
  for (const auto& structure : graph.structures().all()) {
    const std::vector<TableColumns> tables = structure->table_columns();
    if (tables.empty()) without.insert(structure->id());
    for (const TableColumns& table : tables) {
      INFO(structure->id() << '/' << table.name);
      CHECK(table.rows == 0);
      if (table.changes) CHECK((table.changes->touched.empty() && table.changes->removed.empty()));
    }
  }
  CHECK(without == std::set<std::string_view>{"center-line-ends", "curve-source", "settings"});
}

TEST_CASE("Rows of all tables are sound, and change sets name those that differ") {
  const auto seed = static_cast<std::uint64_t>(GENERATE(range(1, 7)));
  Rng rng(seed);
  // Anywhere, on a lattice, or on a line.
  const auto somewhere = [&rng, seed]() -> Vec2 {
    const auto whole = [&rng](std::uint64_t below) { return static_cast<double>(rng.below(below)) / 8.0; };
    if (seed % 4 == 2) return {whole(8), whole(8)};
    if (seed % 4 == 3) return {whole(64), rng.below(20) == 0 ? whole(8) : 0.0};
    return {rng.uniform(), rng.uniform()};
  };
  std::vector<Vec2> positions(seed % 2 == 0 ? 30 : 12);
  std::ranges::generate(positions, somewhere);
  TestBench bench(positions);
  bench.insert_balls({{{0.2, 0.3}, 0.2}, {{0.4, 0.3}, 0.15}, {{0.4, 0.6}, 0.2}, {{2.0, 2.0}, 0.0}});
  Before before;
  std::set<std::string> followed;
  check_step(bench, before, followed);
  ComputationSettings settings;
  for (int step = 0; step < 24; ++step) {
    INFO("seed " << seed << ", step " << step);
    const std::vector<SampleId> ids = bench.ids();
    const SampleId one = ids[rng.below(ids.size())];
    switch (step % 8) {
      case 0: bench.move(one, somewhere()); break;
      case 1: bench.insert({somewhere(), bench.positions().front()}); break;
      case 2: bench.remove({one}); break;
      case 3: bench.change_ball(bench.ball_ids().front(), {somewhere(), 0.3}); break;
      case 4: bench.undo(); break;
      case 5: bench.redo(); break;
      case 6: bench.move({{ids.back(), somewhere()}, {ids.front(), somewhere()}}); break;
      default:
        settings[Parameter::lambda_limit] = 0.2 * rng.uniform();
        settings[Parameter::alpha_radius] = 0.3 * rng.uniform();
        settings[Parameter::keep_topology] = step % 2 == 0 ? 0.0 : 1.0;
        settings[Parameter::scale_axis_factor] = step < 12 ? 1.0 : 1.2;
        bench.choose(settings);
    }
    check_step(bench, before, followed);
  }
  CHECK(followed.size() > 5);
  CHECK(before.kept.contains("delaunay/edges"));
}

TEST_CASE("Tables of a dense sample follow its edits and its parameters") {
  const TestShape shape = ellipse_graded(2.0, 1.0, 0.25);
  TestBench bench;
  bench.load(shape.data);
  Before before;
  std::set<std::string> followed;
  check_step(bench, before, followed);
  Rng rng(5);
  for (int step = 0; step < 20; ++step) {
    INFO("step " << step);
    const std::size_t chosen = rng.below(bench.ids().size());
    const Vec2 at = bench.positions()[chosen];
    if (step % 5 < 3) bench.move(bench.ids()[chosen], {at.x * 1.001, at.y * 1.001});
    if (step % 5 == 3) bench.remove({bench.ids()[chosen]});
    if (step % 5 == 4) bench.undo();
    check_step(bench, before, followed);
  }
  ComputationSettings settings;
  for (const double limit : {0.3, 0.6}) {
    INFO("limit " << limit);
    settings[Parameter::lambda_limit] = limit;
    settings[Parameter::angle_limit] = 100.0 * limit;
    settings[Parameter::alpha_radius] = limit;
    bench.choose(settings);
    check_step(bench, before, followed);
  }
  // The shortcut and what lies below it were updated and not made anew.
  for (const char* name :
       {"delaunay/faces",         "delaunay/edges",      "one-step-crust/edges", "labels/faces",
        "inner-balls/faces",      "medial-axis/edges",   "axis-nodes/faces",     "lambda-axis/edges",
        "angle-axis/edges",       "alpha-complex/edges", "feature-size/sites",   "a-union/balls",
        "a-union/axis_pieces",    "a-union/v_points",    "a-union/arcs",         "a-ball-sampling/medial",
        "axis-certificate/edges", "curve/sites",         "contours/links",       "samples/samples"}) {
    INFO(name);
    CHECK(followed.contains(name));
  }
}

TEST_CASE("Columns say what the accessors of their structures say") {
  const TestShape shape = ellipse_graded(2.0, 1.0, 0.25);
  TestBench bench;
  bench.load(shape.data);
  const AllTables tables = tables_of_graph(bench.graph());
  const auto& delaunay = bench.get<Delaunay>();
  const auto& crust = bench.get<OneStepCrust>();
  const auto& lambda = bench.get<LambdaAxis>();
  const auto& axis = bench.get<MedialAxis>();

  const TableColumns& faces = tables.at("delaunay/faces").table;
  REQUIRE(faces.rows == delaunay.face_rows());
  const TableColumn& corners = column_of(faces, "sites");
  const TableColumn& radius = column_of(faces, "circumradius");
  CHECK(corners.data == delaunay.faces().values().front().v);
  CHECK(radius.data == &delaunay.faces().values().front().radius);
  CHECK(radius.stride == sizeof(FaceRow));
  CHECK(corners.name_of(2) == "sites_2");
  CHECK(column_of(faces, "circumcenter").name_of(1) == "circumcenter_y");
  const TableColumn& inside = column_of(tables.at("labels/faces").table, "is_inside");
  std::size_t finite = 0;
  for (const FaceSlot face : delaunay.face_slots()) {
    REQUIRE(faces.is_alive(face.index()) == delaunay.face(face).is_alive());
    if (!delaunay.is_finite_face(face)) continue;
    ++finite;
    const std::vector<RowNumber> sites = values<RowNumber>(corners, face.index());
    for (std::size_t i = 0; i < 3; ++i) REQUIRE(sites[i] == delaunay.face(face).v[i].index());
    const std::vector<double> center = values<double>(column_of(faces, "circumcenter"), face.index());
    const double r = values<double>(radius, face.index()).front();
    for (const RowNumber site : sites)
      REQUIRE(distance({center[0], center[1]}, delaunay.site_position(SiteSlot(site))) == Approx(r));
    REQUIRE((values<std::uint8_t>(inside, face.index()).front() != 0) == bench.get<Labels>().is_inside(face));
  }
  CHECK(finite > 20);

  const TableColumns& edges = tables.at("one-step-crust/edges").table;
  const TableColumns& axis_edges = tables.at("lambda-axis/edges").table;
  std::size_t crust_edges_seen = 0, axis_edges_seen = 0;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!delaunay.edge(edge).is_alive()) continue;
    const bool is_crust = values<std::uint8_t>(column_of(edges, "is_crust"), edge.index()).front() != 0;
    REQUIRE(is_crust == crust.is_crust(edge));
    crust_edges_seen += is_crust ? 1 : 0;
    REQUIRE(axis_edges.is_alive(edge.index()) == (axis.is_axis_edge(edge) && !axis.is_zero_length(edge)));
    if (!axis_edges.is_alive(edge.index())) continue;
    ++axis_edges_seen;
    const double value = values<double>(column_of(axis_edges, "lambda"), edge.index()).front();
    REQUIRE(value == lambda.value(edge));
    const EdgeRow& row = delaunay.edge(edge);
    REQUIRE(value == Approx(0.5 * distance(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1]))));
  }
  CHECK(crust_edges_seen == shape.data.positions.size());
  CHECK(axis_edges_seen > 10);
}

TEST_CASE("What is pointed at has a row in its own table and in those that speak of it") {
  TestBench bench(ellipse(2.0, 1.0, 60, {.offset = 0.3}).data.positions);
  const auto& delaunay = bench.get<Delaunay>();
  const auto& axis = bench.get<MedialAxis>();
  const auto has_value = [](const ProvenanceRow& row, std::string_view name, std::string_view text) {
    return std::ranges::any_of(row.values, [&](const ProvenanceRow::Value& value) {
      return value.name == name && value.text == text && !value.description.empty();
    });
  };
  for (const FaceSlot face : delaunay.face_slots()) {
    if (!delaunay.is_finite_face(face) || !bench.get<InnerBalls>().is_ball(face) || axis.node_degree(face) != 2)
      continue;
    const Provenance answer = bench.ask(delaunay.circumcenter(face), 1e-9, {"interior-voronoi-vertices"});
    REQUIRE_FALSE(answer.rows.empty());
    CHECK(answer.rows.front().table == "delaunay/faces");
    CHECK(has_value(answer.rows.front(), "is_finite", "yes"));
    for (const ProvenanceRow& row : answer.rows) {
      INFO(row.table);
      CHECK(row.row == face.index());
      if (row.table == "labels/faces") CHECK(has_value(row, "is_inside", "yes"));
      if (row.table == "axis-nodes/faces") CHECK(has_value(row, "degree", "2"));
    }
    CHECK(std::ranges::count(answer.rows, "axis-nodes/faces", &ProvenanceRow::table) == 1);
    return;
  }
  FAIL("there is an inner node of degree 2");
}

TEST_CASE("A row of one family of balls is that of its owner alone") {
  TestBench bench(ellipse(2.0, 1.0, 60, {.offset = 0.3}).data.positions);
  const Table<VPointSlot, VPoint>& points = bench.get<AUnion>().tables().v_points;
  for (const VPointSlot point : points.rows()) {
    if (!points[point].is_alive()) continue;
    const Provenance answer = bench.ask(points[point].position, 1e-9, {"a-v-points"});
    REQUIRE(answer.rows.size() == 1);
    CHECK(answer.rows.front().table == "a-union/v_points");
    CHECK(answer.rows.front().row == point.index());
    return;
  }
  FAIL("there is a v-point");
}
