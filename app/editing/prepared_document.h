// SPDX-License-Identifier: GPL-3.0-or-later
// A document with all that the editor keeps beside it, made on another thread.
#pragma once

#include <cstdint>
#include <memory>

#include "app/editing/place_index.h"
#include "core/base/job_control.h"
#include "core/document/document.h"
#include "core/document/history.h"
#include "core/document/timeline.h"

namespace mes {

/// How many revisions, and ids of samples and of balls, a document keeps to itself while another one is made.
struct NumbersLeft {
  std::uint64_t revisions = 0;
  std::uint32_t ids = 0;
};
/// As `before.successor()`, but further on: `before` may go on and be followed by it all the same, as long as the numbers
/// that are left to it last.
Document successor_of(const Document& before, const NumbersLeft& left);

/// What it guarantees: `Editor::load` and `Editor::restore` take it over in O(1), whatever its size, and leave in it what
/// they had before.
///
/// Smallest use:
///     DocumentReplay replay(successor_of(editor.document(), left));
///     ... on another thread: replay.begin(*data); PreparedDocument next(std::move(replay), data);
///     editor.load(next);
///
/// Cost: making one is O(n). Threads: any, one at a time; it is not moved, for its indices look at its document.
class PreparedDocument {
 public:
  /// The state of the replay, where `data` and `entries` are what was replayed. Throws `Cancelled` if there is a job, and
  /// std::bad_alloc.
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
  std::shared_ptr<DocumentDelta> change_;  // what it begins from is set when it is taken over
  SampleIndex index_;
  CenterIndex centers_;
};

}  // namespace mes
