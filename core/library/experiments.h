// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments for the program: adds the content of a shared library to a registry, and removes it again.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace mes {

class Registry;

/// Lower-case letters and digits in words joined by hyphens, as in "beta-skeleton"; the first character is a letter.
bool is_kebab_case(std::string_view id);

/// Ids of everything that an experiment has added, in this order.
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

/// A shared library with experiments, or a Python file. It stays loaded until the program ends, so pointers to its code
/// stay valid.
class ExperimentLibrary {
 public:
  /// Runs the static initialisers of the library. A Python file is loaded by the library of the Python module, and read
  /// when it is added. Error: `bad_input` if it cannot be loaded, or was made for another ABI.
  static Expected<ExperimentLibrary> load(const std::filesystem::path& file);
  /// Adds all of its content, or nothing. Error: `bad_input` with the file and the reason; the registry is then
  /// unchanged.
  Expected<ExperimentContents> add_to(Registry& registry) const;

 private:
  ExperimentLibrary(std::filesystem::path file, void* entry) : file_(std::move(file)), entry_(entry) {}
  std::filesystem::path file_;
  void* entry_;  // the function that adds the content, for a Python file that of the Python module
};

/// Removes everything that was added, and everything computed from it.
void remove_experiment(const ExperimentContents& contents, Registry& registry);

}  // namespace mes
