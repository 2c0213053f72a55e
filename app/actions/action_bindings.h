// SPDX-License-Identifier: GPL-3.0-or-later
// The effects of the actions of the table in this window, and the conditions under which they are possible.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "app/actions/keymap.h"

namespace mes {

class ActionBindings {
 public:
  /// A condition under which an action is possible, with the message for the case that it is not: "nothing is
  /// selected".
  class Condition {
   public:
    struct Need {
      std::function<bool()> holds;
      std::string missing;  ///< the message when it does not hold
    };
    Condition() = default;  ///< always holds
    Condition(std::function<bool()> holds, std::string missing) : needs_{{std::move(holds), std::move(missing)}} {}
    /// Holds when all needs hold. They are checked in this order, and the first that fails gives the message.
    Condition(std::initializer_list<Need> needs) : needs_(needs) {}
    bool holds() const { return first_missing() == nullptr; }
    /// The message of the first need that fails; empty when the condition holds.
    std::string missing() const {
      const Need* const need = first_missing();
      return need == nullptr ? std::string() : need->missing;
    }
    /// The same condition, which also holds whenever `otherwise` does.
    Condition unless(const std::function<bool()>& otherwise) const {
      Condition out = *this;
      for (Need& need : out.needs_)
        need.holds = [otherwise, holds = std::move(need.holds)] { return otherwise() || holds(); };
      return out;
    }
    /// The same condition, with another need that is checked first.
    Condition after(Need need) const {
      Condition out = *this;
      out.needs_.insert(out.needs_.begin(), std::move(need));
      return out;
    }

   private:
    const Need* first_missing() const {
      const auto found = std::ranges::find_if(needs_, [](const Need& need) { return !need.holds(); });
      return found == needs_.end() ? nullptr : &*found;
    }
    std::vector<Need> needs_;
  };
  struct Binding {
    std::function<void()> run{};
    Condition enabled{};
    std::function<bool()> checked{};  ///< empty: nothing to tick
  };

  void bind(ActionId id, Binding binding) { bindings_[static_cast<std::size_t>(id)] = std::move(binding); }
  const Binding& binding(ActionId id) const { return at(id); }
  bool is_bound(ActionId id) const { return static_cast<bool>(at(id).run); }
  bool is_enabled(ActionId id) const { return is_bound(id) && at(id).enabled.holds(); }
  /// The reason why the action is not possible now; empty when it is possible, and when nothing is bound to it.
  std::string missing(ActionId id) const { return is_bound(id) ? at(id).enabled.missing() : std::string(); }
  bool is_checked(ActionId id) const { return at(id).checked && at(id).checked(); }
  /// Runs the action if it is possible now, and returns whether it was. Catches an action's running out of memory.
  bool run(ActionId id) const {
    if (!is_enabled(id)) return false;
    try {
      at(id).run();
    } catch (const std::bad_alloc&) {
      if (out_of_memory_) out_of_memory_();
    }
    return true;
  }
  /// The keymap in force.
  const Keymap& keymap() const { return keymap_; }
  void set_keymap(Keymap keymap) { keymap_ = std::move(keymap); }
  /// The text of a tooltip: "Undo (Ctrl+Z)", a line with the effect, and the reason if the action is not possible
  /// now.
  std::string tooltip_of(ActionId id) const {
    const ActionDescriptor& action = descriptor_of(id);
    const std::string key = keymap_.key_of(id);
    std::string out = action.name + (key.empty() ? "" : " (" + key + ")") + '\n' + action.tooltip;
    if (const std::string why = missing(id); !why.empty()) out += "\nNot possible now: " + why;
    return out;
  }
  /// Sets the function to call after an action has run out of memory.
  void when_out_of_memory(std::function<void()> act) { out_of_memory_ = std::move(act); }

 private:
  const Binding& at(ActionId id) const { return bindings_[static_cast<std::size_t>(id)]; }
  std::array<Binding, kActionCount> bindings_;
  Keymap keymap_ = Keymap::standard();
  std::function<void()> out_of_memory_;
};

}  // namespace mes
