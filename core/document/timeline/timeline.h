// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that happened since the data were opened, in order; used by sessions, crash recovery and replay.
//
// Guarantees:
//  1. The data and the entries determine the document with its free rows, and everything that can be undone and redone,
//     also for layers.
//  2. Samples and balls are named by index: 0 is the first one since the data were opened. So the same work gives the
//     same timeline, whatever was open before.
//  3. Entries that are `settled` do not change; others may still be merged or dropped until their gesture ends, or
//     until their evolution reaches its target.
//
// Smallest use:
//     Timeline timeline;
//     timeline.restart(std::make_shared<const SampleData>(data));
//     timeline.note_edit(document, delta, "Insert sample", false);
//     DocumentReplay replay;
//     replay.begin(*timeline.data());
//     for (const TimelineEntry& entry : timeline.entries()) replay.apply(entry);
//
// Cost: O(edits) for an entry, in time and memory. Threads: none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/document/commands.h"
#include "core/document/curve_source.h"
#include "core/document/document.h"
#include "core/document/settings/computation_settings.h"
#include "core/document/timeline/history.h"
#include "core/document/timeline/layers_changed.h"
#include "core/document/timeline/lesson.h"

namespace mes {

/// A change of the source curves, or of their sampling.
struct SourceEdit {
  bool has_curves = true;                    ///< false: no curves from now on; other members are ignored
  std::shared_ptr<const CurveSet> curves{};  ///< null: unchanged
  SamplingRequest sampling{};
  std::uint32_t first = 0;  ///< index of the first sample
  std::uint32_t count = 0;
  friend bool operator==(const SourceEdit& a, const SourceEdit& b) {
    const bool are_same = a.curves == b.curves || (a.curves && b.curves && *a.curves == *b.curves);
    return are_same && a.has_curves == b.has_curves && a.sampling == b.sampling && a.first == b.first &&
           a.count == b.count;
  }
};

/// One change of the document.
struct TimelineEdit {
  std::string name{};      ///< name of the undo step, outside a gesture
  bool continues = false;  ///< part of the previous step, if that has the same name and moved the same things
  bool replaces = false;   ///< the previous step is undone first, and replaced by this one
  bool is_state = false;   ///< leads to a state of an evolution, whose state 0 is the document before
  std::vector<std::uint32_t> removed{};
  std::vector<std::pair<std::uint32_t, Vec2>> moved{};
  std::vector<Vec2> inserted{};
  std::vector<std::uint32_t> removed_balls{};
  std::vector<std::pair<std::uint32_t, Disk>> changed_balls{};
  std::vector<Disk> inserted_balls{};
  std::optional<std::vector<SampleData::Contour>> curve{};  ///< the new curve order, if it changed
  std::optional<Annotations> annotations{};                 ///< all of them, if any changed
  std::optional<SourceEdit> source{};
  friend bool operator==(const TimelineEdit&, const TimelineEdit&) = default;
};

/// The delta of the edit. Error: `bad_input`, or errors of the commands that it consists of.
Expected<DocumentDelta> delta_of(const Document& document, const TimelineEdit& edit);

/// Edits until the end of the gesture form one undo step.
struct GestureBegun {
  std::string name{};
  friend bool operator==(const GestureBegun&, const GestureBegun&) = default;
};
struct GestureEnded {
  friend bool operator==(const GestureEnded&, const GestureEnded&) = default;
};
/// Undo of the last edit, even if layers changed since; those changes stay. Undo of layer changes is recorded as a
/// `LayersChanged`.
struct Undone {
  friend bool operator==(const Undone&, const Undone&) = default;
};
struct Redone {
  friend bool operator==(const Redone&, const Redone&) = default;
};

struct SettingsChanged {
  ComputationSettings settings{};
  friend bool operator==(const SettingsChanged&, const SettingsChanged&) = default;
};

/// The view stopped moving.
struct ViewChanged {
  Box2 visible{};  ///< visible part, in document units
  friend bool operator==(const ViewChanged&, const ViewChanged&) = default;
};

/// A caption, shown until the next one; empty: no caption.
struct Captioned {
  std::string text{};
  double seconds = 0.0;  ///< duration of this picture in a video; 0: as for other pictures
  friend bool operator==(const Captioned&, const Captioned&) = default;
};

using TimelineEntry = std::variant<TimelineEdit, GestureBegun, GestureEnded, Undone, Redone, LayersChanged,
                                   SettingsChanged, ViewChanged, Captioned>;

/// Whether the entry concerns samples, balls and annotations.
bool changes_document(const TimelineEntry& entry);
/// Whether the entry is the user's work, which would be missed: an edit, or a manual change of layers.
bool is_work(const TimelineEntry& entry);
/// Whether the entry can change the picture.
bool is_visible(const TimelineEntry& entry);

/// Packed entries: an entry takes about as many bytes as its numbers and words.
///
/// Guarantees: entries read are equal to entries stored. A call that throws changes nothing.
/// Cost: O(size of the entry) for storing or reading one. Threads: none.
class TimelineLog {
 public:
  class Iterator;
  using value_type = TimelineEntry;

  TimelineLog() = default;
  TimelineLog(std::initializer_list<TimelineEntry> entries) : TimelineLog(entries.begin(), entries.end()) {}
  explicit TimelineLog(std::span<const TimelineEntry> entries) : TimelineLog(entries.begin(), entries.end()) {}
  template <class Begin, class End>
  TimelineLog(Begin begin, End end) {
    for (; begin != end; ++begin) push_back(*begin);
  }

  std::size_t size() const { return places_.size(); }
  bool empty() const { return places_.empty(); }
  TimelineEntry operator[](std::size_t i) const;
  TimelineEntry back() const { return (*this)[size() - 1]; }
  Iterator begin() const;
  Iterator end() const;
  /// Copies of the entries from `begin` up to, not including, `end`.
  std::vector<TimelineEntry> between(std::size_t begin, std::size_t end) const;

