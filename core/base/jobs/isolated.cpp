// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/jobs/isolated.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>
#include <string_view>

namespace mes {
namespace {

// First byte of the child's answer.
constexpr char kResult = 'R';
constexpr char kFailure = 'F';
constexpr char kNoMemory = 'M';

bool write_all(int file, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = write(file, at, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    at += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

std::size_t own_address_space() {
  std::ifstream status("/proc/self/statm");
  std::size_t pages = 0;
  status >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

constexpr bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

// Never returns.
[[noreturn]] void be_the_child(int out, const std::function<std::vector<std::byte>()>& work,
                               const IsolationLimits& limits) {
  // It must not outlive its parent, leave a core file, or answer signals meant for the program.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  for (const int signal : {SIGINT, SIGTERM, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, SIG_DFL);
  if (limits.bytes != 0 && !is_sanitized()) {
    const rlim_t most = own_address_space() + limits.bytes;
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
  }
  int code = 0;
  const auto send = [out, &code](char tag, const void* data, std::size_t size) {
    if (!write_all(out, &tag, 1) || !write_all(out, data, size)) code = 1;
  };
  try {
    const std::vector<std::byte> bytes = work();
    send(kResult, bytes.data(), bytes.size());
  } catch (const std::bad_alloc&) {
    send(kNoMemory, nullptr, 0);
  } catch (const std::exception& error) {
    const std::string_view text = error.what();
    send(kFailure, text.data(), text.size());
  } catch (...) {
    send(kFailure, nullptr, 0);
  }
  _exit(code);
}

struct Pipe {
  int in = -1;
  int out = -1;
  Pipe() {
    int ends[2];
    if (pipe(ends) != 0) throw GeometryError("no pipe to a child process");
    in = ends[0];
    out = ends[1];
  }
  ~Pipe() {
    close_out();
    if (in >= 0) close(in);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_out() {
    if (out >= 0) close(out);
    out = -1;
  }
};

/// Kills the child if it still runs, and collects its status in any case.
struct Child {
  pid_t id = -1;
  int status = 0;
  bool is_running = true;
  explicit Child(pid_t child) : id(child) {}
  ~Child() {
    kill(id, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  void wait() {
    if (!is_running) return;
    while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
    is_running = false;
  }
};

}  // namespace

std::vector<std::byte> run_isolated(const std::function<std::vector<std::byte>()>& work,
                                    const IsolationLimits& limits, JobControl& job) {
  const std::string what = limits.what;
  Pipe pipe;
  const pid_t id = fork();
  if (id < 0) throw GeometryError("no child process for " + what);
  if (id == 0) {
    close(pipe.in);
    be_the_child(pipe.out, work, limits);
  }
  Child child(id);
  pipe.close_out();
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::byte> received;
  std::array<std::byte, 1U << 16U> buffer;
  for (;;) {
    constexpr int kBetweenLooksMs = 20;
    pollfd waiting{pipe.in, POLLIN, 0};
    const int ready = poll(&waiting, 1, kBetweenLooksMs);
    job.checkpoint();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (limits.seconds > 0.0 && seconds > limits.seconds)
      throw GeometryError(
          fmt::format("{} did not come to an end within {} s", what, static_cast<int>(limits.seconds)));
    if (ready <= 0) continue;
    const ssize_t count = read(pipe.in, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    received.insert(received.end(), buffer.begin(), buffer.begin() + count);
  }
  child.wait();
  if (WIFSIGNALED(child.status))
    throw GeometryError(fmt::format("{} crashed ({})", what, strsignal(WTERMSIG(child.status))));
  if (received.empty() || WEXITSTATUS(child.status) != 0) throw GeometryError(what + " ended without a result");
  const char tag = static_cast<char>(received.front());
  received.erase(received.begin());
  if (tag == kNoMemory) throw GeometryError(what + " ran out of memory");
  if (tag == kFailure) {
    std::string reason(reinterpret_cast<const char*>(received.data()), received.size());
    for (char& c : reason)
      if (c == '\n') c = ' ';
    throw GeometryError(what + " failed: " + reason);
  }
  return received;
}

}  // namespace mes
