// SPDX-License-Identifier: GPL-3.0-or-later
// The options of frames and snapshots. Plain data, and the folders that follow from it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/color.h"
#include "core/base/error.h"

namespace mes {

struct RecordSettings {
  int width = 0;  ///< pixels; 0: the size of the canvas between the panels
  int height = 0;
  int supersampling = 1;            ///< 1, 2 or 4
  bool transparent = false;         ///< no background
  std::optional<Rgb> background{};  ///< nothing: that of the canvas
  bool with_panels = false;         ///< records the window as it is, and ignores the options above
  bool each_motion = false;         ///< one frame for each step of a pan or zoom, not only for its end
  double fps = 30.0;                ///< rate of the video, [1, 120]
  bool real_time = false;           ///< each frame of the video lasts as long as it did during recording
  bool with_source = true;          ///< snapshots carry the document, takes the session
  bool all_panes = true;            ///< frames, snapshots and copies show all panes if there are several
  std::string folder{};             ///< folder of takes and snapshots; empty: `takes_folder`
  friend bool operator==(const RecordSettings&, const RecordSettings&) = default;
};

inline constexpr int kLargestFrameSide = 16384;
inline constexpr int kMostFramePixels = 1 << 26;  // 256 MiB

/// Error: `usage` with the impossible option.
Expected<void> check(const RecordSettings& settings);

/// The desktop's folder for pictures (XDG_PICTURES_DIR of `user-dirs.dirs`), else the home folder; empty: no home.
std::filesystem::path pictures_folder();
/// The folder "mesecina" in it.
std::filesystem::path takes_folder();
/// The folder for takes and snapshots with these settings; empty: no home.
std::filesystem::path folder_of(const RecordSettings& settings);

}  // namespace mes
