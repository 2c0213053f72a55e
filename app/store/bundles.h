// SPDX-License-Identifier: GPL-3.0-or-later
// The bundles of the user: a list with names, an undo of its own, and a file that outlives the window.
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
#include "core/document/bundle.h"
#include "core/io/atomic_file.h"
#include "core/io/bundle_file.h"
#include "core/io/file_lock.h"

namespace mes {

/// What it guarantees: no two bundles have one name, none has an empty one; every change can be undone, the last 50
/// of them at least. Cost: O(bundles) a change. Threads: none.
class BundleList {
 public:
  explicit BundleList(std::vector<Bundle> bundles = {}) { replace(std::move(bundles)); }

  std::span<const Bundle> bundles() const { return bundles_; }
  const Bundle* find(std::string_view name) const;

  /// Under a new name at the end, under a known one in its place. Error: the name is empty or too long.
  Expected<void> save(const std::string& name, LayerConfiguration layers);
  /// Error: the name is empty, too long or another bundle's.
  Expected<void> rename(std::size_t index, const std::string& name);
  /// So that the bundle stands at place `to` afterwards.
  void move(std::size_t index, std::size_t to);
  void remove(std::size_t index);
  /// At the end; a name that is taken gets a number, a bundle that is here already is skipped. The names under which
  /// they are here now, in their order.
  std::vector<std::string> import(std::span<const Bundle> bundles);
  /// Without undo: what another window did to the file. Undoing what was done here does not undo that either.
  void replace(std::vector<Bundle> bundles);

  /// What the last change did, "Deleted \"Crust\""; empty: nothing to undo.
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

/// "the bundle", without the blanks around it. Error: empty, or longer than 200 bytes.
Expected<std::string> checked_bundle_name(std::string_view name);

/// What both made of `base`: additions, changes and removals of either, in the order of `mine`. What one changed and
/// the other removed stays; of two different bundles of one name, mine keeps it and the other gets a number.
std::vector<Bundle> merge_bundles(std::span<const Bundle> base, std::span<const Bundle> mine,
                                  std::span<const Bundle> theirs);

/// $XDG_DATA_HOME/mesecina/bundles.json; empty when no home folder is known.
std::filesystem::path default_bundles_path();

/// Every layer with its default style, for reading bundles.
std::vector<KnownLayer> known_layers(std::span<const LayerDescriptor> descriptors);

/// Those that come with the program, in the order of their file names.
struct StartingBundles {
  std::vector<Bundle> bundles;
  std::string message;  ///< for the user, one line: the first file that could not be read; empty when all is well
};
StartingBundles read_starting_bundles(std::span<const LayerDescriptor> descriptors,
                                      const std::filesystem::path& assets);

/// The file of the bundles, shared by every running window.
///
/// What it guarantees: writing never loses what another window wrote since (merge_bundles), also where several write at
/// the same moment: each reads, merges and writes under the lock of the file, and again where the file is another one by
/// then. A file that is broken or of a later version of the program is renamed and reported, never
/// overwritten. Threads: none; other processes may use the file at any time.
class BundleStore {
 public:
  BundleStore(std::span<const LayerDescriptor> descriptors, std::filesystem::path path,
              std::chrono::milliseconds patience = UpdateLock::kPatience)
      : descriptors_(descriptors), path_(std::move(path)), patience_(patience) {}

  /// Layers that bundles may leave the style of.
  void set_descriptors(std::span<const LayerDescriptor> descriptors) { descriptors_ = descriptors; }

  struct Loaded {
    std::vector<Bundle> bundles;
    std::string message;  ///< for the user, one line; empty when all is well
  };
  /// Those of the file, or `starting` without one.
  Loaded load(std::vector<Bundle> starting);
  /// Gives what is in the file now, which is more than `mine` when another window has been busy.
  Expected<Loaded> write(std::span<const Bundle> mine);

 private:
  std::optional<std::vector<Bundle>> read(std::string& message);
  /// Leaves a file that is not the one expected alone.
  Expected<Replaced> replace(const std::string& text, const std::optional<FileFingerprint>& expected) const;
  std::span<const LayerDescriptor> descriptors_;
  std::filesystem::path path_;
  std::chrono::milliseconds patience_;  // for the lock
  std::vector<Bundle> seen_;            // as last read or written
};

/// Which bundle the layers were last taken from, and whether they are still as it has them.
class CurrentBundle {
 public:
  /// Shows these layers in the name of the bundle.
  void choose(const std::string& name, const LayerConfiguration& as, LayerStack& layers);
  void choose(const Bundle& bundle, LayerStack& layers) { choose(bundle.name, bundle.layers, layers); }
  /// The layers have just been saved under this name.
  void note_saved(std::string name, const LayerStack& layers);
  void note_renamed(std::string name);
  /// To be called when the layers have changed otherwise: undo and redo lead back to the bundle that was chosen when
  /// the layers looked as they do now, as far as the last few choices go.
  void follow(const LayerStack& layers);
  const std::string& name() const { return name_; }
  bool is_changed(const LayerStack& layers) const;

 private:
  /// Before and after a choice.
  struct Look {
    LayerConfiguration layers;
    std::string name;
    LayerConfiguration as_chosen;
  };
  void remember(const LayerStack& layers);

  std::string name_;  // empty: none
  LayerConfiguration as_chosen_;
  std::vector<Look> looks_;  // the last few, newest last
  std::uint64_t followed_ = 0;
  mutable std::uint64_t compared_ = 0;  // revision of the layers for which the next one is true
  mutable bool is_changed_ = false;
};

}  // namespace mes
