// SPDX-License-Identifier: GPL-3.0-or-later
// What the compiler must refuse, as far as it can be asked, and what slots and tables do at run time.
#include <catch2/catch.hpp>
#include <concepts>
#include <numeric>
#include <type_traits>
#include <unordered_set>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/disjoint_sets.h"
#include "core/base/table.h"
#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/crust/curve.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/inputs/samples.h"

using namespace mes;

namespace {

template <class A, class B>
concept Comparable = requires(A a, B b) {
  a == b;
}
|| requires(A a, B b) {
  a < b;
};
template <class A, class B>
concept Choosable = requires(bool first, A a, B b) {
  first ? a : b;
};
template <class Column, class Index>
concept IndexedBy = requires(Column column, Index index) {
  column[index];
};

template <class A, class B>
constexpr bool kMix = std::is_convertible_v<A, B> || std::is_constructible_v<B, A> || std::is_assignable_v<B&, A> ||
                      Comparable<A, B> || Choosable<A, B> || IndexedBy<Table<B, int>, A>;

template <class Row, class... Others>
consteval bool is_apart_from() {
  return ((std::is_same_v<Row, Others> || !kMix<Row, Others>)&&...);
}
template <class... Rows>
consteval bool are_apart() {
  return (is_apart_from<Rows, Rows...>() && ...);
}
static_assert(are_apart<SampleSlot, BallSlot, SiteSlot, FaceSlot, EdgeSlot, ChainSlot, FamilySlot, InputSlot,
                        TriangleSlot, DualEdgeSlot, DualFaceSlot, VPointSlot, VOriginSlot, AxisPieceSlot, VFaceSlot,
                        VEdgeSlot, ArcSlot, AxisNodeSlot, PowerEdgeSlot, SampledSlot, OwnerSlot>());

template <class Row>
consteval bool is_no_number() {
  using Column = Table<Row, double>;
  return !std::is_convertible_v<RowNumber, Row> && !std::is_convertible_v<int, Row> &&
         !std::is_convertible_v<std::size_t, Row> && !std::is_convertible_v<Row, RowNumber> &&
         !std::is_convertible_v<Row, std::size_t> && !std::is_convertible_v<Row, bool> &&
         !std::is_assignable_v<Row&, RowNumber> && !std::is_assignable_v<RowNumber&, Row> &&
         !Comparable<Row, RowNumber> && !Comparable<Row, int> && !IndexedBy<Column, RowNumber> &&
         !IndexedBy<Column, int> && !IndexedBy<std::vector<double>, Row> && !std::is_convertible_v<LayerIndex, Row> &&
         !std::is_convertible_v<SampleId, Row>;
}
static_assert(is_no_number<SampleSlot>() && is_no_number<SiteSlot>() && is_no_number<FaceSlot>() &&
              is_no_number<EdgeSlot>() && is_no_number<BallSlot>() && is_no_number<FamilySlot>());
static_assert(!std::is_convertible_v<NoSlot, RowNumber> && !std::is_convertible_v<NoSlot, LayerIndex>);

// What is meant to work, so that the refusals above are not those of everything.
static_assert(std::is_constructible_v<FaceSlot, RowNumber> && std::is_convertible_v<NoSlot, FaceSlot> &&
              Comparable<FaceSlot, FaceSlot> && Comparable<FaceSlot, NoSlot> && Choosable<FaceSlot, NoSlot> &&
              IndexedBy<Table<FaceSlot, double>, FaceSlot>);

// Structures, too, ask for their own rows.
static_assert(std::is_invocable_v<decltype(&Delaunay::face), const Delaunay&, FaceSlot> &&
              !std::is_invocable_v<decltype(&Delaunay::face), const Delaunay&, EdgeSlot> &&
              !std::is_invocable_v<decltype(&Delaunay::face), const Delaunay&, int>);
static_assert(std::is_invocable_v<decltype(&Delaunay::apex), const Delaunay&, FaceSlot, EdgeSlot> &&
              !std::is_invocable_v<decltype(&Delaunay::apex), const Delaunay&, EdgeSlot, FaceSlot>);
static_assert(!std::is_invocable_v<decltype(&Samples::position), const Samples&, SiteSlot> &&
              !std::is_invocable_v<decltype(&OneStepCrust::degree), const OneStepCrust&, SampleSlot>);
static_assert(!std::is_convertible_v<const ChangeSet<FaceSlot>&, const ChangeSet<EdgeSlot>&> &&
              !std::is_convertible_v<SlotMarks<FaceSlot>, SlotMarks<EdgeSlot>>);

// At no cost in memory, and copied as numbers are.
static_assert(sizeof(FaceSlot) == sizeof(RowNumber) && alignof(FaceSlot) == alignof(RowNumber) &&
              std::is_trivially_copyable_v<FaceSlot> && std::is_trivially_destructible_v<FaceSlot> &&
              std::is_standard_layout_v<FaceSlot>);
static_assert(sizeof(Table<FaceSlot, double>) == sizeof(std::vector<double>));
static_assert(sizeof(FaceRow) == 64 && sizeof(EdgeRow) == 20);

}  // namespace

