// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/internal/external_layer.h"

#include <algorithm>
#include <utility>

#include "core/library/internal/external_structure.h"

namespace mesecina {
inline namespace v1 {
namespace {

/// A row of the table that a layer draws.
using DrawnRow = mes::Slot<struct DrawnRowTag>;

/// Draws the rows of one table by the function that the experiment prepared.
///
/// Guarantees: an experiment that omits changes draws outdated things, or fails, but rows beyond the end of the
/// table are never written.
class ExternalPart final : public mes::LayerPart {
 public:
  ExternalPart(std::shared_ptr<const ExternalLayerSpec> spec, const mes::StructureSet& set)
      : spec_(std::move(spec)), kinds_(spec_->descriptor.kinds) {
    for (const mes::Structure* input : inputs_in(set, spec_->structures, !spec_->parameters.empty()))
      read_.structures.push_back(input);
    if (!spec_->parameters.empty()) read_.settings = &set.get<mes::SettingsSource>();
    read_.parameters = spec_->parameters;
    part_ = mes::table_part(
        kinds_, [this] { return table_ == nullptr ? std::size_t{0} : table_->rows; }, changes_,
        [this](DrawnRow row, mes::Instance& out) { emit(row.index(), out); });
  }

  void reset(mes::LayerPatch& patch) override {
    prepare();
    part_->reset(patch);
    release();
  }
  void pour(mes::InstancePiece out, bool needs_scalars,
            const std::function<void(const mes::InstancePiece&)>& take) override {
    prepare();
    part_->pour(out, needs_scalars, take);
    release();
  }
  void update(mes::LayerPatch& patch) override {
    const std::size_t rows_before = rows_;
    prepare();
    if (table_->rows >= rows_before && take_changes(rows_before))
      part_->update(patch);
    else
      part_->reset(patch);
    release();
  }
  void expect_update() const override {}
  std::size_t lost() const override { return part_->lost(); }
  void for_each_instance(const Visit& visit) const override {
    // The visible state of the layer does not change.
    auto& self = const_cast<ExternalPart&>(*this);
    try {
      self.prepare();
      const mes::ElementKind kind = table_->kind;
      part_->for_each_instance([&](mes::PrimitiveKind what, const double* values, const mes::Element& element) {
        visit(what, values, {{kind, nullptr}, element.row});
      });
    } catch (const std::exception&) {
      // An element that cannot be drawn cannot be picked.
    }
    self.release();
  }

 private:
  void prepare() {
    read_.begin(nullptr);
    inputs_ = std::make_unique<Inputs>(read_);
    drawer_ = shielded([&] { return spec_->make(*inputs_); });
    if (!drawer_) throw mes::GeometryError("it makes no drawing");
    table_ = shielded([&] { return &read_.find(spec_->rows); });
    rows_ = table_->rows;
  }
  void release() {
    drawer_.reset();
    inputs_.reset();
    table_ = nullptr;
    read_.end();
  }

  /// Returns false if the changed rows are unknown.
  bool take_changes(std::size_t rows_before) {
    changes_.clear();
    std::vector<const mes::TableColumns*> followed{table_};
    for (const std::string& id : spec_->follows) followed.push_back(shielded([&] { return &read_.find(id); }));
    for (const mes::Structure* structure : read_.structures) {
      const bool is_followed =
          owns(spec_->rows, *structure) ||
          std::ranges::any_of(spec_->follows, [&](const std::string& id) { return owns(id, *structure); });
      if (!is_followed && structure->touched() != 0) return false;
    }
    marks_.begin(std::max(rows_before, rows_));
    for (const mes::TableColumns* table : followed) {
      if (!table->changes) return false;
      for (const mes::RowNumber row : table->changes->removed)
        if (row < rows_ && marks_.insert(DrawnRow(row)))
          (table_->is_alive(row) ? changes_.touched : changes_.removed).emplace_back(row);
      for (const mes::RowNumber row : table->changes->touched)
        if (row < rows_ && marks_.insert(DrawnRow(row)))
          (table_->is_alive(row) ? changes_.touched : changes_.removed).emplace_back(row);
    }
    return true;
  }
  static bool owns(std::string_view table, const mes::Structure& structure) {
    return table.substr(0, table.find('/')) == structure.id();
  }

  void emit(mes::RowNumber row, mes::Instance& out) {
    if (!table_->is_alive(row)) return;
    drawn_.clear();
    shielded([&] { drawer_->draw(row, drawn_); });
    if (!drawn_.is_set()) return;
    const auto kind = static_cast<mes::PrimitiveKind>(drawn_.kind());
    if (std::ranges::find(kinds_, kind) == kinds_.end())
      throw mes::GeometryError("it draws a " + std::string(name_of(drawn_.kind())) +
                               ", which is not among its kinds");
    out.set_values(kind, drawn_.values());
  }

  std::shared_ptr<const ExternalLayerSpec> spec_;
  std::vector<mes::PrimitiveKind> kinds_;
  Inputs::Impl read_;
  std::unique_ptr<Inputs> inputs_;
  std::unique_ptr<Drawer> drawer_;
  Drawn drawn_;
  const mes::TableColumns* table_ = nullptr;  // valid while it draws
  std::size_t rows_ = 0;                      // row count of the table at the last drawing
  mes::ChangeSet<DrawnRow> changes_;
  mes::SlotMarks<DrawnRow> marks_;
  std::unique_ptr<mes::LayerPart> part_;  // refers to the members above
};

}  // namespace

mes::Layer make_external_layer(const std::shared_ptr<const ExternalLayerSpec>& spec, const mes::StructureSet& set) {
  mes::Layer layer;
  layer.descriptor = spec->descriptor;
  for (const mes::Structure* structure : inputs_in(set, spec->structures, !spec->parameters.empty())) {
    layer.structures.push_back(structure);
    layer.descriptor.structures.emplace_back(structure->id());
  }
  layer.parts.push_back(std::make_unique<ExternalPart>(spec, set));
  return layer;
}

}  // namespace v1
}  // namespace mesecina
