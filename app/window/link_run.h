// SPDX-License-Identifier: GPL-3.0-or-later
// The window beside a program that started it, such as an interpreter of Python: both work on one document.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "app/model/messages.h"
#include "app/store/document_link.h"
#include "app/window/workspace.h"

namespace mes {

/// What it guarantees: it never waits, except in `open`. When the other side ends, the document stays, and the window goes
/// on by itself.
/// Threads: the window's; `wake` is called from the one that reads.
class LinkRun {
 public:
  struct Uses {
    Workspace& work;
    Messages& messages;
    std::function<void()> leave;  ///< the window is to close, as if the user had asked for it
  };
  LinkRun(Uses uses, std::function<void()> wake) : uses_(std::move(uses)), wake_(std::move(wake)) {}
  ~LinkRun();
  LinkRun(const LinkRun&) = delete;
  LinkRun& operator=(const LinkRun&) = delete;

  /// A socket, which it closes. Waits for the document, which the other side sends at once, so that there is nothing yet
  /// that it could take the place of. To be called once.
  void open(int socket);
  /// Once a turn: makes what the other side says, and says what was done here.
  void follow();
  /// `follow` has work that waits for the end of a gesture, after which nothing else may happen for long.
  bool is_waiting();

 private:
  /// Waits for bytes and adds whole lines. False: there will be no more.
  bool read_some();
  void read();
  Expected<void> begin();
  void say(const std::string& line);
  /// The settings of the computation. While a parameter runs through its values, they are those that the link knows.
  const DocumentLink::Settings& settings();
  void set(const DocumentLink::Settings& settings);
  void end(const std::string& reason);

  Uses uses_;
  std::function<void()> wake_;
  DocumentLink link_;
  DocumentLink::Settings settings_;
  std::string unsent_;
  std::string begun_line_;
  int socket_ = -1;
  std::mutex mutex_;  // of the two below
  std::deque<std::string> lines_;
  bool is_over_ = false;
  std::jthread reader_;  // last: it uses all of the above
};

}  // namespace mes
