// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the window's bundles together: list, file and layers.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/store/looks/bundles.h"

namespace mes {

/// Guarantees: when a call returns, the file has its change, together with the changes of other windows. A change
/// that cannot be written stays in the list and is reported as an error.
///
/// Smallest use:
///     bundles.choose(0);
///     if (auto saved = bundles.save("Lecture 3"); !saved) report(saved.error());
///
/// Cost: a change writes a small file. Threads: the window's.
class WindowBundles {
 public:
  WindowBundles(std::filesystem::path file, const std::filesystem::path& assets, LayerStack& layers);

  std::span<const Bundle> bundles() const { return list_.bundles(); }
  /// The bundle chosen last, if it still exists.
  std::optional<std::size_t> current() const;
  bool is_changed() const { return current_.is_changed(layers_); }
  bool has(std::string_view name) const { return list_.find(name) != nullptr; }
  /// The problem with the file, at the start or since; given once.
  std::string take_message() { return std::exchange(message_, {}); }

  void choose(std::size_t index) { choose(index, list_.bundles()[index].layers); }
  /// Shows these layers under the bundle's name, for example with another family of balls.
  void choose(std::size_t index, const LayerConfiguration& as);
  /// Call it when something else, such as undo, may have changed the layers.
  void follow_layers() { current_.follow(layers_); }
  /// Calls a function that replaces all layers by those of another registry. An unchanged bundle stays the current
  /// one.
  void replace_layers(const std::function<void()>& replace);
  /// Saves the present layers as a new bundle, or over the bundle of that name.
  Expected<void> save(const std::string& name);
  Expected<void> rename(std::size_t index, const std::string& name);
  Expected<void> move(std::size_t index, std::size_t to);
  Expected<void> remove(std::size_t index);

  /// Adds all bundles of the file and shows the first. Returns a remark of one line.
  Expected<std::string> import(const std::filesystem::path& file);
  /// Brings back the bundles that come with the program, if they are missing.
  Expected<void> add_starting_set();
  /// Exports one bundle, or all. Error: `cannot_write`.
  Expected<void> export_to(const std::filesystem::path& file, std::optional<std::size_t> index) const;

  /// The last change, to be undone, until a bundle is chosen; empty: no offer.
  std::string undo_offer() const { return offers_undo_ ? list_.undo_name() : std::string(); }
  bool can_undo() const { return !list_.undo_name().empty(); }
  Expected<void> undo();

 private:
  Expected<void> write();

  LayerStack& layers_;
  std::vector<Bundle> starting_;
  BundleStore store_;
  BundleList list_;
  CurrentBundle current_;
  std::string message_;
  bool offers_undo_ = false;
};

}  // namespace mes
