// SPDX-License-Identifier: GPL-3.0-or-later
// Structures and layers whose functions are Python functions over arrays.
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>
#include <variant>

#include <mesecina/experiment.h>

#include "lock.h"
#include "module.h"

namespace mes_python {
namespace {

/// A Python function that threads without the interpreter lock may copy, call and destroy.
class Function {
 public:
  explicit Function(py::object function)
      : function_(new py::object(std::move(function)), [](py::object* of) {
          if (!Py_IsInitialized()) return;  // the interpreter is gone and must not be touched
          const Locked locked;
          delete of;
        }) {}
  /// The caller holds the lock.
  template <class... Arguments>
  py::object operator()(Arguments&&... arguments) const {
    const py::tuple all = py::make_tuple(std::forward<Arguments>(arguments)...);
    PyObject* const out = may_take_lock([&] { return PyObject_CallObject(function_->ptr(), all.ptr()); });
    if (out == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(out);
  }

 private:
  std::shared_ptr<py::object> function_;
};

/// The inputs of a Python function; they can be read during its call.
class PyInputs {
 public:
  explicit PyInputs(const mesecina::Inputs& inputs) : inputs_(&inputs) {}
  void close() { inputs_ = nullptr; }

  /// A copy in which dead rows are 0, so that they can be used as indices.
  py::array column(const std::string& id, const std::string& name) const {
    const mesecina::Table table = now().table(id);
    py::array out = copy_of(table.column(name));
    const std::size_t rows = table.rows();
    if (rows == 0) return out;
    const auto size = static_cast<std::size_t>(out.nbytes()) / rows;
    auto* const values = static_cast<std::byte*>(out.mutable_data());
    for (std::size_t row = 0; row < rows; ++row)
      if (!table.is_alive(static_cast<mesecina::Row>(row))) std::memset(values + row * size, 0, size);
    return out;
  }
  Numbers live_rows(const std::string& table) const {
    return array_of(std::span<const std::uint32_t>(now().live_rows(table)));
  }
  double parameter(const std::string& id) const { return now().parameter(id); }

 private:
  const mesecina::Inputs& now() const {
    if (inputs_ == nullptr) throw std::runtime_error("inputs can be read while the function is at work, not later");
    return *inputs_;
  }
  const mesecina::Inputs* inputs_;
};

/// Calls `work` with the interpreter lock, and converts Python exceptions to one that threads without it may hold.
template <class Work>
void locked(Work work) {
  const Locked lock;
  std::string text;
  try {
    return work();
  } catch (const py::error_already_set& error) {
    // Ctrl-C stops the whole run; this is not a failure of the structure.
    if (error.matches(PyExc_KeyboardInterrupt)) throw mesecina::Error(mesecina::ErrorCode::cancelled, "stopped");
    // The traceback gives the line of the exception.
    text = py::module_::import("mesecina._experiments")
               .attr("described")(error.value(), error.trace())
               .cast<std::string>();
  } catch (const py::cast_error& error) {
    text = error.what();
  }
  throw std::runtime_error(text);
}

/// Calls a Python function with inputs.
template <class Use>
void call(const Function& function, const mesecina::Inputs& inputs, Use use) {
  locked([&] {
    const auto shown = std::make_shared<PyInputs>(inputs);
    struct Close {
      PyInputs& of;
      ~Close() { of.close(); }
    };
    const py::object out = [&] {
      const Close close{*shown};
      return function(shown);
    }();
    use(out);
  });
}

using Values =
    std::variant<std::vector<double>, std::vector<mesecina::Point>, std::vector<std::array<double, 3>>,
                 std::vector<std::uint32_t>, std::vector<std::array<std::uint32_t, 2>>,
                 std::vector<std::array<std::uint32_t, 3>>, std::vector<std::uint8_t>, std::vector<std::int8_t>>;

Values values_for(const std::string& type, unsigned width) {
  if (type == "float64" && width == 1) return std::vector<double>();
  if (type == "float64" && width == 2) return std::vector<mesecina::Point>();
  if (type == "float64" && width == 3) return std::vector<std::array<double, 3>>();
  if (type == "uint32" && width == 1) return std::vector<std::uint32_t>();
  if (type == "uint32" && width == 2) return std::vector<std::array<std::uint32_t, 2>>();
  if (type == "uint32" && width == 3) return std::vector<std::array<std::uint32_t, 3>>();
  if ((type == "bool" || type == "uint8") && width == 1) return std::vector<std::uint8_t>();
  if (type == "int8" && width == 1) return std::vector<std::int8_t>();
  throw py::type_error("a column has 1 to 3 float64 or uint32, or one bool, uint8 or int8 in a row");
}

struct ColumnPlan {
  std::string name;
  std::string description;
  std::string type;
  unsigned width;
};
struct TablePlan {
  std::string name;
  std::string description;
  std::string rows_of;
  std::vector<ColumnPlan> columns;
  bool has_alive;
};

class PyStructure final : public mesecina::Structure {
 public:
  PyStructure(Function function, std::shared_ptr<const std::vector<TablePlan>> plan)
      : function_(std::move(function)), plan_(std::move(plan)) {
    for (const TablePlan& table : *plan_) {
      Storage& storage = storage_.emplace_back();
      for (const ColumnPlan& column : table.columns) storage.columns.push_back(values_for(column.type, column.width));
    }
  }

