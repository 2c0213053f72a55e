// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/frame_view.h"

#include <algorithm>
#include <cmath>

namespace mes {

WindowPart part_between(const Insets& panels, int width, int height) {
  constexpr int kLeast = 64;
  const auto left = static_cast<int>(std::ceil(panels.left));
  const auto top = static_cast<int>(std::ceil(panels.top));
  const WindowPart out{left, top, width - left - static_cast<int>(std::ceil(panels.right)),
                       height - top - static_cast<int>(std::ceil(panels.bottom))};
  return out.width < kLeast || out.height < kLeast ? WindowPart{0, 0, width, height} : out;
}

FrameView frame_view(const render::Camera& window, const WindowPart& part, double content_scale,
                     const RecordSettings& settings) {
  FrameView out{window.part(part.left, part.top, part.width, part.height), content_scale};
  if (settings.width == 0 || (settings.width == part.width && settings.height == part.height)) return out;
  const double factor =
      std::min(static_cast<double>(settings.width) / part.width, static_cast<double>(settings.height) / part.height);
  out.content_scale *= factor;
  out.camera.set_viewport(settings.width, settings.height);
  // Zooms about the middle, so that even the centre of a deep zoom is not rounded.
  out.camera.zoom_at({0.5 * settings.width, 0.5 * settings.height}, factor);
  return out;
}

}  // namespace mes
