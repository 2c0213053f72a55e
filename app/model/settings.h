// SPDX-License-Identifier: GPL-3.0-or-later
// What the window remembers from one start to the next.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/brush_settings.h"
#include "app/editing/snap_settings.h"
#include "app/model/figure_settings.h"
#include "app/model/record_settings.h"
#include "app/model/scale_marks.h"
#include "core/base/color.h"
#include "core/base/error.h"

namespace mes {

/// What the lower right panel shows.
enum class DetailsPage : std::uint8_t {
  none,
  statistics,
  parameters,
  log,
  lesson,
  selection,
  curves,
  branches,
  persistence,
  sampling,
  experiments
};

enum class Theme : std::uint8_t { light, dark };

inline constexpr double kUsualColumnWidth = 300.0;
inline constexpr double kUsualDetailsShare = 0.4;

struct Settings {
  std::vector<std::string> recent_files;        ///< absolute paths, newest first, at most kRecentFiles
  std::vector<std::string> recent_experiments;  ///< likewise, at most kRecentFiles
  std::string compiler;            ///< of experiments, with its first words; empty: $CXX, or what there is
  double spray_spacing_px = 12.0;  ///< logical pixels, [2, 100]
  BrushSettings brush{};
  double interface_scale = 1.0;  ///< enlarges the panels beyond what the desktop asks, [0.5, 4]
  Theme theme = Theme::light;
  bool for_projector = false;            ///< everything larger, with the strongest contrast
  std::optional<Rgb> canvas_background;  ///< none: what goes with the theme
  int window_width = 1280;               ///< logical pixels
  int window_height = 800;
  bool show_layers = true;
  bool show_bundles = true;  ///< unfolded, above the layers
  DetailsPage details = DetailsPage::none;
  double column_width = kUsualColumnWidth;    ///< of the panels on the right, logical pixels, [200, 1200]
  double details_share = kUsualDetailsShare;  ///< of the height of that column, for the lower panel, [0.1, 0.9]
  double bundles_height = 0.0;                ///< logical pixels, [0, 4000]; 0: what they need
  bool show_legend = true;                    ///< of the colour maps in use
  bool show_key = false;                      ///< of all visible layers
  bool show_annotations = true;
  bool show_differences = false;        ///< of panes: what only some of them have is marked
  std::optional<PaperPlace> legend_at;  ///< where it was dragged to
  ScaleMarks marks{};                   ///< scale bar, axes and grid
  SnapSettings snap{};
  bool show_handles = true;             ///< of the frame around what is selected
  bool show_insertion_preview = false;  ///< what a sample at the cursor would change
  bool keep_degrees = false;            ///< of maps, which are projected otherwise
  bool show_evolution = false;
  bool classic_keys = false;  ///< those of the program of 2007
  std::string last_folder;    ///< of the file browser
  RecordSettings record;
  FigureSettings figure;
};

inline constexpr std::size_t kRecentFiles = 12;

/// Puts the file first, without a twin further down.
void remember_file(Settings& settings, const std::filesystem::path& file);
void remember_experiment(Settings& settings, const std::filesystem::path& name);

/// $XDG_CONFIG_HOME/mesecina/settings.json, or ~/.config/mesecina/settings.json; empty when no home folder is known.
std::filesystem::path default_settings_path();

struct LoadedSettings {
  Settings settings;
  std::string message;  ///< for the user, one line; empty when all is well
};

/// Never fails: a missing file gives the defaults; one that is broken is renamed to `settings.json.broken`, with a
/// message; unknown keys are ignored and values out of range are brought into it.
LoadedSettings load_settings(const std::filesystem::path& path);

/// What to save when another window has saved `now` since this one began with `at_start`: of each setting what was
/// changed here, or else what stands there; recent files of both.
Settings merged(const Settings& ours, const Settings& at_start, const Settings& now);

/// Atomic; makes the folder if need be.
Expected<void> save_settings(const Settings& settings, const std::filesystem::path& path);

}  // namespace mes
