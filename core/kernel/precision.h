// SPDX-License-Identifier: GPL-3.0-or-later
// Number types, chosen at run time.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace mes {

/// Decisions about the samples themselves are exact in all but `naive`. The types differ in how they represent
/// constructed points: circumcentres, crossings of circles.
enum class Precision : std::uint8_t {
  naive,        ///< doubles everywhere, even in predicates: may be wrong; for teaching
  fast,         ///< exact predicates on doubles; constructed points are rounded to doubles first
  exact,        ///< constructed points are rational, roots only where they are needed
  exact_roots,  ///< everything in algebraic numbers with square roots
};
inline constexpr std::size_t kPrecisions = 4;

struct PrecisionDescriptor {
  Precision precision;
  std::string_view id;    ///< public name, kebab case
  std::string_view name;  ///< name in the interface
  std::string_view explanation;
};

constexpr std::array<PrecisionDescriptor, kPrecisions> kPrecisionDescriptors{
    {{Precision::naive, "naive", "Naive",
      "plain doubles everywhere; wrong on degenerate input, to see why it matters"},
     {Precision::fast, "fast", "Fast", "exact decisions on the samples, constructed points rounded to doubles"},
     {Precision::exact, "exact", "Exact", "rational arithmetic for constructed points, roots where they are needed"},
     {Precision::exact_roots, "exact-roots", "Exact with roots",
      "algebraic numbers throughout; slow, the judge of the others"}}};

constexpr std::string_view id_of(Precision precision) {
  return kPrecisionDescriptors[static_cast<std::size_t>(precision)].id;
}

}  // namespace mes
