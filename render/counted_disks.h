// SPDX-License-Identifier: GPL-3.0-or-later
// The disks of one layer as a mask: counted by the processor where painting them would take longer (`DiskField`).
//
// What it guarantees:
//  1. The mask is that of the instances and the view of the last `show`. If only instances changed since, only the rows
//     of these are counted and uploaded again.
//  2. `is_cheaper` is a function of the disks, the view and the device: the same drawing is always drawn the same way.
//
// Smallest use:
//     if (CountedDisks::is_cheaper(buffer, frame, device)) counted.show(buffer, frame, opacity);
//     device.paint_mask(target, area, counted.mask(), color);
//
// Cost: `is_cheaper` O(disks), a few nanoseconds each; `show` O(changed disks), or O(disks) after a change of the view,
// of the opacity, or of most disks. Threads: the one that owns the context; counting borrows all cores.
#pragma once

#include <optional>
#include <vector>

#include "render/device.h"
#include "render/disk_field.h"
#include "render/instance_buffer.h"

namespace mes::render {

/// How drawing space is mapped to the pixels of a view: of x, ((x - center) - center_low) scale + width / 2.
struct PixelFrame {
  double center_x = 0.0;
  double center_low_x = 0.0;
  double center_y = 0.0;
  double center_low_y = 0.0;
  double scale = 1.0;
  int width = 1;
  int height = 1;
  friend bool operator==(const PixelFrame&, const PixelFrame&) = default;

  PixelDisk operator()(const DiskInstance& disk) const {
    return {((disk.x - center_x) - center_low_x) * scale + 0.5 * width,
            ((disk.y - center_y) - center_low_y) * scale + 0.5 * height, disk.radius * scale};
  }
};

class CountedDisks {
 public:
  explicit CountedDisks(Device& device) : device_(device) {}
  ~CountedDisks() { forget(); }
  CountedDisks(const CountedDisks&) = delete;
  CountedDisks& operator=(const CountedDisks&) = delete;

  static bool is_cheaper(const InstanceBuffer& disks, const PixelFrame& frame, const Device& device);

  /// `opacity` is that of one disk. Throws std::bad_alloc.
  void show(InstanceBuffer& disks, const PixelFrame& frame, double opacity);
  TextureId mask() const { return mask_; }
  /// Releases all memory.
  void forget();

 private:
  void count_all(const InstanceBuffer& disks);
  void count_changes(const InstanceBuffer& disks);
  void upload(bool everything);

  Device& device_;
  PixelFrame frame_;
  double opacity_ = 0.0;
  std::optional<DiskField> field_;
  std::vector<PixelDisk> counted_;  ///< by instance; a negative radius: none
  TextureId mask_{};
};

}  // namespace mes::render
