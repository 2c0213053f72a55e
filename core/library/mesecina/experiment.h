// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments: custom structures, layers, parameters, evolutions, shapes and formats, beside the program's.
//
// An experiment is one source file. `mesecina FILE --with gabriel.cpp` compiles it and shows it in the window, where
// it is styled, recorded, exported and undone like everything else; `compute`, `render`, `play` and `list` take the
// same option. A program that links the library adds the same functions to a catalogue (`with_experiment`).
//
// Guarantees:
//  1. An experiment reads the results of its inputs after they have been brought up to date, never half of a change.
//  2. If it throws, its structure or layer fails with the text of the exception. Everything that does not depend on it
//     continues.
//  3. Names are checked when something is added; an experiment with a mistake there adds nothing at all.
//
// Smallest use:
//     MESECINA_EXPERIMENT(experiment) {
//       experiment.add_layer({.id = "long-edges",
//                             .name = "Long edges",
//                             .description = "Delaunay edges, coloured by their length",
//                             .rows = "delaunay/edges",
//                             .kinds = {mesecina::PrimitiveKind::segment},
//                             .scalar = "length"},
//                            [](const mesecina::Inputs& inputs) {
//                              const auto ends = inputs.column<std::array<mesecina::Row, 2>>("delaunay/edges/sites");
//                              const auto place = inputs.column<mesecina::Point>("delaunay/sites/position");
//                              return [=](mesecina::Row edge, mesecina::Drawn& out) {
//                                const mesecina::Point a = place[ends[edge][0]], b = place[ends[edge][1]];
//                                out.segment(a, b, std::hypot(b.x - a.x, b.y - a.y));
//                              };
//                            });
//     }
//
// Cost: drawing a layer takes one virtual call for each changed row. Inputs are read in place.
// Threads: functions of a structure and of an evolution are called on one thread at a time. Several threads draw layers
// in parallel, each layer on one thread; data that they share must only be read.
// Source: the registry, tables and patches behind it are those of the program (docs/architecture.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <mesecina/catalogue.h>
#include <mesecina/error.h>
#include <mesecina/geometry.h>
#include <mesecina/table.h>
#include <mesecina/version.h>
#include <mesecina/workbench.h>