TEST_CASE("a slot names no row until it is given one, and no row comes after all others") {
  const FaceSlot none;
  CHECK(none == kNoSlot);
  CHECK(FaceSlot(0) != kNoSlot);
  CHECK(FaceSlot(3) < FaceSlot(7));
  CHECK(kInfiniteSite < SiteSlot());
  CHECK(kInfiniteSite != kNoSlot);
  CHECK(FaceSlot(7).index() == 7);
  CHECK(same_row<FamilySlot>(FaceSlot(7)) == FamilySlot(7));
  CHECK(same_row<FamilySlot>(none) == kNoSlot);
  CHECK(std::unordered_set<FaceSlot>{FaceSlot(1), FaceSlot(2), FaceSlot(1)}.size() == 2);
}

TEST_CASE("rows are visited in order") {
  std::vector<RowNumber> seen;
  for (const FaceSlot face : slots_below<FaceSlot>(3)) seen.push_back(face.index());
  for (const EdgeSlot edge : slots_between<EdgeSlot>(5, 7)) seen.push_back(edge.index());
  for (const EdgeSlot edge : slots_below<EdgeSlot>(0)) seen.push_back(edge.index());
  CHECK(seen == std::vector<RowNumber>{0, 1, 2, 5, 6});
}

TEST_CASE("a table is a vector in all but its index") {
  Table<EdgeSlot, int> table(2, 5);
  const EdgeSlot edge = table.next();
  CHECK_FALSE(table.has(edge));
  CHECK_FALSE(table.has(EdgeSlot()));
  table.push_back(9);
  CHECK(table.has(edge));
  table[edge] += 1;
  CHECK(table.values() == std::vector{5, 5, 10});
  CHECK(table.address(edge) == &table[edge]);
  CHECK(std::accumulate(table.begin(), table.end(), 0) == 20);
  std::vector<RowNumber> rows;
  for (const EdgeSlot row : table.rows()) rows.push_back(row.index());
  CHECK(rows == std::vector<RowNumber>{0, 1, 2});
  const TableView<EdgeSlot, int> view = table;
  CHECK(view[edge] == 10);
  CHECK(view.size() == 3);
}

TEST_CASE("a change set names each row once, and not those that came and went") {
  ChangeRecorder<FaceSlot> recorder;
  ChangeSet<FaceSlot> changes;
  recorder.begin(2);
  recorder.note(FaceSlot(1), true);
  recorder.note(FaceSlot(0), true);
  recorder.note(FaceSlot(1), false);
  recorder.note(FaceSlot(5), false);
  recorder.note(FaceSlot(6), false);
  recorder.finish(changes, [](FaceSlot face) { return face == FaceSlot(1) || face == FaceSlot(6); });
  CHECK(changes.touched == std::vector{FaceSlot(1), FaceSlot(6)});
  CHECK(changes.removed == std::vector{FaceSlot(0)});
}
