// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/video.h"

#include <fmt/core.h>
#include <algorithm>
#include <fstream>
#include <iomanip>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "app/recording/take.h"
#include "app/system/child_process.h"
#include "core/io/files/atomic_file.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

std::unexpected<Error> failed(std::string text, const fs::path& file) {
  return std::unexpected(Error{ErrorCode::cannot_write, std::move(text), file.string()});
}

/// The list of frames and their durations in the format of ffmpeg. The destructor removes the file.
class TimedFrames {
 public:
  static constexpr const char* kName = "frames.ffconcat";

  TimedFrames(const fs::path& take, double fps, std::span<const FrameInfo> frames, double last)
      : file_(take / kName) {
    std::ofstream out(file_);
    out << "ffconcat version 1.0\n" << std::fixed << std::setprecision(6);
    const double least = 1.0 / fps;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const bool is_last = i + 1 == frames.size();
      const double seen = std::max(least, is_last ? last : frames[i + 1].seconds - frames[i].seconds);
      out << "file " << frame_name(i + 1) << "\nduration " << seen << '\n';
      seconds_ += seen;
    }
    is_written_ = static_cast<bool>(out.flush());
  }
  ~TimedFrames() {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }
  TimedFrames(const TimedFrames&) = delete;
  TimedFrames& operator=(const TimedFrames&) = delete;
  bool is_written() const { return is_written_; }
  /// Duration of all frames.
  double seconds() const { return seconds_; }

 private:
  fs::path file_;
  double seconds_ = 0.0;
  bool is_written_ = false;
};

bool has_times(std::span<const FrameInfo> frames) {
  return frames.size() > 1 && frames.back().seconds > frames.front().seconds;
}

// The arguments of ffmpeg. It writes to `part`, and the name of `output` selects the kind of video. `seconds`:
// duration with the times of the frames; 0: a steady pace.
std::vector<std::string> arguments(double fps, std::size_t frames, const fs::path& output, const fs::path& part,
                                   double seconds) {
  const std::string rate = fmt::format("{:g}", fps);
  const bool is_webm = output.extension() == ".webm";
  std::vector<std::string> out{"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y"};
  const auto add = [&out](std::initializer_list<const char*> words) {
    out.insert(out.end(), words.begin(), words.end());
  };
  const bool is_timed = seconds > 0.0;
  if (is_timed)
    add({"-f", "concat", "-i", TimedFrames::kName});
  else
    add({"-framerate", rate.data(), "-start_number", "1", "-i", "%05d.png"});
  // Repeats a frame until the next one, and the last one until the end, which ffmpeg does not do by itself.
  const std::string paced =
      is_timed ? "[0]fps=" + rate + ",tpad=stop=-1:stop_mode=clone,format=rgba" : "[0]format=rgba";
  // Players need even sides; without the white ground, transparent pixels would be black.
  const std::string filter = paced +
                             ",pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white@0,split[a][b];"
                             "[a]lutrgb=r=255:g=255:b=255:a=255[ground];[ground][b]overlay=format=auto";
  add({"-filter_complex", filter.c_str()});
  if (is_timed)
    add({"-t", fmt::format("{:.6f}", seconds).c_str()});
  else
    add({"-frames:v", std::to_string(frames).c_str()});
  add({"-pix_fmt", "yuv420p", "-c:v"});
  if (is_webm)
    add({"libvpx-vp9", "-crf", "24", "-b:v", "0", "-f", "webm"});
  else
    add({"libx264", "-crf", "16", "-movflags", "+faststart", "-f", "mp4"});
  out.push_back("file:" + part.string());
  return out;
}

}  // namespace

bool has_video_maker() {
  return is_program_on_path("ffmpeg");
}

bool is_video_name(const fs::path& output) {
  return output.extension() == ".mp4" || output.extension() == ".webm";
}

Expected<void> check_video(const fs::path& output) {
  if (!has_video_maker()) return failed("a video needs the program ffmpeg, which is not on the PATH", output);
  const auto writing = OutsideWriting::begin(output);
  if (!writing) return std::unexpected(writing.error());
  return {};
}

Expected<void> make_video(const fs::path& take, double fps, const fs::path& output, const std::stop_token& stop,
                          const VideoTiming& timing) {
  if (!has_video_maker())
    return failed("a video needs the program ffmpeg, which is not on the PATH; the frames stay as they are", output);
  const auto manifest = read_take(take);
  if (!manifest) return std::unexpected(manifest.error());
  auto writing = OutsideWriting::begin(output);
  if (!writing) return std::unexpected(writing.error());
  std::error_code error;
  const fs::path part = fs::absolute(writing->part(), error);
  std::optional<TimedFrames> timed;
  constexpr double kLast = 1.0;  // seconds
  if (timing.pace == VideoPace::real_time && (has_times(manifest->frames) || timing.last_seconds))
    timed.emplace(take, fps, manifest->frames, timing.last_seconds.value_or(kLast));
  if (timed && !timed->is_written()) return failed("the times of the frames cannot be written", take);
  const double seconds = timed ? timed->seconds() : 0.0;
  ChildProcess child;
  if (const int reason = child.start(arguments(fps, manifest->frames.size(), output, part, seconds), take);
      reason != 0)
    return failed("ffmpeg cannot be run: " + std::generic_category().message(reason), output);
  const bool is_done = child.wait(stop);
  if (stop.stop_requested()) return std::unexpected(Error{ErrorCode::cancelled, "the video was cancelled"});
  if (!is_done) return failed("ffmpeg could not make the video: " + child.complaint(), output);
  return writing->finish();
}

void VideoJob::start(fs::path take, double fps, fs::path output, VideoPace pace) {
  output_ = std::move(output);
  stop_ = {};
  job_.begin([take = std::move(take), fps, output = output_, stop = stop_.get_token(), pace](const std::stop_token&) {
    return make_video(take, fps, output, stop, {.pace = pace});
  });
}

}  // namespace mes
