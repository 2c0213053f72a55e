// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments of the user: sources and shared libraries that are added to the registry of the program.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/experiments/compiler.h"
#include "core/base/error.h"
#include "core/library/experiments.h"

namespace mes {

class Registry;

/// A source, `.cpp`, `.cc` or `.cxx`, a shared library, `.so`, or a file of Python, `.py`.
bool is_experiment_file(const std::filesystem::path& file);
/// The experiments that a name stands for: a file itself, or those of a folder by name. Error: `bad_input` if it is
/// neither, or a folder without experiments.
Expected<std::vector<std::filesystem::path>> experiment_files(const std::filesystem::path& name);

/// The programs that prepare experiments.
struct ExperimentTools {
  /// The program that tries them (`try_experiment`); empty: they are not tried.
  std::filesystem::path program{};
  std::string compiler{};  ///< as `Compiler::find` takes it
  static ExperimentTools of_this_program();
};

/// An experiment that can be added.
struct PreparedExperiment {
  std::filesystem::path file{};  ///< as the user named it
  std::optional<ExperimentLibrary> library{};
};

/// Compiles a source if it has to be, tries the library, and loads it. Slow; it may run on any thread. Error: as
/// `compile_experiment`, `try_experiment` and `ExperimentLibrary::load`; file and text name the experiment.
Expected<PreparedExperiment> prepare_experiment(const ExperimentTools& tools, const std::filesystem::path& file,
                                                const std::stop_token& stop, std::vector<CompilerMessage>& messages);

/// Adds the experiments of these names, in their order, and calls `on_added` after each with what it added and what the
/// compiler said. Waits for compilers and trials. Error: the first of any of them; experiments before it stay added.
using OnAdded = std::function<void(const std::filesystem::path& file, const ExperimentContents& added,
                                   const std::vector<CompilerMessage>& messages)>;
Expected<void> add_experiments(Registry& registry, std::span<const std::string> names, const OnAdded& on_added);

/// The registry with all that these names stand for, in their order; without names, the given one, which has to outlive
/// it. Error: the first of any of them.
Expected<std::shared_ptr<const Registry>> with_experiments(const Registry& registry,
                                                           std::span<const std::string> names);

}  // namespace mes
