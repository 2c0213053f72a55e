// SPDX-License-Identifier: GPL-3.0-or-later
// A document with the editor's data for it, made on another thread.
#pragma once

#include <cstdint>
#include <memory>

#include "app/editing/places/place_index.h"
#include "core/base/jobs/job_control.h"
#include "core/document/document.h"
#include "core/document/timeline/history.h"
#include "core/document/timeline/timeline.h"

namespace mes {

/// The revisions, and the ids of samples and of balls, that a document keeps for itself while another one is made.
struct NumbersLeft {
  std::uint64_t revisions = 0;
  std::uint32_t ids = 0;
};
/// Like `before.successor()`, but with later numbers: `before` may be edited and still be followed by the result, as
/// long as the numbers left to it suffice.
Document successor_of(const Document& before, const NumbersLeft& left);

/// Guarantees: `Editor::load` and `Editor::restore` take it over in O(1), whatever its size, and leave in it what
/// they had before.
///
/// Smallest use:
///     DocumentReplay replay(successor_of(editor.document(), left));
///     ... on another thread: replay.begin(*data); PreparedDocument next(std::move(replay), data);
///     editor.load(next);
///
/// Cost: making one is O(n). Threads: any, one at a time; it cannot be moved, because its indices refer to its
/// document.
class PreparedDocument {
 public:
  /// Takes the state of the replay, with `data` and `entries` as replayed. Throws `Cancelled` if there is a job and
  /// it is asked to stop, and std::bad_alloc.
  PreparedDocument(DocumentReplay replay, std::shared_ptr<const SampleData> data, TimelineLog entries = {},
                   Lesson lesson = {}, JobControl* job = nullptr);
  PreparedDocument(const PreparedDocument&) = delete;
  PreparedDocument& operator=(const PreparedDocument&) = delete;

  const Document& document() const { return document_; }

 private:
  friend class Editor;

  Document document_;
  History history_;
  std::shared_ptr<const SampleData> data_;
  TimelineLog entries_;
  Lesson lesson_;
  std::shared_ptr<DocumentDelta> change_;  // its beginning is set at the takeover
  SampleIndex index_;
  CenterIndex centers_;
};

}  // namespace mes
