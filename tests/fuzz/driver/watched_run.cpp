// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/driver/watched_run.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "tests/fuzz/driver/coverage.h"
#include "tests/fuzz/driver/memory.h"

namespace mes::fuzz {
namespace {

constexpr time_t kMostProcessorSeconds = 30;
constexpr time_t kMostSeconds = 1200;
constexpr std::size_t kLongestName = 4096;

void limit_time(time_t processor_seconds, time_t seconds) {
  const itimerval processor{{0, 0}, {processor_seconds, 0}};
  const itimerval wall{{0, 0}, {seconds, 0}};
  ::setitimer(ITIMER_PROF, &processor, nullptr);
  ::setitimer(ITIMER_REAL, &wall, nullptr);
}

std::string end_of(int status) {
  if (WIFEXITED(status))
    return WEXITSTATUS(status) == 0 ? std::string() : "exit code " + std::to_string(WEXITSTATUS(status));
  switch (WTERMSIG(status)) {
    case SIGPROF: return "more than " + std::to_string(kMostProcessorSeconds) + " s of processor time";
    case SIGALRM: return "no end within " + std::to_string(kMostSeconds) + " s";
    default: return std::string("signal ") + ::strsignal(WTERMSIG(status));
  }
}

}  // namespace

struct WatchedRun::Shared {
  Report report;
  std::size_t name_size = 0;
  std::size_t input_size = 0;
  char name[kLongestName];
  char input[kLongestInput];
};

WatchedRun::WatchedRun(const Target& target) : target_(target) {
  void* const memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    std::perror("mmap");
    std::exit(EXIT_FAILURE);
  }
  shared_ = new (memory) Shared;
}

WatchedRun::~WatchedRun() {
  ::munmap(shared_, sizeof(Shared));
}

std::string WatchedRun::watch(const std::function<void()>& work, bool is_quiet) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) return std::string("fork: ") + std::strerror(errno);
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (const int null = is_quiet ? ::open("/dev/null", O_WRONLY | O_CLOEXEC) : -1; null >= 0)
      ::dup2(null, STDERR_FILENO);
    watch_memory();
    work();
    std::fflush(nullptr);
    ::_exit(EXIT_SUCCESS);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return end_of(status);
}

void WatchedRun::run(std::string_view input, std::string_view name) {
  input = input.substr(0, kLongestInput);
  name = name.substr(0, kLongestName);
  shared_->input_size = input.size();
  shared_->name_size = name.size();
  std::ranges::copy(input, shared_->input);
  std::ranges::copy(name, shared_->name);
  // Of exactly this size, so that reading past the end is seen.
  const std::vector<char> bytes(input.begin(), input.end());
  limit_time(kMostProcessorSeconds, kMostSeconds);
  begin_counting();
  begin_measuring();
  target_.run({bytes.data(), bytes.size()});
  limit_time(0, 0);
  ++shared_->report.runs;
}

Report& WatchedRun::report() {
  return shared_->report;
}

std::string WatchedRun::input() const {
  return {shared_->input, shared_->input_size};
}

std::string WatchedRun::name() const {
  return {shared_->name, shared_->name_size};
}

}  // namespace mes::fuzz
