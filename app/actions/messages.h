// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of the window to the user.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace mes {

/// A remark is shown in the status bar until the next one. A problem is shown above the canvas until it is closed, or an
/// operation succeeds that makes it stale. A notice is shown above the canvas for some seconds. A refusal is a remark
/// that is shown even without a status bar, until the next key or press. All stay in the log, which keeps the last
/// thousand.
class Messages {
 public:
  struct Entry {
    std::chrono::system_clock::time_point when;
    bool is_problem = false;
    std::string text;
    std::uint32_t times = 1;  ///< number of consecutive occurrences
  };

  void remark(std::string text) {
    begin_sentence(text);
    log(text, false);
    remark_ = std::move(text);
    is_refusal_ = false;
  }
  void refusal(std::string text) {
    remark(std::move(text));
    is_refusal_ = true;
  }
  void problem(std::string text) {
    begin_sentence(text);
    log(text, true);
    problem_ = std::move(text);
  }
  /// Reports several problems at once without hiding any: each is an entry of the log, and the first few are shown
  /// above the canvas, one line each. Does nothing if there are none.
  void problems(std::span<const std::string> texts) {
    if (!texts.empty()) problem_ = log_all(texts, true);
  }
  /// The same for notices: facts about an operation that has succeeded.
  void notices(std::span<const std::string> texts) {
    if (texts.empty()) return;
    notice_ = log_all(texts, false);
    ++notice_number_;
  }
  void notice(const std::string& text) { notices(std::span(&text, 1)); }
  void clear_remark() {
    remark_.clear();
    is_refusal_ = false;
  }
  void clear_refusal() {
    if (is_refusal_) clear_remark();
  }
  void clear_problem() { problem_.clear(); }
  void clear_notice() { notice_.clear(); }
  /// All messages are outdated. They stay in the log.
  void clear() {
    clear_remark();
    clear_problem();
    clear_notice();
  }
  const std::string& remark() const { return remark_; }
  const std::string& problem() const { return problem_; }
  const std::string& notice() const { return notice_; }
  /// Grows with each notice.
  std::uint64_t notice_number() const { return notice_number_; }
  /// True if the present remark is a refusal.
  bool is_refusal() const { return is_refusal_; }

  /// The number of messages so far.
  std::uint64_t said() const { return said_; }

  const std::deque<Entry>& entries() const { return entries_; }
  void clear_log() { entries_.clear(); }

 private:
  // Writes the first letter large, unless the first word is a name: of a file, which has a point or ends at a colon, or
  // of a parameter or a program.
  static void begin_sentence(std::string& text) {
    const auto is_small = [](char letter) { return letter >= 'a' && letter <= 'z'; };
    const auto end = std::ranges::find_if_not(text, is_small);
    const std::string_view word(text.begin(), end);
    if (word.empty() || word == "ffmpeg" || (end != text.end() && *end != ' ' && *end != ',')) return;
    const std::string_view head = std::string_view(text).substr(0, text.find(": "));
    const bool is_file = head.size() < text.size() && head.contains('.') && !head.contains('/');
    if (!is_file) text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  // Returns the first texts, one line each.
  std::string log_all(std::span<const std::string> texts, bool is_problem) {
    constexpr std::size_t kMostLines = 6;
    constexpr std::size_t kMostLogged = 100;
    std::string lines;
    for (std::size_t i = 0; i < std::min(texts.size(), kMostLogged); ++i) {
      std::string text = texts[i];
      begin_sentence(text);
      log(text, is_problem);
      if (i < kMostLines) lines += (i == 0 ? "" : "\n") + text;
    }
    if (texts.size() > kMostLines)
      lines += "\nand " + std::to_string(texts.size() - kMostLines) + " more, in View > Log";
    if (texts.size() > kMostLogged) log("and " + std::to_string(texts.size() - kMostLogged) + " more", is_problem);
    return lines;
  }
  void log(const std::string& text, bool is_problem) {
    constexpr std::size_t kMost = 1000;
    ++said_;
    const auto now = std::chrono::system_clock::now();
    if (!entries_.empty() && entries_.back().text == text && entries_.back().is_problem == is_problem) {
      entries_.back().when = now;
      ++entries_.back().times;
      return;
    }
    entries_.push_back({now, is_problem, text});
    if (entries_.size() > kMost) entries_.pop_front();
  }

  std::string remark_;
  bool is_refusal_ = false;
  std::string problem_;
  std::string notice_;
  std::uint64_t notice_number_ = 0;
  std::uint64_t said_ = 0;
  std::deque<Entry> entries_;
};

}  // namespace mes
