// SPDX-License-Identifier: GPL-3.0-or-later
// Changes the contours of the document by means of the selected samples.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/editing/curves/crust_chains.h"
#include "app/layers/layer_stack.h"
#include "app/system/waker.h"
#include "core/document/contour_edit.h"

namespace mes {

/// Guarantees:
///  1. Each call is one step of undo, named after its effect, or changes nothing and returns the reason.
///  2. The layer of contours becomes visible in the same step, so that the effect can be seen.
///  3. A thread finds contours along the crust; if the document changes meanwhile, the request is dropped.
///
/// Smallest use:
///     if (const auto done = commands.change(ContourChange::join); !done) messages.problem(done.error().message());
///     commands.begin_along_crust();
///     ... once a turn: const auto remark = commands.follow();
///
/// Threads: the window's; `wake` is called from another.
class ContourCommands {
 public:
  ContourCommands(Editor& editor, LayerStack& layers, Waker wake)
      : editor_(editor), layers_(layers), crust_(editor, std::move(wake)) {}

  /// Changes the contours that have selected samples. Returns a sentence on the effect.
  Expected<std::string> change(ContourChange change);
  /// Makes contours of the chains of the crust: of those with a selected sample, or of all if none is selected. They
  /// replace the contours that share a sample with them.
  void begin_along_crust();
  bool is_under_way() const { return crust_.is_under_way(); }
  /// A sentence on the effect, if it has happened now. Error: the crust could not be computed, or it has no chains
  /// there.
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
