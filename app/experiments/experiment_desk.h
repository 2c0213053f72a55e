// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments of the window: prepared in the background, added to the registry, and prepared anew when they change.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/experiments/experiment.h"
#include "app/experiments/file_watch.h"
#include "app/system/background_job.h"

namespace mes {

/// What it guarantees:
///  1. No call waits for a compiler, a trial or a file system that does not answer.
///  2. A version of an experiment stays in the registry until a later one has been prepared and added; a mistake takes
///     nothing away.
///  3. Experiments are in the registry in the order in which they were added, so that one may read those before it.
///
/// Threads: one; `wake` is called from another.
class ExperimentDesk {
 public:
  enum class State : std::uint8_t {
    waiting,    ///< to be prepared
    preparing,  ///< it is compiled or tried
    added,
    failed,  ///< `problem` says why; an earlier version may still be in the registry
  };
  struct Entry {
    std::filesystem::path file;
    State state = State::waiting;
    std::string problem{};                       ///< one line
    std::vector<CompilerMessage> messages{};     ///< of the last compilation
    ExperimentContents contents{};               ///< what is in the registry
    std::optional<ExperimentLibrary> library{};  ///< that it is from
    bool is_blocked = false;                     ///< it was prepared, and could not be added
    double seconds = 0.0;                        ///< that the last preparation took
    std::size_t versions = 0;                    ///< added so far
  };

  ExperimentDesk(ExperimentTools tools, Waker wake);

  /// For what is compiled from now on.
  void use_compiler(const std::string& words) { tools_.compiler = words; }
  /// A file or a folder. Error: as `experiment_files`. One that is there already is prepared anew.
  Expected<void> add(const std::filesystem::path& name);
  /// Prepares it anew though it has not changed.
  void reload(std::size_t entry);
  /// Its things leave the registry with the next `follow`.
  void remove(std::size_t entry);
  std::span<const Entry> entries() const { return entries_; }

  bool is_busy() const { return job_.is_under_way(); }
  /// The experiment that is being prepared, and for how long.
  struct Work {
    std::filesystem::path file;
    std::chrono::steady_clock::duration time{};
  };
  std::optional<Work> work() const;
  /// Once a turn: takes what was prepared, and begins with what has changed. Returns another registry in place of the one
  /// it is given, or null. `on_news` is called for each experiment that was prepared.
  std::shared_ptr<const Registry> follow(const Registry& present, const std::function<void(const Entry&)>& on_news);

 private:
  struct Prepared {
    Expected<PreparedExperiment> experiment;
    std::vector<CompilerMessage> messages;
    double seconds = 0.0;
  };
  void take_changed_files();
  void watch();
  void begin_next();
  std::shared_ptr<const Registry> take(Entry& entry, Prepared prepared, const Registry& present);

  ExperimentTools tools_;
  std::vector<Entry> entries_;
  std::vector<ExperimentContents> removed_;  // still in the registry
  std::filesystem::path at_work_;            // that the job prepares
  std::chrono::steady_clock::time_point begun_{};
  BackgroundJob<Prepared> job_;
  FileWatch watch_;
};

}  // namespace mes
