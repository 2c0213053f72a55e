// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments for the program: what a shared library adds to a registry, and how it is taken away again.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace mes {

class Registry;

/// Small letters and digits in words with a hyphen between them, as in "beta-skeleton"; the first is a letter.
bool is_kebab_case(std::string_view id);

/// Ids of what an experiment has added, in this order.
struct ExperimentContents {
  std::vector<std::string> parameters{};
  std::vector<std::string> structures{};
  std::vector<std::string> layers{};
  std::vector<std::string> evolutions{};
  std::vector<std::string> shapes{};
  std::vector<std::string> formats{};
  bool is_empty() const {
    return parameters.empty() && structures.empty() && layers.empty() && evolutions.empty() && shapes.empty() &&
           formats.empty();
  }
};

bool is_python_file(const std::filesystem::path& file);

/// A shared library with experiments, or a file of Python. It stays loaded until the program ends, so whatever refers to its
/// code may.
class ExperimentLibrary {
 public:
  /// Error: `bad_input` if it cannot be loaded, or was made for another ABI. Runs its static initialisers. A file of
  /// Python is loaded by the library of the Python module, and read when it is added.
  static Expected<ExperimentLibrary> load(const std::filesystem::path& file);
  /// Adds all that it has, or nothing. Error: `bad_input` with the reason, which the file stands before; registry as
  /// before.
  Expected<ExperimentContents> add_to(Registry& registry) const;

 private:
  ExperimentLibrary(std::filesystem::path file, void* entry) : file_(std::move(file)), entry_(entry) {}
  std::filesystem::path file_;
  void* entry_;  // the function that adds, of a file of Python if that is one
};

/// Takes away what was added, and whatever was computed from it.
void remove_experiment(const ExperimentContents& contents, Registry& registry);

}  // namespace mes
