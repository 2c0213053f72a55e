// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/disk_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/base/parallel.h"

namespace mes::render {
namespace {

constexpr int kFractionBits = 20;  // of logarithms
constexpr double kUnit = 1 << kFractionBits;
/// Stands for the logarithm of zero: far more bits than an opacity has, and a million of them are no overflow.
constexpr std::int64_t kOpaque = std::int64_t{1} << 40U;

/// 2^-(i / size) for the fractions of logarithms.
constexpr int kPowerBits = 12;
const std::array<double, std::size_t{1} << kPowerBits>& powers() {
  static const auto table = [] {
    std::array<double, std::size_t{1} << kPowerBits> out{};
    const auto size = static_cast<double>(out.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::exp2(-(static_cast<double>(i) + 0.5) / size);
    return out;
  }();
  return table;
}

/// Radii for `change_steep_rows`, in pixels.
constexpr double kLeastPlain = 16.0;
constexpr double kMostPlain = 4096.0;

/// Fewer disks are counted without a list for each band.
constexpr std::size_t kFew = 64;

/// The least whole number not below x, and the largest not above it, for |x| far inside the range of an int.
int ceil_of(double x) {
  const int cut = static_cast<int>(x);
  return cut + (static_cast<double>(cut) < x ? 1 : 0);
}
int floor_of(double x) {
  const int cut = static_cast<int>(x);
  return cut - (static_cast<double>(cut) > x ? 1 : 0);
}

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

  Rim(const PixelDisk& disk, int height) : x(disk.x), y(disk.y) {
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

DiskField::DiskField(int width, int height, double opacity) : width_(width), height_(height) {
  MES_ASSERT(width > 0 && height > 0 && opacity >= 0.0 && opacity <= 1.0);
  for (std::size_t i = 0; i < factor_.size(); ++i) {
    const double passes = 1.0 - opacity * static_cast<double>(i) / kSteps;
    factor_[i] = passes > 0.0 ? std::llround(-std::log2(passes) * kUnit) : kOpaque;
  }
  const std::size_t rows = static_cast<std::size_t>(height);
  ends_.resize((columns() + 1) * rows);
  rims_.resize(columns() * rows);
  opacity_.resize(columns() * rows);
  is_stale_.resize(static_cast<std::size_t>(bands()));
}

void DiskField::change(std::span<const PixelDisk> disks, int sign) {
  if (disks.size() < kFew) {
    for (const PixelDisk& disk : disks) {
      const Rim rim(disk, height_);
      change_rows(rim, sign, rim.rows);
    }
    return;
  }
  // The disks of each band, in one array.
  const auto band_range = [](const Rim& rim) {
    return RowRange{rim.rows.first / kBandRows,
                    rim.rows.first < rim.rows.end ? (rim.rows.end - 1) / kBandRows + 1 : 0};
  };
  std::vector<Rim> rims;
  rims.reserve(disks.size());
  std::vector<std::size_t> start(static_cast<std::size_t>(bands()) + 1);
  for (const PixelDisk& disk : disks) {
    const Rim& rim = rims.emplace_back(disk, height_);
    const RowRange range = band_range(rim);
    for (int band = range.first; band < range.end; ++band) ++start[static_cast<std::size_t>(band) + 1];
  }
  for (std::size_t band = 1; band < start.size(); ++band) start[band] += start[band - 1];
  std::vector<std::uint32_t> of_band(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (std::size_t i = 0; i < rims.size(); ++i) {
    const RowRange range = band_range(rims[i]);
    for (int band = range.first; band < range.end; ++band)
      of_band[next[static_cast<std::size_t>(band)]++] = static_cast<std::uint32_t>(i);
  }
  run_tasks(next.size(), [&](std::size_t band) {
    const int first = static_cast<int>(band) * kBandRows;
    for (std::size_t i = start[band]; i < start[band + 1]; ++i) {
      const Rim& rim = rims[of_band[i]];
      change_rows(rim, sign, {std::max(first, rim.rows.first), std::min(first + kBandRows, rim.rows.end)});
    }
  });
}

void DiskField::change_rows(const Rim& rim, int sign, RowRange rows) {
  // Nothing of it may lie between the left and the right edge.
  if (rim.x + rim.outer < 0.0 || rim.x - rim.outer > static_cast<double>(width_)) return;
  const bool is_plain = rim.radius >= kLeastPlain && rim.radius <= kMostPlain && rim.x - rim.outer >= 1.0 &&
                        rim.x + rim.outer <= width_ - 1.0;
  const double steep = is_plain ? 0.8 * rim.radius : 0.0;
  int y = rows.first;
  for (; y < rows.end && y + 0.5 - rim.y <= -steep; ++y) change_row(rim, sign, y);
  while (y < rows.end && y + 0.5 - rim.y < steep) {
    const int last = std::min({y + kBandRows, rows.end, floor_of(rim.y + steep - 0.5) + 1});
    if (last <= y) break;
    change_steep_rows(rim, sign, {y, last});
    y = last;
  }
  for (; y < rows.end; ++y) change_row(rim, sign, y);
  for (int band = rows.first / kBandRows; band * kBandRows < rows.end; ++band)
    is_stale_[static_cast<std::size_t>(band)] = 1;
}

// Up to 0.8 radii from the middle a rim is at most 1 / 0.6 pixels wide, and so covers the middles of at most two. Most
// rows of large disks are such, and take a quarter of the time of `change_row`: loops without branches, which compilers
// turn into vector instructions, and two pixels an end, counted as rim even if one of them is covered.
void DiskField::change_steep_rows(const Rim& rim, int sign, RowRange rows) {
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
      steps[k][i] = static_cast<std::int32_t>((above > 1.0F ? 1.0F : above) * kSteps + 0.5F);
    }
  }
  std::int64_t* rims = &rims_[static_cast<std::size_t>(rows.first) * columns()];
  std::int32_t* ends = &ends_[static_cast<std::size_t>(rows.first) * (columns() + 1)];
  const auto factor = [&](std::int32_t step) { return sign * factor_[static_cast<std::size_t>(step)]; };
  for (std::size_t i = 0; i < count; ++i, rims += columns(), ends += columns() + 1) {
    rims[left[i]] += factor(steps[0][i]);
    rims[left[i] + 1] += factor(steps[1][i]);
    rims[right[i] - 1] += factor(steps[2][i]);
    rims[right[i]] += factor(steps[3][i]);
    ends[left[i] + 2] += sign;
    ends[right[i] - 1] -= sign;
  }
}

void DiskField::change_row(const Rim& rim, int sign, int y) {
  const double dy = y + 0.5 - rim.y;
  const double outer_square = rim.outer * rim.outer - dy * dy;
  if (outer_square <= 0.0) return;
  const double most = width_;
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
      std::int32_t* ends = &ends_[static_cast<std::size_t>(y) * (columns() + 1)];
      ends[from] += sign;
      ends[to + 1] -= sign;
    } else {
      // Covered pixels are beside the view: whatever is touched lies to one side of them.
      from = first > right ? right + 1 : std::max(first, left);
      to = from - 1;
    }
  }
  std::int64_t* rims = &rims_[static_cast<std::size_t>(y) * columns()];
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
    rims[x] += sign * factor_[static_cast<std::size_t>(covered * kSteps + 0.5)];
  };
  for (int x = left; x < from; ++x) count(x);
  for (int x = to + 1; x <= right; ++x) count(x);
}

