// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/layer.h"

#include <algorithm>
#include <unordered_set>

#include "core/base/error.h"
#include "core/base/jobs/prefetch.h"

namespace mes {

namespace {

/// Rows that are emitted together: their instances stay in the cache.
constexpr std::size_t kBlock = 16;

}  // namespace

void Instance::set_values(PrimitiveKind kind, const std::array<double, 8>& values) {
  double sum = 0.0;
  const std::size_t size = stride_of(kind);
  for (std::size_t i = 0; i < size; ++i) sum += std::abs(values[i]) * 0x1p-8;
  values_ = values;
  kind_ = kind;
  is_set_ = std::isfinite(sum);
  is_lost_ = !is_set_;
}

/// Maintains the indices of a table's primitives in the drawing buffers of one layer.
///
/// Instances of a kind are numbered without gaps. A row that stops drawing leaves a hole, which the next new instance
/// fills; remaining holes are filled with the last instances, whose rows are emitted again for that.
class TablePart::Places {
 public:
  void reset(std::size_t rows, PrimitiveKind main_kind) {
    lost.clear();
    place_.assign(rows, kNoPlace);
    for (auto& rows_of_kind : row_at_) rows_of_kind.clear();
    row_at_[index_of(main_kind)].reserve(rows);
  }
  /// Bulk emission: the row gets the next instance of its kind.
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
  /// Removes the instance of the row.
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
  /// Closes the holes of the given kinds; calls `emit(row, instance)` for rows that move.
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

  std::unordered_set<RowNumber> lost;  ///< few, or none

 private:
  static constexpr std::uint32_t kNoPlace = 0xffffffffU;
  static constexpr unsigned kIndexBits = 28;
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

  std::vector<std::uint32_t> place_;  // for each row: kind and index
  std::array<std::vector<RowNumber>, kPrimitiveKinds> row_at_;
  std::array<std::vector<std::uint32_t>, kPrimitiveKinds> holes_;
};

TablePart::TablePart(std::vector<PrimitiveKind> kinds, ElementType element)
    : kinds_(std::move(kinds)), element_(element), places_(std::make_unique<Places>()) {}

TablePart::~TablePart() = default;

template <class Take>
void TablePart::for_each_row(bool wants_scalars, Take take) const {
  const std::size_t rows = row_count();
  std::array<Instance, kBlock> block;
  for (Instance& instance : block) instance.set_wants_scalar(wants_scalars);
  for (std::size_t first = 0; first < rows; first += kBlock) {
    const std::span<Instance> out(block.data(), std::min(kBlock, rows - first));
    for (Instance& instance : out) instance.clear();
    emit_rows(static_cast<RowNumber>(first), out);
    for (std::size_t i = 0; i < out.size(); ++i) take(static_cast<RowNumber>(first + i), out[i]);
  }
}

void TablePart::reset(LayerPatch& patch) {
  const std::size_t rows = row_count();
  // Reserves room for all rows as the first kind: unwritten memory costs nothing, but growth step by step does.
  places_->reset(rows, kinds_.front());
  for (const PrimitiveKind kind : kinds_) {
    patch[kind].clear();
    patch[kind].reset = true;
  }
  patch[kinds_.front()].data.reserve(rows * stride_of(kinds_.front()));
  for_each_row(true, [&](RowNumber row, const Instance& instance) {
    if (instance.is_set()) places_->append(row, instance, patch);
    if (instance.is_lost()) places_->lost.insert(row);
  });
  for (const PrimitiveKind kind : kinds_) patch[kind].count = places_->count(kind);
}

void TablePart::pour(InstancePiece out, bool needs_scalars, const std::function<void(const InstancePiece&)>& take) {
  constexpr std::size_t kPiece = 4096;  // instances; some hundred kibibytes, which fit in the cache
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
  places_->lost.clear();
  for_each_row(needs_scalars, [&](RowNumber row, const Instance& instance) {
    if (instance.is_lost()) places_->lost.insert(row);
    if (!instance.is_set()) return;
    std::vector<double>& values = pieces[static_cast<std::size_t>(instance.kind())];
    values.insert(values.end(), instance.begin(), instance.end());
    if (values.size() >= kPiece * stride_of(instance.kind())) flush(instance.kind());
  });
  for (const PrimitiveKind kind : kinds_) flush(kind);
}

void TablePart::update(LayerPatch& patch) {
  Places& places = *places_;
  const RowChanges changed = changes();
  places.grow(row_count());
  for (const PrimitiveKind kind : kinds_) patch[kind].count = places.count(kind);
  for (const RowNumber row : changed.removed) places.withdraw(row);
  if (!places.lost.empty())
    for (const auto& rows : {changed.removed, changed.touched})
      for (const RowNumber row : rows) places.lost.erase(row);
  std::array<Instance, kBlock> block;
  for (std::size_t from = 0; from < changed.touched.size(); from += kBlock) {
    const std::span<Instance> out(block.data(), std::min(kBlock, changed.touched.size() - from));
    for (Instance& instance : out) instance.clear();
    emit_listed(changed.touched, from, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const RowNumber row = changed.touched[from + i];
      if (out[i].is_lost()) places.lost.insert(row);
      if (out[i].is_set()) {
        places.put(row, out[i], patch);
      } else {
        places.withdraw(row);
      }
    }
  }
  places.close_holes(kinds_, patch, [this](RowNumber row, Instance& out) { emit_rows(row, {&out, 1}); });
}

void TablePart::expect_update() const {
  const RowChanges changed = changes();
  for (const RowNumber row : changed.touched) places_->expect(row);
  for (const RowNumber row : changed.removed) places_->expect(row);
}

std::size_t TablePart::lost() const {
  return places_->lost.size();
}

void TablePart::for_each_instance(const Visit& visit) const {
  for_each_row(true, [&](RowNumber row, const Instance& instance) {
    if (instance.is_set()) visit(instance.kind(), instance.begin(), {element_, row});
  });
}

}  // namespace mes
