// SPDX-License-Identifier: GPL-3.0-or-later
// A layer: a pure function from the rows of a table to primitives, and the bookkeeping that turns change sets into
// patches.
//
// A layer file (core/layers/*.cpp) gives one function `Layer make_xyz_layer(const StructureSet&)`. The emitter looks
// at one row and fills in at most one primitive; which instance of the drawing buffer that becomes is not its
// business.
//
// Smallest use:
//     const auto emit = [&](EdgeSlot edge, Instance& out) {
//       if (crust.is_crust(edge)) emit_edge(delaunay, edge, out);
//     };
//     return make_layer({.id = "curve", .kinds = {PrimitiveKind::segment}}, {&delaunay, &crust},
//                       edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(), emit));
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <unordered_set>
#include <vector>

#include "core/base/arc.h"
#include "core/base/change_set.h"
#include "core/base/error.h"
#include "core/base/prefetch.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/patch.h"
#include "core/graph/hit.h"
#include "core/graph/structure.h"

namespace mes {

/// What an emitter fills in. Coordinates that are not finite make nothing, as such a primitive cannot be drawn; it is
/// lost.
class Instance {
 public:
  void point(Vec2 p, double scalar = 0.0) { set(PrimitiveKind::point, {p.x, p.y, scalar}); }
  void disk(Vec2 c, double r, double scalar = 0.0) { set(PrimitiveKind::disk, {c.x, c.y, r, scalar}); }
  void circle(Vec2 c, double r, double scalar = 0.0) { set(PrimitiveKind::circle, {c.x, c.y, r, scalar}); }
  void segment(Vec2 a, Vec2 b, double scalar = 0.0) { set(PrimitiveKind::segment, {a.x, a.y, b.x, b.y, scalar}); }
  /// A direction of length zero, as rounding may leave it, makes nothing.
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

  /// The same by kind, coordinates first and the scalar behind them.
  void set_values(PrimitiveKind kind, const std::array<double, 8>& values);

  /// A scalar that takes time to find is not needed, and may be 0, unless this says so. True by default.
  bool wants_scalar() const { return wants_scalar_; }
  void set_wants_scalar(bool wanted) { wants_scalar_ = wanted; }
  bool is_set() const { return is_set_; }
  /// There was something, but not with finite coordinates.
  bool is_lost() const { return is_lost_; }
  PrimitiveKind kind() const { return kind_; }
  const double* begin() const { return values_.data(); }
  const double* end() const { return values_.data() + stride_of(kind_); }
  void clear() { is_set_ = is_lost_ = false; }