namespace mesecina {
inline namespace v1 {

/// The values of a column of an input, stored or computed. A copy reads the same column. It is valid as long as the
/// `Inputs` that returned it; indices are not checked.
template <class T>
class InputColumn {
 public:
  InputColumn() = default;
  /// `read` serves a computed column, and `values` a stored one.
  using Read = void (*)(const void* column, Row row, void* out);
  InputColumn(Values<T> values, const void* column, Read read) : values_(values), column_(column), read_(read) {}

  T operator[](Row row) const {
    if (read_ == nullptr) return values_[row];
    T out{};
    read_(column_, row, &out);
    return out;
  }

 private:
  Values<T> values_{};
  const void* column_ = nullptr;
  Read read_ = nullptr;
};

/// The results that an experiment may read: tables of its inputs, and its parameters. It is valid during the call that
/// received it, and for a layer until the next drawing of the layer.
class MESECINA_API Inputs {
 public:
  struct Impl;
  explicit Inputs(Impl& impl) noexcept : impl_(impl) {}
  Inputs(const Inputs&) = delete;
  Inputs& operator=(const Inputs&) = delete;

  /// A table of an input, by its id as in "delaunay/faces". Error: `usage` if no input has it.
  Table table(std::string_view id) const;
  /// Number of all rows of a table, including dead ones. Error, here and below: as `table`.
  std::size_t rows(std::string_view table) const;
  /// Live rows by increasing number. O(rows).
  std::vector<Row> live_rows(std::string_view table) const;
  bool is_alive(std::string_view table, Row row) const;
  /// The rows of a table that have changed since the previous call of the experiment's function. Error: `usage` if the
  /// table does not track changes.
  RowChanges changes(std::string_view table) const;
  /// A column of a table, by its path as in "delaunay/faces/circumcenter". Error: `usage` if no input has it, or if its
  /// values are of another type or number.
  template <class T>
  InputColumn<T> column(std::string_view path) const {
    const Found found = find(path, ColumnValue<T>::type, ColumnValue<T>::width);
    return InputColumn<T>(Values<T>(found.data, found.rows, found.stride), found.column, found.read);
  }
  /// The value of a parameter that the structure or the layer names. Error: `usage` for another one.
  double parameter(std::string_view id) const;

  /// Throws if the user has stopped the computation, and reports progress. Loops that may take longer than a moment
  /// should call it about every thousand rows.
  void checkpoint(std::uint64_t done = 0, std::uint64_t total = 0) const;

 private:
  struct Found {
    const void* data;
    std::size_t rows;
    std::size_t stride;
    const void* column;
    void (*read)(const void* column, Row row, void* out);
  };
  Found find(std::string_view path, ColumnType type, unsigned width) const;
  Impl& impl_;
};

/// Describes a custom table whose columns are vectors. Nothing is copied: the vectors are members of the structure;
/// they may grow, shrink and reallocate, but the vector objects must live as long as the structure.
class MESECINA_API OwnTable {
 public:
  OwnTable(std::string name, std::string description);
  ~OwnTable();
  OwnTable(OwnTable&&) noexcept;
  OwnTable& operator=(OwnTable&&) noexcept;

  /// The rows are those of another table, as in "delaunay/edges": a row of the same number is the same element.
  OwnTable& rows_of(std::string table);
  /// Marks rows with 0 as dead. Without this call, the live rows are those of the table of `rows_of`.
  OwnTable& alive(const std::vector<std::uint8_t>& flags);
  /// The rows that `update` changed. Without this call, each update redraws all of the layers of the table.
  OwnTable& changes(const std::vector<Row>& touched, const std::vector<Row>& removed);
  /// Adds a column of contiguous values. Error of all columns: `usage` for more than three values in a row.
  template <class T>
  OwnTable& column(std::string name, std::string description, const std::vector<T>& values) {
    static_assert(!std::is_same_v<T, bool>, "bits have no address; use std::uint8_t");
    return add(std::move(name), std::move(description), ColumnValue<T>::type, ColumnValue<T>::width, sizeof(T),
               [&values] {
                 return Place{values.data(), values.size()};
               });
  }
  /// Adds a column of bytes that are 0 or 1.
  OwnTable& flag(std::string name, std::string description, const std::vector<std::uint8_t>& values) {
    return add(std::move(name), std::move(description), ColumnType::boolean, 1, 1, [&values] {
      return Place{values.data(), values.size()};
    });
  }
  /// Adds a column that is a member of each row.
  template <class S, class T>
  OwnTable& column(std::string name, std::string description, const std::vector<S>& rows, T S::*member) {
    return add(std::move(name), std::move(description), ColumnValue<T>::type, ColumnValue<T>::width, sizeof(S),
               [&rows, member] {
                 return Place{rows.empty() ? nullptr : std::addressof(rows.front().*member), rows.size()};
               });
  }
  /// Declares that the last added column holds row numbers of a table, as in "delaunay/sites".
  OwnTable& refers_to(std::string table);

  struct Impl;

 private:
  friend struct OwnTableAccess;
  /// Current location of the values of a column.
  struct Place {
    const void* data;
    std::size_t rows;
  };
  OwnTable& add(std::string name, std::string description, ColumnType type, unsigned width, std::size_t stride,
                std::function<Place()> place);
  std::unique_ptr<Impl> impl_;
};

/// A structure: tables that are a function of the tables of its inputs and of its parameters. Each computation that
/// shows it makes its own instance, so panes side by side have one each.
class MESECINA_API Structure {
 public:
  Structure() = default;
  virtual ~Structure();
  Structure(const Structure&) = delete;
  Structure& operator=(const Structure&) = delete;

  /// Computes everything from scratch.
  virtual void rebuild(const Inputs& inputs) = 0;
  /// Follows the changes of the inputs (`Inputs::changes`). Returns false to request `rebuild` instead. Called only if
  /// the last call succeeded, no input was rebuilt, and no parameter of the structure changed.
  virtual bool update(const Inputs& inputs);
  /// Its tables. Also called before anything is computed: they then have no rows.
  virtual std::vector<OwnTable> tables() const;
  /// Counters and measures, for the window's list and for `mesecina compute`. They may cost O(n).
  virtual std::vector<Statistic> statistics() const;
  /// Remarks for the reader of the result; `structure` of a finding is not used.
  virtual std::vector<Finding> findings() const;
};

/// The output of one row of a layer: one primitive, or nothing. A primitive with a coordinate that is not finite is not
/// drawn, and is counted as lost.
class Drawn {
 public:
  void point(Point p, double scalar = 0.0) { set<PrimitiveKind::point>({p.x, p.y, scalar}); }
  void disk(const Ball& b, double scalar = 0.0) {
    set<PrimitiveKind::disk>({b.center.x, b.center.y, b.radius, scalar});
  }
  void circle(const Ball& b, double scalar = 0.0) {
    set<PrimitiveKind::circle>({b.center.x, b.center.y, b.radius, scalar});
  }
  void segment(Point a, Point b, double scalar = 0.0) { set<PrimitiveKind::segment>({a.x, a.y, b.x, b.y, scalar}); }
  /// A direction of length zero draws nothing, here and below.
  void ray(Point from, Point direction, double scalar = 0.0) {
    if (direction != Point{}) set<PrimitiveKind::ray>({from.x, from.y, direction.x, direction.y, scalar});
  }
  void line(Point through, Point direction, double scalar = 0.0) {
    if (direction != Point{}) set<PrimitiveKind::line>({through.x, through.y, direction.x, direction.y, scalar});
  }
  void triangle(Point a, Point b, Point c, double scalar = 0.0) {
    set<PrimitiveKind::triangle>({a.x, a.y, b.x, b.y, c.x, c.y, scalar});
  }
  /// Runs counter-clockwise along the circle.
  void arc(const Ball& circle, Point from, Point to, double scalar = 0.0) {
    set<PrimitiveKind::arc>({circle.center.x, circle.center.y, circle.radius, from.x, from.y, to.x, to.y, scalar});
  }
  /// An arc of a parabola, whose tangents at both ends meet in `control`.
  void parabola(Point from, Point control, Point to, double scalar = 0.0) {
    set<PrimitiveKind::parabola>({from.x, from.y, control.x, control.y, to.x, to.y, scalar});
  }

  bool is_set() const { return is_set_; }
  PrimitiveKind kind() const { return kind_; }
  const std::array<double, 8>& values() const { return values_; }
  void clear() { is_set_ = false; }

 private:
  template <PrimitiveKind kKind>
  void set(const std::array<double, stride_of(kKind)>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) values_[i] = values[i];
    kind_ = kKind;
    is_set_ = true;
  }
  std::array<double, 8> values_{};
  PrimitiveKind kind_ = PrimitiveKind::point;
  bool is_set_ = false;
};

/// Draws the live rows of a layer.
class MESECINA_API Drawer {
 public:
  virtual ~Drawer();
  virtual void draw(Row row, Drawn& out) = 0;
};

struct StructureSpec {
  std::string id{};                       ///< kebab case, new
  std::vector<std::string> inputs{};      ///< ids of structures, of the program or added before
  std::vector<std::string> parameters{};  ///< ids of the parameters that it reads
};

struct LayerSpec {
  std::string id{};           ///< kebab case, new
  std::string name{};         ///< name shown in the window
  std::string description{};  ///< one sentence, no full stop
  std::string rows{};         ///< the table whose rows are drawn, one primitive each, as in "delaunay/edges"
  /// Other tables of the same rows whose changes also change the picture, as "one-step-crust/edges" here. All other
  /// structures that it reads must be named in `structures`; a change there redraws the whole layer.
  std::vector<std::string> follows{};
  std::vector<std::string> structures{};
  std::vector<std::string> parameters{};
  std::vector<PrimitiveKind> kinds{};            ///< kinds that it may draw, bottom first
  std::string scalar{};                          ///< the meaning of the scalars, with the unit; empty: no scalar
  std::array<double, 3> color{0.85, 0.33, 0.1};  ///< red, green, blue, from 0 to 1
  double opacity = 1.0;
  double line_width = 1.5;  ///< in pixels
  double point_size = 6.0;  ///< diameter in pixels
  std::string color_map{};  ///< a map that colours by the scalar, as in "viridis"; empty: `color` alone
  bool is_visible_at_start = true;
};

/// The state that an evolution moves. Spans are valid during the call.
struct MovingSamples {
  std::span<const Point> positions{};
  std::span<const Contour> curves{};         ///< chains of samples: contours of the document, or those of the crust
  std::span<const std::uint8_t> may_move{};  ///< for each sample, 1 if it is an inner sample of one chain
  std::uint64_t step = 0;                    ///< number of the starting state
  std::uint64_t seed = 1;
};

struct EvolutionSpec {
  std::string id{};           ///< kebab case, new
  std::string name{};         ///< name shown in the window
  std::string description{};  ///< one sentence, no full stop
  bool is_random = false;     ///< the seed matters
  std::vector<ParameterInfo> parameters{};
  std::string moved_parameter{};  ///< id of the structure parameter that it moves; empty: it moves samples
};

/// A shape: curves through given points. `numbers` has the values of its parameters in their order.
struct ShapeSpec {
  std::string id{};           ///< kebab case, new
  std::string name{};         ///< name shown in the window
  std::string description{};  ///< one sentence, no full stop
  std::vector<ParameterInfo> parameters{};
};

struct FormatSpec {
  std::string id{};                       ///< kebab case, new
  std::string name{};                     ///< name shown in file dialogs
  std::vector<std::string> extensions{};  ///< with the dot, lower case
};

/// Returns the next positions of all samples, in their order. The program's evolutions do not move ends of open curves
/// and samples where curves meet (`may_move`); these may. `values` has the values of the evolution's parameters in
/// their order.
using MoveSamples = std::function<std::vector<Point>(const MovingSamples& samples, std::span<const double> values)>;
/// Returns the value of the moved parameter in state `step`, from its value in state 0. The evolution ends before the
/// first step whose value is out of range or whose call throws.
using MoveParameter = std::function<double(double first, std::uint64_t step, std::span<const double> values)>;
/// Returns closed polygons without repeated first corner, outer ones and holes in any order and direction.
using MakeShape = std::function<std::vector<std::vector<Point>>(std::span<const double> values)>;

/// Returns samples, contours and balls from the bytes of a file. Throws with the reason if there are none; an `Error`
/// may carry line and column.
using ReadBytes = std::function<Data(std::string_view bytes)>;
/// Returns true if the bytes identify themselves as this format, whatever the name of the file.
using RecognizeBytes = std::function<bool(std::string_view bytes)>;

/// Adds to a catalogue. Error of all functions: `usage` for an id that is not kebab case or not new, for an unknown
/// structure, table or parameter, and for invalid numbers; the text is one line.
class MESECINA_API Experiment {
 public:
  struct Impl;
  explicit Experiment(Impl& impl) noexcept : impl_(impl) {}
  Experiment(const Experiment&) = delete;
  Experiment& operator=(const Experiment&) = delete;

