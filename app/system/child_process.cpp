// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <thread>

namespace mes {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kLookInterval = std::chrono::milliseconds(30);
constexpr auto kKillInterval = std::chrono::milliseconds(1);
constexpr auto kPatience = std::chrono::seconds(3);  // the time a child has to end after SIGTERM

/// Children that were started and not yet reaped: until then their process ids cannot be reused. The object is never
/// destroyed, because threads may outlive `main`.
struct Children {
  std::timed_mutex mutex;
  bool is_closed = false;
  std::vector<pid_t> running;
};
Children& children() {
  static Children& out = *new Children;
  return out;
}

/// A file that becomes readable when a process ends; -1 where the system has none.
class EndOfProcess {
 public:
  explicit EndOfProcess(pid_t pid) : file_(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0U))) {}
  ~EndOfProcess() {
    if (file_ >= 0) ::close(file_);
  }
  EndOfProcess(const EndOfProcess&) = delete;
  EndOfProcess& operator=(const EndOfProcess&) = delete;

  /// Waits until the process ends, at most for one interval.
  void wait() const {
    pollfd waited_for{.fd = file_, .events = POLLIN, .revents = 0};
    if (file_ < 0 || ::poll(&waited_for, 1, static_cast<int>(kLookInterval.count())) < 0)
      std::this_thread::sleep_for(kLookInterval);
  }

 private:
  int file_;
};

int spawn(const std::vector<std::string>& words, const fs::path& folder, int errors, pid_t& pid) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
  ::posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  sigset_t none;
  sigset_t usual;
  sigemptyset(&none);
  sigemptyset(&usual);
  for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&usual, signal);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &usual);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const int reason = ::posix_spawnp(&pid, pointers[0], &files, &attributes, pointers.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  return reason;
}

}  // namespace

ChildProcess::~ChildProcess() {
  if (errors_ != nullptr) std::fclose(errors_);
}

int ChildProcess::start(const std::vector<std::string>& words, const fs::path& folder) {
  errors_ = std::tmpfile();
  if (errors_ == nullptr) return errno;
  const std::lock_guard lock(children().mutex);
  if (children().is_closed) return ECANCELED;
  const int reason = spawn(words, folder, ::fileno(errors_), pid_);
  if (reason == 0) children().running.push_back(pid_);
  return reason;
}

bool ChildProcess::wait(const std::stop_token& stop, Clock::time_point until) {
  int status = 0;
  Clock::time_point asked{};
  const EndOfProcess end(pid_);  // not reaped yet, so the process id is still its own
  for (;;) {
    {
      const std::lock_guard lock(children().mutex);
      if (const pid_t ended = ::waitpid(pid_, &status, WNOHANG); ended != 0) {
        std::erase(children().running, pid_);
        if (ended == pid_ && WIFSIGNALED(status)) signal_ = WTERMSIG(status);
        return ended == pid_ && WIFEXITED(status) && WEXITSTATUS(status) == 0;
      }
    }
    const Clock::time_point now = Clock::now();
    if (stop.stop_requested() && asked.time_since_epoch().count() == 0) {
      ::kill(pid_, SIGTERM);
      asked = now;
    } else if (now > until || (asked.time_since_epoch().count() != 0 && now - asked > kPatience)) {
      ::kill(pid_, SIGKILL);
    }
    end.wait();
  }
}

std::string ChildProcess::complaint() {
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

std::string ChildProcess::complaints() {
  std::rewind(errors_);
  std::string out;
  std::array<char, 4096> piece{};
  while (const std::size_t size = std::fread(piece.data(), 1, piece.size(), errors_)) out.append(piece.data(), size);
  return out;
}

bool is_program_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path != nullptr ? path : "";
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    if (!folder.empty() && ::access((fs::path(folder) / name).c_str(), X_OK) == 0) return true;
  }
  return false;
}

void kill_children(Clock::time_point until) {
  const std::unique_lock lock(children().mutex, until);
  if (!lock) return;
  children().is_closed = true;
  for (const pid_t pid : children().running) ::kill(pid, SIGKILL);
  // Temporary files may be removed only when no child can write them again.
  for (const pid_t pid : children().running) {
    siginfo_t ended{};
    while (::waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0 &&
           Clock::now() < until)
      std::this_thread::sleep_for(kKillInterval);
  }
}

}  // namespace mes
