// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/frame_writer.h"

#include <algorithm>
#include <new>
#include <utility>

#include "render/image/png.h"

namespace mes {
namespace {

std::string_view text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

unsigned thread_count(unsigned wanted) {
  return wanted != 0 ? wanted : std::clamp(std::thread::hardware_concurrency() / 2, 1U, 4U);
}

}  // namespace

FrameWriter::FrameWriter(Take take, FrameWriterOptions options)
    : take_(std::move(take)), options_(std::move(options)), manifest_time_(std::chrono::steady_clock::now()) {
  for (unsigned i = 0; i < thread_count(options_.threads); ++i) threads_.emplace_back([this] { write_on(); });
}

FrameWriter::~FrameWriter() {
  // A caller that needs the result has called `finish` before.
  static_cast<void>(finish());
}

bool FrameWriter::has_room(std::size_t frames, std::size_t bytes) const {
  const std::lock_guard lock(mutex_);
  return held_frames_ + frames <= options_.most_frames && held_bytes_ + bytes <= options_.most_bytes;
}

bool FrameWriter::push(Frame frame) {
  const std::size_t bytes = frame.picture.bytes();
  std::unique_lock lock(mutex_);
  room_.wait(lock, [&] {
    const bool fits = held_frames_ < options_.most_frames && held_bytes_ + bytes <= options_.most_bytes;
    return problem_ || is_ending_ || fits || held_frames_ == 0;
  });
  if (problem_ || is_ending_) return false;
  infos_.push_back(frame.info);
  is_written_.push_back(false);
  ++held_frames_;
  held_bytes_ += bytes;
  queue_.push_back({infos_.size() - 1, bytes, std::move(frame)});
  lock.unlock();
  work_.notify_one();
  return true;
}

Expected<void> FrameWriter::write(Work& work) const {
  try {
    const auto png = render::encode_png(std::move(work.frame.picture).image());
    if (!png) return std::unexpected(png.error());
    return options_.write(take_.folder / frame_name(options_.first + work.index * options_.stride), text_of(*png));
  } catch (const std::bad_alloc&) {
    return std::unexpected(Error{ErrorCode::out_of_memory, "not enough memory to write a frame"});
  }
}

void FrameWriter::fail(Error error) {
  if (problem_) return;
  problem_ = std::move(error);
  for (const Work& work : queue_) held_bytes_ -= work.bytes;
  held_frames_ -= queue_.size();
  queue_.clear();
}

void FrameWriter::write_on() {
  std::unique_lock lock(mutex_);
  for (;;) {
    work_.wait(lock, [this] { return is_ending_ || !queue_.empty(); });
    if (queue_.empty()) return;
    Work work = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    auto done = write(work);
    work.frame = {};
    lock.lock();
    --held_frames_;
    held_bytes_ -= work.bytes;
    if (done) {
      is_written_[work.index] = true;
      ++written_;
      write_manifest_now_and_then(lock);
    } else {
      fail(std::move(done.error()));
    }
    room_.notify_all();
    options_.wake();
  }
}

Manifest FrameWriter::manifest() const {
  const auto end = std::ranges::find(is_written_, false) - is_written_.begin();
  return {take_.format, false, {}, {infos_.begin(), infos_.begin() + end}, session_};
}

void FrameWriter::write_manifest_now_and_then(std::unique_lock<std::mutex>& lock) {
  const auto now = std::chrono::steady_clock::now();
  if (is_writing_manifest_ || problem_ || now - manifest_time_ < options_.manifest_interval) return;
  is_writing_manifest_ = true;
  const Manifest known = manifest();
  lock.unlock();
  auto done = options_.write(take_.folder / options_.manifest, manifest_text(known));
  lock.lock();
  is_writing_manifest_ = false;
  manifest_time_ = std::chrono::steady_clock::now();
  if (!done) fail(std::move(done.error()));
}

void FrameWriter::carry(std::string session) {
  const std::lock_guard lock(mutex_);
  session_ = std::move(session);
}

Expected<void> FrameWriter::finish() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  work_.notify_all();
  room_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  if (!std::exchange(is_finished_, true)) {
    Manifest known = manifest();
    known.complete = !problem_;
    if (problem_) known.problem = problem_->message();
    auto done = options_.write(take_.folder / options_.manifest, manifest_text(known));
    if (!done && !problem_) problem_ = std::move(done.error());
  }
  if (problem_) return std::unexpected(*problem_);
  return {};
}

std::optional<Error> FrameWriter::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

std::size_t FrameWriter::pending() const {
  const std::lock_guard lock(mutex_);
  return held_frames_;
}

std::size_t FrameWriter::written() const {
  const std::lock_guard lock(mutex_);
  return written_;
}

}  // namespace mes
