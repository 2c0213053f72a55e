// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to the contours of the document by way of the selected samples.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/editing/crust_chains.h"
#include "app/layers/layer_stack.h"
#include "app/system/waker.h"
#include "core/document/contour_edit.h"

namespace mes {

/// What it guarantees:
///  1. Each call is one step of undo, named after what it does, or changes nothing and says why.
///  2. The layer of contours becomes visible with the step, so that what was done is seen.
///  3. Contours along the crust are found on a thread; a document that changes meanwhile drops the wish.
///
/// Smallest use:
///     if (const auto done = desk.change(ContourChange::join); !done) messages.problem(done.error().message());
///     desk.begin_along_crust();
///     ... once a turn: const auto remark = desk.follow();
///
/// Threads: the window's; `wake` is called from another.
class ContourDesk {
 public:
  ContourDesk(Editor& editor, LayerStack& layers, Waker wake)
      : editor_(editor), layers_(layers), crust_(editor, std::move(wake)) {}

  /// Of the contours with selected samples. What was done.
  Expected<std::string> change(ContourChange change);
  /// The chains of the crust become contours: those with a selected sample, all where none is selected. They take the
  /// place of contours that share a sample with them.
  void begin_along_crust();
  bool is_under_way() const { return crust_.is_under_way(); }
  /// What was done, if it was done now. Error: the crust could not be computed, or it has no chains there.
  Expected<std::optional<std::string>> follow();

 private:
  Expected<std::string> along(const CrustChains::Curve& curve);
  Expected<void> put(const CurveOrder& contours, const std::string& name);
  std::vector<SampleId> selected() const;

  Editor& editor_;
  LayerStack& layers_;
  CrustChains crust_;
  bool is_wanted_ = false;
};

}  // namespace mes
