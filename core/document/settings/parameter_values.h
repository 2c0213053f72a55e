// SPDX-License-Identifier: GPL-3.0-or-later
// Values of parameters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/settings/parameter.h"

namespace mes {

/// Guarantees:
///  1. A parameter that was never set has its default.
///  2. Two objects are equal if they give the same values to the same parameters; defaults do not count.
///  3. A value that was read for an id without known specification is kept; once the parameter is requested, it gets
///     this value, clamped to its range.
///
/// Cost: a lookup compares the ids of the set values, O(log n) of them.
class ParameterValues {
 public:
  struct Entry {
    std::string id;
    double value = 0.0;
    std::optional<double> default_value;  ///< unset: only the id is known
    bool is_of_document = true;
  };
  ParameterValues() = default;
  /// Copies the entries of another object.
  explicit ParameterValues(std::vector<Entry> entries) : entries_(std::move(entries)) {}

  double operator[](const Parameter& parameter) const;
  double& operator[](const Parameter& parameter);
  bool is_on(const Parameter& parameter) const { return (*this)[parameter] != 0.0; }
  /// Stores a value for an id without specification; the last one counts.
  void keep(std::string_view id, double value);
  /// Resets parameters of the document to their defaults, and drops values without specification.
  void reset_for_another_document();
  /// Values without specification, and values that differ from their defaults, sorted by id.
  std::vector<Entry> changed() const;

  friend bool operator==(const ParameterValues& a, const ParameterValues& b);

 private:
  std::vector<Entry> entries_;  // sorted by id, without duplicates
};

}  // namespace mes
