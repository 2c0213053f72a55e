// SPDX-License-Identifier: GPL-3.0-or-later
// A queue of window events that wait until they can be handled.
#pragma once

#include <deque>
#include <functional>
#include <utility>

namespace mes {

/// Guarantees: each event runs once, in order of arrival. Threads: none.
class EventQueue {
 public:
  using Act = std::function<void()>;

  void push(Act act) { events_.push_back({false, std::move(act)}); }
  /// Adds an event before all waiting ones.
  void push_first(Act act) { events_.push_front({false, std::move(act)}); }
  /// Adds a move of the pointer; of several moves in a row only the last one counts.
  void push_move(Act act) { events_.push_back({true, std::move(act)}); }
  bool is_empty() const { return events_.empty(); }

  /// Runs events while `may_go_on`, and `after` each; of several moves in a row only the last, unless `needs_each_move`.
  void deliver(const std::function<bool()>& may_go_on, const std::function<bool()>& needs_each_move,
               const std::function<void()>& after) {
    while (!events_.empty() && may_go_on()) {
      const Event event = std::move(events_.front());
      events_.pop_front();
      const bool is_followed = event.is_move && !events_.empty() && events_.front().is_move;
      if (is_followed && !needs_each_move()) continue;
      event.act();
      after();
    }
  }

 private:
  struct Event {
    bool is_move = false;
    Act act;
  };
  std::deque<Event> events_;
};

}  // namespace mes
