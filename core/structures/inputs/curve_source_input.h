// SPDX-License-Identifier: GPL-3.0-or-later
// The curves that the document's samples were taken from, as a source of the graph.
#pragma once

#include <memory>
#include <optional>

#include "core/document/curve_source.h"
#include "core/document/delta.h"
#include "core/graph/source_structure.h"

namespace mes {

/// A source beside `Samples`; what it holds is shared and never changes.
class CurveSourceInput final : public SourceStructure {
 public:
  CurveSourceInput() : SourceStructure("curve-source") {}

  void post(std::shared_ptr<const DocumentDelta> delta) override {
    // A replacement gives the whole state, whatever was there before.
    if (delta->changes_source() || delta->replaces_all()) pending_ = delta->source_after;
  }
  bool has_pending() const override { return pending_.has_value(); }
  /// Null if the samples were not taken from curves.
  const std::shared_ptr<const CurveSource>& current() const { return current_; }

  void rebuild(JobControl&) override {
    if (pending_) current_ = *std::move(pending_);
    pending_.reset();
    touched_ = 1;
  }
  bool update(JobControl& job) override {
    rebuild(job);
    return true;
  }
  void clear_changes() override { touched_ = 0; }
  /// A change of the curves or of the way to sample them counts as one.
  std::size_t touched() const override { return touched_; }
  StatList statistics() const override;

 private:
  std::shared_ptr<const CurveSource> current_;
  std::optional<std::shared_ptr<const CurveSource>> pending_;
  std::size_t touched_ = 0;
};

}  // namespace mes