  void rebuild(const mesecina::Inputs& inputs) override {
    call(function_, inputs, [this, &inputs](const py::object& out) {
      const auto parts = out.cast<py::tuple>();
      const auto tables = parts[0].cast<py::list>();
      for (std::size_t i = 0; i < storage_.size(); ++i) {
        const auto table = tables[i].cast<py::tuple>();
        const auto columns = table[0].cast<py::list>();
        for (std::size_t j = 0; j < storage_[i].columns.size(); ++j)
          std::visit([&](auto& to) { take(columns[j].cast<py::array>(), to); }, storage_[i].columns[j]);
        if ((*plan_)[i].has_alive) take(table[1].cast<py::array>(), storage_[i].alive);
        check_rows((*plan_)[i], columns, inputs);
      }
      statistics_.clear();
      for (const auto& [key, value] : parts[1].cast<py::dict>())
        statistics_.push_back({key.cast<std::string>(), value.cast<mesecina::StatisticValue>()});
    });
  }

  std::vector<mesecina::OwnTable> tables() const override {
    std::vector<mesecina::OwnTable> out;
    for (std::size_t i = 0; i < storage_.size(); ++i) {
      const TablePlan& plan = (*plan_)[i];
      mesecina::OwnTable& table = out.emplace_back(plan.name, plan.description);
      if (!plan.rows_of.empty()) table.rows_of(plan.rows_of);
      if (plan.has_alive) table.alive(storage_[i].alive);
      for (std::size_t j = 0; j < plan.columns.size(); ++j) {
        const ColumnPlan& column = plan.columns[j];
        if (column.type == "bool")
          table.flag(column.name, column.description, std::get<std::vector<std::uint8_t>>(storage_[i].columns[j]));
        else
          std::visit([&](const auto& values) { table.column(column.name, column.description, values); },
                     storage_[i].columns[j]);
      }
    }
    return out;
  }

  std::vector<mesecina::Statistic> statistics() const override { return statistics_; }

 private:
  struct Storage {
    std::vector<Values> columns;
    std::vector<std::uint8_t> alive;
  };
  // A table over rows of another table must have as many rows.
  static void check_rows(const TablePlan& plan, const py::list& columns, const mesecina::Inputs& inputs) {
    if (plan.rows_of.empty() || columns.empty()) return;
    const std::size_t own = py::len(columns[0]);
    const std::size_t theirs = inputs.table(plan.rows_of).rows();
    if (own != theirs)
      throw py::value_error("table " + plan.name + " has " + std::to_string(own) + " rows, and " + plan.rows_of +
                            " has " + std::to_string(theirs));
  }
  // The Python part has made contiguous arrays of the planned types.
  template <class T>
  static void take(const py::array& from, std::vector<T>& to) {
    to.resize(static_cast<std::size_t>(from.shape(0)));
    if (static_cast<std::size_t>(from.nbytes()) != to.size() * sizeof(T))
      throw py::type_error("another type of column");
    if (!to.empty()) std::memcpy(to.data(), from.data(), to.size() * sizeof(T));
  }