  void push_back(const TimelineEntry& entry);
  void emplace_back(const TimelineEntry& entry) { push_back(entry); }
  void pop_back();
  void replace_back(const TimelineEntry& entry);
  /// Cost: O(1) for the last entry, O(total size) for others.
  void erase(std::size_t i);
  friend bool operator==(const TimelineLog& a, const TimelineLog& b);

 private:
  struct Place {
    std::uint32_t chunk;
    std::uint32_t offset;
  };
  /// Appends a slot of `bytes` bytes.
  void make_place(std::size_t bytes);
  std::span<const std::byte> bytes(std::size_t i) const;

  // Chunks never grow, so nothing is copied to make room.
  std::vector<std::vector<std::byte>> chunks_;
  std::deque<Place> places_;
};

class TimelineLog::Iterator {
 public:
  using value_type = TimelineEntry;
  using reference = TimelineEntry;
  using pointer = void;
  using difference_type = std::ptrdiff_t;
  using iterator_category = std::input_iterator_tag;

  Iterator() = default;
  Iterator(const TimelineLog& log, std::size_t i) : log_(&log), i_(i) {}
  TimelineEntry operator*() const { return (*log_)[i_]; }
  Iterator& operator++() {
    ++i_;
    return *this;
  }
  Iterator operator++(int) {
    Iterator before = *this;
    ++i_;
    return before;
  }
  bool operator==(const Iterator& other) const { return i_ == other.i_; }

 private:
  const TimelineLog* log_ = nullptr;
  std::size_t i_ = 0;
};

inline TimelineLog::Iterator TimelineLog::begin() const {
  return {*this, 0};
}
inline TimelineLog::Iterator TimelineLog::end() const {
  return {*this, size()};
}

class Timeline {
 public:
  Timeline();

  /// Forgets all entries: the document is the given data now.
  void restart(std::shared_ptr<const SampleData> data);
  /// The same, with entries that are known to have happened since, and the lesson made from them.
  void restart(std::shared_ptr<const SampleData> data, TimelineLog entries, Lesson lesson = {});
  const std::shared_ptr<const SampleData>& data() const { return data_; }
  const TimelineLog& entries() const { return entries_; }
  /// Its positions are among the settled entries.
  const Lesson& lesson() const { return lesson_; }
  /// The lesson is not an entry: its steps name entries, and only the last lesson counts.
  void set_lesson(Lesson lesson) {
    lesson_ = std::move(lesson);
    ++lesson_revision_;
  }
  /// Increases with each `set_lesson`; 0 after a `restart`.
  std::uint64_t lesson_revision() const { return lesson_revision_; }
  /// Number of entries, from the first, that will not change any more.
  std::size_t settled() const { return gesture_at_ ? *gesture_at_ : evolution_at_.value_or(entries_.size()); }
  /// Prevents merging of past entries with later ones: a step of a lesson may name this position.
  void settle() {
    end_overdue_gesture();
    evolution_at_.reset();
  }
  /// Increases with each `restart`.
  std::uint64_t generation() const { return generation_; }

  /// `document` is the document before or after the delta. When memory runs out, these functions throw and change
  /// nothing. Large edits that continue the previous one within a gesture are merged with it, so that dragging a
  /// million samples does not fill the memory.
  void note_edit(const Document& document, const DocumentDelta& delta, const std::string& name, bool continues);
  /// Records that an evolution advanced; `replaces` the previous state. Large evolutions keep only their last state.
  void note_evolved(const Document& document, const DocumentDelta& delta, const std::string& name, bool replaces,
                    bool is_state);
  void note_gesture_begun(const std::string& name);
  /// A gesture without edits leaves no trace. When memory runs out, the end is recorded with the next entry.
  void note_gesture_ended();
  void note(const TimelineEntry& entry) {
    end_overdue_gesture();
    entries_.push_back(entry);
    evolution_at_.reset();
  }

 private:
  void end_overdue_gesture();

  std::shared_ptr<const SampleData> data_;
  TimelineLog entries_;
  Lesson lesson_;
  std::uint64_t lesson_revision_ = 0;
  std::optional<std::size_t> gesture_at_;    // index where the open gesture began
  bool is_gesture_overdue_ = false;          // no memory for recording its end yet
  std::optional<std::size_t> evolution_at_;  // a last entry that the next state may replace
  std::size_t evolution_edits_ = 0;          // edits recorded since the evolution began
  std::uint64_t generation_ = 0;
};

/// Rebuilds the document and its history from a timeline. Entries come from files and are not trusted: an entry that
/// makes no sense is an error, and nothing of it is applied.
class DocumentReplay {
 public:
  using Listener = std::function<void(const DocumentDelta&)>;
  /// Revisions and ids continue from those of `before`. The listener receives every change.
  explicit DocumentReplay(const Document& before = {}, Listener listener = {})
      : document_(before.successor()), listener_(std::move(listener)) {}

  Expected<void> begin(const SampleData& data);
  /// Entries that concern neither the document nor undo steps change nothing.
  Expected<void> apply(const TimelineEntry& entry);
  /// Ends a gesture that was left open.
  void finish();

  const Document& document() const { return document_; }
  const History& history() const { return history_; }
  Document take_document() && { return std::move(document_); }
  History take_history() && { return std::move(history_); }

 private:
  Expected<void> apply_edit(const TimelineEdit& edit);
  Expected<void> apply_replacement(const TimelineEdit& edit);
  Expected<void> apply_layers(const LayersChanged& change);
  void change(const DocumentDelta& delta);

  Document document_;
  History history_;
  Listener listener_;
};

}  // namespace mes
