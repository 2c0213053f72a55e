// SPDX-License-Identifier: GPL-3.0-or-later
// A table of the branches of an axis: computed from samples, filtered, sorted, and written as CSV.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/document/map_plane.h"
#include "core/document/sample_data.h"
#include "core/document/settings/computation_settings.h"
#include "core/structures/filters/axis_branches.h"
#include "core/structures/filters/paths/center_line.h"

namespace mes {

class Registry;

/// The part of the one-step axis whose branches are listed.
enum class BranchAxis : std::uint8_t { whole, lambda, angle, cover };
inline constexpr std::array kBranchAxes{BranchAxis::whole, BranchAxis::lambda, BranchAxis::angle, BranchAxis::cover};
/// Id of the axis's layer.
std::string_view layer_of(BranchAxis axis);

/// A number that is valid along a length of the axis.
struct AxisShare {
  double value = 0.0;
  double length = 0.0;
};

struct BranchTable {
  std::optional<MapPlane> map;           ///< of the data; its plane is that of all positions and lengths
  std::vector<AxisBranch> branches;      ///< in the order of `branches_of`, which numbers them from 1
  std::vector<std::vector<Vec2>> lines;  ///< points of each branch from end to end; a single point: an isolated point
  std::string reason;                    ///< why there is no axis
  double length = 0.0;                   ///< total length of all branches
  std::int64_t components = 0;           ///< components of the filtered axis
  std::int64_t cycles = 0;
  /// Asked to measure the union of the balls along the axis; it is measured unless `area_problem` has a reason.
  bool measures_area = false;
  std::string area_problem;
  double area = 0.0;            ///< area of that union
  double share_of_shape = 0.0;  ///< the part of the shape that it holds (`KeptUnion`); 0: no share
  /// Shares of the whole axis, edge by edge, regardless of the filter.
  std::vector<AxisShare> radii;
  std::vector<AxisShare> lambdas;
  /// Stations along the centre lines of the filtered axis, in equal steps from the beginning of each, the longest shape
  /// first.
  std::vector<std::vector<Station>> stations;
};

/// Throws `Cancelled`. Error: a structure failed; if only the union fails, the table is returned without its area.
/// Cost: the axis from scratch; `measures_area` adds the union of the balls by the general pipeline, which takes many
/// times longer.
Expected<BranchTable> branch_table_of(const Registry& registry, const SampleData& data,
                                      const ComputationSettings& settings, BranchAxis axis, JobControl& job,
                                      bool measures_area = true);

/// A summary in one line: "12 branches, length 3.25, 1 component, 0 cycles, 98.7 % of the shape", the last only if
/// there is a share.
std::string kept_in_words(const BranchTable& table);

/// Positions are in the coordinate system of the map, lengths and radii in its unit. Error: as for `WrittenPlane`.
Expected<std::string> branches_as_csv(const BranchTable& table);

/// The columns by which a table can be sorted and filtered.
enum class BranchColumn : std::uint8_t {
  number,
  from,
  to,
  length,
  radius_least,
  radius_mean,
  radius_largest,
  lambda,
  angle
};
inline constexpr std::size_t kBranchColumns = 9;
std::string_view name_of(BranchEndKind kind);
/// The cell as a number; for an end, the number of its kind.
double number_in(const AxisBranch& branch, std::size_t row, BranchColumn column);

/// Conditions that a row must all meet: "length>2.5 lambda<1 leaf". A word is the kind of an end; the numbers are
/// `length`, `radius` (mean), `least`, `largest`, `lambda`, `angle`, with <, >, <= or >=.
class BranchFilter {
 public:
  /// Error: a malformed condition.
  static Expected<BranchFilter> parse(std::string_view text);
  bool holds(const AxisBranch& branch) const;

 private:
  struct Condition {
    BranchColumn column = BranchColumn::length;
    bool is_kind = false;
    BranchEndKind kind = BranchEndKind::leaf;
    bool is_above = false;
    bool is_equal_enough = false;
    double limit = 0.0;
  };
  std::vector<Condition> conditions_;
};

/// The rows that pass the filter, sorted; ties by number.
std::vector<std::size_t> rows_of(const BranchTable& table, const BranchFilter& filter, BranchColumn by,
                                 bool is_descending);

/// The branch whose line is nearest to the point, if within `reach`; otherwise the number of branches.
std::size_t branch_near(const BranchTable& table, Vec2 place, double reach);

/// Histogram of lengths over equal steps of the value, from 0 to the largest.
struct ShareHistogram {
  double high = 0.0;
  std::vector<double> lengths;
};
ShareHistogram histogram_of(std::span<const AxisShare> shares, std::size_t bins);

}  // namespace mes
