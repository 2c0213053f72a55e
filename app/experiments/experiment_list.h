// SPDX-License-Identifier: GPL-3.0-or-later
// The window's experiments: prepared in the background, added to the registry, and prepared again when they change.
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

/// Guarantees:
///  1. No call waits for a compiler, a trial or a file system that does not answer.
///  2. A version of an experiment stays in the registry until a later one has been prepared and added; a faulty version
///     takes nothing away.
///  3. Experiments are in the registry in the order in which they were added, so that one may read those before it.
///
/// Threads: one; `wake` is called from another.
class ExperimentList {
 public:
  enum class State : std::uint8_t {
    waiting,    ///< waits to be prepared
    preparing,  ///< it is compiled or tried
    added,
    failed,  ///< `problem` has the reason; an earlier version may still be in the registry
  };
  struct Entry {
    std::filesystem::path file;
    State state = State::waiting;
    std::string problem{};                       ///< one line
    std::vector<CompilerMessage> messages{};     ///< messages of the last compilation
    ExperimentContents contents{};               ///< its additions to the registry
    std::optional<ExperimentLibrary> library{};  ///< the library of these additions
    bool is_blocked = false;                     ///< prepared, but could not be added
    double seconds = 0.0;                        ///< duration of the last preparation
    std::size_t versions = 0;                    ///< number of versions added so far
  };

  ExperimentList(ExperimentTools tools, Waker wake);

  /// Sets the compiler for later compilations.
  void use_compiler(const std::string& words) { tools_.compiler = words; }
  /// Adds a file, or the files of a folder. Error: as `experiment_files`. A known experiment is prepared again.
  Expected<void> add(const std::filesystem::path& name);
  /// Prepares the experiment again though it has not changed.
  void reload(std::size_t entry);
  /// Removes the experiment; its contents leave the registry with the next `follow`.
  void remove(std::size_t entry);
  std::span<const Entry> entries() const { return entries_; }

  bool is_busy() const { return job_.is_under_way(); }
  /// The experiment that is being prepared, and the time since it began.
  struct Work {
    std::filesystem::path file;
    std::chrono::steady_clock::duration time{};
  };
  std::optional<Work> work() const;
  /// Called once per frame: takes prepared experiments, and begins to prepare changed ones. Returns the changed
  /// registry, or null if there is no change. Calls `on_news` for each experiment that was prepared.
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
  std::filesystem::path at_work_;            // the file that the job prepares
  std::chrono::steady_clock::time_point begun_{};
  BackgroundJob<Prepared> job_;
  FileWatch watch_;
};

}  // namespace mes
