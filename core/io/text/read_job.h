// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and cancellation of a reader. Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/base/jobs/job_control.h"

namespace mes {

/// A reader goes through texts, each a part of its work, and reports its position in them.
///
/// Smallest use:
///     ReadJob job(&control);
///     job.begin(text);
///     for (const char& c : text) job.passed(&c);
///
/// Cost: a comparison for each position; a check of the control every 64 KiB.
/// Threads: one; others may use the control.
class ReadJob {
 public:
  /// A null control never cancels. `done` is the completed share of the whole.
  explicit ReadJob(JobControl* control = nullptr, double done = 0.0, bool keeps_vertices = false,
                   bool wants_curves = false)
      : control_(control), done_(done), keeps_vertices_(keeps_vertices), wants_curves_(wants_curves) {}

  /// The options of `ReadRequest`.
  bool keeps_vertices() const { return keeps_vertices_; }
  bool takes_vertices() const { return keeps_vertices_ || wants_curves_; }

  /// Begins the next text, which is this share of the remaining work. Throws `Cancelled`.
  void begin(std::string_view text, double share = 1.0) {
    text_ = text;
    from_ = done_;
    to_ = done_ + share * (kRead - done_);
    next_ = std::numeric_limits<std::size_t>::max();
    look(0);
  }
  /// Reports that the text before `at` is read. Throws `Cancelled`.
  void passed(const char* at) {
    if (const auto done = static_cast<std::size_t>(at - text_.data()); done >= next_) look(done);
  }
  /// Throws `Cancelled`.
  void checkpoint() const {
    if (control_ != nullptr) control_->checkpoint();
  }
  /// Completed share of the whole.
  double done() const { return done_; }
  /// Null if nothing can cancel the reading.
  JobControl* control() const { return control_; }

 private:
  static constexpr double kRead = 0.9;  // the work after reading takes a share too

  void look(std::size_t done) {
    if (control_ == nullptr) return;
    constexpr std::size_t kOften = std::size_t{1} << 16U;
    constexpr std::uint64_t kSteps = std::uint64_t{1} << 20U;
    const double share = text_.empty() ? 1.0 : static_cast<double>(done) / static_cast<double>(text_.size());
    done_ = from_ + share * (to_ - from_);
    control_->checkpoint(static_cast<std::uint64_t>(done_ * static_cast<double>(kSteps)), kSteps);
    next_ = done + kOften;
  }

  JobControl* control_;
  std::string_view text_;
  std::size_t next_ = std::numeric_limits<std::size_t>::max();
  double from_ = 0.0;
  double to_ = 1.0;
  double done_;
  bool keeps_vertices_;
  bool wants_curves_;
};

}  // namespace mes
