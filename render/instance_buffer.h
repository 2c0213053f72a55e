// SPDX-License-Identifier: GPL-3.0-or-later
// The instances of one layer and kind on a device.
//
// What it guarantees: after `apply` the first `count()` instances are those the patches say; bytes uploaded are those
// of instances named by the patch (a reset: all). Growth is geometric and copies on the device.
#pragma once

#include <cstdint>
#include <vector>

#include "core/graph/patch.h"
#include "render/device.h"
#include "render/instance_encoder.h"

namespace mes::render {

class InstanceBuffer {
 public:
  InstanceBuffer() = default;
  InstanceBuffer(Device& device, PrimitiveKind kind) : device_(&device), kind_(kind) {}
  ~InstanceBuffer() { clear(); }
  InstanceBuffer(InstanceBuffer&& other) noexcept { swap(other); }
  InstanceBuffer& operator=(InstanceBuffer&& other) noexcept {
    swap(other);
    return *this;
  }

  /// Returns the bytes uploaded. A patch with `reset` takes over `frame`; one without must have the same.
  std::uint64_t apply(const KindPatch& patch, const DrawingFrame& frame);
  /// Replaces everything; `data` as in a patch with `reset`.
  std::uint64_t replace(std::uint32_t count, std::span<const double> data, const DrawingFrame& frame);
  void clear();

  PrimitiveKind kind() const { return kind_; }
  std::uint32_t count() const { return count_; }
  BufferId buffer() const { return buffer_; }
  const DrawingFrame& frame() const { return frame_; }
  const InstanceExtent& extent() const { return extent_; }

 private:
  void swap(InstanceBuffer& other) noexcept;
  void reserve(std::size_t instances, std::size_t keep);
  std::uint64_t write(std::span<const std::uint32_t> index, std::span<const double> data);

  Device* device_ = nullptr;
  PrimitiveKind kind_ = PrimitiveKind::point;
  BufferId buffer_{};
  std::size_t capacity_ = 0;
  std::uint32_t count_ = 0;
  DrawingFrame frame_;
  InstanceExtent extent_;
};

}  // namespace mes::render
