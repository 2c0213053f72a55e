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
  struct Binding {
    std::function<void()> run{};
    std::function<bool()> enabled{};  ///< empty: always
    std::function<bool()> checked{};  ///< empty: nothing to tick
  };

  void bind(ActionId id, Binding binding) { bindings_[static_cast<std::size_t>(id)] = std::move(binding); }
  const Binding& binding(ActionId id) const { return at(id); }
  bool is_bound(ActionId id) const { return static_cast<bool>(at(id).run); }
  bool is_enabled(ActionId id) const { return is_bound(id) && (!at(id).enabled || at(id).enabled()); }
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
  /// "Undo (Ctrl+Z)", and below it what it does: what a tooltip says.
  std::string tooltip_of(ActionId id) const {
    const ActionDescriptor& action = descriptor_of(id);
    const std::string key = keymap_.key_of(id);
    return action.name + (key.empty() ? "" : " (" + key + ")") + '\n' + action.tooltip;
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
