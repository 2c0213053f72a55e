// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the source of an experiment into a shared library.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace mes {

/// One line of what the compiler says.
struct CompilerMessage {
  std::string file{};
  std::uint64_t line = 0;    ///< from 1; 0 = unknown
  std::uint64_t column = 0;  ///< from 1; 0 = unknown
  bool is_error = false;     ///< else a warning
  std::string text{};        ///< one line
};

/// Lines of GCC and of Clang that name a place, errors and warnings alone, in their order.
std::vector<CompilerMessage> compiler_messages(std::string_view output);

/// A compiler, its headers, and the place for its results.
struct Compiler {
  std::vector<std::string> command{};  ///< the program and words that come before all others
  std::filesystem::path headers{};     ///< the folder in which `mesecina/experiment.h` lies
  std::filesystem::path cache{};       ///< the folder of what was compiled before

  /// The wanted words, or else $CXX, or else the first of g++, clang++ and c++ that there is. Error: `bad_input` if there is
  /// none, or no headers.
  static Expected<Compiler> find(std::string_view wanted = {});
};

struct CompiledExperiment {
  std::filesystem::path library{};
  bool was_there = false;  ///< it was compiled before
};

/// What it guarantees: a source that was compiled before by the same command, together with all files that it includes
/// with quotation marks, is not compiled again. A library appears in the cache complete or not at all.
///
/// Error: `bad_input` with file, line and column of the first error; `cancelled`. `messages` has all of them.
Expected<CompiledExperiment> compile_experiment(const Compiler& compiler, const std::filesystem::path& source,
                                                const std::stop_token& stop, std::vector<CompilerMessage>& messages);

}  // namespace mes
