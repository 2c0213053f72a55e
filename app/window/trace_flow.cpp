// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/trace_flow.h"

#include <utility>
#include <vector>

namespace mes {

TraceFlow::TraceFlow(Uses uses, Waker wake) : uses_(uses), desk_(uses_.registry, std::move(wake)) {
  uses_.dialogs.trace.set_uses({.desk = desk_,
                                .texture = [this] { return texture(); },
                                .trace =
                                    [this](const TraceRequest& request) {
                                      // The user may give up the picture while the question is open.
                                      uses_.leave_work([this, request] {
                                        if (uses_.dialogs.trace.is_open()) desk_.trace(request);
                                      });
                                    },
                                .lay_underneath =
                                    [this] {
                                      uses_.dialogs.trace.close();
                                      desk_.end();
                                      uses_.board.traced().trace(desk_.file());
                                    },
                                .closed = [this] { desk_.end(); }});
}

void TraceFlow::open(const std::filesystem::path& file) {
  uses_.board.canvas().cancel_gesture();
  desk_.begin(file);
  uses_.dialogs.trace.open();
}

void TraceFlow::take_results() {
  desk_.follow();
  if (const auto read = desk_.poll_picture(); read && !*read) {
    uses_.dialogs.trace.close();
    desk_.end();
    uses_.messages.problem(read->error().message());
  }
  if (auto samples = desk_.poll_samples()) take_samples(std::move(*samples));
}

void TraceFlow::take_samples(Expected<TraceDesk::Samples> samples) {
  uses_.dialogs.trace.close();
  desk_.end();
  if (!samples) {
    uses_.messages.problem(samples.error().message());
    return;
  }
  uses_.open_made(*std::move(samples), desk_.file().filename().string());
}

ImTextureID TraceFlow::texture() {
  const TracePreview* const preview = desk_.preview();
  if (preview == nullptr) return nullptr;
  render::GlDevice& device = uses_.board.picture().device();
  if (!texture_ || textured_ != desk_.preview_number()) {
    forget_texture();
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * preview->image.values.size());
    for (const std::uint8_t value : preview->image.values) rgba.insert(rgba.end(), {value, value, value, 255});
    texture_ = device.create_texture(preview->image.width, preview->image.height, rgba, true);
    textured_ = desk_.preview_number();
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(device.name_of(*texture_)));
}

void TraceFlow::forget_texture() {
  if (texture_) uses_.board.picture().device().destroy_texture(*texture_);
  texture_.reset();
}

}  // namespace mes
