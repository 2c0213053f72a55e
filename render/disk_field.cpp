// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/disk_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mes::render {
namespace {

/// Radii for `change_steep_rows`, in pixels.
constexpr double kLeastPlain = 16.0;
constexpr double kMostPlain = 4096.0;

}  // namespace

// As `soft_radius` and `soft_alpha` of shaders/uniforms.glsl have it.
struct DiskField::Rim {
  double x;
  double y;
  double radius;    ///< where half of a pixel is covered
  double strength;  ///< of a disk too small for its ramp
  double inner;     ///< whole pixels are covered up to here; negative: nowhere
  double outer;
  RowRange rows;
  std::int32_t times;

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
  std::vector<Rim> rims;
  rims.reserve(disks.size());
  for (const PixelDisk& disk : disks) rims.emplace_back(disk, height());
  change_by_bands(
      std::span<const Rim>(rims), [](const Rim& rim) { return rim.rows; },
      [&](const Rim& rim, RowRange rows) { change_rows(rim, sign * rim.times, rows); });
}

void DiskField::change_rows(const Rim& rim, std::int32_t times, RowRange rows) {
  // Nothing of it may lie between the left and the right edge.
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

// Up to 0.8 radii from the middle a rim is at most 1 / 0.6 pixels wide, and so covers the middles of at most two. Most
// rows of large disks are such, and take a quarter of the time of `change_row`: loops without branches, which compilers
// turn into vector instructions, and two pixels an end, counted as rim even if one of them is covered.
void DiskField::change_steep_rows(const Rim& rim, std::int32_t times, RowRange rows) {
  const auto count = static_cast<std::size_t>(rows.end - rows.first);
  std::array<double, kBandRows> square{};  // of the distance between row and middle
  std::array<double, kBandRows> half{};
  std::array<int, kBandRows> left{};
  std::array<int, kBandRows> right{};
  std::array<std::array<float, kBandRows>, 4>
      across{};  // from the middle to the pixels, outermost ones first and last
  std::array<std::array<std::int32_t, kBandRows>, 4> steps{};
  for (std::size_t i = 0; i < count; ++i) {
    const double dy = static_cast<double>(rows.first) + static_cast<double>(static_cast<int>(i)) + 0.5 - rim.y;
    square[i] = dy * dy;
  }
  const double outer_square = rim.outer * rim.outer;
  for (std::size_t i = 0; i < count; ++i) half[i] = std::sqrt(outer_square - square[i]);
  // Both ends are inside the view, so that cutting decimals off is rounding down.
  const double x = rim.x - 0.5;
  for (std::size_t i = 0; i < count; ++i) {
    const double left_end = x - half[i];
    const int cut = static_cast<int>(left_end);
    left[i] = cut + (static_cast<double>(cut) < left_end ? 1 : 0);
    right[i] = static_cast<int>(x + half[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    across[0][i] = static_cast<float>(left[i] - x);
    across[3][i] = static_cast<float>(right[i] - x);
  }
  // Single precision has a ten thousandth of a pixel to spare here.
  const auto half_inverse = static_cast<float>(0.5 / rim.radius);
  const double radius_square = rim.radius * rim.radius;
  std::array<float, kBandRows> offset{};
  for (std::size_t i = 0; i < count; ++i) {
    offset[i] = static_cast<float>(square[i] - radius_square);
    across[1][i] = across[0][i] + 1.0F;
    across[2][i] = across[3][i] - 1.0F;
  }
  for (std::size_t k = 0; k < across.size(); ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      const float estimate = (across[k][i] * across[k][i] + offset[i]) * half_inverse;
      const float covered = 0.5F - (estimate - estimate * estimate * half_inverse);
      const float above = covered < 0.0F ? 0.0F : covered;
      steps[k][i] = static_cast<std::int32_t>((above > 1.0F ? 1.0F : above) * kSteps + kHalfStep);
    }
  }
  std::int64_t* rims = sums(rows.first);
  std::int32_t* covered = ends(rows.first);
  const auto times_factor = [&](std::int32_t step) { return times * factor(static_cast<std::size_t>(step)); };
  for (std::size_t i = 0; i < count; ++i, rims += columns(), covered += columns() + 1) {
    rims[left[i]] += times_factor(steps[0][i]);
    rims[left[i] + 1] += times_factor(steps[1][i]);
    rims[right[i] - 1] += times_factor(steps[2][i]);
    rims[right[i]] += times_factor(steps[3][i]);
    covered[left[i] + 2] += times;
    covered[right[i] - 1] -= times;
  }
}

void DiskField::change_row(const Rim& rim, std::int32_t times, int y) {
  const double dy = y + 0.5 - rim.y;
  const double outer_square = rim.outer * rim.outer - dy * dy;
  if (outer_square <= 0.0) return;
  const double most = width();
  const double half = std::sqrt(outer_square);
  // The pixels from `left` to `right` are touched, from `from` to `to` covered.
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
      ends(y)[from] += times;
      ends(y)[to + 1] -= times;
    } else {
      // Covered pixels are beside the view: whatever is touched lies to one side of them.
      from = first > right ? right + 1 : std::max(first, left);
      to = from - 1;
    }
  }
  std::int64_t* rims = sums(y);
  // The distance from the rim is (d^2 - q^2) / (d + q), and d + q nearly 2 q for large disks.
  const bool is_large = rim.radius >= 32.0;
  const double half_inverse = 0.5 / rim.radius;
  const double offset = dy * dy - rim.radius * rim.radius;
  const auto count = [&](int x) {
    const double dx = x + 0.5 - rim.x;
    const double difference = dx * dx + offset;
    double distance;
    if (is_large) {
      const double estimate = difference * half_inverse;
      distance = estimate - estimate * estimate * half_inverse;
    } else {
      distance = std::sqrt(dx * dx + dy * dy) - rim.radius;
    }
    const double covered = std::clamp(0.5 - distance, 0.0, 1.0) * rim.strength;
    rims[x] += times * factor(static_cast<std::size_t>(covered * kSteps + double{kHalfStep}));
  };
  for (int x = left; x < from; ++x) count(x);
  for (int x = to + 1; x <= right; ++x) count(x);
}

}  // namespace mes::render
