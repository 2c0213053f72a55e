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

/// One message of the compiler.
struct CompilerMessage {
  std::string file{};
  std::uint64_t line = 0;    ///< from 1; 0 = unknown
  std::uint64_t column = 0;  ///< from 1; 0 = unknown
  bool is_error = false;     ///< else a warning
  std::string text{};        ///< one line
};

/// The errors and warnings with a file position in the output of GCC or Clang, in their order.
std::vector<CompilerMessage> compiler_messages(std::string_view output);

/// A compiler, its headers, and the folder for its results.
struct Compiler {
  std::vector<std::string> command{};  ///< the program and its first arguments
  std::filesystem::path headers{};     ///< the folder that contains `mesecina/experiment.h`
  std::filesystem::path cache{};       ///< the folder of compiled libraries

  /// Finds the `wanted` command, else $CXX, else the first available of g++, clang++ and c++. Error: `bad_input` if
  /// there is no compiler, or no headers.
  static Expected<Compiler> find(std::string_view wanted = {});
};

struct CompiledExperiment {
  std::filesystem::path library{};
  bool was_there = false;  ///< true if it was compiled before
};

/// Guarantees: a source that was compiled before by the same command, with the same text of all files that it
/// includes in quotation marks, is not compiled again. A library appears in the cache complete or not at all.
///
/// Error: `bad_input` with file, line and column of the first error; `cancelled`. `messages` gets all messages.
Expected<CompiledExperiment> compile_experiment(const Compiler& compiler, const std::filesystem::path& source,
                                                const std::stop_token& stop, std::vector<CompilerMessage>& messages);

}  // namespace mes
