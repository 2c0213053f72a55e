// SPDX-License-Identifier: GPL-3.0-or-later
// The compiled part of the module `mesecina`; the rest of it is python/mesecina.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bench.h"
#include "interrupts.h"
#include "lock.h"
#include "module.h"

namespace mes_python {
namespace {

template <class Info>
py::list all_described(const std::vector<Info>& all);

py::dict described(const mesecina::ColumnInfo& column) {
  py::dict out;
  out["name"] = column.name;
  out["description"] = column.description;
  out["type"] = name_of(column.type);
  out["width"] = column.width;
  out["parts"] = column.parts;
  out["is_stored"] = column.is_stored;
  out["refers_to"] = column.refers_to;
  out["infinity"] = column.infinity;
  return out;
}

py::dict described(const mesecina::TableInfo& table) {
  py::dict out;
  out["id"] = table.id;
  out["name"] = table.name;
  out["description"] = table.description;
  out["rows_of"] = table.rows_of;
  out["columns"] = all_described(table.columns);
  return out;
}

py::dict described(const mesecina::StructureInfo& structure) {
  py::dict out;
  out["id"] = structure.id;
  out["inputs"] = structure.inputs;
  out["parameters"] = structure.parameters;
  out["tables"] = all_described(structure.tables);
  return out;
}

py::dict described(const mesecina::LayerInfo& layer) {
  py::dict out;
  out["id"] = layer.id;
  out["name"] = layer.name;
  out["description"] = layer.description;
  out["group"] = layer.group;
  py::list kinds;
  for (const mesecina::PrimitiveKind kind : layer.kinds) kinds.append(name_of(kind));
  out["kinds"] = kinds;
  out["structures"] = layer.structures;
  out["parameters"] = layer.parameters;
  out["scalar"] = layer.scalar;
  out["is_visible_at_start"] = layer.is_visible_at_start;
  out["color"] = py::make_tuple(layer.color[0], layer.color[1], layer.color[2]);
  out["opacity"] = layer.opacity;
  out["line_width"] = layer.line_width;
  out["point_size"] = layer.point_size;
  return out;
}

py::dict described(const mesecina::ParameterInfo& parameter) {
  py::dict out;
  out["id"] = parameter.id;
  out["description"] = parameter.description;
  out["unit"] = parameter.unit;
  out["low"] = parameter.low;
  out["high"] = parameter.high;
  out["default"] = parameter.default_value;
  out["is_whole"] = parameter.is_whole;
  out["is_length"] = parameter.is_length;
  out["choices"] = parameter.choices;
  return out;
}

py::dict described(const mesecina::ShapeInfo& shape) {
  py::dict out;
  out["id"] = shape.id;
  out["name"] = shape.name;
  out["description"] = shape.description;
  out["parameters"] = all_described(shape.parameters);
  py::list formulas;
  for (const mesecina::FormulaInfo& formula : shape.formulas) formulas.append(formula.id);
  out["formulas"] = formulas;
  return out;
}

py::dict described(const mesecina::EvolutionInfo& evolution) {
  py::dict out;
  out["id"] = evolution.id;
  out["name"] = evolution.name;
  out["description"] = evolution.description;
  out["moved_parameter"] = evolution.moved_parameter;
  out["is_random"] = evolution.is_random;
  out["parameters"] = all_described(evolution.parameters);
  return out;
}

py::dict described(const mesecina::FormatInfo& format) {
  py::dict out;
  out["id"] = format.id;
  out["name"] = format.name;
  out["extensions"] = format.extensions;
  out["can_read"] = format.can_read;
  out["can_write"] = format.can_write;
  return out;
}

py::tuple shape(const std::string& id, const std::vector<std::pair<std::string, double>>& parameters,
                const std::vector<std::pair<std::string, std::string>>& formulas, std::optional<std::size_t> samples,
                std::optional<double> spacing, double jitter, std::uint64_t seed) {
  const mesecina::Data data = [&] {
    const Unlocked unlocked;
    return mesecina::make_shape(mesecina::Catalogue::builtin(), id,
                                {parameters, formulas, samples, spacing, jitter, seed});
  }();
  return arrays_of(data);
}

py::dict described(const mesecina::StructureReport& report) {
  static constexpr const char* kStates[] = {"inactive", "up to date", "failed", "blocked", "unfinished"};
  py::dict out;
  out["id"] = report.id;
  out["state"] = kStates[static_cast<std::size_t>(report.state)];
  out["reason"] = report.reason;
  out["milliseconds"] = report.milliseconds;
  out["is_rebuilt"] = report.is_rebuilt;
  out["number_type"] = report.number_type;
  return out;
}

py::dict described(const mesecina::Finding& finding) {
  static constexpr const char* kLevels[] = {"note", "doubt", "wrong"};
  py::dict out;
  out["structure"] = finding.structure;
  out["level"] = kLevels[static_cast<std::size_t>(finding.level)];
  out["text"] = finding.text;
  out["count"] = finding.count;
  out["places"] = array_of(std::span<const mesecina::Point>(finding.places));
  return out;
}

template <class Info>
py::list all_described(const std::vector<Info>& all) {
  py::list out;
  for (const Info& one : all) out.append(described(one));
  return out;
}

mesecina::ReadOptions options_of(const std::string& format, bool vertices, bool degrees, const std::string& crs) {
  return {.format = format, .keeps_vertices = vertices, .projects_degrees = !degrees, .system = crs};
}

void add_catalogue(py::module_& module) {
  using mesecina::Catalogue;
  py::class_<Catalogue>(module, "Catalogue")
      .def("structures", [](const Catalogue& of) { return all_described(of.structures()); })
      .def("layers", [](const Catalogue& of) { return all_described(of.layers()); })
      .def("parameters", [](const Catalogue& of) { return all_described(of.parameters()); })
      .def("evolutions", [](const Catalogue& of) { return all_described(of.evolutions()); })
      .def("shapes", [](const Catalogue& of) { return all_described(of.shapes()); })
      .def("formats", [](const Catalogue& of) { return all_described(of.formats()); })
      .def("with_experiment", &with_python);
  module.def("builtin", &Catalogue::builtin);
  module.def("shape", &shape);
  module.def("version", [] { return mesecina::version(); });
}

void add_bench(py::module_& module) {
  py::class_<Bench>(module, "Bench")
      .def(py::init<const mesecina::Catalogue&, bool>())
      .def("open", [](Bench& of, const std::string& path, const std::string& format, bool vertices, bool degrees,
                      const std::string& crs) { return of.open(path, options_of(format, vertices, degrees, crs)); })
      .def("open_bytes",
           [](Bench& of, const py::bytes& bytes, const std::string& name, const std::string& format, bool vertices,
              bool degrees) { return of.open_bytes(bytes, name, options_of(format, vertices, degrees, {})); })
      .def("text", &Bench::text)
      .def("save", &Bench::save)
      .def("load", &Bench::load)
      .def("data", &Bench::data)
      .def("insert", &Bench::insert)
      .def("insert_balls", &Bench::insert_balls)
      .def("move", &Bench::move)
      .def("move_one", &Bench::move_one)
      .def("change_balls", &Bench::change_balls)
      .def("remove", &Bench::remove)
      .def("remove_balls", &Bench::remove_balls)
      .def("set_contours", &Bench::set_contours)
      .def("samples", &Bench::samples)
      .def("sample_ids", &Bench::sample_ids)
      .def("balls", &Bench::balls)
      .def("ball_ids", &Bench::ball_ids)
      .def("begin_step", &Bench::begin_step)
      .def("end_step", &Bench::end_step)
      .def("undo", &Bench::undo)
      .def("redo", &Bench::redo)
      .def("forget_history", &Bench::forget_history)
      .def("can_undo", &Bench::can_undo)
      .def("can_redo", &Bench::can_redo)
      .def("set", &Bench::set)
      .def("value", &Bench::value)
      .def("set_precision", &Bench::set_precision)
      .def("precision", &Bench::precision)
      .def("reset_settings", &Bench::reset_settings)
      .def("run", &Bench::run)
      .def("column", &Bench::column)
      .def("live_rows", &Bench::live_rows)
      .def("rows", &Bench::rows)
      .def("changes", &Bench::changes)
      .def("statistics", &Bench::statistics)
      .def("instances", [](Bench& of, const std::string& layer,
                           std::string_view kind) { return of.instances(layer, kind_of(kind)); })
      .def("digest", &Bench::digest)
      .def("reports", [](Bench& of) { return all_described(of.reports()); })
      .def("findings", [](Bench& of) { return all_described(of.findings()); })
      .def("light",
           [](Bench& of) {
             static constexpr const char* kLights[] = {"none", "green", "yellow", "red"};
             return kLights[static_cast<std::size_t>(of.light())];
           })
      .def_property_readonly("revision", &Bench::revision)
      .def_property_readonly("views", &Bench::views);
}

}  // namespace

mesecina::PrimitiveKind kind_of(std::string_view name) {
  for (int i = 0; i <= static_cast<int>(mesecina::PrimitiveKind::parabola); ++i)
    if (name_of(static_cast<mesecina::PrimitiveKind>(i)) == name) return static_cast<mesecina::PrimitiveKind>(i);
  throw py::value_error("there is no kind of primitive \"" + std::string(name) + "\"");
}

}  // namespace mes_python

PYBIND11_MODULE(_mesecina, module) {
  // These calls initialise static variables. Two threads doing this at once could deadlock, one of them with the
  // interpreter lock.
  (void)pybind11::dtype::of<double>();
  (void)mes_python::is_main_thread();
  mes_python::add_errors();
  mes_python::add_inputs(module);
  mes_python::add_catalogue(module);
  mes_python::add_bench(module);
}
