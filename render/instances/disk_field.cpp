// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/disk_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mes::render {
namespace {

/// Radii for `change_steep_rows`, in pixels; single precision would lose the rim of larger disks.
constexpr double kLeastPlain = 16.0;
constexpr double kMostPlain = 4096.0;
constexpr double kLeastLarge = 32.0;

/// Clamps to the range of a pixel.
float within_pixel(float x) {
  const float above = x > 0.0F ? x : 0.0F;
  return above < 1.0F ? above : 1.0F;
}

}  // namespace

// Matches `soft_radius` and `soft_alpha` of shaders/uniforms.glsl.
struct DiskField::Rim {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;    ///< half of a pixel is covered at this radius
  double strength = 0.0;  ///< strength of a disk too small for its ramp
  double inner = 0.0;     ///< whole pixels are covered up to this radius; negative: nowhere
  double outer = 0.0;
  RowRange rows;
  std::int32_t times = 0;

  Rim() = default;
  Rim(const PixelDisk& disk, int height) : x(disk.x), y(disk.y), times(disk.times) {
    const double r = disk.radius;
    radius = std::sqrt(std::max(r * r - 1.0 / 12.0, 0.25));
    strength = std::min(3.0 * r * r, 1.0);
    inner = radius - 0.5;
    outer = radius + 0.5;
    const double top = height;
    rows = {ceil_of(std::clamp(y - outer - 0.5, 0.0, top)),
            floor_of(std::clamp(y + outer - 0.5, -1.0, top - 1.0)) + 1};
  }
};

void DiskField::change(std::span<const PixelDisk> disks, int sign) {
  std::vector<Rim> rims(disks.size());
  parallel_for(disks.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) rims[i] = Rim(disks[i], height());
  });
  change_by_bands(
      std::span<const Rim>(rims), [](const Rim& rim) { return rim.rows; },
      [&](const Rim& rim, RowRange rows) { change_rows(rim, sign * rim.times, rows); });
}

void DiskField::change_rows(const Rim& rim, std::int32_t times, RowRange rows) {
  // Skip disks entirely left or right of the view.
  if (rim.x + rim.outer < 0.0 || rim.x - rim.outer > static_cast<double>(width())) return;
  const bool is_plain = rim.radius >= kLeastPlain && rim.radius <= kMostPlain && rim.x - rim.outer >= 1.0 &&
                        rim.x + rim.outer <= width() - 1.0;
  const double steep = is_plain ? 0.8 * rim.radius : 0.0;
  int y = rows.first;
  for (; y < rows.end && y + 0.5 - rim.y <= -steep; ++y) change_row(rim, times, y);
  while (y < rows.end && y + 0.5 - rim.y < steep) {
    const int last = std::min({y + kBandRows, rows.end, floor_of(rim.y + steep - 0.5) + 1});
    if (last <= y) break;
    change_steep_rows(rim, times, {y, last});
    y = last;
  }
  for (; y < rows.end; ++y) change_row(rim, times, y);
  mark(rows);
}

// Up to 0.8 radii from the middle, a rim is at most 1 / 0.6 pixels wide, and so covers the centres of at most two
// pixels. Most rows of large disks are such rows, and take a quarter of the time of `change_row`: each end counts two
// pixels as rim even if one of them is covered, and four rows at a time run in loops without branches and with a
// constant count, which compilers vectorise. Rows past the last one are computed but not counted.
void DiskField::change_steep_rows(const Rim& rim, std::int32_t times, RowRange rows) {
  constexpr int kRows = 4;
  using Rows = std::array<float, kRows>;
  const double outer_square = rim.outer * rim.outer;
  const double radius_square = rim.radius * rim.radius;
  // Single precision suffices with a margin of a ten-thousandth of a pixel.
  const auto half_inverse = static_cast<float>(0.5 / rim.radius);
  // Both ends are inside the view, so truncation rounds down, also for pixels right of the left end. If an end that is
  // nearly a whole number goes to the wrong side of it, an uncovered pixel is counted.
  const double x = rim.x - 0.5;
  const double beside = width();  // index of the view's right border
  const std::int64_t whole = times * factor(kSteps);
  for (int first = rows.first; first < rows.end; first += kRows) {
    std::array<double, kRows> square;  // squared distance between row and middle
    Rows half;
    std::array<std::int32_t, kRows> left;
    std::array<std::int32_t, kRows> right;
    Rows offset;
    std::array<Rows, 4> across;  // offsets of pixels from the middle, outermost ones first and last
    std::array<std::array<std::int32_t, kRows>, 4> steps;
    for (std::size_t i = 0; i < kRows; ++i) {
      const double dy = static_cast<double>(first + static_cast<int>(i)) + 0.5 - rim.y;
      square[i] = dy * dy;
      const double beyond = outer_square - square[i];
      half[i] = std::sqrt(static_cast<float>(beyond > 0.0 ? beyond : 0.0));
    }
    for (std::size_t i = 0; i < kRows; ++i) {
      left[i] = width() - static_cast<std::int32_t>(beside - (x - double{half[i]}));
      right[i] = static_cast<std::int32_t>(x + double{half[i]});
    }
    for (std::size_t i = 0; i < kRows; ++i) {
      offset[i] = static_cast<float>(square[i] - radius_square);
      across[0][i] = static_cast<float>(static_cast<double>(left[i]) - x);
      across[3][i] = static_cast<float>(static_cast<double>(right[i]) - x);
      across[1][i] = across[0][i] + 1.0F;
      across[2][i] = across[3][i] - 1.0F;
    }
    for (std::size_t k = 0; k < across.size(); ++k) {
      for (std::size_t i = 0; i < kRows; ++i) {
        const float estimate = (across[k][i] * across[k][i] + offset[i]) * half_inverse;
        const float covered = within_pixel(0.5F - (estimate - estimate * estimate * half_inverse));
        steps[k][i] = static_cast<std::int32_t>(covered * kSteps + kHalfStep);
      }
    }
    const auto times_factor = [&](std::int32_t step) { return times * factor(static_cast<std::size_t>(step)); };
    const std::size_t count = static_cast<std::size_t>(std::min(kRows, rows.end - first));
    std::int64_t* row = sums(first);
    for (std::size_t i = 0; i < count; ++i, row += stride()) {
      const std::array<std::int64_t, 4> part{times_factor(steps[0][i]), times_factor(steps[1][i]),
                                             times_factor(steps[2][i]), times_factor(steps[3][i])};
      std::int64_t* begin = row + left[i];
      begin[0] += part[0];
      begin[1] += part[1] - part[0];
      begin[2] += whole - part[1];
      std::int64_t* end = row + right[i];
      end[-1] += part[2] - whole;
      end[0] += part[3] - part[2];
      end[1] -= part[3];
    }
  }
}