void DiskField::settle_row(int y) {
  const auto at = static_cast<std::size_t>(y);
  const std::int32_t* ends = &ends_[at * (columns() + 1)];
  const std::int64_t* rims = &rims_[at * columns()];
  std::uint16_t* out = &opacity_[at * columns()];
  constexpr double kMost = std::numeric_limits<std::uint16_t>::max();
  constexpr std::int64_t kNothingPasses = std::int64_t{18} << kFractionBits;
  const std::int64_t whole = factor_.back();
  const auto& power = powers();
  std::int64_t covers = 0;
  for (std::size_t x = 0; x < columns(); ++x) {
    covers += ends[x];
    const std::int64_t bits = covers * whole + rims[x];
    if (bits == 0) {
      out[x] = 0;
    } else if (bits >= kNothingPasses) {
      out[x] = static_cast<std::uint16_t>(kMost);
    } else {
      constexpr int kDropped = kFractionBits - kPowerBits;
      const auto fraction = static_cast<std::size_t>(bits >> kDropped) & (power.size() - 1);
      const double passes = power[fraction] / static_cast<double>(std::int64_t{1} << (bits >> kFractionBits));
      out[x] = static_cast<std::uint16_t>((1.0 - passes) * kMost + 0.5);
    }
  }
}

std::span<const RowRange> DiskField::settle() {
  std::vector<int> stale;
  for (int band = 0; band < bands(); ++band)
    if (is_stale_[static_cast<std::size_t>(band)] != 0) stale.push_back(band);
  const auto rows_of = [this](int band) {
    return RowRange{band * kBandRows, std::min((band + 1) * kBandRows, height_)};
  };
  const auto settle_band = [&](std::size_t i) {
    const RowRange rows = rows_of(stale[i]);
    for (int y = rows.first; y < rows.end; ++y) settle_row(y);
  };
  constexpr std::size_t kWorthThreads = 8;
  if (stale.size() < kWorthThreads) {
    for (std::size_t i = 0; i < stale.size(); ++i) settle_band(i);
  } else {
    run_tasks(stale.size(), settle_band);
  }
  settled_.clear();
  for (const int band : stale) {
    const RowRange rows = rows_of(band);
    is_stale_[static_cast<std::size_t>(band)] = 0;
    if (!settled_.empty() && settled_.back().end == rows.first)
      settled_.back().end = rows.end;
    else
      settled_.push_back(rows);
  }
  return settled_;
}

}  // namespace mes::render