  /// Adds a number that the user sets, with a slider or `--set id=value`.
  void add_parameter(const ParameterInfo& parameter);

  void add_structure(const StructureSpec& spec, std::function<std::unique_ptr<Structure>()> make);
  template <class S>
  void add_structure(const StructureSpec& spec) {
    static_assert(std::is_base_of_v<Structure, S>);
    add_structure(spec, [] { return std::make_unique<S>(); });
  }

  using MakeDrawer = std::function<std::unique_ptr<Drawer>(const Inputs& inputs)>;
  void add_layer(const LayerSpec& spec, MakeDrawer make);
  /// Calls `prepare` before the layer is drawn; it returns the function that draws a row:
  /// `[...](Row row, Drawn& out) { ... }`.
  template <class Prepare>
  requires std::is_invocable_v < std::invoke_result_t<Prepare&, const Inputs&>
  &, Row, Drawn& > void add_layer(const LayerSpec& spec, Prepare prepare) {
    using Draw = std::invoke_result_t<Prepare&, const Inputs&>;
    class Drawing final : public Drawer {
     public:
      explicit Drawing(Draw draw) : draw_(std::move(draw)) {}
      void draw(Row row, Drawn& out) override { draw_(row, out); }

     private:
      Draw draw_;
    };
    add_layer(spec, MakeDrawer([prepare = std::move(prepare)](const Inputs& inputs) mutable {
                return std::unique_ptr<Drawer>(std::make_unique<Drawing>(prepare(inputs)));
              }));
  }