// Calls `take(x, steps)` for each pixel of a row up to `end`, with its covered part. Four at a time, as above.
template <class Take>
void DiskField::for_each_at_rim(const Rim& rim, double dy, int begin, int end, Take take) {
  // The distance from the rim is (d^2 - q^2) / (d + q), and d + q nearly 2 q for large disks.
  const double half_inverse = 0.5 / rim.radius;
  const double square = rim.radius * rim.radius;
  const double offset = dy * dy - square;
  if (rim.radius > kMostPlain) {
    for (int x = begin; x < end; ++x) {
      const double dx = x + 0.5 - rim.x;
      const double estimate = (dx * dx + offset) * half_inverse;
      const double covered = std::clamp(0.5 - (estimate - estimate * estimate * half_inverse), 0.0, 1.0);
      take(x, static_cast<std::size_t>(covered * kSteps + double{kHalfStep}));
    }
    return;
  }
  constexpr int kPixels = 4;
  const auto by_pixels = [&](auto distance) {
    const auto strength = static_cast<float>(rim.strength);
    for (int x = begin; x < end; x += kPixels) {
      const double dx = x + 0.5 - rim.x;
      const auto difference = static_cast<float>(dx * dx + offset);
      const auto slope = static_cast<float>(2.0 * dx);
      std::array<std::int32_t, kPixels> steps;
      for (std::size_t k = 0; k < kPixels; ++k) {
        const auto right = static_cast<float>(static_cast<std::int32_t>(k));
        const float covered = within_pixel(0.5F - distance(difference + right * (slope + right))) * strength;
        steps[k] = static_cast<std::int32_t>(covered * kSteps + kHalfStep);
      }
      const int count = std::min(kPixels, end - x);
      for (int k = 0; k < count; ++k) take(x + k, static_cast<std::size_t>(steps[static_cast<std::size_t>(k)]));
    }
  };
  if (rim.radius >= kLeastLarge) {
    by_pixels([inverse = static_cast<float>(half_inverse)](float difference) {
      const float estimate = difference * inverse;
      return estimate - estimate * estimate * inverse;
    });
  } else {
    by_pixels([square = static_cast<float>(square), radius = static_cast<float>(rim.radius)](float difference) {
      const float distance = difference + square;
      return std::sqrt(distance > 0.0F ? distance : 0.0F) - radius;
    });
  }
}

void DiskField::change_row(const Rim& rim, std::int32_t times, int y) {
  const double dy = y + 0.5 - rim.y;
  const double outer_square = rim.outer * rim.outer - dy * dy;
  if (outer_square <= 0.0) return;
  const double most = width();
  const double half = std::sqrt(outer_square);
  // Pixels `left` to `right` are touched, `from` to `to` are covered.
  const int left = ceil_of(std::clamp(rim.x - half - 0.5, 0.0, most));
  const int right = floor_of(std::clamp(rim.x + half - 0.5, -1.0, most - 1.0));
  int from = right + 1;
  int to = right;
  const double inner_square = rim.inner * rim.inner - dy * dy;
  if (rim.inner > 0.0 && inner_square > 0.0) {
    const double inner_half = std::sqrt(inner_square);
    const int first = ceil_of(std::clamp(rim.x - inner_half - 0.5, 0.0, most));
    const int last = floor_of(std::clamp(rim.x + inner_half - 0.5, -1.0, most - 1.0));
    if (first <= last) {
      from = first;
      to = last;
    } else {
      // The covered pixels are outside the view: all touched pixels lie to one side of them.
      from = first > right ? right + 1 : std::max(first, left);
      to = from - 1;
    }
  }
  if (left > right) return;
  std::int64_t* row = sums(y);
  std::int64_t before = 0;
  const auto go_on_with = [&](int x, std::int64_t now) {
    row[x] += now - before;
    before = now;
  };
  const auto count = [&](int begin, int end) {
    for_each_at_rim(rim, dy, begin, end, [&](int x, std::size_t step) { go_on_with(x, times * factor(step)); });
  };
  count(left, from);
  if (from <= to) go_on_with(from, times * factor(kSteps));
  count(to + 1, right + 1);
  go_on_with(right + 1, 0);
}

}  // namespace mes::render
