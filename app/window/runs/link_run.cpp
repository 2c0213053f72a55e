// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/runs/link_run.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace mes {

LinkRun::~LinkRun() {
  if (socket_ < 0) return;
  ::shutdown(socket_, SHUT_RDWR);
  reader_.join();
  ::close(socket_);
}

void LinkRun::open(int socket) {
  socket_ = socket;
  const auto done = begin();
  reader_ = std::jthread([this] { read(); });
  if (!done) end(done.error().text);
}

Expected<void> LinkRun::begin() {
  while (lines_.empty() && read_some()) {
  }
  if (lines_.empty()) return std::unexpected(Error{.code = ErrorCode::bad_input, .text = "the link has no document"});
  const auto session = DocumentLink::begun_by(lines_.front());
  lines_.pop_front();
  if (!session) return std::unexpected(session.error());
  if (auto done = uses_.work.editor().load(*session->data); !done) return done;
  uses_.work.computation().set(session->settings);
  link_.begin(uses_.work.document(), settings());
  return {};
}

bool LinkRun::read_some() {
  std::array<char, 65536> bytes{};
  ssize_t count = 0;
  do count = ::recv(socket_, bytes.data(), bytes.size(), 0);
  while (count < 0 && errno == EINTR);
  if (count <= 0) return false;
  const std::lock_guard lock(mutex_);
  for (ssize_t i = 0; i < count; ++i) {
    const char c = bytes[static_cast<std::size_t>(i)];
    if (c == '\n')
      lines_.push_back(std::exchange(begun_line_, {}));
    else
      begun_line_ += c;
  }
  return true;
}

void LinkRun::read() {
  while (read_some()) wake_();
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  wake_();
}

void LinkRun::follow() {
  if (socket_ < 0) return;
  // Waits for the end of a gesture.
  if (uses_.work.editor().in_gesture()) return;
  for (;;) {
    std::string line;
    {
      const std::lock_guard lock(mutex_);
      if (lines_.empty()) break;
      line = std::move(lines_.front());
      lines_.pop_front();
    }
    if (line == DocumentLink::kClosed) {
      end("The program that shared this document with the window has disconnected");
      return uses_.leave();
    }
    DocumentLink::Settings wanted = settings();
    const auto answer = link_.take(line, uses_.work.editor(), wanted);
    if (!answer) return end(answer.error().text);
    set(wanted);
    if (!answer->empty()) unsent_ += *answer + '\n';
    // The other side now has the document.
    uses_.work.editor().mark_saved();
  }
  const bool is_over = [this] {
    const std::lock_guard lock(mutex_);
    return is_over_ && lines_.empty();
  }();
  if (is_over) return end("The program that shared this document with the window has ended");
  if (auto line = link_.propose(uses_.work.editor(), settings())) unsent_ += *line + '\n';
  if (!unsent_.empty()) say(std::exchange(unsent_, {}));
}

bool LinkRun::is_waiting() {
  if (socket_ < 0) return false;
  const std::lock_guard lock(mutex_);
  return !lines_.empty() || link_.may_propose(uses_.work.editor(), settings());
}

const DocumentLink::Settings& LinkRun::settings() {
  ComputationControl& computation = uses_.work.computation();
  if (computation.animation().is_running()) return settings_;
  settings_.precision = id_of(computation.settings().precision);
  for (const Parameter& parameter : computation.parameters())
    settings_.parameters[parameter.id] = computation.settings()[parameter];
  return settings_;
}

void LinkRun::set(const DocumentLink::Settings& settings) {
  if (settings == settings_) return;
  ComputationControl& computation = uses_.work.computation();
  ComputationSettings wanted = computation.settings();
  const auto precision = std::ranges::find(kPrecisionDescriptors, settings.precision, &PrecisionDescriptor::id);
  if (precision != kPrecisionDescriptors.end()) wanted.precision = precision->precision;
  for (const Parameter& parameter : computation.parameters())
    if (const double value = settings.parameters.at(parameter.id); value != settings_.parameters[parameter.id])
      wanted[parameter] = within(parameter, value);
  computation.set(wanted);
}

// Sends text. The socket may take only a part; the rest is sent in the next turn.
void LinkRun::say(const std::string& text) {
  const ssize_t count = ::send(socket_, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (count < 0 && errno != EAGAIN && errno != EINTR) return;  // the reader sees the end
  unsent_ = text.substr(count < 0 ? 0 : static_cast<std::size_t>(count));
}

void LinkRun::end(const std::string& reason) {
  ::shutdown(socket_, SHUT_RDWR);
  reader_.join();
  ::close(std::exchange(socket_, -1));
  uses_.messages.remark(reason);
}

}  // namespace mes
