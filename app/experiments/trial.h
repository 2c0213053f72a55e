// SPDX-License-Identifier: GPL-3.0-or-later
// Tries an experiment in a process of its own, so that a mistake of the kind that ends a process ends that one.
#pragma once

#include <filesystem>
#include <stop_token>

#include "core/base/error.h"

namespace mes {

class Registry;

/// The first word of the command by which the program tries an experiment.
inline constexpr const char* kTrialCommand = "try-experiment";

/// Computes and draws all that a shared library adds, of a few small documents and through some edits. Exceptions do
/// not count, because the user sees them later. Returns the exit code of the process.
int run_trial(const Registry& registry, const std::filesystem::path& library);

/// Runs `program try-experiment LIBRARY`, unless this library has passed before. Error: `bad_input` if it is ended by a
/// signal or takes more than twenty seconds; the text says at what it was. `cancelled`.
Expected<void> try_experiment(const std::filesystem::path& program, const std::filesystem::path& cache,
                              const std::filesystem::path& library, const std::stop_token& stop);

}  // namespace mes
