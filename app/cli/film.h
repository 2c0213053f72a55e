// SPDX-License-Identifier: GPL-3.0-or-later
// Makes frames and a video of a session.
#pragma once

#include <string>

#include "app/settings/scale_marks.h"
#include "core/base/error.h"
#include "core/io/session/session.h"

namespace mes {
class Registry;
}  // namespace mes

namespace mes::cli {

struct FilmRequest {
  std::string frames;  ///< folder; empty: only the video
  std::string video;   ///< .mp4 or .webm; empty: only the frames
  std::string size = "1280x720";
  std::string fps = "12";
  bool with_legend = true;  ///< if a colour map is used
  bool with_key = false;
  ScaleMarks marks{};
  bool with_annotations = true;
  bool with_source = true;  ///< the manifest of the frames holds the session
  std::string title;        ///< above the drawing; empty: no title
  std::string shard;        ///< "3/16": every 16th frame beginning with the 3rd; empty: all
};

/// Rejects invalid options, and a video that cannot be made or written, before the work begins.
Expected<void> check(const FilmRequest& request);

/// Error: `cannot_write` also if the folder has such frames already. `name` stands for the session in messages.
Expected<void> make_film(const Registry& registry, const Session& session, const std::string& name,
                         const FilmRequest& request);

}  // namespace mes::cli
