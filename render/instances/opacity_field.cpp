// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/opacity_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/assert.h"

namespace mes::render {
namespace {

constexpr int kFractionBits = 20;  // fraction bits of logarithms
constexpr double kUnit = 1 << kFractionBits;
/// The logarithm of zero: far more bits than an opacity has, and a hundred million of them do not overflow.
constexpr std::int64_t kOpaque = std::int64_t{1} << 36U;

/// 65535 2^-(i / size), in units of 2^-14, for the fractions of logarithms.
constexpr int kPowerBits = 12;
constexpr int kPowerUnitBits = 14;
using Powers = std::array<std::uint32_t, std::size_t{1} << kPowerBits>;
const Powers& powers() {
  static const auto table = [] {
    Powers out{};
    const auto size = static_cast<double>(out.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = static_cast<std::uint32_t>(
          std::llround(std::ldexp(65535.0 * std::exp2(-(static_cast<double>(i) + 0.5) / size), kPowerUnitBits)));
    return out;
  }();
  return table;
}

}  // namespace

OpacityField::OpacityField(int width, int height, double opacity, Sums kind)
    : width_(width), height_(height), kind_(kind) {
  MES_ASSERT(width > 0 && height > 0 && opacity >= 0.0 && opacity <= 1.0);
  for (std::size_t i = 0; i < factor_.size(); ++i) {
    const double passes = 1.0 - opacity * static_cast<double>(i) / kSteps;
    factor_[i] = passes > 0.0 ? std::llround(-std::log2(passes) * kUnit) : kOpaque;
  }
  const auto rows = static_cast<std::size_t>(height);
  sums_.resize(stride() * rows);
  opacity_.resize(columns() * rows);
  is_stale_.resize(static_cast<std::size_t>(bands()));
  is_used_.resize(is_stale_.size());
  is_visible_.resize(is_stale_.size() * static_cast<std::size_t>(blocks()));
}

void OpacityField::clear() {
  const auto clear_band = [this](std::size_t band) {
    if (is_used_[band] == 0 && is_stale_[band] == 0) return;
    const std::size_t first = band * kBandRows;
    const std::size_t end = std::min(first + kBandRows, static_cast<std::size_t>(height_));
    std::fill(sums_.begin() + static_cast<std::ptrdiff_t>(first * stride()),
              sums_.begin() + static_cast<std::ptrdiff_t>(end * stride()), 0);
    is_stale_[band] = 1;
    is_used_[band] = 0;
  };
  run_tasks(is_used_.size(), clear_band);
}

void OpacityField::settle_row(int y, std::span<std::uint8_t> is_visible) {
  const auto at = static_cast<std::size_t>(y);
  const std::int64_t* sums = &sums_[at * stride()];
  const bool are_differences = kind_ == Sums::differences;
  std::uint16_t* out = &opacity_[at * columns()];
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint16_t>::max();
  constexpr std::int64_t kNothingPasses = std::int64_t{18} << kFractionBits;
  const auto& power = powers();
  std::int64_t bits = 0;
  for (std::size_t block = 0; block < is_visible.size(); ++block) {
    std::uint32_t any = 0;
    const std::size_t end = std::min((block + 1) * kBlockColumns, columns());
    for (std::size_t x = block * kBlockColumns; x < end; ++x) {
      bits = are_differences ? bits + sums[x] : sums[x];
      std::uint32_t opacity = 0;
      if (bits >= kNothingPasses) {
        opacity = kMost;
      } else if (bits != 0) {
        constexpr int kDropped = kFractionBits - kPowerBits;
        const auto fraction = static_cast<std::size_t>(bits >> kDropped) & (power.size() - 1);
        const std::uint32_t passes = power[fraction] >> static_cast<std::uint32_t>(bits >> kFractionBits);
        constexpr std::uint32_t kHalf = 1U << (kPowerUnitBits - 1);
        opacity = kMost - ((passes + kHalf) >> kPowerUnitBits);
      }
      any |= opacity;
      out[x] = static_cast<std::uint16_t>(opacity);
    }
    if (any != 0) is_visible[block] = 1;
  }
}

void OpacityField::settle_band(int band) {
  const auto at = static_cast<std::size_t>(band);
  const auto size = static_cast<std::size_t>(blocks());
  const std::span<std::uint8_t> is_visible = std::span(is_visible_).subspan(at * size, size);
  std::ranges::fill(is_visible, std::uint8_t{0});
  const RowRange rows = rows_of(band);
  for (int y = rows.first; y < rows.end; ++y) settle_row(y, is_visible);
}

std::span<const RowRange> OpacityField::settle() {
  std::vector<int> stale;
  for (int band = 0; band < bands(); ++band)
    if (is_stale_[static_cast<std::size_t>(band)] != 0) stale.push_back(band);
  constexpr std::size_t kWorthThreads = 8;
  if (stale.size() < kWorthThreads) {
    for (const int band : stale) settle_band(band);
  } else {
    run_tasks(stale.size(), [&](std::size_t i) { settle_band(stale[i]); });
  }
  settled_.clear();
  for (const int band : stale) {
    const RowRange rows = rows_of(band);
    is_used_[static_cast<std::size_t>(band)] = 1;
    is_stale_[static_cast<std::size_t>(band)] = 0;
    if (!settled_.empty() && settled_.back().end == rows.first)
      settled_.back().end = rows.end;
    else
      settled_.push_back(rows);
  }
  return settled_;
}

std::vector<FieldPart> OpacityField::parts() const {
  std::vector<FieldPart> out;
  const int size = blocks();
  for (int band = 0; band < bands(); ++band) {
    const std::size_t first_block = static_cast<std::size_t>(band) * static_cast<std::size_t>(size);
    const auto is_visible = [&](int block) {
      return is_visible_[first_block + static_cast<std::size_t>(block)] != 0;
    };
    for (int block = 0; block < size; ++block) {
      if (!is_visible(block)) continue;
      const int first = block;
      while (block + 1 < size && is_visible(block + 1)) ++block;
      out.push_back({first * kBlockColumns, std::min((block + 1) * kBlockColumns, width_), rows_of(band)});
    }
  }
  return out;
}

}  // namespace mes::render