  /// Adds an evolution of samples, or of the parameter named by `spec.moved_parameter`.
  void add_evolution(const EvolutionSpec& spec, MoveSamples move);
  void add_evolution(const EvolutionSpec& spec, MoveParameter move);
  void add_shape(const ShapeSpec& spec, MakeShape make);
  /// Adds a format for reading files. Without `recognize` a file is known by its extension alone.
  void add_format(const FormatSpec& spec, ReadBytes read, RecognizeBytes recognize = {});

 private:
  Impl& impl_;
};

/// The catalogue with the additions of a function. Error: that of the function, which then adds nothing.
MESECINA_API Catalogue with_experiment(const Catalogue& catalogue, const std::function<void(Experiment&)>& add);
/// The same for a shared library compiled from a source with `MESECINA_EXPERIMENT`. It stays loaded until the program
/// ends. Error: `bad_input` if it cannot be loaded or is made for another ABI.
MESECINA_API Catalogue load_experiment(const Catalogue& catalogue, const std::string& shared_library);

}  // namespace v1
}  // namespace mesecina

#define MESECINA_JOINED_(a, b) a##b
#define MESECINA_JOINED(a, b) MESECINA_JOINED_(a, b)
/// The name of the function that a shared library with experiments exports.
#define MESECINA_EXPERIMENT_ENTRY MESECINA_JOINED(mesecina_experiment_of_abi_, MESECINA_ABI)
/// Begins the function of a source file that adds the experiment's content: `MESECINA_EXPERIMENT(experiment) { ... }`.
#define MESECINA_EXPERIMENT(name) extern "C" MESECINA_API void MESECINA_EXPERIMENT_ENTRY(::mesecina::Experiment& name)
