// SPDX-License-Identifier: GPL-3.0-or-later
// The bundles as the window uses them: list, file and layers kept together.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/store/bundles.h"

namespace mes {

/// What it guarantees: every change is in the file when the call returns, together with what other windows wrote
/// there; a change that cannot be written stays in the list and is an error.
///
/// Smallest use:
///     desk.choose(0);
///     if (auto saved = desk.save("Lecture 3"); !saved) report(saved.error());
///
/// Cost: a change writes a small file. Threads: the window's.
class BundleDesk {
 public:
  BundleDesk(std::filesystem::path file, const std::filesystem::path& assets, LayerStack& layers);

  std::span<const Bundle> bundles() const { return list_.bundles(); }
  /// The one that was chosen last, if it is still there.
  std::optional<std::size_t> current() const;
  bool is_changed() const { return current_.is_changed(layers_); }
  bool has(std::string_view name) const { return list_.find(name) != nullptr; }
  /// What was wrong with the file at the start or is since; once.
  std::string take_message() { return std::exchange(message_, {}); }

  void choose(std::size_t index) { choose(index, list_.bundles()[index].layers); }
  /// Shows these layers in its place, as for another family of balls.
  void choose(std::size_t index, const LayerConfiguration& as);
  /// To be called when the layers may have changed otherwise, as by undo.
  void follow_layers() { current_.follow(layers_); }
  /// Calls a function that replaces all layers by those of another registry. A bundle that is shown as it was saved stays
  /// the shown one.
  void replace_layers(const std::function<void()>& replace);
  /// The layers as they are, under a new name or over the bundle of that name.
  Expected<void> save(const std::string& name);
  Expected<void> rename(std::size_t index, const std::string& name);
  Expected<void> move(std::size_t index, std::size_t to);
  Expected<void> remove(std::size_t index);

  /// Takes all bundles of the file and shows the first. A remark on it, one line.
  Expected<std::string> import(const std::filesystem::path& file);
  /// Brings back those that come with the program, where they are missing.
  Expected<void> add_starting_set();
  /// One, or all. Error: `cannot_write`.
  Expected<void> export_to(const std::filesystem::path& file, std::optional<std::size_t> index) const;

  /// What the last change did, until a bundle is chosen; empty: nothing to offer.
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
