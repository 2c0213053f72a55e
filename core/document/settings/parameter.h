// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters: numbers that control structures, layers, evolutions and shapes, as the command line, the window and the
// manual present them.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace mes {

/// The specification of a parameter; `ParameterValues` holds its value.
///
/// Smallest use:
///     const Parameter reach{.id = "reach", .explanation = "Edges are at most this long", .unit = "units", .high = 10.0};
///     ParameterValues values;
///     values[reach] = 2.5;
struct Parameter {
  std::string id{};           ///< public name, kebab case
  std::string explanation{};  ///< one sentence, no full stop
  std::string unit{};         ///< empty = a plain number
  double low = 0.0;
  double high = 1.0;
  double default_value = 0.0;
  bool is_whole = false;        ///< whole numbers only
  bool is_of_document = false;  ///< reset to the default for a new document; otherwise the user's value stays
  bool is_limit = false;        ///< bounds a filter: values beyond the range are clamped, not refused
  bool is_length = false;       ///< in units of the document; a slider ends below `high`
  bool is_multiplier = false;   ///< lengths are multiplied by it
  std::string title{};          ///< its name in the window; empty: the id in words
  /// Explanation for the window, where it differs because no number is shown; empty: the general one.
  std::string window_explanation{};
  std::vector<std::string> choices{};  ///< names of its whole numbers, from `low` on; empty: numbers

  /// Two parameters are equal if their ids are.
  friend bool operator==(const Parameter& a, const Parameter& b) { return a.id == b.id; }

  // Parameters of the program's structures; core/structures/inputs adds them to its registry.
  static const Parameter union_shortcut;
  static const Parameter pole_propagation;
  static const Parameter medial_sampling_angle;
  static const Parameter a_scale;
  static const Parameter p_scale;
  static const Parameter b_scale;
  static const Parameter lambda_limit;
  static const Parameter angle_limit;
  static const Parameter angle_mode;
  static const Parameter keep_topology;
  static const Parameter scale_axis_factor;
  static const Parameter scale_skeleton_step;
  static const Parameter alpha_radius;
  static const Parameter center_line_pruning;
  static const Parameter center_line_branches;
  static const Parameter transects;
};

/// The parameters above, in listing order.
std::span<const Parameter> computation_parameters();

inline bool is_switch(const Parameter& parameter) {
  return parameter.is_whole && parameter.low == 0.0 && parameter.high == 1.0;
}

/// The allowed value of the parameter that is nearest to a number.
double within(const Parameter& parameter, double value);

}  // namespace mes
