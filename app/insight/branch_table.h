// SPDX-License-Identifier: GPL-3.0-or-later
// The branches of an axis as a table: computed from samples, filtered, sorted, and written as CSV.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/document/commands.h"
#include "core/document/computation_settings.h"
#include "core/structures/filters/axis_branches.h"

namespace mes {

class Registry;

/// What of the one-step axis has the branches.
enum class BranchAxis : std::uint8_t { whole, lambda, angle, cover };
inline constexpr std::array kBranchAxes{BranchAxis::whole, BranchAxis::lambda, BranchAxis::angle, BranchAxis::cover};
/// Id of its layer.
std::string_view layer_of(BranchAxis axis);

/// A number that holds for a part of the axis of some length.
struct AxisShare {
  double value = 0.0;
  double length = 0.0;
};

struct BranchTable {
  std::vector<AxisBranch> branches;      ///< in the order of `branches_of`, which numbers them from 1
  std::vector<std::vector<Vec2>> lines;  ///< of each branch: its places from end to end; one place: a point
  std::string reason;                    ///< why there is none
  double length = 0.0;                   ///< of all together
  std::int64_t components = 0;           ///< of what is kept
  std::int64_t cycles = 0;
  /// The union of the balls along it was asked for, and is measured unless `area_problem` says why not.
  bool measures_area = false;
  std::string area_problem;
  double area = 0.0;            ///< of that union
  double share_of_shape = 0.0;  ///< how much of the shape it holds (`KeptUnion`); 0: there is none
  /// Of the whole axis, edge by edge, whatever the filter leaves.
  std::vector<AxisShare> radii;
  std::vector<AxisShare> lambdas;
};

/// Throws `Cancelled`. Error: a structure failed; but where the union alone fails, the table is there without its area.
/// Cost: of the axis from scratch; with `measures_area`, also of the union of the balls by the general pipeline, which
/// is many times that.
Expected<BranchTable> branch_table_of(const Registry& registry, const SampleData& data,
                                      const ComputationSettings& settings, BranchAxis axis, JobControl& job,
                                      bool measures_area = true);

/// What is kept, in one line: "12 branches, length 3.25, 1 component, 0 cycles, 98.7 % of the shape", the last only where
/// there is a share.
std::string kept_in_words(const BranchTable& table);

std::string branches_as_csv(std::span<const AxisBranch> branches);

/// Columns by which a table is sorted and filtered.
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
/// The cell as a number; of an end its kind.
double number_in(const AxisBranch& branch, std::size_t row, BranchColumn column);

/// Conditions that a row must meet, all of them: "length>2.5 lambda<1 leaf". A word is the kind of an end; the numbers are
/// `length`, `radius` (mean), `least`, `largest`, `lambda`, `angle`, with <, >, <= or >=.
class BranchFilter {
 public:
  /// Error: a condition that is not one.
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

/// Rows that the filter leaves, sorted; equal ones by number.
std::vector<std::size_t> rows_of(const BranchTable& table, const BranchFilter& filter, BranchColumn by,
                                 bool is_descending);

/// The branch whose line passes nearest to the place, if it is no farther than `reach`; otherwise the number of branches.
std::size_t branch_near(const BranchTable& table, Vec2 place, double reach);

/// Lengths in equal steps of the value, from 0 to the largest.
struct ShareHistogram {
  double high = 0.0;
  std::vector<double> lengths;
};
ShareHistogram histogram_of(std::span<const AxisShare> shares, std::size_t bins);

}  // namespace mes
