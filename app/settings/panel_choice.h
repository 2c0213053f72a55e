// SPDX-License-Identifier: GPL-3.0-or-later
// Which panels the column at the right shows: one, or two of which the pinned one is above.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mes {

/// The panels, in the order of the rail.
enum class PanelPage : std::uint8_t {
  layers,
  bundles,
  selection,
  curves,
  sampling,
  branches,
  persistence,
  statistics,
  parameters,
  experiments,
  lesson,
  log
};
inline constexpr std::size_t kPanelPages = static_cast<std::size_t>(PanelPage::log) + 1;

/// The name of a panel in the file of settings.
std::string_view id_of(PanelPage page);
std::optional<PanelPage> find_panel(std::string_view id);

/// Guarantees: at most two panels are open, the pinned one above. A panel that opens takes the place of those that are
/// not pinned. Where only one has room, the one that was opened last is shown, and the other returns with the room.
/// Where none has room, all are hidden until one is opened, which is then shown alone. Threads: none.
class PanelChoice {
 public:
  PanelChoice() = default;
  /// At most two of the pages, each once; a third one is dropped.
  PanelChoice(std::span<const PanelPage> open, std::optional<PanelPage> pinned);

  /// The open panels, from top to bottom, with or without room.
  std::span<const PanelPage> all() const { return open_; }
  /// Those of them that have room.
  std::span<const PanelPage> shown() const;
  bool is_shown(PanelPage page) const;
  void open(PanelPage page);
  void close(PanelPage page);
  /// Closes the panel if it is shown, and shows it otherwise.
  void toggle(PanelPage page);

  std::optional<PanelPage> pinned() const { return pinned_; }
  /// Pins the panel in place of another one, or unpins it.
  void toggle_pin(PanelPage page);

  /// The panel whose diagram is also shown large, in a window over the canvas.
  std::optional<PanelPage> large() const { return large_; }
  void set_large(std::optional<PanelPage> page) { large_ = page; }
  /// True if the panel or its large diagram is shown.
  bool is_in_use(PanelPage page) const { return large_ == page || is_shown(page); }

  /// Sets how many panels have room: 0, 1 or 2.
  void set_room(std::size_t panels);

  /// Compares what the settings remember.
  friend bool operator==(const PanelChoice& a, const PanelChoice& b) {
    return a.open_ == b.open_ && a.pinned_ == b.pinned_;
  }

 private:
  void lift_pinned();

  std::vector<PanelPage> open_{PanelPage::layers, PanelPage::bundles};
  std::optional<PanelPage> pinned_ = PanelPage::layers;
  PanelPage last_ = PanelPage::layers;  // the open panel that was opened last
  std::optional<PanelPage> large_;
  std::size_t room_ = 2;
  bool is_wanted_without_room_ = false;  // the last one was opened where no panel has room
};

}  // namespace mes
