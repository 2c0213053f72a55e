// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the frames of a take as PNG files, on threads of its own.
//
// Guarantees:
//  1. No frame is dropped: `push` waits while the queue is full. The queue holds at most `most_frames` pictures and
//     `most_bytes` of pixels, including those being written (one picture is always accepted).
//  2. Whatever interrupts the program, every file `00001.png` and so on is complete.
//  3. When a file cannot be written, the take ends there: one problem is reported, all earlier files stay, and `push`
//     refuses further frames.
//  4. The manifest lists every frame after `finish`, and lags by some seconds until then.
//
// Smallest use:
//     FrameWriter writer(*begin_take(folder, {1920, 1080, 30.0}));
//     for (...) writer.push({.picture = image, .info = {"Move"}});
//     if (auto done = writer.finish(); !done) ...
//
// Cost: `push` is a move. A 1080p frame takes a thread about 20 ms. Threads: all methods from one; the writer's
// threads call `wake` and `write`.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include "app/recording/captured_picture.h"
#include "app/recording/take.h"
#include "core/io/files/atomic_file.h"

namespace mes {

struct Frame {
  CapturedPicture picture;  ///< must be whole
  FrameInfo info{};
};

struct FrameWriterOptions {
  std::size_t most_frames = 64;
  std::size_t most_bytes = std::size_t{256} << 20U;
  std::uint64_t first = 1;               ///< number of the first frame
  std::uint64_t stride = 1;              ///< step between its frames; other writers write those between
  std::string manifest = kManifestName;  ///< file name
  unsigned threads = 0;                  ///< 0: half the processors, from 1 to 4
  std::chrono::milliseconds manifest_interval{5000};
  std::function<void()> wake = [] {};  ///< called when a frame was written, or there is a problem
  std::function<Expected<void>(const std::filesystem::path&, std::string_view)> write = write_file_atomically;
};

class FrameWriter {
 public:
  explicit FrameWriter(Take take, FrameWriterOptions options = {});
  /// Does the same as `finish`.
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// True if `push` would take this many frames, with this many bytes in all, without waiting.
  bool has_room(std::size_t frames, std::size_t bytes) const;
  /// False once there is a problem or the take is finished.
  bool push(Frame frame);
  /// Puts this session into the manifest from now on (`packed_session`).
  void carry(std::string session);
  /// Waits until all is written. Returns the problem, if there is one.
  Expected<void> finish();

  std::optional<Error> problem() const;
  /// Number of frames that were pushed and are not written yet.
  std::size_t pending() const;
  std::size_t written() const;
  const Take& take() const { return take_; }

 private:
  struct Work {
    std::size_t index = 0;
    std::size_t bytes = 0;
    Frame frame;
  };
  void write_on();
  Expected<void> write(Work& work) const;
  void fail(Error error);
  /// The manifest of the frames that exist without a gap. Call it with the lock held.
  Manifest manifest() const;
  void write_manifest_now_and_then(std::unique_lock<std::mutex>& lock);

  const Take take_;
  const FrameWriterOptions options_;
  mutable std::mutex mutex_;
  std::condition_variable work_;  // signals new work, or the end
  std::condition_variable room_;
  std::deque<Work> queue_;
  std::size_t held_frames_ = 0;  // queued and being written
  std::size_t held_bytes_ = 0;
  std::vector<FrameInfo> infos_;
  std::vector<bool> is_written_;
  std::size_t written_ = 0;
  std::string session_;
  std::optional<Error> problem_;
  bool is_ending_ = false;
  bool is_finished_ = false;
  bool is_writing_manifest_ = false;
  std::chrono::steady_clock::time_point manifest_time_;
  std::vector<std::thread> threads_;
};

}  // namespace mes
