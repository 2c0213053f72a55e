// SPDX-License-Identifier: GPL-3.0-or-later
// A layer: a pure function from the rows of a table to primitives, and the bookkeeping that turns change sets into
// patches.
//
// A layer is made by a function `Layer make_xyz_layer(const StructureSet&)` in core/layers. The emitter looks
// at one row and writes at most one primitive; it does not know the index of that primitive in the drawing buffer.
//
// Smallest use:
//     const auto emit = [&](EdgeSlot edge, Instance& out) {
//       if (crust.is_crust(edge)) emit_edge(delaunay, edge, out);
//     };
//     return make_layer({.id = "curve", .kinds = {PrimitiveKind::segment}}, {&delaunay, &crust},
//                       edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(), emit));
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/arc.h"
#include "core/base/geometry/parabola_arc.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/patch.h"
#include "core/graph/hit.h"
#include "core/graph/structure.h"
#include "core/graph/table_columns.h"

namespace mes {

/// The output of an emitter. A primitive with coordinates that are not finite cannot be drawn; it is dropped and
/// counted as lost.
class Instance {
 public:
  void point(Vec2 p, double scalar = 0.0) { set(PrimitiveKind::point, {p.x, p.y, scalar}); }
  void disk(Vec2 c, double r, double scalar = 0.0) { set(PrimitiveKind::disk, {c.x, c.y, r, scalar}); }
  void circle(Vec2 c, double r, double scalar = 0.0) { set(PrimitiveKind::circle, {c.x, c.y, r, scalar}); }
  void segment(Vec2 a, Vec2 b, double scalar = 0.0) { set(PrimitiveKind::segment, {a.x, a.y, b.x, b.y, scalar}); }
  /// A direction of length zero, which rounding may produce, draws nothing.
  void ray(Vec2 from, Vec2 towards, double scalar = 0.0) {
    if (towards != Vec2{}) set(PrimitiveKind::ray, {from.x, from.y, towards.x, towards.y, scalar});
  }
  void line(Vec2 through, Vec2 direction, double scalar = 0.0) {
    if (direction != Vec2{}) set(PrimitiveKind::line, {through.x, through.y, direction.x, direction.y, scalar});
  }
  void triangle(Vec2 a, Vec2 b, Vec2 c, double scalar = 0.0) {
    set(PrimitiveKind::triangle, {a.x, a.y, b.x, b.y, c.x, c.y, scalar});
  }
  void arc(const Arc& arc, double scalar = 0.0) {
    set(PrimitiveKind::arc,
        {arc.center.x, arc.center.y, arc.radius, arc.from.x, arc.from.y, arc.to.x, arc.to.y, scalar});
  }
  void parabola(const ParabolaArc& arc, double scalar = 0.0) {
    set(PrimitiveKind::parabola, {arc.from.x, arc.from.y, arc.control.x, arc.control.y, arc.to.x, arc.to.y, scalar});
  }

  /// The same by kind: coordinates first, then the scalar.
  void set_values(PrimitiveKind kind, const std::array<double, 8>& values);

  /// If false, a scalar that is expensive to compute is not needed and may be 0. True by default.
  bool wants_scalar() const { return wants_scalar_; }
  void set_wants_scalar(bool wanted) { wants_scalar_ = wanted; }
  bool is_set() const { return is_set_; }
  /// True if a primitive was dropped because its coordinates are not finite.
  bool is_lost() const { return is_lost_; }
  PrimitiveKind kind() const { return kind_; }
  const double* begin() const { return values_.data(); }
  const double* end() const { return values_.data() + stride_of(kind_); }
  void clear() { is_set_ = is_lost_ = false; }

 private:
  template <std::size_t N>
  void set(PrimitiveKind kind, const double (&values)[N]) {
    // One sum instead of many tests: it is finite unless a term is not (or the terms are too large to draw).
    double sum = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      values_[i] = values[i];
      sum += std::abs(values[i]) * 0x1p-8;
    }
    kind_ = kind;
    is_set_ = std::isfinite(sum);
    is_lost_ = !is_set_;
  }
  std::array<double, 8> values_{};
  PrimitiveKind kind_ = PrimitiveKind::point;
  bool is_set_ = false;
  bool is_lost_ = false;
  bool wants_scalar_ = true;
};

