// SPDX-License-Identifier: GPL-3.0-or-later
// A session as frames and as a video.
#pragma once

#include <string>

#include "app/model/scale_marks.h"
#include "core/base/error.h"
#include "core/io/session.h"

namespace mes {
class FrameWriter;
class Registry;
}  // namespace mes

namespace mes::cli {

struct FilmRequest {
  std::string frames;  ///< folder; empty: only the video
  std::string video;   ///< .mp4 or .webm; empty: only the frames
  std::string size = "1280x720";
  std::string fps = "12";
  bool with_legend = true;  ///< where a colour map is used
  bool with_key = false;
  ScaleMarks marks{};
  bool with_annotations = true;
  bool with_source = true;  ///< the manifest of the frames holds the session
  std::string title;        ///< above the drawing; empty: none
  std::string shard;        ///< "3/16": every 16th frame beginning with the 3rd; empty: all
};

/// Words that make no sense, and a video that cannot be made or written, before any work is done.
Expected<void> check(const FilmRequest& request);

/// Error: `cannot_write` also when the folder has such frames already. `name` stands for the session in messages.
Expected<void> make_film(const Registry& registry, const Session& session, const std::string& name,
                         const FilmRequest& request);

/// The manifest of the frames holds the session, without the folders of its author. Says when it is too long for that.
void carry(FrameWriter& writer, const Session& session);

}  // namespace mes::cli
