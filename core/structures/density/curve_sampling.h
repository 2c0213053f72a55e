// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how well the samples represent the curves that they were taken from.
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

/// Findings for and against samples that represent curves in this way, with this crust: a note with the epsilon, and
/// doubts for intervals of the curves with an epsilon above 1 and for neighbours along the curves that the crust does
/// not join. If samples lie off the curves, only a note of that. `slots` maps the sample numbers of the standing to
/// samples.
std::vector<Finding> findings_of(const CurveStanding& standing, std::span<const SampleSlot> slots,
                                 const Delaunay& delaunay, const OneStepCrust& crust);

/// Judges samples that all lie on the curves that the document says they were taken from: how dense they are, by the
/// feature size of the curves themselves (core/curves/feature_field.h), and whether the crust joins neighbours along
/// the curves. It is a judge because the theorem is about the samples: green says little of curves that they do not
/// represent.
///
/// Guarantees:
///  1. The epsilon is `FeatureField::standing`, the same as that of `take_samples` for the same curves and samples.
///  2. Samples off the curves, such as those moved by hand, are counted; no epsilon is given then.
///
/// Cost: once for given curves, that of `FeatureField::of`; curves that need more than 100,000 positions are not
/// measured. An edit costs O(edited log positions) while samples lie off the curves, and O(n log positions) otherwise.
class CurveSampling final : public Structure {
 public:
  CurveSampling(CurveSourceInput& source, Samples& samples, Delaunay& delaunay, OneStepCrust& crust);

  /// True if a standing is known.
  bool has_standing() const { return standing_.has_value(); }
  const CurveStanding& standing() const { return *standing_; }
  /// Feature field of the curves, if they were measured; else null.
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
  std::shared_ptr<const CurveSet> curves_;  // curves of the field; kept so that their address is not reused
  SamplingRequest request_;
  std::optional<FeatureField> field_;
  std::string no_field_;  // the reason why there is none
  Table<SampleSlot, std::uint8_t> is_off_;
  std::size_t off_ = 0;
  std::optional<CurveStanding> standing_;
  std::vector<Finding> findings_;
  bool is_changed_ = false;
};

}  // namespace mes
