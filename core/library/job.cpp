// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

#include "core/library/internal/adapter.h"

namespace mesecina {
inline namespace v1 {

struct Job::Impl {
  std::stop_source source;
  mes::JobControl control{source.get_token()};
  std::optional<std::stop_callback<std::function<void()>>> outer_stop;
  std::mutex mutex;  // guards the task
  std::string task;
};

Job::Job() : impl_(guarded([] { return std::make_unique<Impl>(); })) {}

Job::Job(std::stop_token token) : Job() {
  guarded([&] { impl_->outer_stop.emplace(std::move(token), [this] { stop(); }); });
}

Job::~Job() = default;

void Job::stop() noexcept {
  impl_->source.request_stop();
}

bool Job::is_stopped() const noexcept {
  return impl_->source.stop_requested();
}

double Job::progress() const noexcept {
  return impl_->control.progress();
}

std::string Job::task() const {
  return guarded([&] {
    const std::lock_guard lock(impl_->mutex);
    return impl_->task;
  });
}

mes::JobControl& JobAccess::control(Job& job) {
  return job.impl_->control;
}

void JobAccess::begin_task(Job& job, std::string_view task) {
  const std::lock_guard lock(job.impl_->mutex);
  job.impl_->task = task;
}

}  // namespace v1
}  // namespace mesecina
