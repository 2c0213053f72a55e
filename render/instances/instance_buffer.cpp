// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/instance_buffer.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <utility>

#include "core/base/assert.h"
#include "core/draw/primitive_values.h"
#include "render/device/instance_layout.h"

namespace mes::render {
namespace {

constexpr std::size_t kSmallest = 32;

/// Appends the byte range of an instance; merges adjacent ranges.
void append(std::vector<ByteRange>& ranges, std::size_t instance, std::size_t bytes) {
  const std::size_t offset = instance * bytes;
  if (!ranges.empty() && ranges.back().offset + ranges.back().size == offset) {
    ranges.back().size += bytes;
  } else {
    ranges.push_back({offset, bytes});
  }
}

}  // namespace

void InstanceBuffer::swap(InstanceBuffer& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(kind_, other.kind_);
  std::swap(has_scalars_, other.has_scalars_);
  std::swap(buffer_, other.buffer_);
  std::swap(scalars_, other.scalars_);
  std::swap(capacity_, other.capacity_);
  std::swap(count_, other.count_);
  std::swap(zero_length_count_, other.zero_length_count_);
  std::swap(is_zero_length_, other.is_zero_length_);
  std::swap(frame_, other.frame_);
  std::swap(extent_, other.extent_);
  std::swap(boxes_, other.boxes_);
  std::swap(store_, other.store_);
  std::swap(kept_, other.kept_);
  std::swap(removed_, other.removed_);
  std::swap(added_, other.added_);
  std::swap(all_changed_, other.all_changed_);
}

void InstanceBuffer::clear() {
  if (buffer_ != BufferId{}) device_->destroy_buffer(buffer_);
  if (scalars_ != BufferId{}) device_->destroy_buffer(scalars_);
  buffer_ = {};
  scalars_ = {};
  capacity_ = 0;
  count_ = 0;
  drop_lengths(0);
  extent_ = {};
  boxes_.clear();
  store_.clear();
  kept_ = {};
  note_all_changed();
}

void InstanceBuffer::forget_changes() {
  removed_.clear();
  added_.clear();
  all_changed_ = false;
}

void InstanceBuffer::note_all_changed() {
  removed_ = {};
  added_ = {};
  all_changed_ = true;
}

bool InstanceBuffer::is_kept() const {
  // Counting takes about as long, see counted_instances.cpp.
  constexpr double kWorthCountingNs = 60.0;
  switch (kind_) {
    case PrimitiveKind::disk: return true;
    case PrimitiveKind::circle:
    case PrimitiveKind::point:
    case PrimitiveKind::segment: return device_->instance_cost_ns() > kWorthCountingNs;
    default: return false;
  }
}

void InstanceBuffer::keep(std::size_t instance, std::span<const double> encoded, bool is_new) {
  const std::size_t doubles = layout_of(kind_).doubles();
  const std::span<double> place = std::span(kept_).subspan(instance * doubles, doubles);
  if (!all_changed_) {
    // Beyond a quarter, updating all at once takes no longer.
    if (added_.size() > kept_.size() / 4 + 16 * doubles) {
      note_all_changed();
    } else {
      if (!is_new) removed_.insert(removed_.end(), place.begin(), place.end());
      added_.insert(added_.end(), encoded.begin(), encoded.end());
    }
  }
  std::ranges::copy(encoded, place.begin());
}

void InstanceBuffer::keep_count(std::uint32_t count) {
  const std::size_t size = count * layout_of(kind_).doubles();
  if (!all_changed_ && size < kept_.size())
    removed_.insert(removed_.end(), kept_.begin() + static_cast<std::ptrdiff_t>(size), kept_.end());
  kept_.resize(size);
}

void InstanceBuffer::note_length(std::size_t instance, const double* values) {
  if (kind_ != PrimitiveKind::segment) return;
  const bool is_zero = is_zero_length(values);
  if (instance >= is_zero_length_.size()) {
    if (!is_zero) return;
    is_zero_length_.resize(instance + 1);
  }
  if (is_zero == is_zero_length_[instance]) return;
  is_zero_length_[instance] = is_zero;
  is_zero ? ++zero_length_count_ : --zero_length_count_;
}

// The instances from `count` on are gone.
void InstanceBuffer::drop_lengths(std::size_t count) {
  if (count >= is_zero_length_.size()) return;
  const auto gone = is_zero_length_.begin() + static_cast<std::ptrdiff_t>(count);
  zero_length_count_ -= static_cast<std::uint32_t>(std::count(gone, is_zero_length_.end(), true));
  is_zero_length_.resize(count);
}

void InstanceBuffer::reserve(std::size_t instances, std::size_t keep) {
  const std::size_t bytes = layout_of(kind_).bytes();
  // Half as much again is a compromise between frequent copies and unused memory.
  const std::size_t room = std::max({instances, kSmallest, keep == 0 ? 0 : capacity_ + capacity_ / 2});
  try {
    if (buffer_ == BufferId{}) {
      if (instances == 0) return;
      buffer_ = device_->create_buffer(room * bytes);
      if (has_scalars_) scalars_ = device_->create_buffer(room * sizeof(double));
      capacity_ = room;
    } else if (instances > capacity_ || (keep == 0 && instances < capacity_ / 8 && capacity_ > kSmallest)) {
      device_->resize_buffer(buffer_, room * bytes, keep * bytes);
      if (has_scalars_) device_->resize_buffer(scalars_, room * sizeof(double), keep * sizeof(double));
      capacity_ = room;
    }
  } catch (const std::bad_alloc&) {
    // Later patches depend on this one, so a partial patch is worse than none.
    clear();
    throw;
  }
}

std::uint64_t InstanceBuffer::replace(std::uint32_t count, std::span<const double> data, const DrawingFrame& frame,
                                      bool has_scalars) {
  const std::size_t stride = stride_of(kind_);
  MES_ASSERT(data.size() >= count * stride);
  const std::size_t doubles = layout_of(kind_).doubles();
  decltype(extent_) extent{};
  BlockBoxes boxes;
  // Encodes first, so that the current instances survive a lack of memory.
  std::vector<double> encoded(count * doubles);
  for (std::size_t i = 0; i < count; ++i) {
    encode_instance(kind_, frame, data.subspan(i * stride, stride), std::span(encoded).subspan(i * doubles, doubles),
                    extent);
    boxes.add(i, box_of_instance(kind_, std::span(encoded).subspan(i * doubles, doubles)));
  }
  if (has_scalars != has_scalars_) clear();
  has_scalars_ = has_scalars;
  frame_ = frame;
  extent_ = extent;
  boxes_ = std::move(boxes);
  store_.clear();
  count_ = 0;
  drop_lengths(0);
  try {
    for (std::size_t i = 0; i < count; ++i) note_length(i, data.data() + i * stride);
    return fill(count, encoded, data);
  } catch (const std::bad_alloc&) {
    clear();  // a part of the instances would be a wrong picture
    throw;
  }
}

std::uint64_t InstanceBuffer::fill(std::uint32_t count, std::span<const double> encoded,
                                   std::span<const double> data) {
  const std::size_t stride = stride_of(kind_);
  reserve(count, 0);
  count_ = count;
  if (is_kept()) {
    note_all_changed();
    kept_.assign(encoded.begin(), encoded.end());
  }
  if (count == 0) return 0;
  const ByteRange all{0, encoded.size_bytes()};
  device_->update_buffer(buffer_, std::span(&all, 1), std::as_bytes(encoded));
  if (!has_scalars_) return all.size;
  store_.resize(count);
  for (std::size_t i = 0; i < count; ++i) store_.set(i, data[i * stride + stride - 1]);
  store_.settle();
  const ByteRange of_scalars{0, count * sizeof(double)};
  return all.size + write_scalars(std::span(&of_scalars, 1), store_.values());
}

std::uint64_t InstanceBuffer::write_scalars(std::span<const ByteRange> ranges, std::span<const double> scalars) {
  device_->update_buffer(scalars_, ranges, std::as_bytes(scalars));
  return scalars.size_bytes();
}

std::uint64_t InstanceBuffer::apply(const KindPatch& patch, const DrawingFrame& frame, bool has_scalars) {
  if (patch.reset) return replace(patch.count, patch.data, frame, has_scalars);
  if (patch.is_empty()) return 0;
  MES_ASSERT(patch.data.size() >= patch.index.size() * stride_of(kind_));
  MES_ASSERT(count_ == 0 || frame == frame_);
  frame_ = frame;
  if (capacity_ == 0) has_scalars_ = has_scalars;
  MES_ASSERT(has_scalars == has_scalars_);
  if (patch.count > capacity_) reserve(patch.count, count_);
  const std::uint32_t first_new = std::exchange(count_, patch.count);
  drop_lengths(count_);
  if (count_ == 0) {
    extent_ = {};
    boxes_.clear();
  }
  try {
    if (has_scalars_) store_.resize(count_);
    if (is_kept()) keep_count(count_);
    return write(patch.index, patch.data, first_new);
  } catch (const std::bad_alloc&) {
    clear();  // a part of the instances would be a wrong picture
    throw;
  }
}

std::uint64_t InstanceBuffer::write(std::span<const std::uint32_t> index, std::span<const double> data,
                                    std::uint32_t first_new) {
  const std::size_t stride = stride_of(kind_);
  const std::size_t doubles = layout_of(kind_).doubles();
  const std::size_t bytes = layout_of(kind_).bytes();

  // Positions in the patch by instance; if an instance occurs repeatedly, only the last position stays.
  std::vector<std::uint32_t> order(index.size());
  std::iota(order.begin(), order.end(), 0U);
  if (!std::ranges::is_sorted(index)) {
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return index[i]; });
  }
  std::vector<double> encoded;
  encoded.reserve(order.size() * doubles);
  std::vector<double> scalars;
  std::vector<ByteRange> ranges;
  std::vector<ByteRange> scalar_ranges;
  const bool are_kept = is_kept();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t instance = index[order[i]];
    // The instance was written and removed within one run of the graph.
    if (instance >= count_) break;
    if (i + 1 < order.size() && index[order[i + 1]] == instance) continue;
    const std::size_t end = encoded.size();
    encoded.resize(end + doubles);
    encode_instance(kind_, frame_, data.subspan(order[i] * stride, stride), std::span(encoded).subspan(end), extent_);
    boxes_.add(instance, box_of_instance(kind_, std::span(encoded).subspan(end)));
    append(ranges, instance, bytes);
    note_length(instance, data.data() + order[i] * stride);
    if (are_kept) keep(instance, std::span(encoded).subspan(end), instance >= first_new);
    if (!has_scalars_) continue;
    scalars.push_back(data[order[i] * stride + stride - 1]);
    store_.set(instance, scalars.back());
    append(scalar_ranges, instance, sizeof(double));
  }
  store_.settle();
  if (!ranges.empty()) device_->update_buffer(buffer_, ranges, std::as_bytes(std::span(encoded)));
  std::uint64_t uploaded = encoded.size() * sizeof(double);
  if (!scalar_ranges.empty()) uploaded += write_scalars(scalar_ranges, scalars);
  return uploaded;
}

}  // namespace mes::render
