// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/video.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "app/recording/take.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr auto kLookInterval = std::chrono::milliseconds(30);
constexpr auto kPatience = std::chrono::seconds(3);  // for a child that was asked to end

std::unexpected<Error> failed(std::string text, const fs::path& file) {
  return std::unexpected(Error{ErrorCode::cannot_write, std::move(text), file.string()});
}

std::vector<std::string> arguments(double fps, std::size_t frames, const fs::path& output) {
  std::array<char, 32> rate{};
  std::snprintf(rate.data(), rate.size(), "%g", fps);
  const bool is_webm = output.extension() == ".webm";
  std::vector<std::string> out{"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y", "-framerate",
                               rate.data(), "-start_number", "1", "-i", "%05d.png",
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
  out.push_back("file:" + output.string());
  return out;
}

/// A child in its own folder with its errors in a file without a name. Signals are at their defaults there.
class ChildProcess {
 public:
  ~ChildProcess() {
    if (errors_ != nullptr) std::fclose(errors_);
  }
  /// 0 or the reason.
  int start(const std::vector<std::string>& words, const fs::path& folder) {
    errors_ = std::tmpfile();
    if (errors_ == nullptr) return errno;
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, ::fileno(errors_), STDERR_FILENO);
    ::posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
    sigset_t none;
    sigset_t usual;
    sigemptyset(&none);
    sigemptyset(&usual);
    for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&usual, signal);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &usual);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    const int reason = ::posix_spawnp(&pid_, pointers[0], &files, &attributes, pointers.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
    return reason;
  }
  /// Whether it ended well.
  bool wait(const std::stop_token& stop) {
    int status = 0;
    std::chrono::steady_clock::time_point asked{};
    while (::waitpid(pid_, &status, WNOHANG) == 0) {
      const auto now = std::chrono::steady_clock::now();
      if (stop.stop_requested() && asked.time_since_epoch().count() == 0) {
        ::kill(pid_, SIGTERM);
        asked = now;
      } else if (asked.time_since_epoch().count() != 0 && now - asked > kPatience) {
        ::kill(pid_, SIGKILL);
      }
      std::this_thread::sleep_for(kLookInterval);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  /// The last printable line it complained with.
  std::string complaint() {
    std::rewind(errors_);
    std::string last;
    std::array<char, 512> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), errors_) != nullptr) {
      std::string text;
      for (const char c : std::string_view(line.data()))
        if (c >= ' ' && c <= '~') text += c;
      if (!text.empty()) last = text;
    }
    return last;
  }

 private:
  pid_t pid_ = -1;
  std::FILE* errors_ = nullptr;
};

}  // namespace

bool has_video_maker() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path != nullptr ? path : "";
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    if (!folder.empty() && ::access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return true;
  }
  return false;
}

Expected<void> make_video(const fs::path& take, double fps, const fs::path& output, const std::stop_token& stop) {
  if (!has_video_maker())
    return failed("a video needs the program ffmpeg, which is not on the PATH; the frames stay as they are", output);
  const auto manifest = read_take(take);
  if (!manifest) return std::unexpected(manifest.error());
  std::error_code error;
  const fs::path target = fs::absolute(output, error);
  const fs::path partial =
      target.parent_path() / (".mesecina-" + std::to_string(::getpid()) + "-video" + target.extension().string());
  ChildProcess child;
  if (const int reason = child.start(arguments(fps, manifest->frames.size(), partial), take); reason != 0)
    return failed("ffmpeg cannot be run: " + std::generic_category().message(reason), output);
  const bool is_done = child.wait(stop);
  if (stop.stop_requested() || !is_done) {
    fs::remove(partial, error);
    if (stop.stop_requested()) return std::unexpected(Error{ErrorCode::cancelled, "the video was cancelled"});
    return failed("ffmpeg could not make the video: " + child.complaint(), output);
  }
  fs::rename(partial, target, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(partial, error);
    return failed("cannot be written: " + why, output);
  }
  return {};
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
