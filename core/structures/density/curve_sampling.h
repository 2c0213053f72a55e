// SPDX-License-Identifier: GPL-3.0-or-later
// How the samples stand for the curves that they were taken from.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/table.h"
#include "core/curves/feature_field.h"
#include "core/document/curve_source.h"
#include "core/graph/structure.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/inputs/curve_source_input.h"
#include "core/structures/inputs/samples.h"

namespace mes {

/// What speaks for and against samples that stand for curves so, with this crust: a note that says the epsilon, and
/// doubts, which are intervals of the curves with an epsilon above 1, and neighbours along the curves that the crust does
/// not join. Where samples lie off the curves, a note of that and nothing else. `slots` are the samples that the standing
/// numbers.
std::vector<Finding> findings_of(const CurveStanding& standing, std::span<const SampleSlot> slots,
                                 const Delaunay& delaunay, const OneStepCrust& crust);

/// Where the document knows the curves that its samples were taken from, and all samples still lie on them: how densely
/// they do, by the feature size of the curves themselves (core/curves/feature_field.h), and whether the crust joins those
/// that follow each other. A judge: the theorem is about the samples, and green says little of curves that they do not
/// stand for.
///
/// What it guarantees:
///  1. The epsilon is `FeatureField::standing`, the same as that of `take_samples` for the same curves and samples.
///  2. Samples that lie off the curves, as those moved by hand do, are counted, and then nothing is said of an epsilon.
///
/// Cost: once for curves, that of `FeatureField::of`; of curves that would need more than 100,000 places nothing is said.
/// An edit costs O(edited log places) while samples lie off the curves, and O(n log places) otherwise.
class CurveSampling final : public Structure {
 public:
  CurveSampling(CurveSourceInput& source, Samples& samples, Delaunay& delaunay, OneStepCrust& crust);

  /// There is something to say.
  bool has_standing() const { return standing_.has_value(); }
  const CurveStanding& standing() const { return *standing_; }
  /// Of the curves, if they were measured; else null.
  const FeatureField* field() const { return field_ ? &*field_ : nullptr; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { is_changed_ = false; }
  std::size_t touched() const override { return is_changed_ ? 1 : 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  bool is_judge() const override { return true; }
  bool has_verdict() const override { return false; }
  void find(std::vector<Finding>& out) const override;

 private:
  void measure(JobControl& job);
  void judge(JobControl& job);

  CurveSourceInput& source_;
  Samples& samples_;
  Delaunay& delaunay_;
  OneStepCrust& crust_;
  std::shared_ptr<const CurveSet> curves_;  // that the field is of; kept, so that no other has its address
  SamplingRequest request_;
  std::optional<FeatureField> field_;
  std::string no_field_;  // why not
  Table<SampleSlot, std::uint8_t> is_off_;
  std::size_t off_ = 0;
  std::optional<CurveStanding> standing_;
  std::vector<Finding> findings_;
  bool is_changed_ = false;
};

}  // namespace mes
