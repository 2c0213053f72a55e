// SPDX-License-Identifier: GPL-3.0-or-later
// The disks, segments, points or circles of one layer as a mask. The processor counts them where painting would take
// longer (`DiskField`, `StrokeField`, `CircleField`).
//
// Guarantees:
//  1. The mask is that of the instances, the view and the look of the last `show`. If only instances have changed
//     since, only their rows are counted and uploaded again. A preview keeps its grid meanwhile.
//  2. `is_cheaper` depends only on the instances, the view and the device (for other kinds than disks, only on their
//     number and the device): the same drawing is always drawn the same way.
//
// Smallest use:
//     if (CountedInstances::is_cheaper(buffer, frame, device)) {
//       const auto counted = CountedInstances::create(buffer.kind(), device);
//       counted->show(buffer, frame, {.opacity = 0.5});
//       device.paint_mask(target, area, counted->mask(), counted->parts(), color);
//     }
//
// Cost: `is_cheaper` O(disks), a few nanoseconds each, O(1) for other kinds; `show` O(changed instances), or
// O(instances) after a change of the view, of the look, or of most instances. Threads: the one that owns the context;
// counting borrows all cores.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "render/device/device.h"
#include "render/instances/instance_buffer.h"

namespace mes::render {

/// The map from drawing space to the pixels of a view: for x, ((x - center) - center_low) scale + width / 2.
struct PixelFrame {
  double center_x = 0.0;
  double center_low_x = 0.0;
  double center_y = 0.0;
  double center_low_y = 0.0;
  double scale = 1.0;
  int width = 1;
  int height = 1;
  friend bool operator==(const PixelFrame&, const PixelFrame&) = default;

  Vec2 operator()(double x, double y) const {
    return {((x - center_x) - center_low_x) * scale + 0.5 * width,
            ((y - center_y) - center_low_y) * scale + 0.5 * height};
  }
};

/// Allowed error of coordinates and radii of very many instances; instances that become equal are counted together.
enum class Preview : std::uint8_t {
  none,
  fine,    ///< up to 1/16 of a pixel: for a window
  coarse,  ///< up to 1/4 of a pixel, for disks 1 pixel: for a moving view
};

/// The look of instances of one kind.
struct CountedLook {
  double opacity = 1.0;     ///< opacity of one instance
  double half_width = 0.5;  ///< of all kinds but disks, which have their own size; as in `StrokeField`
  Preview preview = Preview::none;
  friend bool operator==(const CountedLook&, const CountedLook&) = default;
};

class CountedInstances {
 public:
  /// Null for kinds that cannot be counted.
  static std::unique_ptr<CountedInstances> create(PrimitiveKind kind, Device& device);
  virtual ~CountedInstances() = default;
  CountedInstances(const CountedInstances&) = delete;
  CountedInstances& operator=(const CountedInstances&) = delete;

  static bool is_cheaper(const InstanceBuffer& buffer, const PixelFrame& frame, const Device& device);

  /// On std::bad_alloc the mask is empty.
  virtual void show(InstanceBuffer& buffer, const PixelFrame& frame, const CountedLook& look) = 0;
  virtual TextureId mask() const = 0;
  /// The defined parts of the mask, to be painted; the rest of it is undefined.
  virtual std::span<const PixelRect> parts() const = 0;
  /// Whether a finer preview may differ.
  virtual bool is_coarse() const = 0;

 protected:
  CountedInstances() = default;
};

}  // namespace mes::render