  Function function_;
  std::shared_ptr<const std::vector<TablePlan>> plan_;
  std::vector<Storage> storage_;
  std::vector<mesecina::Statistic> statistics_;
};

/// Draws the rows of an array: coordinates and a scalar. Rows that begin with NaN draw nothing.
class PyDrawer final : public mesecina::Drawer {
 public:
  PyDrawer(const Function& function, const mesecina::Inputs& inputs, mesecina::PrimitiveKind kind)
      : kind_(kind), stride_(mesecina::stride_of(kind)) {
    call(function, inputs, [this](const py::object& out) {
      const auto array = out.cast<Doubles>();
      if (array.ndim() != 2 || static_cast<std::size_t>(array.shape(1)) != stride_)
        throw py::type_error("another number of coordinates");
      values_.assign(array.data(), array.data() + array.size());
    });
  }

  void draw(mesecina::Row row, mesecina::Drawn& out) override {
    using mesecina::PrimitiveKind;
    if ((row + std::size_t{1}) * stride_ > values_.size()) return;
    const double* const v = values_.data() + row * stride_;
    if (std::isnan(v[0])) return;
    switch (kind_) {
      case PrimitiveKind::point: return out.point({v[0], v[1]}, v[2]);
      case PrimitiveKind::disk: return out.disk({{v[0], v[1]}, v[2]}, v[3]);
      case PrimitiveKind::circle: return out.circle({{v[0], v[1]}, v[2]}, v[3]);
      case PrimitiveKind::segment: return out.segment({v[0], v[1]}, {v[2], v[3]}, v[4]);
      case PrimitiveKind::ray: return out.ray({v[0], v[1]}, {v[2], v[3]}, v[4]);
      case PrimitiveKind::line: return out.line({v[0], v[1]}, {v[2], v[3]}, v[4]);
      case PrimitiveKind::triangle: return out.triangle({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, v[6]);
      case PrimitiveKind::arc: return out.arc({{v[0], v[1]}, v[2]}, {v[3], v[4]}, {v[5], v[6]}, v[7]);
      case PrimitiveKind::parabola: return out.parabola({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, v[6]);
    }
  }

 private:
  mesecina::PrimitiveKind kind_;
  std::size_t stride_;
  std::vector<double> values_;
};

// The Python part passes descriptions of experiments as dicts.

mesecina::ParameterInfo parameter_of(const py::handle& one) {
  return {.id = one["id"].cast<std::string>(),
          .description = one["description"].cast<std::string>(),
          .low = one["low"].cast<double>(),
          .high = one["high"].cast<double>(),
          .default_value = one["default"].cast<double>(),
          .is_whole = one["is_whole"].cast<bool>()};
}

void add_parameters(mesecina::Experiment& to, const py::handle& parameters) {
  for (const auto& one : parameters) to.add_parameter(parameter_of(one));
}

std::vector<std::string> ids_of(const py::handle& described) {
  std::vector<std::string> out;
  for (const auto& one : described) out.push_back(one["id"].cast<std::string>());
  return out;
}

void add_structure(mesecina::Experiment& to, const py::dict& spec) {
  std::vector<TablePlan> plan;
  for (const auto& table : spec["tables"]) {
    TablePlan& one = plan.emplace_back(TablePlan{table["name"].cast<std::string>(),
                                                 table["description"].cast<std::string>(),
                                                 table["rows_of"].cast<std::string>(),
                                                 {},
                                                 table["has_alive"].cast<bool>()});
    for (const auto& column : table["columns"]) {
      one.columns.push_back({column["name"].cast<std::string>(), column["description"].cast<std::string>(),
                             column["type"].cast<std::string>(), column["width"].cast<unsigned>()});
      (void)values_for(one.columns.back().type, one.columns.back().width);
    }
  }
  add_parameters(to, spec["parameters"]);
  to.add_structure({.id = spec["id"].cast<std::string>(),
                    .inputs = spec["inputs"].cast<std::vector<std::string>>(),
                    .parameters = ids_of(spec["parameters"])},
                   [function = Function(spec["function"]),
                    plan = std::make_shared<const std::vector<TablePlan>>(std::move(plan))] {
                     return std::make_unique<PyStructure>(function, plan);
                   });
}

void add_layer(mesecina::Experiment& to, const py::dict& spec) {
  const mesecina::PrimitiveKind kind = kind_of(spec["kind"].cast<std::string>());
  add_parameters(to, spec["parameters"]);
  to.add_layer({.id = spec["id"].cast<std::string>(),
                .name = spec["name"].cast<std::string>(),
                .description = spec["description"].cast<std::string>(),
                .rows = spec["rows"].cast<std::string>(),
                .structures = spec["inputs"].cast<std::vector<std::string>>(),
                .parameters = ids_of(spec["parameters"]),
                .kinds = {kind},
                .scalar = spec["scalar"].cast<std::string>(),
                .color = spec["color"].cast<std::array<double, 3>>(),
                .opacity = spec["opacity"].cast<double>(),
                .line_width = spec["line_width"].cast<double>(),
                .point_size = spec["point_size"].cast<double>(),
                .color_map = spec["color_map"].cast<std::string>()},
               mesecina::Experiment::MakeDrawer([function = Function(spec["function"]), kind](const auto& inputs) {
                 return std::unique_ptr<mesecina::Drawer>(std::make_unique<PyDrawer>(function, inputs, kind));
               }));
}

void add_evolution(mesecina::Experiment& to, const py::dict& spec) {
  std::vector<mesecina::ParameterInfo> parameters;
  for (const auto& one : spec["parameters"]) parameters.push_back(parameter_of(one));
  to.add_evolution({.id = spec["id"].cast<std::string>(),
                    .name = spec["name"].cast<std::string>(),
                    .description = spec["description"].cast<std::string>(),
                    .parameters = std::move(parameters)},
                   [function = Function(spec["function"])](const mesecina::MovingSamples& samples,
                                                           std::span<const double> values) {
                     std::vector<mesecina::Point> out;
                     locked([&] {
                       const std::vector<double> numbers(values.begin(), values.end());
                       const auto moved =
                           function(array_of(samples.positions), contours_of(samples.curves), samples.step, numbers)
                               .cast<Doubles>();
                       const std::span<const mesecina::Point> points = points_of(moved);
                       out.assign(points.begin(), points.end());
                     });
                     return out;
                   });
}

void add(mesecina::Experiment& to, const py::dict& spec) {
  const auto what = spec["what"].cast<std::string>();
  if (what == "structure")
    add_structure(to, spec);
  else if (what == "layer")
    add_layer(to, spec);
  else
    add_evolution(to, spec);
}

/// Adds everything that a Python file defines. The program calls this through embedded.cpp.
void add_file(mesecina::Experiment& to, const char* file) {
  locked([&] {
    for (const auto& spec : py::module_::import("mesecina._experiments").attr("specs_of")(file))
      add(to, spec.cast<py::dict>());
  });
}

}  // namespace

mesecina::Catalogue with_python(const mesecina::Catalogue& catalogue, const py::dict& spec) {
  return mesecina::with_experiment(catalogue, [&](mesecina::Experiment& to) { add(to, spec); });
}

void add_inputs(py::module_& module) {
  py::class_<PyInputs, std::shared_ptr<PyInputs>>(module, "Inputs")
      .def("column", &PyInputs::column)
      .def("live_rows", &PyInputs::live_rows)
      .def("parameter", &PyInputs::parameter);
  module.attr("add_file") = py::capsule(reinterpret_cast<void*>(&add_file), kAddFile);
}

}  // namespace mes_python
