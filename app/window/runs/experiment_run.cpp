// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/runs/experiment_run.h"

#include <fmt/core.h>
#include <imgui.h>

#include <cstdlib>
#include <utility>

#include "app/experiments/crash_line.h"
#include "app/system/child_process.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

/// Looks beside the other files that come with the program, or in its sources.
std::vector<fs::path> find_examples(const fs::path& assets) {
  std::error_code error;
  for (const fs::path& folder : {assets / "examples", assets / "../examples/experiments"})
    if (!assets.empty() && fs::is_directory(folder, error))
      if (auto files = experiment_files(fs::canonical(folder, error))) return *std::move(files);
  return {};
}

}  // namespace

ExperimentRun::ExperimentRun(Uses uses, const fs::path& assets, Waker wake)
    : uses_(std::move(uses)),
      examples_(find_examples(assets)),
      list_(ExperimentTools::of_this_program(), std::move(wake)) {}

void ExperimentRun::add(const fs::path& name) {
  if (const auto added = list_.add(name); !added) return uses_.messages.problem(added.error().message());
  remember_experiment(uses_.settings, name);
}

void ExperimentRun::ask(const fs::path& file) {
  uses_.dialogs.experiment.ask(file, [this, file] {
    uses_.settings.panels.open(PanelPage::experiments);
    add(file);
  });
}

void ExperimentRun::ask_file() {
  std::error_code error;
  const auto& recent = uses_.settings.recent_experiments;
  const fs::path folder = recent.empty() ? fs::current_path(error) : fs::path(recent.front()).parent_path();
  uses_.dialogs.browser.ask_open(
      folder, [this](const fs::path& file) { add(file); },
      {.heading = "Load an experiment", .extensions = {".cpp", ".cc", ".cxx", ".so", ".py"}});
}

void ExperimentRun::edit(const fs::path& file, std::uint64_t line) {
  const std::string place = line == 0 ? file.string() : fmt::format("{}:{}", file.string(), line);
  ImGui::SetClipboardText(place.c_str());
  const char* const visual = std::getenv("VISUAL");
  const std::string program = visual != nullptr && visual[0] != '\0' ? visual : "xdg-open";
  // The shell ends at once; the editor keeps running.
  ChildProcess shell;
  std::error_code error;
  if (shell.start({"sh", "-c", program + " \"$1\" >/dev/null 2>&1 &", "sh", file.string()},
                  fs::current_path(error)) == 0)
    shell.wait({});
  uses_.messages.remark(place + " is on the clipboard");
}

void ExperimentRun::say(const ExperimentList::Entry& entry) {
  const std::string name = entry.file.filename().string();
  if (entry.state == ExperimentList::State::failed) {
    // The panel shows the full messages, and drops them once the experiment is repaired.
    uses_.settings.panels.open(PanelPage::experiments);
    uses_.messages.remark(entry.contents.is_empty() ? name + " cannot be used"
                                                    : name + " has a mistake; its previous version stays in use");
  } else {
    uses_.messages.remark(entry.versions > 1 ? fmt::format("A new version of {} is loaded", name)
                                             : fmt::format("{} is loaded", name));
  }
}

void ExperimentRun::follow() {
  list_.use_compiler(uses_.settings.compiler);
  const auto changed =
      list_.follow(uses_.work.registry(), [this](const ExperimentList::Entry& entry) { say(entry); });
  if (!changed) return;
  uses_.keep_work();
  std::string loaded;
  for (const ExperimentList::Entry& entry : list_.entries())
    if (entry.library) loaded += (loaded.empty() ? "" : ", ") + entry.file.filename().string();
  say_at_crash(loaded.empty() ? "" : "experiments loaded: " + loaded + "; the journal has what was not saved");
  uses_.work.set_registry(changed);
}

}  // namespace mes
