// SPDX-License-Identifier: GPL-3.0-or-later
// The settings that the window remembers from one start to the next.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/tools/brush_settings.h"
#include "app/editing/tools/snap_settings.h"
#include "app/settings/figure_settings.h"
#include "app/settings/panel_choice.h"
#include "app/settings/record_settings.h"
#include "app/settings/scale_marks.h"
#include "core/base/color.h"
#include "core/base/error.h"

namespace mes {

enum class Theme : std::uint8_t { light, dark };

inline constexpr double kUsualColumnWidth = 300.0;
inline constexpr double kUsualLowerShare = 0.5;

/// Where the user has put the large window of a diagram, on the canvas.
struct DiagramPlace {
  std::optional<PaperPlace> at{};  ///< nothing: where it hides the least
  double width = 0.0;              ///< logical pixels, [0, 16384]
  double height = 0.0;
  friend bool operator==(const DiagramPlace&, const DiagramPlace&) = default;
};

struct Settings {
  std::vector<std::string> recent_files;        ///< absolute paths, newest first, at most kRecentFiles
  std::vector<std::string> recent_experiments;  ///< likewise, at most kRecentFiles
  std::string compiler;            ///< for experiments, with its first arguments; empty: $CXX, or an available one
  double spray_spacing_px = 12.0;  ///< logical pixels, [2, 100]
  BrushSettings brush{};
  double interface_scale = 1.0;  ///< enlarges the panels beyond the desktop's scale, [0.5, 4]
  Theme theme = Theme::light;
  bool for_projector = false;            ///< everything is larger, with the strongest contrast
  std::optional<Rgb> canvas_background;  ///< nothing: that of the theme
  int window_width = 1280;               ///< logical pixels
  int window_height = 800;
  PanelChoice panels;
  double column_width = kUsualColumnWidth;      ///< width of the panels on the right, logical pixels, [200, 1200]
  double lower_panel_share = kUsualLowerShare;  ///< share of their height for the lower of two, [0.1, 0.9]
  DiagramPlace diagram;                         ///< of the large window of a diagram
  std::vector<std::string> favorite_layers;     ///< ids
  std::vector<std::string> unfolded_layers{"Favourites", "Shown", "Delaunay & Voronoi"};  ///< sections of their list
  bool show_legend = true;  ///< legend of the colour maps in use
  bool show_key = false;    ///< key of all visible layers
  bool show_annotations = true;
  bool show_differences = false;        ///< marks elements that only some of the panes have
  std::optional<PaperPlace> legend_at;  ///< position to which it was dragged
  ScaleMarks marks{};                   ///< scale bar, axes and grid
  SnapSettings snap{};
  bool show_handles = true;             ///< handles of the frame around the selection
  bool show_insertion_preview = false;  ///< previews the changes by a sample at the pointer
  bool keep_degrees = false;            ///< for maps, which are projected otherwise
  bool show_evolution = false;
  bool classic_keys = false;  ///< the keys of the program of 2007
  std::string last_folder;    ///< last folder of the file browser
  RecordSettings record;
  FigureSettings figure;
};

inline constexpr std::size_t kRecentFiles = 12;

/// Puts the file first, and removes a duplicate further down.
void remember_file(Settings& settings, const std::filesystem::path& file);
void remember_experiment(Settings& settings, const std::filesystem::path& name);

/// $XDG_CONFIG_HOME/mesecina/settings.json, or ~/.config/mesecina/settings.json; empty when no home folder is known.
std::filesystem::path default_settings_path();

struct LoadedSettings {
  Settings settings;
  std::string message;  ///< one line for the user; empty when all is well
};

/// Never fails: a missing file gives the defaults; a broken one is renamed to `settings.json.broken`, with a message;
/// unknown keys are ignored, and values out of range are clamped.
LoadedSettings load_settings(const std::filesystem::path& path);

/// The settings to save if another window has saved `now` since this one began with `at_start`: each setting that was
/// changed here, else the one in `now`; recent files of both.
Settings merged(const Settings& ours, const Settings& at_start, const Settings& now);

/// Saves atomically; makes the folder if necessary.
Expected<void> save_settings(const Settings& settings, const std::filesystem::path& path);

}  // namespace mes
