// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiments/experiment_list.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "core/graph/registry.h"

namespace mes {
namespace fs = std::filesystem;

ExperimentList::ExperimentList(ExperimentTools tools, Waker wake)
    : tools_(std::move(tools)), job_(wake), watch_(std::move(wake)) {}

Expected<void> ExperimentList::add(const fs::path& name) {
  const auto files = experiment_files(name);
  if (!files) return std::unexpected(files.error());
  for (const fs::path& file : *files) {
    std::error_code error;
    const fs::path full = fs::weakly_canonical(file, error);
    const auto known = std::ranges::find(entries_, full, &Entry::file);
    if (known != entries_.end())
      reload(static_cast<std::size_t>(known - entries_.begin()));
    else
      entries_.push_back({.file = full});
  }
  watch();
  return {};
}

void ExperimentList::reload(std::size_t entry) {
  // The running job may have read the file before it changed.
  if (entries_[entry].file == at_work_) job_.give_up();
  entries_[entry].state = State::waiting;
}

void ExperimentList::remove(std::size_t entry) {
  if (!entries_[entry].contents.is_empty()) removed_.push_back(std::move(entries_[entry].contents));
  if (entries_[entry].file == at_work_) job_.give_up();
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(entry));
  watch();
}

void ExperimentList::watch() {
  std::vector<fs::path> files;
  for (const Entry& entry : entries_) files.push_back(entry.file);
  watch_.watch(std::move(files));
}

void ExperimentList::take_changed_files() {
  for (const fs::path& file : watch_.take_changed()) {
    const auto entry = std::ranges::find(entries_, file, &Entry::file);
    if (entry != entries_.end()) reload(static_cast<std::size_t>(entry - entries_.begin()));
  }
}

std::optional<ExperimentList::Work> ExperimentList::work() const {
  if (!is_busy()) return {};
  return Work{.file = at_work_, .time = std::chrono::steady_clock::now() - begun_};
}

void ExperimentList::begin_next() {
  if (job_.is_under_way()) return;
  const auto next = std::ranges::find(entries_, State::waiting, &Entry::state);
  if (next == entries_.end()) return;
  next->state = State::preparing;
  at_work_ = next->file;
  begun_ = std::chrono::steady_clock::now();
  job_.begin([tools = tools_, file = next->file](const std::stop_token& stop) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<CompilerMessage> messages;
    Prepared out{.experiment = prepare_experiment(tools, file, stop, messages), .messages = {}};
    out.messages = std::move(messages);
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
  });
}

// Later experiments may read what this one adds, so they are added again, too.
std::shared_ptr<const Registry> ExperimentList::take(Entry& entry, Prepared prepared, const Registry& present) {
  entry.messages = std::move(prepared.messages);
  entry.seconds = prepared.seconds;
  const auto fail = [&entry](const Error& error) {
    entry.state = State::failed;
    entry.problem = error.message();
    return nullptr;
  };
  if (!prepared.experiment) return fail(prepared.experiment.error());
  const auto first = std::ranges::find(entries_, entry.file, &Entry::file);
  auto out = std::make_shared<Registry>(present);
  for (auto one = entries_.end(); one-- != first;) remove_experiment(one->contents, *out);
  auto added = prepared.experiment->library->add_to(*out);
  entry.is_blocked = !added;
  if (!added) return fail(added.error());
  entry.contents = *std::move(added);
  entry.library = std::move(prepared.experiment->library);
  entry.state = State::added;
  ++entry.versions;
  entry.problem.clear();
  for (auto one = first + 1; one != entries_.end(); ++one) {
    if (!one->library) continue;
    auto again = one->library->add_to(*out);
    if (again) {
      one->contents = *std::move(again);
      if (std::exchange(one->is_blocked, false)) one->state = State::added;
    } else {
      one->contents = {};
      one->is_blocked = true;
      one->state = State::failed;
      one->problem = again.error().message();
    }
  }
  return out;
}

std::shared_ptr<const Registry> ExperimentList::follow(const Registry& present,
                                                       const std::function<void(const Entry&)>& on_news) {
  // An experiment that reads a removed one leaves with it, and reports that when it is prepared again.
  std::shared_ptr<const Registry> out;
  if (!removed_.empty()) {
    auto changed = std::make_shared<Registry>(present);
    for (const ExperimentContents& contents : removed_) remove_experiment(contents, *changed);
    removed_.clear();
    out = std::move(changed);
  }
  if (auto prepared = job_.poll()) {
    const auto entry = std::ranges::find(entries_, std::exchange(at_work_, {}), &Entry::file);
    // Meanwhile it may have been removed, or have changed again.
    if (entry != entries_.end() && entry->state == State::preparing) {
      if (auto changed = take(*entry, *std::move(prepared), out ? *out : present)) out = std::move(changed);
      on_news(*entry);
    }
  }
  take_changed_files();
  begin_next();
  return out;
}

}  // namespace mes
