// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/counted_disks.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "core/base/parallel.h"

namespace mes::render {
namespace {

// Nanoseconds as measured: of a disk in a row of pixels, with its rim, and of a pixel of the mask from sum to screen.
constexpr double kRowNs = 25.0;
constexpr double kMaskPixelNs = 8.0;

bool is_drawn(const PixelDisk& disk) {
  return disk.radius >= 0.0;
}

double overlap(double center, double radius, int size) {
  return std::max(0.0, std::min(center + radius, static_cast<double>(size)) - std::max(center - radius, 0.0));
}

}  // namespace

bool CountedDisks::is_cheaper(const InstanceBuffer& disks, const PixelFrame& frame, const Device& device) {
  double rows = 0.0;
  double pixels = 0.0;
  for (const DiskInstance& instance : disks.disks()) {
    const PixelDisk disk = frame(instance);
    if (!is_drawn(disk)) continue;
    const double across = overlap(disk.x, disk.radius + 0.5, frame.width);
    const double up = across > 0.0 ? overlap(disk.y, disk.radius + 0.5, frame.height) : 0.0;
    rows += up;
    pixels += 0.25 * std::numbers::pi * across * up;
  }
  const double mask = kMaskPixelNs * frame.width * frame.height;
  const double counting = kRowNs * rows / static_cast<double>(worker_count()) + mask;
  return counting < device.pixel_cost_ns() * pixels;
}

void CountedDisks::forget() {
  if (mask_ != TextureId{}) device_.destroy_texture(mask_);
  mask_ = {};
  field_.reset();
  counted_ = {};
}

void CountedDisks::show(InstanceBuffer& disks, const PixelFrame& frame, double opacity) {
  const bool is_new = !field_ || frame != frame_ || opacity != opacity_;
  try {
    const bool from_scratch = is_new || disks.have_all_disks_changed();
    if (from_scratch) {
      if (frame.width != frame_.width || frame.height != frame_.height) forget();
      frame_ = frame;
      opacity_ = opacity;
      count_all(disks);
    } else {
      count_changes(disks);
    }
    disks.forget_disk_changes();
    upload(from_scratch);
  } catch (...) {
    forget();
    throw;
  }
}

void CountedDisks::count_all(const InstanceBuffer& disks) {
  field_.emplace(frame_.width, frame_.height, opacity_);
  counted_.clear();
  counted_.reserve(disks.disks().size());
  for (const DiskInstance& disk : disks.disks()) counted_.push_back(frame_(disk));
  if (std::ranges::all_of(counted_, is_drawn)) {
    field_->add(counted_);
    return;
  }
  std::vector<PixelDisk> drawn;
  std::ranges::copy_if(counted_, std::back_inserter(drawn), is_drawn);
  field_->add(drawn);
}

void CountedDisks::count_changes(const InstanceBuffer& disks) {
  std::vector<PixelDisk> removed;
  std::vector<PixelDisk> added;
  const std::size_t count = disks.disks().size();
  for (std::size_t i = count; i < counted_.size(); ++i) removed.push_back(counted_[i]);
  const std::size_t common = std::min(count, counted_.size());
  counted_.resize(count);
  for (std::size_t i = common; i < count; ++i) added.push_back(counted_[i] = frame_(disks.disks()[i]));
  for (const std::uint32_t i : disks.changed_disks()) {
    if (i >= common) continue;
    removed.push_back(counted_[i]);
    added.push_back(counted_[i] = frame_(disks.disks()[i]));
  }
  std::erase_if(removed, [](const PixelDisk& disk) { return !is_drawn(disk); });
  std::erase_if(added, [](const PixelDisk& disk) { return !is_drawn(disk); });
  field_->remove(removed);
  field_->add(added);
}

void CountedDisks::upload(bool everything) {
  const std::span<const RowRange> settled = field_->settle();
  if (mask_ == TextureId{}) {
    mask_ = device_.create_mask(frame_.width, frame_.height);
    everything = true;
  }
  if (everything) {
    device_.update_mask(mask_, 0, field_->rows({0, frame_.height}));
  } else {
    for (const RowRange& range : settled) device_.update_mask(mask_, range.first, field_->rows(range));
  }
}

}  // namespace mes::render
