// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/video.h"

#include <fmt/core.h>
#include <string>
#include <system_error>
#include <vector>

#include "app/recording/take.h"
#include "app/system/child_process.h"
#include "core/io/atomic_file.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

std::unexpected<Error> failed(std::string text, const fs::path& file) {
  return std::unexpected(Error{ErrorCode::cannot_write, std::move(text), file.string()});
}

// `part` is where the bytes go; the kind of video is by the name of `output`.
std::vector<std::string> arguments(double fps, std::size_t frames, const fs::path& output, const fs::path& part) {
  const bool is_webm = output.extension() == ".webm";
  std::vector<std::string> out{"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y", "-framerate",
                               fmt::format("{:g}", fps), "-start_number", "1", "-i", "%05d.png",
                               // Players want even sides; without the ground, what is transparent would be black.
                               "-filter_complex",
                               "[0]format=rgba,pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white@0,split[a][b];"
                               "[a]lutrgb=r=255:g=255:b=255:a=255[ground];[ground][b]overlay=format=auto",
                               "-frames:v", std::to_string(frames), "-pix_fmt", "yuv420p", "-c:v"};
  const auto add = [&out](std::initializer_list<const char*> words) {
    out.insert(out.end(), words.begin(), words.end());
  };
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

Expected<void> check_video(const fs::path& output) {
  if (!has_video_maker()) return failed("a video needs the program ffmpeg, which is not on the PATH", output);
  const auto writing = OutsideWriting::begin(output);
  if (!writing) return std::unexpected(writing.error());
  return {};
}

Expected<void> make_video(const fs::path& take, double fps, const fs::path& output, const std::stop_token& stop) {
  if (!has_video_maker())
    return failed("a video needs the program ffmpeg, which is not on the PATH; the frames stay as they are", output);
  const auto manifest = read_take(take);
  if (!manifest) return std::unexpected(manifest.error());
  auto writing = OutsideWriting::begin(output);
  if (!writing) return std::unexpected(writing.error());
  std::error_code error;
  const fs::path part = fs::absolute(writing->part(), error);
  ChildProcess child;
  if (const int reason = child.start(arguments(fps, manifest->frames.size(), output, part), take); reason != 0)
    return failed("ffmpeg cannot be run: " + std::generic_category().message(reason), output);
  const bool is_done = child.wait(stop);
  if (stop.stop_requested()) return std::unexpected(Error{ErrorCode::cancelled, "the video was cancelled"});
  if (!is_done) return failed("ffmpeg could not make the video: " + child.complaint(), output);
  return writing->finish();
}

void VideoJob::start(fs::path take, double fps, fs::path output) {
  output_ = std::move(output);
  stop_ = {};
  result_ = std::async(std::launch::async,
                       [take = std::move(take), fps, output = output_, stop = stop_.get_token(), wake = wake_] {
                         auto done = make_video(take, fps, output, stop);
                         wake();
                         return done;
                       });
}

std::optional<Expected<void>> VideoJob::take_result() {
  if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return result_.get();
}

}  // namespace mes
