// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiments/experiment.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/experiments/crash_line.h"
#include "app/experiments/trial.h"
#include "app/system/data_folder.h"
#include "core/graph/registry.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

bool is_library(const fs::path& file) {
  return file.extension() == ".so" || is_python_file(file);
}

}  // namespace

bool is_experiment_file(const fs::path& file) {
  constexpr std::array<std::string_view, 5> kExtensions{".cpp", ".cc", ".cxx", ".so", ".py"};
  return std::ranges::find(kExtensions, file.extension().string()) != kExtensions.end();
}

Expected<std::vector<fs::path>> experiment_files(const fs::path& name) {
  const auto failure = [&name](std::string text) {
    return std::unexpected(Error{.code = ErrorCode::bad_input, .text = std::move(text), .file = name.string()});
  };
  std::error_code error;
  if (fs::is_directory(name, error)) {
    std::vector<fs::path> out;
    for (auto at = fs::directory_iterator(name, error); !error && at != fs::directory_iterator(); at.increment(error))
      if (at->is_regular_file(error) && is_experiment_file(at->path())) out.push_back(at->path());
    if (error) return failure(error.message());
    if (out.empty()) return failure("the folder has no experiment, which is a .cpp, .so or .py file");
    std::ranges::sort(out);
    return out;
  }
  if (!fs::exists(name, error)) return failure("there is no such file");
  if (!is_experiment_file(name)) return failure("an experiment is a .cpp, .so or .py file, or a folder of them");
  return std::vector{name};
}

ExperimentTools ExperimentTools::of_this_program() {
  std::error_code error;
  return {.program = fs::read_symlink("/proc/self/exe", error), .compiler = {}};
}

Expected<PreparedExperiment> prepare_experiment(const ExperimentTools& tools, const fs::path& file,
                                                const std::stop_token& stop, std::vector<CompilerMessage>& messages) {
  PreparedExperiment out{.file = file};
  fs::path library = file;
  if (!is_library(file)) {
    const auto compiler = Compiler::find(tools.compiler);
    if (!compiler) {
      Error error = compiler.error();
      error.file = file.string();
      return std::unexpected(std::move(error));
    }
    auto compiled = compile_experiment(*compiler, file, stop, messages);
    if (!compiled) return std::unexpected(std::move(compiled.error()));
    library = std::move(compiled->library);
  }
  const auto named = [&file](Error error) {
    error.file = file.string();
    return std::unexpected(std::move(error));
  };
  if (!tools.program.empty())
    if (const auto good = try_experiment(tools.program, cache_folder() / "experiments", library, stop); !good)
      return named(good.error());
  auto loaded = ExperimentLibrary::load(library);
  if (!loaded) return named(std::move(loaded.error()));
  out.library = *std::move(loaded);
  return out;
}

Expected<void> add_experiments(Registry& registry, std::span<const std::string> names, const OnAdded& on_added) {
  for (const std::string& name : names) {
    const auto files = experiment_files(name);
    if (!files) return std::unexpected(files.error());
    for (const fs::path& file : *files) {
      std::vector<CompilerMessage> messages;
      const auto prepared = prepare_experiment(ExperimentTools::of_this_program(), file, {}, messages);
      if (!prepared) return std::unexpected(prepared.error());
      auto added = prepared->library->add_to(registry);
      if (!added) {
        added.error().file = file.string();
        return std::unexpected(std::move(added.error()));
      }
      on_added(file, *added, messages);
    }
  }
  return {};
}

Expected<std::shared_ptr<const Registry>> with_experiments(const Registry& registry,
                                                           std::span<const std::string> names) {
  // A pointer without ownership suffices: the registry of the program lives as long as the program.
  if (names.empty()) return std::shared_ptr<const Registry>(std::shared_ptr<void>(), &registry);
  auto out = std::make_shared<Registry>(registry);
  std::string loaded;
  const auto note = [&loaded](const fs::path& file, const ExperimentContents& /*added*/,
                              const std::vector<CompilerMessage>& /*messages*/) {
    loaded += (loaded.empty() ? "" : ", ") + file.filename().string();
  };
  if (auto good = add_experiments(*out, names, note); !good) return std::unexpected(std::move(good.error()));
  say_at_crash("experiments loaded: " + loaded);
  return out;
}

}  // namespace mes
