// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesecina/catalogue.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/builtins/builtins.h"
#include "core/draw/layer_descriptor.h"
#include "core/evolutions/evolution.h"
#include "core/graph/structure.h"
#include "core/io/format_spec.h"
#include "core/kernel/precision.h"
#include "core/library/internal/adapter.h"
#include "core/library/internal/table_access.h"
#include "core/shapes/shape.h"

namespace mesecina {
inline namespace v1 {

struct Catalogue::Impl {
  std::shared_ptr<const mes::Registry> registry;
};

namespace {

ParameterInfo info_of(const mes::Parameter& parameter) {
  return {.id = parameter.id,
          .description = parameter.explanation,
          .unit = parameter.unit,
          .low = parameter.low,
          .high = parameter.high,
          .default_value = parameter.default_value,
          .is_whole = parameter.is_whole,
          .is_limit = parameter.is_limit,
          .is_length = parameter.is_length,
          .choices = parameter.choices};
}

template <class Parameters>
std::vector<ParameterInfo> infos_of(const Parameters& parameters) {
  std::vector<ParameterInfo> out;
  out.reserve(parameters.size());
  for (const mes::Parameter& parameter : parameters) out.push_back(info_of(parameter));
  return out;
}

LayerInfo info_of(const mes::LayerDescriptor& layer) {
  LayerInfo out{.id = std::string(layer.id),
                .name = std::string(layer.name),
                .description = std::string(layer.tooltip),
                .group = std::string(mes::title_of(layer.group)),
                .structures = all_texts(layer.structures),
                .parameters = layer.parameters,
                .scalar = std::string(layer.scalar),
                .is_visible_at_start = layer.visible_at_start,
                .follows_settings = layer.follows_settings,
                .color = {layer.style.color.r / 255.0, layer.style.color.g / 255.0, layer.style.color.b / 255.0},
                .opacity = layer.style.opacity,
                .line_width = layer.style.line_width_px,
                .point_size = layer.style.point_size_px};
  for (const mes::PrimitiveKind kind : layer.kinds) out.kinds.push_back(static_cast<PrimitiveKind>(kind));
  return out;
}

EvolutionInfo info_of(const mes::Evolution& evolution) {
  const mes::ParameterMove* const move = evolution.moved_parameter();
  return {.id = evolution.descriptor.id,
          .name = evolution.descriptor.name,
          .description = evolution.descriptor.tooltip,
          .moved_parameter = move != nullptr ? move->parameter.id : std::string(),
          .is_random = evolution.descriptor.is_random,
          .parameters = infos_of(mes::parameters_of(evolution))};
}

ShapeInfo info_of(const mes::ShapeDescriptor& shape) {
  ShapeInfo out{.id = shape.id,
                .name = shape.name,
                .description = shape.explanation,
                .parameters = infos_of(shape.parameters),
                .points = shape.points};
  for (const mes::FormulaParameter& formula : shape.formulas)
    out.formulas.push_back({formula.id, formula.explanation, formula.default_text});
  return out;
}

}  // namespace

// Kinds are converted by numeric value.
static_assert([] {
  for (const mes::PrimitiveKind kind : mes::kAllPrimitiveKinds) {
    const auto same = static_cast<PrimitiveKind>(kind);
    if (name_of(same) != mes::name_of(kind) || stride_of(same) != mes::stride_of(kind)) return false;
  }
  return true;
}());

const std::shared_ptr<const mes::Registry>& CatalogueAccess::registry(const Catalogue& catalogue) {
  return catalogue.impl_->registry;
}

Catalogue CatalogueAccess::make(std::shared_ptr<const mes::Registry> registry) {
  return Catalogue(std::make_shared<const Catalogue::Impl>(Catalogue::Impl{std::move(registry)}));
}

Catalogue Catalogue::builtin() {
  // The program's registry lives as long as the program.
  return guarded([] {
    return CatalogueAccess::make(std::shared_ptr<const mes::Registry>(std::shared_ptr<void>(), &mes::builtins()));
  });
}

Catalogue::Catalogue(std::shared_ptr<const Impl> impl) noexcept : impl_(std::move(impl)) {}
Catalogue::~Catalogue() = default;
Catalogue::Catalogue(const Catalogue&) noexcept = default;
Catalogue& Catalogue::operator=(const Catalogue&) noexcept = default;

std::vector<StructureInfo> Catalogue::structures() const {
  return guarded([&] {
    std::vector<StructureInfo> out;
    const mes::StructureSet structures = impl_->registry->make_structures();
    for (const auto& structure : structures.all()) {
      StructureInfo& info = out.emplace_back();
      info.id = structure->id();
      const mes::StructureSpec& spec = *impl_->registry->find_structure(structure->id());
      info.inputs = spec.inputs;
      info.parameters = spec.parameters;
      for (const mes::TableColumns& table : structure->table_columns())
        info.tables.push_back(v1::info_of(structure->id(), table));
    }
    return out;
  });
}

std::vector<LayerInfo> Catalogue::layers() const {
  return guarded([&] {
    std::vector<LayerInfo> out;
    for (const mes::LayerDescriptor& layer : impl_->registry->layers())
      if (!layer.is_removed) out.push_back(info_of(layer));
    return out;
  });
}

std::vector<ParameterInfo> Catalogue::parameters() const {
  return guarded([&] { return infos_of(impl_->registry->parameters()); });
}

std::vector<EvolutionInfo> Catalogue::evolutions() const {
  return guarded([&] {
    std::vector<EvolutionInfo> out;
    for (const auto& evolution : impl_->registry->evolutions().all()) out.push_back(info_of(*evolution));
    return out;
  });
}

std::vector<ShapeInfo> Catalogue::shapes() const {
  return guarded([&] {
    std::vector<ShapeInfo> out;
    for (const auto& shape : impl_->registry->shapes().all()) out.push_back(info_of(*shape));
    return out;
  });
}

std::vector<FormatInfo> Catalogue::formats() const {
  return guarded([&] {
    constexpr std::array<std::string_view, 3> kWritten{"poff", "wpoff", "session"};
    std::vector<FormatInfo> out;
    for (const auto& each : impl_->registry->formats().all()) {
      const mes::FormatDescriptor& format = each->descriptor;
      out.push_back({.id = std::string(format.id),
                     .name = std::string(format.name),
                     .extensions = all_texts(format.extensions),
                     .can_read = format.can_read,
                     .can_write = std::ranges::find(kWritten, format.id) != kWritten.end()});
    }
    return out;
  });
}

std::vector<PrecisionInfo> Catalogue::precisions() {
  return guarded([] {
    std::vector<PrecisionInfo> out;
    for (const mes::PrecisionDescriptor& precision : mes::kPrecisionDescriptors)
      out.push_back({.id = std::string(precision.id),
                     .name = std::string(precision.name),
                     .description = std::string(precision.explanation)});
    return out;
  });
}

}  // namespace v1
}  // namespace mesecina
