// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of a shape or a text, computed aside while it is being chosen.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/document/commands.h"

namespace mes {

/// What it guarantees:
///  1. Samples are computed on a thread of their own; nothing waits. Of several wishes the last counts, but each that
///     was begun is shown, so that a slider that is dragged is followed.
///  2. Only samples of the last wish are taken: what is accepted before they are ready waits for them. Where they
///     cannot be made, nothing is taken.
///
/// Smallest use:
///     making.want([request](JobControl& job) { return SampleMaking::Made{make_shape(shape, request, &job)}; });
///     ... each frame: making.follow();
///     if (making.is_accepted_and_ready()) use(*making.made()->data);
///
/// Threads: the window's; `wake` is called from the other.
class SampleMaking {
 public:
  struct Made {
    Expected<SampleData> data;
    std::vector<std::string> remarks{};
  };
  using Call = std::function<Made(JobControl&)>;

  explicit SampleMaking(Waker wake) : job_(std::move(wake)) {}

  void want(Call call);
  /// Gives up what is being computed, which ends where it looks at its job next, and what was accepted.
  void stop();
  /// Takes what is ready. What is accepted and cannot be made is accepted no more.
  void follow();
  bool is_busy() const { return job_.is_under_way(); }

  /// What was computed last, for the last wish or one before; null: nothing yet.
  const Made* made() const { return made_ ? &*made_ : nullptr; }
  /// The last wish has samples, or may still have.
  bool is_possible() const { return is_busy() || (made_ && made_->data); }
  void accept() { is_accepted_ = true; }
  bool is_accepted() const { return is_accepted_; }
  bool is_accepted_and_ready() const { return is_accepted_ && !is_busy() && made_ && made_->data; }

 private:
  void begin();

  BackgroundJob<Made> job_;
  Call wanted_;  // not begun yet
  std::optional<Made> made_;
  bool is_accepted_ = false;
};

}  // namespace mes
