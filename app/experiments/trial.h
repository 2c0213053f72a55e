// SPDX-License-Identifier: GPL-3.0-or-later
// Tries an experiment in a process of its own, so that a crash ends only that process.
#pragma once

#include <filesystem>
#include <stop_token>

#include "core/base/error.h"

namespace mes {

class Registry;

/// The first word of the command by which the program tries an experiment.
inline constexpr const char* kTrialCommand = "try-experiment";

/// Computes and draws all additions of a shared library for a few small documents and through some edits. Ignores
/// exceptions, because the user sees them later. Returns the exit code of the process.
int run_trial(const Registry& registry, const std::filesystem::path& library);

/// Runs `program try-experiment LIBRARY`, unless this library has passed before. Error: `bad_input` if a signal ends
/// it or it takes more than twenty seconds; the text names the step it had reached. `cancelled`.
Expected<void> try_experiment(const std::filesystem::path& program, const std::filesystem::path& cache,
                              const std::filesystem::path& library, const std::stop_token& stop);

}  // namespace mes
