// SPDX-License-Identifier: GPL-3.0-or-later
// The ends of the centre lines that the user asks for: annotations of the kind `center_line`, as a source of the graph.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/document/annotation.h"
#include "core/document/delta.h"
#include "core/graph/source_structure.h"

namespace mes {

/// One end of a centre line: a sample that it follows, the centre of the circle through three, or a fixed position.
struct CenterLineEnd {
  Vec2 at{};  ///< the position, if it follows nothing, or a sample that is not alive
  std::vector<SampleId> follows{};
  friend bool operator==(const CenterLineEnd&, const CenterLineEnd&) = default;
};

/// A source beside `Samples`. Ends on balls stay where they were set.
class CenterLineEnds final : public SourceStructure {
 public:
  CenterLineEnds() : SourceStructure("center-line-ends") {}

  void post(std::shared_ptr<const DocumentDelta> delta) override {
    if (delta->replaces_all()) first_ = delta->after->first;
    if (delta->changes_annotations() || delta->replaces_all()) pending_ = delta->annotations_after;
  }
  bool has_pending() const override { return pending_ != nullptr; }
  /// In the order of the annotations.
  const std::vector<std::array<CenterLineEnd, 2>>& current() const { return current_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override {
    rebuild(job);
    return true;
  }
  void clear_changes() override { touched_ = 0; }
  /// A change of any ends counts as one.
  std::size_t touched() const override { return touched_; }
  StatList statistics() const override { return {{"lines", static_cast<std::int64_t>(current_.size())}}; }

 private:
  std::vector<std::array<CenterLineEnd, 2>> current_;
  std::shared_ptr<const Annotations> pending_;  // null: none
  SampleId first_{0};                           // of the data, counted from which annotations name samples
  std::size_t touched_ = 0;
};

}  // namespace mes
