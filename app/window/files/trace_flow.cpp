// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/trace_flow.h"

#include <utility>
#include <vector>

namespace mes {

TraceFlow::TraceFlow(Uses uses, Waker wake) : uses_(uses), job_(uses_.registry, std::move(wake)) {
  uses_.dialogs.trace.set_uses({.job = job_,
                                .texture = [this] { return texture(); },
                                .trace =
                                    [this](const TraceRequest& request) {
                                      // The user may give up the picture while the question is open.
                                      uses_.leave_work([this, request] {
                                        if (uses_.dialogs.trace.is_open()) job_.trace(request);
                                      });
                                    },
                                .lay_underneath =
                                    [this] {
                                      uses_.dialogs.trace.close();
                                      job_.end();
                                      uses_.board.traced().trace(job_.file());
                                    },
                                .closed = [this] { job_.end(); }});
}

void TraceFlow::open(const std::filesystem::path& file) {
  uses_.board.canvas().cancel_gesture();
  job_.begin(file);
  uses_.dialogs.trace.open();
}

void TraceFlow::take_results() {
  job_.follow();
  if (const auto read = job_.poll_picture(); read && !*read) {
    uses_.dialogs.trace.close();
    job_.end();
    uses_.messages.problem(read->error().message());
  }
  if (auto samples = job_.poll_samples()) take_samples(std::move(*samples));
}

void TraceFlow::take_samples(Expected<TraceJob::Samples> samples) {
  uses_.dialogs.trace.close();
  job_.end();
  if (!samples) {
    uses_.messages.problem(samples.error().message());
    return;
  }
  uses_.open_made(*std::move(samples), job_.file().filename().string());
}

ImTextureID TraceFlow::texture() {
  const TracePreview* const preview = job_.preview();
  if (preview == nullptr) return nullptr;
  render::GlDevice& device = uses_.board.picture().device();
  if (!texture_ || textured_ != job_.preview_number()) {
    forget_texture();
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * preview->image.values.size());
    for (const std::uint8_t value : preview->image.values) rgba.insert(rgba.end(), {value, value, value, 255});
    texture_ = device.create_texture(preview->image.width, preview->image.height, rgba, true);
    textured_ = job_.preview_number();
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(device.name_of(*texture_)));
}

void TraceFlow::forget_texture() {
  if (texture_) uses_.board.picture().device().destroy_texture(*texture_);
  texture_.reset();
}

}  // namespace mes
