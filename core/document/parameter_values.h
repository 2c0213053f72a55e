// SPDX-License-Identifier: GPL-3.0-or-later
// Values of parameters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/parameter.h"

namespace mes {

/// What it guarantees:
///  1. A parameter that was never set has its default.
///  2. Two are equal if they give the same values to the same parameters, defaults aside.
///  3. A value that was read for an id alone, of which no specification is known, is kept; once the parameter is asked
///     for, it is that value, taken into the range of the parameter.
///
/// Cost: a lookup compares the ids of the values that were set, O(log n) of them.
class ParameterValues {
 public:
  struct Entry {
    std::string id;
    double value = 0.0;
    std::optional<double> default_value;  ///< none: it is known by its id alone
    bool is_of_document = true;
  };
  ParameterValues() = default;
  /// From the entries of another.
  explicit ParameterValues(std::vector<Entry> entries) : entries_(std::move(entries)) {}

  double operator[](const Parameter& parameter) const;
  double& operator[](const Parameter& parameter);
  bool is_on(const Parameter& parameter) const { return (*this)[parameter] != 0.0; }
  /// The value under an id alone; the last one counts.
  void keep(std::string_view id, double value);
  /// Gives parameters of a document their defaults, and drops what was kept for an id alone.
  void reset_for_another_document();
  /// The kept values, and the set ones that differ from their defaults, sorted by id.
  std::vector<Entry> changed() const;

  friend bool operator==(const ParameterValues& a, const ParameterValues& b);

 private:
  std::vector<Entry> entries_;  // by id, each once
};

}  // namespace mes
