// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue: available structures, layers, parameters, evolutions, shapes, file formats and number types, with
// their public ids.
//
// Guarantees:
//  1. Ids are those of the command line (`mesecina list`) and of files. New ones may be added, but none is renamed
//     within a major version.
//  2. Descriptions are values: later changes of the catalogue do not affect them.
//  3. A workbench keeps its catalogue alive. A copy of a catalogue is the same catalogue.
//
// Smallest use:
//     for (const mesecina::LayerInfo& layer : mesecina::Catalogue::builtin().layers())
//       if (layer.is_visible_at_start) std::puts(layer.id.c_str());
//
// Cost: each list is made on request, in O(its size); `structures` makes every structure once, without data, which
// takes about a millisecond.
// Threads: several threads may read a catalogue.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <mesecina/error.h>
#include <mesecina/geometry.h>
#include <mesecina/table.h>
#include <mesecina/version.h>

namespace mesecina {
inline namespace v1 {

struct StructureInfo {
  std::string id{};                       ///< kebab case, as in "one-step-crust"
  std::vector<std::string> inputs{};      ///< ids of the structures it is computed from
  std::vector<std::string> parameters{};  ///< ids of the parameters it reads itself
  std::vector<TableInfo> tables{};
};

struct LayerInfo {
  std::string id{};           ///< kebab case, as in "medial-axis"
  std::string name{};         ///< name shown in the window
  std::string description{};  ///< one sentence, no full stop
  std::string group{};        ///< heading in the window's list
  std::vector<PrimitiveKind> kinds{};
  std::vector<std::string> structures{};  ///< ids of the structures it reads
  std::vector<std::string> parameters{};  ///< ids of the parameters that affect it
  std::string scalar{};                   ///< the meaning of an instance's scalar; empty: no scalar
  bool is_visible_at_start = false;
  bool follows_settings = false;  ///< it depends on the number type or on parameters
  std::array<double, 3> color{};  ///< default style: red, green, blue, from 0 to 1
  double opacity = 1.0;
  double line_width = 1.0;  ///< in pixels
  double point_size = 5.0;  ///< diameter in pixels
};

/// A number that controls structures, an evolution or a shape.
struct ParameterInfo {
  std::string id{};           ///< kebab case
  std::string description{};  ///< one sentence, no full stop
  std::string unit{};         ///< empty: a plain number
  double low = 0.0;
  double high = 1.0;
  double default_value = 0.0;
  bool is_whole = false;               ///< it takes whole numbers only
  bool is_limit = false;               ///< a value beyond the range is clamped, not refused
  bool is_length = false;              ///< in units of the document
  std::vector<std::string> choices{};  ///< meanings of its whole numbers, from `low`; empty: plain numbers
};

/// A map from one state of the samples, or of a parameter, to the next.
struct EvolutionInfo {
  std::string id{};
  std::string name{};
  std::string description{};
  std::string moved_parameter{};  ///< id; empty: it moves samples
  bool is_random = false;         ///< the seed matters
  std::vector<ParameterInfo> parameters{};
};

struct FormulaInfo {
  std::string id{};
  std::string description{};
  std::string default_text{};
};

/// A family of curves, of sets of points, or of balls.
struct ShapeInfo {
  std::string id{};
  std::string name{};
  std::string description{};
  std::vector<ParameterInfo> parameters{};
  std::vector<FormulaInfo> formulas{};
  std::size_t points = 0;  ///< default number of points of a set; 0: it consists of curves
};

struct FormatInfo {
  std::string id{};
  std::string name{};
  std::vector<std::string> extensions{};  ///< with the dot, lower case
  bool can_read = false;
  bool can_write = false;  ///< by `Workbench::save`
};

struct PrecisionInfo {
  std::string id{};  ///< "naive", "fast", "exact", "exact-roots"
  std::string name{};
  std::string description{};
};

/// A set of structures, layers, parameters, evolutions and shapes that a workbench computes with.
class MESECINA_API Catalogue {
 public:
  /// The catalogue of the program.
  static Catalogue builtin();

  ~Catalogue();
  Catalogue(const Catalogue&) noexcept;
  Catalogue& operator=(const Catalogue&) noexcept;

  /// Inputs before the structures that read them.
  std::vector<StructureInfo> structures() const;
  /// In default stacking order, bottom first.
  std::vector<LayerInfo> layers() const;
  /// Parameters of structures, for `Workbench::set`.
  std::vector<ParameterInfo> parameters() const;
  std::vector<EvolutionInfo> evolutions() const;
  std::vector<ShapeInfo> shapes() const;
  /// In the order in which contents are tried.
  std::vector<FormatInfo> formats() const;
  /// Number types are the same in every catalogue.
  static std::vector<PrecisionInfo> precisions();

 private:
  friend struct CatalogueAccess;
  struct Impl;
  explicit Catalogue(std::shared_ptr<const Impl> impl) noexcept;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace v1
}  // namespace mesecina
