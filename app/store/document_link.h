// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a document and one in another program the same, by lines of text that go both ways.
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
#include "core/document/commands.h"
#include "core/io/session.h"

namespace mes {

/// Both sides agree on a list of samples and one of balls, and number the changes of these. The other side decides:
/// what it sends is a change, what this side sends is a proposal for the next one, and two proposals that cross are made
/// one after the other. Samples and balls have their places in the lists, because each side has its own ids.
///
///     {"session": "..."}                            the other side begins: the text of a session
///     {"number": 3, "name": "Move", "moved": [[17, 3.0, 4.0]], "removed": [2], "inserted": [[0.5, 0.5]],
///      "moved_balls": [[0, 1.0, 1.0, 2.0]], "removed_balls": [], "inserted_balls": [[0.0, 0.0, 1.0]],
///      "contours": [[true, [0, 1, 2]]], "settings": {"precision": "exact", "lambda": 2.5}}
///     {"accepted": 3}                               the other side made the proposal
///     {"made": 3}                                   this side made the change
///     {"close": true}                               the other side does not need this one any more (`kClosed`)
///
/// Places are those before the change; removed ones close up, and inserted ones follow at the end. Contours, if they are
/// named, are all of them, by places after the change; otherwise they lose what is removed. Settings are those that change.
///
/// Guarantee: after the last line, both sides have the same lists, coordinates bit for bit, the same contours, and the same
/// values of the settings that both know. A line that makes no sense changes nothing.
///
/// Cost: a proposal takes O(samples), a line what it says and O(samples) where something is removed.
/// Threads: that of the editor.
class DocumentLink {
 public:
  /// The number type and the parameters by their ids, as the line of a change has them.
  struct Settings {
    std::string precision{};
    std::map<std::string, double, std::less<>> parameters{};
    friend bool operator==(const Settings&, const Settings&) = default;
  };
  static constexpr std::string_view kClosed = R"({"close": true})";

  /// Returns the session that the first line holds. Error: `bad_input`.
  static Expected<Session> begun_by(std::string_view line);

  /// The document and the settings are those of the first line.
  void begin(const Document& document, const Settings& settings);
  bool has_begun() const { return has_begun_; }
  /// Returns the line that answers, or an empty one, and changes the settings. Not within a gesture. Error: `bad_input`.
  Expected<std::string> take(std::string_view line, Editor& editor, Settings& settings);
  /// There may be something to propose once no gesture is under way.
  bool may_propose(const Editor& editor, const Settings& settings) const {
    return has_begun_ && !proposed_ &&
           (compared_ != editor.document().revision() || !(compared_settings_ == settings));
  }
  /// The line that makes the other side follow, if it has to. Not within a gesture.
  std::optional<std::string> propose(const Editor& editor, const Settings& settings);

 private:
  struct Lists {
    std::vector<SampleId> samples{};
    std::vector<Vec2> positions{};
    std::vector<BallId> balls{};
    std::vector<Disk> disks{};
    std::vector<CurveOrder::Contour> contours{};  // without what was removed
    Settings settings{};
  };
  struct Change;
  static Lists lists_of(const Document& document, const Settings& settings);
  void make(const Change& change, const std::string& name, Editor& editor);

  bool has_begun_ = false;
  Lists agreed_;
  std::uint64_t number_ = 0;         // of the last change
  std::optional<Lists> proposed_{};  // what the lists are if the proposal is accepted
  std::uint64_t compared_ = 0;       // revision for which there was nothing to propose
  Settings compared_settings_{};     // with that
};

}  // namespace mes
