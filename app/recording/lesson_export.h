// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the lesson of the window into a file, whose extension chooses the format, while the window goes on.
//
// Guarantees:
//  1. Nothing waits for computing, drawing or the disk: the work is a call on a thread of its own, which calls `wake`.
//  2. The file is that of `mesecina lesson` with its default options, made of the session as it was at `begin`.
//  3. The file appears complete or not at all, also after `cancel`.
//
// Smallest use:
//     LessonExport lesson(wake);
//     lesson.begin(registry, session, "lesson.pdf");
//     ... each frame: if (auto done = lesson.take_done()) tell(done->outcome);
//
// Threads: the window's.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/graph/registry.h"
#include "core/io/session/session.h"

namespace mes {

/// The extensions of files of lessons: ".pdf", ".html", ".mp4", ".webm".
const std::vector<std::string>& lesson_extensions();

class LessonExport {
 public:
  explicit LessonExport(Waker wake) : job_(std::move(wake)) {}
  ~LessonExport() { cancel(); }
  LessonExport(const LessonExport&) = delete;
  LessonExport& operator=(const LessonExport&) = delete;

  /// Call it only while no export is under way; the session must have a step. An existing file is replaced.
  void begin(std::shared_ptr<const Registry> registry, std::shared_ptr<const Session> session,
             const std::filesystem::path& file);
  bool is_under_way() const { return job_.is_under_way(); }
  const std::filesystem::path& file() const { return file_; }
  /// The finished share of the work, in [0, 1].
  double progress() const { return *progress_; }
  /// The export ends soon, with the error `cancelled` if the file was not complete yet.
  void cancel() { stop_.request_stop(); }

  struct Done {
    std::filesystem::path file;
    Expected<void> outcome;
    std::vector<std::string> remarks;  ///< what was left out, one sentence each
  };
  /// The result, given once.
  std::optional<Done> take_done() { return job_.poll(); }

 private:
  std::filesystem::path file_;
  std::shared_ptr<std::atomic<double>> progress_ = std::make_shared<std::atomic<double>>(0.0);
  std::stop_source stop_;  // not that of the job, whose result would be dropped
  BackgroundJob<Done> job_;
};

}  // namespace mes
