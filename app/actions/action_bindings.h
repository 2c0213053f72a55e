// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of the table do in this window, and when they are possible.
#pragma once

#include <array>
#include <functional>
#include <new>
#include <string>
#include <utility>

#include "app/actions/keymap.h"

namespace mes {

class ActionBindings {
 public:
  /// When an action is possible, and what there is to say when it is not: "nothing is selected".
  class Condition {
   public:
    Condition() = default;  ///< always
    Condition(std::function<bool()> holds, std::string missing)
        : holds_(std::move(holds)), missing_(std::move(missing)) {}
    bool holds() const { return !holds_ || holds_(); }
    const std::string& missing() const { return missing_; }

   private:
    std::function<bool()> holds_;
    std::string missing_;
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
  std::string missing(ActionId id) const { return is_enabled(id) ? std::string() : at(id).enabled.missing(); }
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
