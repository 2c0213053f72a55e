// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the content of experiments to a registry.
#include <mesecina/experiment.h>

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/color.h"
#include "core/curves/curve.h"
#include "core/evolutions/evolution.h"
#include "core/io/format_spec.h"
#include "core/library/internal/adapter.h"
#include "core/library/internal/experiment_parts.h"
#include "core/library/internal/external_layer.h"
#include "core/library/internal/external_structure.h"
#include "core/shapes/shape.h"

namespace mesecina {
inline namespace v1 {
namespace {

void check_id(std::string_view what, std::string_view id) {
  if (!mes::is_kebab_case(id))
    refuse(fmt::format("\"{}\" is no id of a {}: small letters and digits, with a hyphen between words", one_line(id),
                       what));
}

void check_new(std::string_view what, std::string_view id, bool is_known) {
  check_id(what, id);
  if (is_known) refuse(fmt::format("there is a {} {} already", what, id));
}

mes::Parameter inner(const ParameterInfo& info) {
  check_id("parameter", info.id);
  if (!(std::isfinite(info.low) && std::isfinite(info.high) && info.low < info.high &&
        info.low <= info.default_value && info.default_value <= info.high))
    refuse(fmt::format("the default of parameter {} does not lie in a range of finite numbers", info.id));
  return {.id = info.id,
          .explanation = one_line(info.description),
          .unit = info.unit,
          .low = info.low,
          .high = info.high,
          .default_value = info.default_value,
          .is_whole = info.is_whole,
          .is_of_document = true,
          .is_limit = info.is_limit,
          .is_length = info.is_length,
          .choices = info.choices};
}

std::vector<mes::Parameter> all_inner(const std::vector<ParameterInfo>& infos) {
  std::vector<mes::Parameter> out;
  for (const ParameterInfo& info : infos) out.push_back(inner(info));
  return out;
}

std::vector<mes::Parameter> known_parameters(const mes::Registry& registry, const std::vector<std::string>& ids) {
  std::vector<mes::Parameter> out;
  for (const std::string& id : ids) {
    const mes::Parameter* const known = registry.find_parameter(id);
    if (known == nullptr) refuse_unknown("parameter", id);
    out.push_back(*known);
  }
  return out;
}

void check_structure(const mes::Registry& registry, std::string_view id) {
  if (registry.find_structure(id) == nullptr) refuse_unknown("structure", id);
}

/// The structure of a table, which must exist.
std::string structure_of(const mes::StructureSet& structures, const std::string& table) {
  const std::string id = table.substr(0, table.find('/'));
  const mes::Structure* const structure = structures.find(id);
  if (structure == nullptr) refuse_unknown("structure", id);
  for (const mes::TableColumns& one : structure->table_columns())
    if (mes::table_name(id, one.name) == table) return id;
  refuse_unknown("table", table);
}

mes::PrimitiveKind inner(PrimitiveKind kind) {
  if (static_cast<std::size_t>(kind) >= mes::kAllPrimitiveKinds.size()) refuse("a kind of primitives is unknown");
  return static_cast<mes::PrimitiveKind>(kind);
}

mes::LayerDescriptor descriptor_of(const LayerSpec& spec) {
  mes::LayerDescriptor out;
  out.id = spec.id;
  out.name = one_line(spec.name.empty() ? spec.id : spec.name);
  out.tooltip = one_line(spec.description);
  out.group = mes::LayerGroup::experiments;
  out.visible_at_start = spec.is_visible_at_start;
  out.scalar = spec.scalar;
  for (const double part : spec.color)
    if (!(part >= 0.0 && part <= 1.0)) refuse(fmt::format("a part of the colour of {} is not from 0 to 1", spec.id));
  const auto byte = [](double part) { return static_cast<std::uint8_t>(part * 255.0 + 0.5); };
  out.style.color = {byte(spec.color[0]), byte(spec.color[1]), byte(spec.color[2])};
  if (!(spec.opacity >= 0.0 && spec.opacity <= 1.0))
    refuse(fmt::format("the opacity of {} is not from 0 to 1", spec.id));
  out.style.opacity = spec.opacity;
  if (!(spec.line_width >= 0.1 && spec.line_width <= 64.0))
    refuse(fmt::format("the line width of {} is not from 0.1 to 64", spec.id));
  out.style.line_width_px = spec.line_width;
  if (!(spec.point_size >= 0.5 && spec.point_size <= 64.0))
    refuse(fmt::format("the point size of {} is not from 0.5 to 64", spec.id));
  out.style.point_size_px = spec.point_size;
  out.style.color_map = spec.color_map;
  if (spec.kinds.empty()) refuse(fmt::format("layer {} draws no kind of primitives", spec.id));
  for (const PrimitiveKind kind : spec.kinds) {
    if (std::ranges::find(out.kinds, inner(kind)) != out.kinds.end())
      refuse(fmt::format("layer {} names a kind of primitives twice", spec.id));
    out.kinds.push_back(inner(kind));
  }
  return out;
}

void add_new(std::vector<std::string>& to, const std::string& id) {
  if (std::ranges::find(to, id) == to.end()) to.push_back(id);
}

mes::SampleMove inner(std::shared_ptr<const MoveSamples> move, std::vector<mes::Parameter> parameters) {
  return [move = std::move(move), parameters = std::move(parameters)](
             const mes::EvolutionState& state, const mes::EvolutionStep& step) -> mes::Expected<mes::EvolutionState> {
    std::vector<double> values;
    for (const mes::Parameter& parameter : parameters) values.push_back(step.choice.values[parameter]);
    const std::vector<Point> positions = all_outer(state.positions);
    std::vector<Contour> curves;
    for (const mes::MovingCurve::Chain& chain : step.curve.chains) curves.push_back({chain.closed, chain.points});
    const std::vector<std::uint8_t> may_move(step.curve.may_move.begin(), step.curve.may_move.end());
    mes::EvolutionState out = state;
    try {
      const std::vector<Point> moved = shielded([&] {
        return (*move)({positions, curves, may_move, step.number, step.choice.seed}, values);
      });
      if (moved.size() != positions.size())
        throw mes::GeometryError(fmt::format("it gives {} positions for {} samples", moved.size(), positions.size()));
      for (std::size_t i = 0; i < moved.size(); ++i) out.positions[i] = v1::inner(moved[i]);
    } catch (const mes::GeometryError& error) {
      return std::unexpected(mes::Error{mes::ErrorCode::cannot_compute, error.what()});
    }
    return out;
  };
}

/// A step whose call throws gets the value NaN, which is out of every range.
std::function<double(double, std::uint64_t, const mes::ParameterValues&)> inner(
    MoveParameter move, std::vector<mes::Parameter> parameters) {
  return [move = std::move(move), parameters = std::move(parameters)](double first, std::uint64_t step,
                                                                      const mes::ParameterValues& chosen) {
    std::vector<double> values;
    for (const mes::Parameter& parameter : parameters) values.push_back(chosen[parameter]);
    try {
      return shielded([&] { return move(first, step, values); });
    } catch (const mes::GeometryError&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  };
}

mes::Evolution evolution_of(const EvolutionSpec& spec, std::vector<mes::Parameter> parameters) {
  mes::Evolution out;
  out.descriptor.id = spec.id;
  out.descriptor.name = one_line(spec.name.empty() ? spec.id : spec.name);
  out.descriptor.tooltip = one_line(spec.description);
  out.descriptor.is_random = spec.is_random;
  out.descriptor.parameters = std::move(parameters);
  return out;
}

mes::Expected<mes::MadeShape> made(const MakeShape& make, const mes::ShapeArguments& arguments) {
  mes::MadeShape out;
  try {
    for (const std::vector<Point>& corners : shielded([&] { return make(arguments.numbers); })) {
      if (corners.size() < 3) throw mes::GeometryError("it gives a polygon with fewer than three corners");
      for (const Point& corner : corners)
        if (!std::isfinite(corner.x) || !std::isfinite(corner.y))
          throw mes::GeometryError("it gives a corner that is no number");
      mes::PlaneCurve curve(v1::inner(corners.front()));
      for (const Point& corner : std::span(corners).subspan(1)) curve.line_to(v1::inner(corner));
      curve.close();
      out.curves.curves.push_back(std::move(curve));
    }
  } catch (const mes::GeometryError& error) {
    return std::unexpected(mes::Error{mes::ErrorCode::bad_input, error.what()});
  }
  if (out.curves.curves.empty()) return std::unexpected(mes::Error{mes::ErrorCode::bad_input, "it gives no polygon"});
  return out;
}

/// The result of an experiment's reader, if it is valid.
mes::Expected<mes::LoadedFile> read_by(const ReadBytes& read, std::string_view bytes, const std::string& name) {
  const auto failure = [&name](std::string text, std::uint64_t line = 0, std::uint64_t column = 0) {
    return std::unexpected(mes::Error{mes::ErrorCode::bad_input, std::move(text), name, line, column});
  };
  try {
    const Data data = read(bytes);
    for (const Contour& contour : data.contours)
      for (const std::uint32_t point : contour.points)
        if (point >= data.samples.size()) return failure("a contour names a sample that there is not");
    mes::LoadedFile out;
    out.data = v1::inner(data);
    return out;
  } catch (const Error& error) {
    return failure(one_line(error.text()), error.line(), error.column());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return failure(one_line(error.what()));
  } catch (...) {
    return failure("its reader threw something that is no exception");
  }
}

mes::Match match_by(const RecognizeBytes& recognize, std::string_view bytes) {
  try {
    return recognize && recognize(bytes) ? mes::Match::surely : mes::Match::no;
  } catch (...) {
    return mes::Match::no;
  }
}

}  // namespace

Structure::~Structure() = default;
bool Structure::update(const Inputs& /*inputs*/) {
  return false;
}
std::vector<OwnTable> Structure::tables() const {
  return {};
}
std::vector<Statistic> Structure::statistics() const {
  return {};
}
std::vector<Finding> Structure::findings() const {
  return {};
}

Drawer::~Drawer() = default;

void Experiment::add_parameter(const ParameterInfo& parameter) {
  guarded([&] {
    check_new("parameter", parameter.id, impl_.registry.find_parameter(parameter.id) != nullptr);
    impl_.registry.add_parameter(inner(parameter));
    impl_.added.parameters.push_back(parameter.id);
  });
}

void Experiment::add_structure(const StructureSpec& spec, std::function<std::unique_ptr<Structure>()> make) {
  guarded([&] {
    check_new("structure", spec.id, impl_.registry.find_structure(spec.id) != nullptr);
    for (const std::string& input : spec.inputs) check_structure(impl_.registry, input);
    if (spec.inputs.empty()) refuse(fmt::format("structure {} has no input", spec.id));
    if (!make) refuse(fmt::format("nothing makes structure {}", spec.id));
    auto inside = std::make_shared<const ExternalStructureSpec>(ExternalStructureSpec{
        spec.id, spec.inputs, known_parameters(impl_.registry, spec.parameters), std::move(make)});
    try {
      impl_.registry.add_structure(
          [inside](const mes::StructureSet& set) { return std::make_unique<ExternalStructure>(inside, set); });
    } catch (const mes::GeometryError& error) {
      refuse(fmt::format("structure {}: {}", spec.id, error.what()));
    }
    impl_.added.structures.push_back(spec.id);
  });
}

void Experiment::add_layer(const LayerSpec& spec, MakeDrawer make) {
  guarded([&] {
    check_new("layer", spec.id, impl_.registry.find_layer(spec.id) != mes::kNoLayer);
    if (!make) refuse(fmt::format("nothing draws layer {}", spec.id));
    ExternalLayerSpec inside{.descriptor = descriptor_of(spec),
                             .rows = spec.rows,
                             .follows = spec.follows,
                             .structures = {},
                             .parameters = known_parameters(impl_.registry, spec.parameters),
                             .make = std::move(make)};
    const mes::StructureSet structures = impl_.registry.make_structures();
    add_new(inside.structures, structure_of(structures, spec.rows));
    for (const std::string& table : spec.follows) add_new(inside.structures, structure_of(structures, table));
    for (const std::string& id : spec.structures) {
      check_structure(impl_.registry, id);
      add_new(inside.structures, id);
    }
    inside.descriptor.parameters = spec.parameters;
    const auto shared = std::make_shared<const ExternalLayerSpec>(std::move(inside));
    impl_.registry.add_layer([shared](const mes::StructureSet& set) { return make_external_layer(shared, set); });
    impl_.added.layers.push_back(spec.id);
  });
}

void Experiment::add_evolution(const EvolutionSpec& spec, MoveSamples move) {
  guarded([&] {
    check_new("evolution", spec.id, impl_.registry.evolutions().find(spec.id) != nullptr);
    if (!move) refuse(fmt::format("nothing moves the samples of evolution {}", spec.id));
    if (!spec.moved_parameter.empty())
      refuse(fmt::format("evolution {} names a parameter, but moves samples", spec.id));
    std::vector<mes::Parameter> parameters = all_inner(spec.parameters);
    auto evolution = std::make_shared<mes::Evolution>(evolution_of(spec, parameters));
    evolution->move = inner(std::make_shared<const MoveSamples>(std::move(move)), std::move(parameters));
    impl_.registry.evolutions().add(spec.id, std::move(evolution));
    impl_.added.evolutions.push_back(spec.id);
  });
}

void Experiment::add_evolution(const EvolutionSpec& spec, MoveParameter move) {
  guarded([&] {
    check_new("evolution", spec.id, impl_.registry.evolutions().find(spec.id) != nullptr);
    if (!move) refuse(fmt::format("nothing moves the parameter of evolution {}", spec.id));
    const mes::Parameter* const moved = impl_.registry.find_parameter(spec.moved_parameter);
    if (moved == nullptr) refuse_unknown("parameter", spec.moved_parameter);
    std::vector<mes::Parameter> parameters = all_inner(spec.parameters);
    auto evolution = std::make_shared<mes::Evolution>(evolution_of(spec, parameters));
    evolution->descriptor.moves = "what " + moved->id + " changes";
    evolution->move = mes::ParameterMove{*moved, inner(std::move(move), std::move(parameters))};
    impl_.registry.evolutions().add(spec.id, std::move(evolution));
    impl_.added.evolutions.push_back(spec.id);
  });
}

void Experiment::add_shape(const ShapeSpec& spec, MakeShape make) {
  guarded([&] {
    check_new("shape", spec.id, impl_.registry.shapes().find(spec.id) != nullptr);
    if (!make) refuse(fmt::format("nothing makes shape {}", spec.id));
    auto shape = std::make_shared<mes::ShapeDescriptor>();
    shape->id = spec.id;
    shape->name = one_line(spec.name.empty() ? spec.id : spec.name);
    shape->explanation = one_line(spec.description);
    shape->parameters = all_inner(spec.parameters);
    shape->make = [make = std::move(make)](const mes::ShapeArguments& arguments) { return made(make, arguments); };
    impl_.registry.shapes().add(spec.id, std::move(shape));
    impl_.added.shapes.push_back(spec.id);
  });
}

void Experiment::add_format(const FormatSpec& spec, ReadBytes read, RecognizeBytes recognize) {
  guarded([&] {
    check_new("format", spec.id, impl_.registry.formats().find(spec.id) != nullptr);
    if (!read) refuse(fmt::format("nothing reads format {}", spec.id));
    for (const std::string& extension : spec.extensions)
      if (extension.size() < 2 || extension.front() != '.')
        refuse(fmt::format("an extension of format {} does not begin with a dot", spec.id));
    auto format = std::make_shared<mes::Format>();
    format->descriptor.id = spec.id;
    format->descriptor.name = one_line(spec.name.empty() ? spec.id : spec.name);
    format->descriptor.extensions = spec.extensions;
    format->descriptor.can_read = true;
    format->may_look_foreign = static_cast<bool>(recognize);
    format->match = [recognize = std::move(recognize)](std::string_view bytes) { return match_by(recognize, bytes); };
    format->read = [read = std::move(read)](std::string_view bytes, const std::string& name, mes::ReadJob& /*job*/) {
      return read_by(read, bytes, name);
    };
    impl_.registry.formats().add(spec.id, std::move(format));
    impl_.added.formats.push_back(spec.id);
  });
}

Catalogue with_experiment(const Catalogue& catalogue, const std::function<void(Experiment&)>& add) {
  if (!add) refuse("an experiment without a function adds nothing");
  auto registry = guarded([&] { return std::make_shared<mes::Registry>(*CatalogueAccess::registry(catalogue)); });
  Experiment::Impl impl{*registry};
  Experiment experiment(impl);
  add(experiment);
  return guarded([&] { return CatalogueAccess::make(std::move(registry)); });
}

Catalogue load_experiment(const Catalogue& catalogue, const std::string& shared_library) {
  return guarded([&] {
    const mes::ExperimentLibrary library = taken(mes::ExperimentLibrary::load(shared_library));
    auto registry = std::make_shared<mes::Registry>(*CatalogueAccess::registry(catalogue));
    taken(library.add_to(*registry));
    return CatalogueAccess::make(std::move(registry));
  });
}

}  // namespace v1
}  // namespace mesecina
