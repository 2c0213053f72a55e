// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_binary.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace mes::test {
namespace {

struct Pipe {
  int read = -1;
  int write = -1;
  Pipe() {
    std::array<int, 2> ends{};
    REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0);
    read = ends[0];
    write = ends[1];
  }
};

void drain(int descriptor, std::string& to, const std::function<void()>& at_first = {}) {
  std::array<char, 65536> piece{};
  for (;;) {
    const ssize_t got = ::read(descriptor, piece.data(), piece.size());
    if (got <= 0) break;
    if (at_first && to.empty()) at_first();
    to.append(piece.data(), static_cast<std::size_t>(got));
  }
  ::close(descriptor);
}

[[noreturn]] void become(const std::vector<std::string>& arguments, const RunOptions& options) {
  for (const std::string& variable : options.environment) {
    const std::size_t equals = variable.find('=');
    ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  if (options.address_space_mib != 0) {
    const rlim_t bytes = options.address_space_mib << 20U;
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGINT, SIG_DFL);
  if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(127);
  std::vector<std::string> words{options.program.empty() ? std::getenv("MESECINA_BINARY") : options.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

// Whether the process leaves the signal to its watcher: before that it would die of it like any program that is still
// being loaded.
bool watches(pid_t child, int signal) {
  std::ifstream status("/proc/" + std::to_string(child) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigBlk:")) continue;
    return ((std::stoull(line.substr(7), nullptr, 16) >> static_cast<unsigned>(signal - 1)) & 1U) != 0;
  }
  return false;
}

void interrupt(pid_t child, const RunOptions& options) {
  const auto is_time = [&] {
    if (options.interrupt_when && !options.interrupt_when()) return false;
    return options.interrupt_with == SIGKILL || watches(child, options.interrupt_with);
  };
  // Bounded, so that a program that ends early, or never watches, cannot hang the test.
  for (int i = 0; i < 60000 && !is_time(); ++i) {
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid == child) return;
    ::usleep(500);
  }
  ::usleep(options.interrupt_after_ms * 1000);
  ::kill(child, options.interrupt_with);
}

}  // namespace

RunResult run(const std::vector<std::string>& arguments, const RunOptions& options) {
  REQUIRE((!options.program.empty() || std::getenv("MESECINA_BINARY") != nullptr));
  const Pipe in;
  const Pipe out;
  const Pipe err;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::dup2(in.read, STDIN_FILENO);
    ::dup2(options.out_path.empty() ? out.write : ::open(options.out_path.c_str(), O_WRONLY), STDOUT_FILENO);
    ::dup2(err.write, STDERR_FILENO);
    become(arguments, options);
  }
  for (const int end : {in.read, out.write, err.write}) ::close(end);
  RunResult result;
  std::signal(SIGPIPE, SIG_IGN);
  std::thread feeder([&] {
    static_cast<void>(!::write(in.write, options.input.data(), options.input.size()));
    if (!options.keep_input_open) ::close(in.write);
  });
  std::thread out_reader([&] { drain(out.read, result.out); });
  std::thread err_reader([&] { drain(err.read, result.err, options.at_first_error); });
  if (options.interrupt_with != 0) interrupt(child, options);
  int status = 0;
  ::waitpid(child, &status, 0);
  feeder.join();
  out_reader.join();
  err_reader.join();
  if (options.keep_input_open) ::close(in.write);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return result;
}

}  // namespace mes::test
