// SPDX-License-Identifier: GPL-3.0-or-later
// Connects the window to the program that started it, such as a Python interpreter: both work on one document.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "app/actions/messages.h"
#include "app/store/document_link.h"
#include "app/window/work/workspace.h"

namespace mes {

/// Guarantees: it never waits, except in `open`. When the other side ends, the document stays, and the window
/// continues on its own. Threads: the window's; `wake` is called from the reading one.
class LinkRun {
 public:
  struct Uses {
    Workspace& work;
    Messages& messages;
    std::function<void()> leave;  ///< closes the window, as if the user had asked for it
  };
  LinkRun(Uses uses, std::function<void()> wake) : uses_(std::move(uses)), wake_(std::move(wake)) {}
  ~LinkRun();
  LinkRun(const LinkRun&) = delete;
  LinkRun& operator=(const LinkRun&) = delete;

  /// Takes over a socket and closes it at the end. Waits for the document, which the other side sends at once, so
  /// that it cannot replace any work. Call it once.
  void open(int socket);
  /// Called once per turn: makes the changes of the other side, and sends those made here.
  void follow();
  /// True if `follow` has changes that wait for the end of a gesture, after which no event may wake the loop for
  /// long.
  bool is_waiting();

 private:
  /// Waits for bytes and adds whole lines. Returns false when the connection has ended.
  bool read_some();
  void read();
  Expected<void> begin();
  void say(const std::string& line);
  /// The settings of the computation. During an animation of a parameter, they are those that the link knows.
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
  std::mutex mutex_;  // guards the next two members
  std::deque<std::string> lines_;
  bool is_over_ = false;
  std::jthread reader_;  // last: it uses all members above
};

}  // namespace mes
