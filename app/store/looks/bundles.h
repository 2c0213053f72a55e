// SPDX-License-Identifier: GPL-3.0-or-later
// The user's bundles: a list with names, its own undo, and a file that outlives the window.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/layers/layer_stack.h"
#include "core/base/error.h"
#include "core/document/settings/bundle.h"
#include "core/io/bundle_file.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/file_lock.h"

namespace mes {

/// Guarantees: no two bundles share a name, and no name is empty; at least the last 50 changes can be undone. Cost:
/// O(bundles) per change. Threads: none.
class BundleList {
 public:
  explicit BundleList(std::vector<Bundle> bundles = {}) { replace(std::move(bundles)); }

  std::span<const Bundle> bundles() const { return bundles_; }
  const Bundle* find(std::string_view name) const;

  /// Appends a new name, or replaces the bundle of a known one. Error: the name is empty or too long.
  Expected<void> save(const std::string& name, LayerConfiguration layers);
  /// Error: the name is empty, too long or taken by another bundle.
  Expected<void> rename(std::size_t index, const std::string& name);
  /// Moves the bundle so that its index becomes `to`.
  void move(std::size_t index, std::size_t to);
  void remove(std::size_t index);
  /// Appends the bundles. A taken name gets a number; a bundle that exists already is skipped. Returns the names that
  /// the bundles have here, in their order.
  std::vector<std::string> import(std::span<const Bundle> bundles);
  /// Takes over another window's changes to the file, without undo: undoing changes made here does not revert them.
  void replace(std::vector<Bundle> bundles);

  /// The last change, e.g. "Deleted \"Crust\""; empty if there is nothing to undo.
  std::string undo_name() const { return steps_.empty() ? std::string() : steps_.back().name; }
  void undo();
  /// Grows with every change.
  std::uint64_t revision() const { return revision_; }

 private:
  struct Step {
    std::string name;
    std::vector<Bundle> before;
  };
  void begin_step(std::string name);

  std::vector<Bundle> bundles_;
  std::vector<Step> steps_;
  std::uint64_t revision_ = 0;
};

/// The name without the blanks around it. Error: it is empty, or longer than 200 bytes.
Expected<std::string> checked_bundle_name(std::string_view name);

/// Merges the changes that both lists made to `base`, in the order of `mine`. A bundle that one list changed and the
/// other removed stays. If two different bundles have one name, mine keeps it and the other gets a number.
std::vector<Bundle> merge_bundles(std::span<const Bundle> base, std::span<const Bundle> mine,
                                  std::span<const Bundle> theirs);

/// $XDG_DATA_HOME/mesecina/bundles.json; empty when no home folder is known.
std::filesystem::path default_bundles_path();

/// Every layer with its default style, for reading bundles.
std::vector<KnownLayer> known_layers(std::span<const LayerDescriptor> descriptors);

/// The bundles that come with the program, in the order of their file names.
struct StartingBundles {
  std::vector<Bundle> bundles;
  std::string message;  ///< one line for the user: the first file that could not be read; empty when all is well
};
StartingBundles read_starting_bundles(std::span<const LayerDescriptor> descriptors,
                                      const std::filesystem::path& assets);

/// The file of the bundles, shared by all running windows.
///
/// Guarantees: writing never loses what another window has written (merge_bundles), even at the same moment: each
/// window reads, merges and writes under the lock of the file, and starts again if the file has changed meanwhile. A
/// file that is broken or of a later version of the program is renamed and reported, never overwritten. Threads:
/// none; other processes may use the file at any time.
class BundleStore {
 public:
  BundleStore(std::span<const LayerDescriptor> descriptors, std::filesystem::path path,
              std::chrono::milliseconds patience = UpdateLock::kPatience)
      : descriptors_(descriptors), path_(std::move(path)), patience_(patience) {}

  /// Sets the layers that are known, whose default style is used where bundles have none.
  void set_descriptors(std::span<const LayerDescriptor> descriptors) { descriptors_ = descriptors; }

  struct Loaded {
    std::vector<Bundle> bundles;
    std::string message;  ///< one line for the user; empty when all is well
  };
  /// Loads the bundles of the file, or `starting` if there is no file.
  Loaded load(std::vector<Bundle> starting);
  /// Returns the bundles that are in the file now: more than `mine` if another window has added some.
  Expected<Loaded> write(std::span<const Bundle> mine);

 private:
  std::optional<std::vector<Bundle>> read(std::string& message);
  /// Leaves the file alone if it is not the expected one.
  Expected<Replaced> replace(const std::string& text, const std::optional<FileFingerprint>& expected) const;
  std::span<const LayerDescriptor> descriptors_;
  std::filesystem::path path_;
  std::chrono::milliseconds patience_;  // for the lock
  std::vector<Bundle> seen_;            // state when last read or written
};

/// The bundle that the layers were last taken from, and whether they have changed since.
class CurrentBundle {
 public:
  /// Shows these layers under the bundle's name.
  void choose(const std::string& name, const LayerConfiguration& as, LayerStack& layers);
  void choose(const Bundle& bundle, LayerStack& layers) { choose(bundle.name, bundle.layers, layers); }
  /// Notes that the layers have just been saved under this name.
  void note_saved(std::string name, const LayerStack& layers);
  void note_renamed(std::string name);
  /// Call it after any other change of the layers. Undo and redo return to the bundle that was chosen when the layers
  /// looked as they do now, as far as the last few choices reach.
  void follow(const LayerStack& layers);
  const std::string& name() const { return name_; }
  bool is_changed(const LayerStack& layers) const;

 private:
  /// The layers and the chosen name before or after a choice.
  struct Look {
    LayerConfiguration layers;
    std::string name;
    LayerConfiguration as_chosen;
  };
  void remember(const LayerStack& layers);

  std::string name_;  // empty: no bundle
  LayerConfiguration as_chosen_;
  std::vector<Look> looks_;  // the last few, newest last
  std::uint64_t followed_ = 0;
  mutable std::uint64_t compared_ = 0;  // revision of the layers for which `is_changed_` is valid
  mutable bool is_changed_ = false;
};

}  // namespace mes