 private:
  template <std::size_t N>
  void set(PrimitiveKind kind, const double (&values)[N]) {
    // One sum instead of many tests: it is finite unless a term is not (or the terms are beyond any drawing).
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

inline void Instance::set_values(PrimitiveKind kind, const std::array<double, 8>& values) {
  double sum = 0.0;
  const std::size_t size = stride_of(kind);
  for (std::size_t i = 0; i < size; ++i) sum += std::abs(values[i]) * 0x1p-8;
  values_ = values;
  kind_ = kind;
  is_set_ = std::isfinite(sum);
  is_lost_ = !is_set_;
}

/// Where the primitives of a table's rows stand in the drawing buffers of one layer.
///
/// Instances of a kind are numbered without gaps. A row that stops drawing leaves a hole, which the next newcomer
/// takes; holes left at the end are filled with the last instances, whose rows are emitted again for that.
class LayerPart {
 public:
  virtual ~LayerPart() = default;
  /// Emits every row.
  virtual void reset(LayerPatch& patch) = 0;
  /// Hands the primitive of every row out, in pieces, and keeps none of them. `out` says which layer it is. Unless
  /// scalars are needed, they may be 0.
  virtual void pour(InstancePiece out, bool needs_scalars, const std::function<void(const InstancePiece&)>& take) = 0;
  /// Emits the rows of the change set.
  virtual void update(LayerPatch& patch) = 0;
  /// An `update` may follow soon: asks for the memory that it will look at.
  virtual void expect_update() const = 0;
  /// Rows whose primitive is lost, because its coordinates are not finite.
  virtual std::size_t lost() const = 0;
  /// Shows every instance; O(rows). Values are as in core/draw/primitives.h, the scalar last.
  using Visit = std::function<void(PrimitiveKind kind, const double* values, const Element& element)>;
  virtual void for_each_instance(const Visit& visit) const = 0;
};

class InstancePlaces {
 public:
  void reset(std::size_t rows, PrimitiveKind main_kind) {
    place_.assign(rows, kNoPlace);
    for (auto& rows_of_kind : row_at_) rows_of_kind.clear();
    row_at_[index_of(main_kind)].reserve(rows);
  }
  /// Bulk emission: the row's instance is the next of its kind.
  void append(RowNumber row, const Instance& instance, LayerPatch& patch) {
    auto& rows = row_at_[index_of(instance.kind())];
    place_[row] = encode(instance.kind(), static_cast<std::uint32_t>(rows.size()));
    rows.push_back(row);
    append_to(patch[instance.kind()].data, instance);
  }
  void grow(std::size_t rows) {
    if (place_.size() < rows) place_.resize(rows, kNoPlace);
  }
  void expect(RowNumber row) const { prefetch(place_.data() + row); }
  /// The row draws nothing any more.
  void withdraw(RowNumber row) {
    const std::uint32_t place = place_[row];
    if (place == kNoPlace) return;
    const std::size_t kind = place >> kIndexBits;
    const std::uint32_t index = place & kIndexMask;
    row_at_[kind][index] = kNoRow;
    holes_[kind].push_back(index);
    place_[row] = kNoPlace;
  }
  void put(RowNumber row, const Instance& instance, LayerPatch& patch) {
    const std::size_t kind = index_of(instance.kind());
    if (place_[row] != kNoPlace && place_[row] >> kIndexBits != kind) withdraw(row);
    if (place_[row] == kNoPlace) {
      auto& rows = row_at_[kind];
      std::uint32_t index = static_cast<std::uint32_t>(rows.size());
      if (holes_[kind].empty()) {
        rows.push_back(row);
      } else {
        index = holes_[kind].back();
        holes_[kind].pop_back();
        rows[index] = row;
      }
      place_[row] = encode(instance.kind(), index);
    }
    write(place_[row] & kIndexMask, instance, patch);
  }
  /// Closes the holes of the given kinds; `emit(row, instance)` is asked for rows that move.
  template <class Emit>
  void close_holes(const std::vector<PrimitiveKind>& kinds, LayerPatch& patch, Emit emit) {
    for (const PrimitiveKind kind : kinds) {
      auto& holes = holes_[index_of(kind)];
      auto& rows = row_at_[index_of(kind)];
      const auto drop_tail = [&rows] {
        while (!rows.empty() && rows.back() == kNoRow) rows.pop_back();
      };
      while (!holes.empty()) {
        drop_tail();
        const std::uint32_t hole = holes.back();
        holes.pop_back();
        if (hole >= rows.size()) continue;
        const RowNumber row = rows.back();
        rows.pop_back();
        rows[hole] = row;
        place_[row] = encode(kind, hole);
        Instance instance;
        emit(row, instance);
        if (!instance.is_set() || instance.kind() != kind)
          throw GeometryError("a row is drawn in another way, though no change of it is named");
        write(hole, instance, patch);
      }
      drop_tail();
      KindPatch& out = patch[kind];
      out.count_changed = out.count_changed || out.count != rows.size();
      out.count = static_cast<std::uint32_t>(rows.size());
    }
  }
  std::uint32_t count(PrimitiveKind kind) const { return static_cast<std::uint32_t>(row_at_[index_of(kind)].size()); }

 private:
  static constexpr std::uint32_t kNoPlace = 0xffffffffU;
  static constexpr RowNumber kNoRow = 0xffffffffU;
  static constexpr unsigned kIndexBits = 29;
  static constexpr std::uint32_t kIndexMask = (1U << kIndexBits) - 1U;
  static_assert(kPrimitiveKinds <= std::size_t{1} << (32U - kIndexBits));
  static std::size_t index_of(PrimitiveKind kind) { return static_cast<std::size_t>(kind); }
  static std::uint32_t encode(PrimitiveKind kind, std::uint32_t index) {
    return (static_cast<std::uint32_t>(kind) << kIndexBits) | index;
  }
  static void append_to(std::vector<double>& data, const Instance& instance) {
    data.insert(data.end(), instance.begin(), instance.end());
  }
  void write(std::uint32_t index, const Instance& instance, LayerPatch& patch) {
    KindPatch& out = patch[instance.kind()];
    out.index.push_back(index);
    append_to(out.data, instance);
  }

  std::vector<std::uint32_t> place_;  // by row: kind and index
  std::array<std::vector<RowNumber>, kPrimitiveKinds> row_at_;
  std::array<std::vector<std::uint32_t>, kPrimitiveKinds> holes_;
};

/// `RowCount()` gives the number of rows, `Emit(row, instance)` looks at one, dead or alive.
template <class Row, class RowCount, class Emit>
class TablePart final : public LayerPart {
 public:
  TablePart(std::vector<PrimitiveKind> kinds, RowCount rows, const ChangeSet<Row>& changes, Emit emit,
            ElementType element)
      : kinds_(std::move(kinds)), rows_(rows), changes_(changes), emit_(emit), element_(element) {}

  void reset(LayerPatch& patch) override {
    const std::size_t rows = rows_();
    // Room for all rows as the first kind: memory that is not written costs nothing, growing step by step does.
    places_.reset(rows, kinds_.front());
    for (const PrimitiveKind kind : kinds_) {
      patch[kind].clear();
      patch[kind].reset = true;
    }
    patch[kinds_.front()].data.reserve(rows * stride_of(kinds_.front()));
    Instance instance;
    lost_.clear();
    for (RowNumber row = 0; row < rows; ++row) {
      instance.clear();
      emit_(Row(row), instance);
      if (instance.is_set()) places_.append(row, instance, patch);
      if (instance.is_lost()) lost_.insert(row);
    }
    for (const PrimitiveKind kind : kinds_) patch[kind].count = places_.count(kind);
  }

  void pour(InstancePiece out, bool needs_scalars, const std::function<void(const InstancePiece&)>& take) override {
    constexpr std::size_t kPiece = 4096;  // instances; some hundred kibibytes, which stay in the cache
    std::array<std::vector<double>, kPrimitiveKinds> pieces;
    const auto flush = [&](PrimitiveKind kind) {
      std::vector<double>& values = pieces[static_cast<std::size_t>(kind)];
      if (values.empty()) return;
      out.kind = kind;
      out.values = values;
      take(out);
      values.clear();
    };
    for (const PrimitiveKind kind : kinds_) pieces[static_cast<std::size_t>(kind)].reserve(kPiece * stride_of(kind));
    const std::size_t rows = rows_();
    Instance instance;
    instance.set_wants_scalar(needs_scalars);
    lost_.clear();
    for (RowNumber row = 0; row < rows; ++row) {
      instance.clear();
      emit_(Row(row), instance);
      if (instance.is_lost()) lost_.insert(row);
      if (!instance.is_set()) continue;
      std::vector<double>& values = pieces[static_cast<std::size_t>(instance.kind())];
      values.insert(values.end(), instance.begin(), instance.end());
      if (values.size() >= kPiece * stride_of(instance.kind())) flush(instance.kind());
    }
    for (const PrimitiveKind kind : kinds_) flush(kind);
  }

  void update(LayerPatch& patch) override {
    places_.grow(rows_());
    for (const PrimitiveKind kind : kinds_) patch[kind].count = places_.count(kind);
    for (const Row row : changes_.removed) places_.withdraw(row.index());
    if (!lost_.empty())
      for (const auto* rows : {&changes_.removed, &changes_.touched})
        for (const Row row : *rows) lost_.erase(row.index());
    Instance instance;
    constexpr std::size_t kAhead = 8;
    const std::vector<Row>& touched = changes_.touched;
    for (std::size_t i = 0; i < touched.size(); ++i) {
      const Row row = touched[i];
      if constexpr (requires { emit_.expect(row); }) {
        if (i + 2 * kAhead < touched.size()) emit_.expect(touched[i + 2 * kAhead]);
        if (i + kAhead < touched.size()) emit_.expect_more(touched[i + kAhead]);
      }
      instance.clear();
      emit_(row, instance);
      if (instance.is_lost()) lost_.insert(row.index());
      if (instance.is_set()) {
        places_.put(row.index(), instance, patch);
      } else {
        places_.withdraw(row.index());
      }
    }
    places_.close_holes(kinds_, patch, [this](RowNumber row, Instance& out) { emit_(Row(row), out); });
  }

  void expect_update() const override {
    for (const Row row : changes_.touched) places_.expect(row.index());
    for (const Row row : changes_.removed) places_.expect(row.index());
  }

  std::size_t lost() const override { return lost_.size(); }

  void for_each_instance(const Visit& visit) const override {
    const std::size_t rows = rows_();
    Instance instance;
    for (RowNumber row = 0; row < rows; ++row) {
      instance.clear();
      emit_(Row(row), instance);
      if (instance.is_set()) visit(instance.kind(), instance.begin(), {element_, row});
    }
  }

 private:
  std::vector<PrimitiveKind> kinds_;
  RowCount rows_;
  const ChangeSet<Row>& changes_;
  Emit emit_;
  ElementType element_;
  InstancePlaces places_;
  std::unordered_set<RowNumber> lost_;  // few, or none
};

/// Part of a layer over one table, whose rows are of the kind of the change set. Each kind of primitive of a layer
/// belongs to one part. `element` says what the rows are when one of them is pointed at. `Emit` may have members
/// `expect(row)` and, for what the row refers to, `expect_more(row)`: they ask for memory a few rows ahead, for a label
/// may turn thousands.
template <class Row, class RowCount, class Emit>
std::unique_ptr<LayerPart> table_part(std::vector<PrimitiveKind> kinds, RowCount rows, const ChangeSet<Row>& changes,
                                      Emit emit, ElementType element = {}) {
  return std::make_unique<TablePart<Row, RowCount, Emit>>(std::move(kinds), rows, changes, emit, element);
}

struct Layer {
  LayerDescriptor descriptor;
  std::vector<const Structure*> structures;  ///< what the parts read
  std::vector<std::unique_ptr<LayerPart>> parts;
};

}  // namespace mes
