// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/experiments.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include <cstdlib>
#include <exception>
#include <ranges>
#include <utility>

#include "core/document/settings/parameter.h"
#include "core/evolutions/evolution.h"
#include "core/graph/registry.h"
#include "core/io/format_spec.h"
#include "core/library/internal/experiment_parts.h"
#include "core/library/internal/inputs.h"
#include "core/shapes/shape.h"

namespace mes {
namespace {

#define MESECINA_TEXT_(text) #text
#define MESECINA_TEXT(text) MESECINA_TEXT_(text)
constexpr const char* kEntry = MESECINA_TEXT(MESECINA_EXPERIMENT_ENTRY);
constexpr const char* kPythonEntry = MESECINA_TEXT(MESECINA_JOINED(mesecina_python_experiment_of_abi_, MESECINA_ABI));

std::unexpected<Error> failure(const std::filesystem::path& file, std::string_view text) {
  return std::unexpected(
      Error{.code = ErrorCode::bad_input, .text = mesecina::one_line(text), .file = file.string()});
}

/// The loader's message, without the file name in front of it.
std::string loader_error(const std::filesystem::path& file) {
  const char* const said = dlerror();
  std::string text = said == nullptr ? "it cannot be loaded" : said;
  const std::string prefix = file.string() + ": ";
  return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

/// The library with a Python interpreter: beside the program in a build, in its prefix, or in Debian's folder. Empty if
/// there is no such library.
std::filesystem::path find_python_library() {
  namespace fs = std::filesystem;
  std::vector<fs::path> candidates;
  std::error_code error;
  if (const char* const given = std::getenv("MESECINA_PYTHON"); given != nullptr) candidates.emplace_back(given);
  if (const fs::path self = fs::read_symlink("/proc/self/exe", error); !error) {
    const fs::path folder = self.parent_path();
    candidates.push_back(folder / "python/mesecina");                        // in a build
    candidates.push_back(folder / "../..");                                  // in a wheel
    candidates.push_back(folder / "../lib/python3/dist-packages/mesecina");  // in a Debian package
  }
  for (const fs::path& one : candidates)
    if (fs::exists(one / "embedded.so", error)) return fs::weakly_canonical(one / "embedded.so", error);
  return {};
}

}  // namespace

bool is_python_file(const std::filesystem::path& file) {
  return file.extension() == ".py";
}

bool is_kebab_case(std::string_view id) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (id.empty() || !is_small(id.front()) || id.back() == '-') return false;
  for (std::size_t i = 0; i < id.size(); ++i)
    if (!is_small(id[i]) && !is_digit(id[i]) && (id[i] != '-' || id[i - 1] == '-')) return false;
  return true;
}

Expected<ExperimentLibrary> ExperimentLibrary::load(const std::filesystem::path& file) {
  std::error_code failed;
  // The loader searches other folders for a name without a slash.
  std::filesystem::path full = std::filesystem::absolute(file, failed);
  if (failed) return failure(file, failed.message());
  if (!std::filesystem::is_regular_file(full, failed)) return failure(file, "there is no such file");
  const bool is_python = is_python_file(file);
  if (is_python) {
    full = find_python_library();
    if (full.empty()) return failure(file, "the Python module is not installed, which experiments in Python need");
  }
  void* library = nullptr;
  try {
    library = dlopen(full.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  } catch (const std::exception& error) {
    return failure(file, fmt::format("a static initialiser threw: {}", error.what()));
  } catch (...) {
    return failure(file, "a static initialiser threw something");
  }
  if (library == nullptr) return failure(file, loader_error(full));
  void* const entry = dlsym(library, is_python ? kPythonEntry : kEntry);
  if (entry == nullptr)
    return failure(file, fmt::format("it has no experiment for version {} of the binary interface", MESECINA_ABI));
  return ExperimentLibrary(file, entry);
}

Expected<ExperimentContents> ExperimentLibrary::add_to(Registry& registry) const {
  using Add = void (*)(mesecina::Experiment&);
  using AddPython = void (*)(mesecina::Experiment&, const char* file);
  Registry changed = registry;
  mesecina::Experiment::Impl impl{changed};
  mesecina::Experiment experiment(impl);
  try {
    mesecina::shielded([&] {
      if (is_python_file(file_))
        reinterpret_cast<AddPython>(entry_)(experiment, file_.c_str());
      else
        reinterpret_cast<Add>(entry_)(experiment);
    });
  } catch (const GeometryError& error) {
    return failure(file_, error.what());
  } catch (const Cancelled&) {
    return failure(file_, "it stopped by itself");
  }
  registry = std::move(changed);
  return std::move(impl.added);
}

void remove_experiment(const ExperimentContents& contents, Registry& registry) {
  for (const std::string& id : contents.layers) registry.remove_layer(id);
  for (const std::string& id : std::views::reverse(contents.structures)) registry.remove_structure(id);
  for (const std::string& id : contents.parameters) registry.remove_parameter(id);
  for (const std::string& id : contents.evolutions) registry.evolutions().remove(id);
  for (const std::string& id : contents.shapes) registry.shapes().remove(id);
  for (const std::string& id : contents.formats) registry.formats().remove(id);
}

}  // namespace mes