/// Draws the rows of one table for a layer.
class LayerPart {
 public:
  virtual ~LayerPart() = default;
  /// Emits every row.
  virtual void reset(LayerPatch& patch) = 0;
  /// Passes the primitives of all rows to `take`, in pieces, and keeps none of them. `out` names the layer. Scalars may
  /// be 0 unless they are needed.
  virtual void pour(InstancePiece out, bool needs_scalars, const std::function<void(const InstancePiece&)>& take) = 0;
  /// Emits the rows of the change set.
  virtual void update(LayerPatch& patch) = 0;
  /// Prefetches memory, because an `update` may follow soon.
  virtual void expect_update() const = 0;
  /// Number of rows whose primitive is lost, because its coordinates are not finite.
  virtual std::size_t lost() const = 0;
  /// Visits every instance; O(rows). Values are as in core/draw/primitives.h, the scalar last.
  using Visit = std::function<void(PrimitiveKind kind, const double* values, const Element& element)>;
  virtual void for_each_instance(const Visit& visit) const = 0;
};

/// A part that visits the rows of a table in turn; holds the code that is the same for all tables.
class TablePart : public LayerPart {
 public:
  ~TablePart() override;
  TablePart(const TablePart&) = delete;
  TablePart& operator=(const TablePart&) = delete;

  void reset(LayerPatch& patch) final;
  void pour(InstancePiece out, bool needs_scalars, const std::function<void(const InstancePiece&)>& take) final;
  void update(LayerPatch& patch) final;
  void expect_update() const final;
  std::size_t lost() const final;
  void for_each_instance(const Visit& visit) const final;

 protected:
  TablePart(std::vector<PrimitiveKind> kinds, ElementType element);

 private:
  class Places;
  virtual std::size_t row_count() const = 0;
  virtual RowChanges changes() const = 0;
  /// Emits the rows from `first` on, one for each instance of `out`, which are all clear.
  virtual void emit_rows(RowNumber first, std::span<Instance> out) const = 0;
  /// The same for the rows of a list, from index `from` on.
  virtual void emit_listed(std::span<const RowNumber> rows, std::size_t from, std::span<Instance> out) const = 0;

  /// Calls `take` with the instance of each row, set, lost or clear.
  template <class Take>
  void for_each_row(bool wants_scalars, Take take) const;

  std::vector<PrimitiveKind> kinds_;
  ElementType element_;
  std::unique_ptr<Places> places_;
};

/// `RowCount()` is the number of rows; `Emit(row, instance)` emits one, dead or alive.
template <class Row, class RowCount, class Emit>
class PartOf final : public TablePart {
 public:
  PartOf(std::vector<PrimitiveKind> kinds, RowCount rows, const ChangeSet<Row>& changes, Emit emit,
         ElementType element)
      : TablePart(std::move(kinds), element), rows_(rows), changes_(changes), emit_(emit) {}

 private:
  std::size_t row_count() const override { return rows_(); }
  RowChanges changes() const override { return row_numbers(changes_); }
  void emit_rows(RowNumber first, std::span<Instance> out) const override {
    for (Instance& instance : out) emit_(Row(first++), instance);
  }
  void emit_listed(std::span<const RowNumber> rows, std::size_t from, std::span<Instance> out) const override {
    for (Instance& instance : out) {
      if constexpr (requires(Row row) { emit_.expect(row); }) {
        constexpr std::size_t kAhead = 8;
        if (from + 2 * kAhead < rows.size()) emit_.expect(Row(rows[from + 2 * kAhead]));
        if (from + kAhead < rows.size()) emit_.expect_more(Row(rows[from + kAhead]));
      }
      emit_(Row(rows[from++]), instance);
    }
  }

  RowCount rows_;
  const ChangeSet<Row>& changes_;
  Emit emit_;
};

/// Creates a part of a layer over one table, whose row type is that of the change set. Each kind of primitive of a
/// layer belongs to one part. `element` identifies the rows for picking. `Emit` may have members `expect(row)` and, for
/// data that the row refers to, `expect_more(row)`: they prefetch memory a few rows ahead, because one label may change
/// thousands of rows.
template <class Row, class RowCount, class Emit>
std::unique_ptr<LayerPart> table_part(std::vector<PrimitiveKind> kinds, RowCount rows, const ChangeSet<Row>& changes,
                                      Emit emit, ElementType element = {}) {
  return std::make_unique<PartOf<Row, RowCount, Emit>>(std::move(kinds), rows, changes, emit, element);
}

struct Layer {
  LayerDescriptor descriptor;
  std::vector<const Structure*> structures;  ///< structures that the parts read
  std::vector<std::unique_ptr<LayerPart>> parts;
};

}  // namespace mes
