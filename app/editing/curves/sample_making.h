// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the samples of a shape or a text in the background while the user chooses it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"

namespace mes {

/// Guarantees:
///  1. A separate thread computes the samples; nothing waits. Of several requests the last counts, but each one that
///     was begun is shown, so that the preview follows a dragged slider.
///  2. Only samples of the last request are used: accepting before they are ready waits for them. If they cannot be
///     made, nothing is used.
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
  /// Gives up the computation, which ends at its next look at the job, and an acceptance.
  void stop();
  /// Takes finished samples. If accepted samples cannot be made, the acceptance is withdrawn.
  void follow();
  bool is_busy() const { return job_.is_under_way(); }

  /// The last finished result, of the last request or an earlier one; null: none yet.
  const Made* made() const { return made_ ? &*made_ : nullptr; }
  /// True if the last request has samples, or may still get them.
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
