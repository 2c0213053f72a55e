// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that are not finite are avoided where there is a finite one, and otherwise counted and left out.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "core/base/sum.h"
#include "core/graph/layer.h"
#include "core/io/format.h"
#include "core/structures/balls/ball_union.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}  // namespace

TEST_CASE("a sum leaves out what is not finite, and keeps what large terms would swallow") {
  Sum sum;
  for (const double term : {1e100, 1.0, kNothing, -1e100, kInfinity, 1.0, -kInfinity}) sum.add(term);
  CHECK(sum.value() == 2.0);
  CHECK(sum.left_out() == 3);
}

TEST_CASE("crossings that are collinear for products of doubles have finite circumcentres all the same") {
  auto file = read_sample_file("tests/data/crossings_nearly_in_line.poff");
  REQUIRE(file.has_value());
  ComputationSettings settings;
  settings.precision = Precision::fast;
  settings[Parameter::union_shortcut] = 0.0;
  TestBench bench;
  bench.show({"a-ball-medial-axis", "a-v-voronoi"});
  bench.choose(settings);
  bench.load(file->data);
  REQUIRE(bench.get<AUnion>().rung() == UnionRung::doubles);
  CHECK(std::isfinite(bench.measure("a-union", "length")));
  CHECK(bench.measure("a-union", "length") > 0.0);
  CHECK(bench.count("a-union", "not_finite") == 0);
  for (const VFace& face : bench.get<AUnion>().tables().v_faces) CHECK(is_finite(Disk{face.center, face.radius}));
  for (const LayerReport& report : bench.patch().reports) CHECK(report.lost == 0);
}

TEST_CASE("a layer counts the primitives it cannot draw, through updates as after a reset") {
  using Row = Slot<struct RowTag>;
  Table<Row, double> radius;
  for (const double r : {1.0, kInfinity, 2.0, kNothing, -1.0}) radius.push_back(r);
  ChangeSet<Row> changes;
  // A negative radius stands for a row without primitive.
  const auto part = table_part(
      {PrimitiveKind::disk}, [&radius] { return radius.size(); }, changes,
      [&radius](Row row, Instance& out) {
        if (!(radius[row] < 0.0)) out.disk({}, radius[row]);
      });
  LayerPatch patch;
  part->reset(patch);
  CHECK(patch[PrimitiveKind::disk].count == 2);
  CHECK(part->lost() == 2);
  const auto change = [&](Row row, double value) {
    radius[row] = value;
    changes.clear();
    changes.touched.push_back(row);
    for (const PrimitiveKind kind : kAllPrimitiveKinds) patch[kind].clear();
    part->update(patch);
  };
  change(Row(1), 3.0);
  CHECK(part->lost() == 1);
  change(Row(0), kInfinity);
  CHECK(part->lost() == 2);
  CHECK(patch[PrimitiveKind::disk].count == 2);
  change(Row(3), -1.0);
  CHECK(part->lost() == 1);
  changes.clear();
  changes.removed.emplace_back(0);
  radius[Row(0)] = -1.0;
  part->update(patch);
  CHECK(part->lost() == 0);
}
