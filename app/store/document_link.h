// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a document and its copy in another program equal by exchanging lines of text.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editing/editor.h"
#include "core/base/error.h"
#include "core/document/sample_data.h"
#include "core/io/session/session.h"

namespace mes {

/// Both sides share a list of samples and one of balls, and number the changes to them. The other side decides: it
/// sends changes, this side sends proposals for the next change, and two proposals that cross are made one after the
/// other. Lines name samples and balls by their index in the lists, because each side has its own ids.
///
///     {"session": "..."}                            the other side begins: the text of a session
///     {"number": 3, "name": "Move", "moved": [[17, 3.0, 4.0]], "removed": [2], "inserted": [[0.5, 0.5]],
///      "moved_balls": [[0, 1.0, 1.0, 2.0]], "removed_balls": [], "inserted_balls": [[0.0, 0.0, 1.0]],
///      "contours": [[true, [0, 1, 2]]], "settings": {"precision": "exact", "lambda": 2.5}}
///     {"accepted": 3}                               the other side made the proposal
///     {"made": 3}                                   this side made the change
///     {"close": true}                               the other side does not need this one any more (`kClosed`)
///
/// Indices are those before the change; removing elements closes the gaps, and inserted ones are appended. Contours,
/// if present, are complete and use indices after the change; otherwise they lose the removed samples. Settings are
/// those that change.
///
/// Guarantee: after the last line, both sides have the same lists, with coordinates equal bit for bit, the same
/// contours, and the same values of the settings that both know. A malformed line changes nothing.
///
/// Cost: O(samples) for a proposal; for a line its length, and O(samples) if it removes something. Threads: the
/// editor's.
class DocumentLink {
 public:
  /// The number type, and the parameters by id, as in the line of a change.
  struct Settings {
    std::string precision{};
    std::map<std::string, double, std::less<>> parameters{};
    friend bool operator==(const Settings&, const Settings&) = default;
  };
  static constexpr std::string_view kClosed = R"({"close": true})";

  /// Returns the session that the first line holds. Error: `bad_input`.
  static Expected<Session> begun_by(std::string_view line);

  /// Begins with the document and the settings of the first line.
  void begin(const Document& document, const Settings& settings);
  bool has_begun() const { return has_begun_; }
  /// Applies a line, and returns the answer or an empty line. May change the settings. Not within a gesture. Error:
  /// `bad_input`.
  Expected<std::string> take(std::string_view line, Editor& editor, Settings& settings);
  /// True if there may be something to propose once no gesture is under way.
  bool may_propose(const Editor& editor, const Settings& settings) const {
    return has_begun_ && !proposed_ &&
           (compared_ != editor.document().revision() || !(compared_settings_ == settings));
  }
  /// The line that makes the other side follow, if it must. Not within a gesture.
  std::optional<std::string> propose(const Editor& editor, const Settings& settings);

 private:
  struct Lists {
    std::vector<SampleId> samples{};
    std::vector<Vec2> positions{};
    std::vector<BallId> balls{};
    std::vector<Disk> disks{};
    std::vector<CurveOrder::Contour> contours{};  // without the removed samples
    Settings settings{};
  };
  struct Change;
  static Lists lists_of(const Document& document, const Settings& settings);
  void make(const Change& change, const std::string& name, Editor& editor);

  bool has_begun_ = false;
  Lists agreed_;
  std::uint64_t number_ = 0;         // number of the last change
  std::optional<Lists> proposed_{};  // the lists if the proposal is accepted
  std::uint64_t compared_ = 0;       // revision at which there was nothing to propose
  Settings compared_settings_{};     // settings at that time
};

}  // namespace mes
