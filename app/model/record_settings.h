// SPDX-License-Identifier: GPL-3.0-or-later
// The options of frames and snapshots. Plain data, and values derived from it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/model/view_motion.h"
#include "core/base/color.h"
#include "core/base/error.h"
#include "render/camera.h"

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

/// A part of a window, in pixels from its upper left corner.
struct WindowPart {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  friend bool operator==(const WindowPart&, const WindowPart&) = default;
};
/// The area that the panels leave free; the whole window if that is hardly anything.
WindowPart part_between(const Insets& panels, int width, int height);

/// The picture's view of a window's view: the whole part around the same middle, with lines and points enlarged like
/// the rest.
struct FrameView {
  render::Camera camera;
  double content_scale = 1.0;
};
FrameView frame_view(const render::Camera& window, const WindowPart& part, double content_scale,
                     const RecordSettings& settings);

/// The desktop's folder for pictures (XDG_PICTURES_DIR of `user-dirs.dirs`), else the home folder; empty: no home.
std::filesystem::path pictures_folder();
/// The folder "mesecina" in it.
std::filesystem::path takes_folder();
/// The folder for takes and snapshots with these settings; empty: no home.
std::filesystem::path folder_of(const RecordSettings& settings);

}  // namespace mes
