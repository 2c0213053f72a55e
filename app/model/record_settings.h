// SPDX-License-Identifier: GPL-3.0-or-later
// How frames and snapshots are to be made. Plain data, and what follows from it.
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
  int width = 0;  ///< pixels; 0: as large as the canvas between the panels
  int height = 0;
  int supersampling = 1;            ///< 1, 2 or 4
  bool transparent = false;         ///< instead of the background
  std::optional<Rgb> background{};  ///< none: that of the canvas
  bool with_panels = false;         ///< the window as it is; what is above does not apply then
  bool each_motion = false;         ///< a frame of each step of a pan or zoom, not only where it ends
  double fps = 30.0;                ///< of the video, [1, 120]
  bool real_time = false;           ///< each frame of the video is seen as long as it was when recorded
  bool with_source = true;          ///< snapshots carry the document, takes the session
  bool all_panes = true;            ///< frames, snapshots and copies show all panes, where there are several
  std::string folder{};             ///< where takes and snapshots go; empty: `takes_folder`
  friend bool operator==(const RecordSettings&, const RecordSettings&) = default;
};

inline constexpr int kLargestFrameSide = 16384;
inline constexpr int kMostFramePixels = 1 << 26;  // 256 MiB

/// Error: `usage`, what is impossible about it.
Expected<void> check(const RecordSettings& settings);

/// Part of a window in pixels from its upper left corner.
struct WindowPart {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  friend bool operator==(const WindowPart&, const WindowPart&) = default;
};
/// What the panels leave free; all of the window where they leave hardly anything.
WindowPart part_between(const Insets& panels, int width, int height);

/// What a picture shows of a window's view: all of the part, in the same middle, lines and points as much larger as
/// the rest.
struct FrameView {
  render::Camera camera;
  double content_scale = 1.0;
};
FrameView frame_view(const render::Camera& window, const WindowPart& part, double content_scale,
                     const RecordSettings& settings);

/// The desktop's folder for pictures (XDG_PICTURES_DIR of `user-dirs.dirs`), else the home folder; empty: no home.
std::filesystem::path pictures_folder();
/// "mesecina" in it.
std::filesystem::path takes_folder();
/// Where takes and snapshots of these settings go; empty: no home.
std::filesystem::path folder_of(const RecordSettings& settings);

}  // namespace mes
