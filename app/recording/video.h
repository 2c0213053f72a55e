// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a video of a take with ffmpeg, if it is installed.
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

/// The duration of frames: all equal, or as long as they were seen during the recording. A take without times has a
/// steady pace.
enum class VideoPace : std::uint8_t { steady, real_time };
struct VideoTiming {
  VideoPace pace = VideoPace::steady;
  /// The duration of the last frame in real time, which a take does not know; nothing: one second.
  std::optional<double> last_seconds{};
};

/// True if ffmpeg is on the PATH.
bool has_video_maker();

/// Checks that a video of this name can be made: ffmpeg exists, and the file can be written. Creates a file beside it
/// and removes it again.
Expected<void> check_video(const std::filesystem::path& output);

/// Makes frames 1, 2, ... of the folder an MP4 (H.264), or a WebM (VP9) if the name says so; transparent pixels
/// become white. The file appears complete or not at all, and replaces one of the same name; if that is a link, the
/// linked file. Waits for the child process, which is ended when a stop is requested (error `cancelled`). Threads:
/// any.
Expected<void> make_video(const std::filesystem::path& take, double fps, const std::filesystem::path& output,
                          const std::stop_token& stop = {}, const VideoTiming& timing = {});
/// True if the name of a video ends in .mp4 or .webm.
bool is_video_name(const std::filesystem::path& output);

/// Makes a video beside the window. Threads: one; `wake` is called from another when it is done.
class VideoJob {
 public:
  explicit VideoJob(std::function<void()> wake) : job_(std::move(wake)) {}
  ~VideoJob() { cancel(); }
  VideoJob(const VideoJob&) = delete;
  VideoJob& operator=(const VideoJob&) = delete;

  /// Starts a video; call it only while none is being made.
  void start(std::filesystem::path take, double fps, std::filesystem::path output,
             VideoPace pace = VideoPace::steady);
  void cancel() { stop_.request_stop(); }
  bool is_running() const { return job_.is_under_way(); }
  const std::filesystem::path& output() const { return output_; }
  /// The result, given once.
  std::optional<Expected<void>> take_result() { return job_.poll(); }

 private:
  std::filesystem::path output_;
  std::stop_source stop_;  // a cancelled video has a result too
  BackgroundJob<Expected<void>> job_;
};

}  // namespace mes
