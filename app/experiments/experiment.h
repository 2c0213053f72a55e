// SPDX-License-Identifier: GPL-3.0-or-later
// The user's experiments: sources and shared libraries that are added to the registry of the program.
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

/// True for a source (`.cpp`, `.cc` or `.cxx`), a shared library (`.so`), or a Python file (`.py`).
bool is_experiment_file(const std::filesystem::path& file);
/// The experiments that a name stands for: a file itself, or those of a folder, sorted by name. Error: `bad_input` if
/// it is neither, or a folder without experiments.
Expected<std::vector<std::filesystem::path>> experiment_files(const std::filesystem::path& name);

/// The programs that prepare experiments.
struct ExperimentTools {
  /// The program that tries experiments (`try_experiment`); empty: they are not tried.
  std::filesystem::path program{};
  std::string compiler{};  ///< in the form that `Compiler::find` takes
  static ExperimentTools of_this_program();
};

/// An experiment that is ready to be added.
struct PreparedExperiment {
  std::filesystem::path file{};  ///< the name that the user gave
  std::optional<ExperimentLibrary> library{};
};

/// Compiles the source if necessary, tries the library, and loads it. Slow; may run on any thread. Errors: those of
/// `compile_experiment`, `try_experiment` and `ExperimentLibrary::load`; file and text name the experiment.
Expected<PreparedExperiment> prepare_experiment(const ExperimentTools& tools, const std::filesystem::path& file,
                                                const std::stop_token& stop, std::vector<CompilerMessage>& messages);

/// Adds the experiments of these names in their order, and after each calls `on_added` with its contents and the
/// compiler's messages. Waits for compilers and trials. Error: the first one; experiments before it stay added.
using OnAdded = std::function<void(const std::filesystem::path& file, const ExperimentContents& added,
                                   const std::vector<CompilerMessage>& messages)>;
Expected<void> add_experiments(Registry& registry, std::span<const std::string> names, const OnAdded& on_added);

/// The registry extended by the experiments of these names, in their order; without names, the given registry, which
/// must outlive the result. Error: the first one.
Expected<std::shared_ptr<const Registry>> with_experiments(const Registry& registry,
                                                           std::span<const std::string> names);

}  // namespace mes
