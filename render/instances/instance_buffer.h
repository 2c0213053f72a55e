// SPDX-License-Identifier: GPL-3.0-or-later
// The instances of one layer and kind on a device.
//
// Guarantees: after `apply` the first `count()` instances are those of the patches. It uploads only the
// instances in the patch, or all of them for a patch with `reset`. The buffer grows geometrically and is copied on the
// device.
//
// Instances out of view can be left out, in blocks (`BlockBoxes`).
//
// Scalars are in a separate buffer, so drawing without a colour map does not read them. Updating their range takes
// time proportional to the change.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/draw/patch.h"
#include "render/device/device.h"
#include "render/instances/block_boxes.h"
#include "render/instances/instance_encoder.h"
#include "render/instances/scalar_store.h"

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

  /// Returns the number of bytes uploaded. Without `reset`, the frame must be that of the existing instances.
  std::uint64_t apply(const KindPatch& patch, const DrawingFrame& frame, bool has_scalars);
  /// Replaces all instances; `data` is as in a patch with `reset`. Returns the number of bytes uploaded.
  std::uint64_t replace(std::uint32_t count, std::span<const double> data, const DrawingFrame& frame,
                        bool has_scalars);
  void clear();

  PrimitiveKind kind() const { return kind_; }
  std::uint32_t count() const { return count_; }
  /// The number of segments whose ends are equal.
  std::uint32_t zero_length_count() const { return zero_length_count_; }
  BufferId buffer() const { return buffer_; }
  /// One double an instance; no buffer without scalars.
  BufferId scalars() const { return scalars_; }
  ScalarRange scalar_range() const { return store_.range(); }
  const DrawingFrame& frame() const { return frame_; }
  const InstanceExtent& extent() const { return extent_; }

  /// The instances that may be visible in a box of drawing space, in order. Valid until the next call.
  std::span<const BlockBoxes::Run> runs(const Box2& view) { return boxes_.runs(count_, view); }

  /// The encoded instances, `layout_of(kind()).doubles()` each, if the processor may have to draw them: disks, and
  /// segments, circles and points if the device is slow at placing them. Otherwise empty.
  std::span<const double> kept() const { return kept_; }
  /// Instances removed and added since `forget_changes`, encoded as in `kept`; one written twice is in both twice.
  std::span<const double> removed() const { return removed_; }
  std::span<const double> added() const { return added_; }
  /// Whether so many have changed that they are not listed.
  bool have_all_changed() const { return all_changed_; }
  bool have_changed() const { return all_changed_ || !removed_.empty() || !added_.empty(); }
  void forget_changes();

 private:
  void swap(InstanceBuffer& other) noexcept;
  void reserve(std::size_t instances, std::size_t keep);
  bool is_kept() const;
  void keep(std::size_t instance, std::span<const double> encoded, bool is_new);
  void keep_count(std::uint32_t count);
  void note_all_changed();
  void note_length(std::size_t instance, const double* values);
  void drop_lengths(std::size_t count);
  /// Instances from `first_new` on are new.
  std::uint64_t write(std::span<const std::uint32_t> index, std::span<const double> data, std::uint32_t first_new);
  std::uint64_t fill(std::uint32_t count, std::span<const double> encoded, std::span<const double> data);
  std::uint64_t write_scalars(std::span<const ByteRange> ranges, std::span<const double> scalars);

  Device* device_ = nullptr;
  PrimitiveKind kind_ = PrimitiveKind::point;
  bool has_scalars_ = false;
  BufferId buffer_{};
  BufferId scalars_{};
  std::size_t capacity_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t zero_length_count_ = 0;
  std::vector<bool> is_zero_length_;  // of segments; those beyond its end have a length
  DrawingFrame frame_;
  InstanceExtent extent_;
  BlockBoxes boxes_;
  ScalarStore store_;
  std::vector<double> kept_;
  std::vector<double> removed_;
  std::vector<double> added_;
  bool all_changed_ = false;
};

}  // namespace mes::render
