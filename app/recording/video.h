// SPDX-License-Identifier: GPL-3.0-or-later
// A video of a take, made by the program ffmpeg if there is one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

#include "app/system/background_job.h"
#include "core/base/error.h"

namespace mes {

/// How long each frame is seen: all equally long, or as long as it was seen when it was recorded. A take without times
/// has a steady pace.
enum class VideoPace : std::uint8_t { steady, real_time };
struct VideoTiming {
  VideoPace pace = VideoPace::steady;
  /// In real time: how long the last frame is seen, which a take does not know; nothing: a second.
  std::optional<double> last_seconds{};
};

/// Whether ffmpeg is on the PATH.
bool has_video_maker();

/// Whether a video of this name can be made: the program is there, and the file can be written. A file beside it is
/// made and removed again.
Expected<void> check_video(const std::filesystem::path& output);

/// Frames 1, 2, ... of the folder as an MP4 (H.264), or a WebM (VP9) if the name says so; what is transparent becomes
/// white. The file appears complete or not at all, and replaces one of the same name; if that is a link, the file it
/// leads to. Waits for the child process, which is ended when a stop is requested (error `cancelled`). Any thread.
Expected<void> make_video(const std::filesystem::path& take, double fps, const std::filesystem::path& output,
                          const std::stop_token& stop = {}, const VideoTiming& timing = {});
/// Whether the name of a video ends in .mp4 or .webm.
bool is_video_name(const std::filesystem::path& output);

/// The same beside the window. Threads: one; `wake` is called from another when it is done.
class VideoJob {
 public:
  explicit VideoJob(std::function<void()> wake) : job_(std::move(wake)) {}
  ~VideoJob() { cancel(); }
  VideoJob(const VideoJob&) = delete;
  VideoJob& operator=(const VideoJob&) = delete;

  /// Not while one is being made.
  void start(std::filesystem::path take, double fps, std::filesystem::path output,
             VideoPace pace = VideoPace::steady);
  void cancel() { stop_.request_stop(); }
  bool is_running() const { return job_.is_under_way(); }
  const std::filesystem::path& output() const { return output_; }
  /// The result, once, when there is one.
  std::optional<Expected<void>> take_result() { return job_.poll(); }

 private:
  std::filesystem::path output_;
  std::stop_source stop_;  // a video that is cancelled has a result too
  BackgroundJob<Expected<void>> job_;
};

}  // namespace mes
