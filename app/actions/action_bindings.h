// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of the table do in this window, and when they are possible.
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
  /// When an action is possible, and what there is to say when it is not: "nothing is selected".
  class Condition {
   public:
    struct Need {
      std::function<bool()> holds;
      std::string missing;  ///< said where it does not hold
    };
    Condition() = default;  ///< always
    Condition(std::function<bool()> holds, std::string missing) : needs_{{std::move(holds), std::move(missing)}} {}
    /// When all of them hold. They are looked at in this order, and the first that does not hold is what there is to
    /// say: each has a reason of its own.
    Condition(std::initializer_list<Need> needs) : needs_(needs) {}
    bool holds() const { return first_missing() == nullptr; }
    /// Empty where it holds.
    std::string missing() const {
      const Need* const need = first_missing();
      return need == nullptr ? std::string() : need->missing;
    }
    /// The same, but it holds as well where `otherwise` does.
    Condition unless(const std::function<bool()>& otherwise) const {
      Condition out = *this;
      for (Need& need : out.needs_)
        need.holds = [otherwise, holds = std::move(need.holds)] { return otherwise() || holds(); };
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
  /// Why it is not possible now; empty where it is, and where nothing is bound.
  std::string missing(ActionId id) const { return is_bound(id) ? at(id).enabled.missing() : std::string(); }
  bool is_checked(ActionId id) const { return at(id).checked && at(id).checked(); }
  /// Runs it if it is possible now; whether it was. An action that runs out of memory ends there.
  bool run(ActionId id) const {
    if (!is_enabled(id)) return false;
    try {
      at(id).run();
    } catch (const std::bad_alloc&) {
      if (out_of_memory_) out_of_memory_();
    }
    return true;
  }
  /// The keys that are in force.
  const Keymap& keymap() const { return keymap_; }
  void set_keymap(Keymap keymap) { keymap_ = std::move(keymap); }
  /// "Undo (Ctrl+Z)", below it what it does, and why it is not possible now: what a tooltip says.
  std::string tooltip_of(ActionId id) const {
    const ActionDescriptor& action = descriptor_of(id);
    const std::string key = keymap_.key_of(id);
    std::string out = action.name + (key.empty() ? "" : " (" + key + ")") + '\n' + action.tooltip;
    if (const std::string why = missing(id); !why.empty()) out += "\nNot possible now: " + why;
    return out;
  }
  /// What is done then.
  void when_out_of_memory(std::function<void()> act) { out_of_memory_ = std::move(act); }

 private:
  const Binding& at(ActionId id) const { return bindings_[static_cast<std::size_t>(id)]; }
  std::array<Binding, kActionCount> bindings_;
  Keymap keymap_ = Keymap::standard();
  std::function<void()> out_of_memory_;
};

}  // namespace mes
